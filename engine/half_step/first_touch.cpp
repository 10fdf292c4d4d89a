#include "pushback/engine/half_step/first_touch.h"

#include <algorithm>
#include <limits>

#include "pushback/common/world/measure.h"
#include "pushback/engine/half_step/gap.h"
#include "pushback/engine/half_step/half_step.h"

namespace pushback {

Flight::Flight(const Body& body, const Vec3& linear, const Vec3& angular, Real within)
    : begin_(body), moved_(body), linear_(linear), angular_(angular), core_(corners_of_core(body)) {
  if (begin_.conveys) begin_.velocity.setZero(), begin_.angular_velocity.setZero();
  Real reach = 0;
  for (const Vec3& corner : core_) reach = std::max(reach, corner.norm());
  turns_ = reach > 0 && !(angular.isZero(0) && begin_.angular_velocity.isZero(0));
  if (!turns_) return;
  Real fastest = begin_.angular_velocity.norm() + within * angular.norm();
  if (tumbles(body)) {
    // Euler: w_3' = (I_1 - I_2) / I_3 w_1 w_2, and |I_1 - I_2| <= I_3, so |w|' <= |w|^2 / sqrt(3). And the energy bounds it:
    // w . I w >= |w|^2 times the least moment of inertia.
    const Real energy = begin_.angular_velocity.dot(spin_momentum(begin_)) * body.principal_inverse_inertia.maxCoeff();
    const Real left = 1 - fastest * within / std::sqrt(Real(3));
    const Real by_energy = std::sqrt(energy) + within * angular.norm();
    fastest = left > 0 ? std::min(fastest / left, by_energy) : by_energy;
  }
  bend_ = reach * (fastest * fastest * (1 + fastest * within) + 2 * angular.norm());
  little_ = within * std::sqrt(std::numeric_limits<Real>::epsilon());
}

/// All but its place.
Body Flight::turned_after(Real t) const {
  Body body = begin_;
  body.velocity.setZero();
  body.angular_velocity += t / 2 * angular_;
  drift(body, t);
  return body;
}

const Body& Flight::at(Real t) {
  time_ = t;
  if (turns_) moved_.orientation = turned_after(t).orientation;
  moved_.position = begin_.position + t * (begin_.velocity + t / 2 * linear_);
  return moved_;
}

/// The speed of a rotation in a step, which is not w, because the step rotates by 2 atan(w t / 2).
void Flight::look_along(const Vec3& n) {
  const Real speed = n.dot(begin_.velocity + time_ * linear_);
  const Quat later = turns_ ? turned_after(time_ + little_).orientation : moved_.orientation;
  seen_.clear();
  for (const Vec3& corner : core_) {
    const Real height = n.dot(moved_.orientation * corner);
    seen_.push_back({height, turns_ ? speed + (n.dot(later * corner) - height) / little_ : speed});
  }
}

Real first_root(Real d, Real c, Real a) {
  const Real discriminant = c * c - 2 * a * d;
  if (discriminant < 0 || (c >= 0 && a >= 0)) return std::numeric_limits<Real>::infinity();
  const Real root = std::sqrt(discriminant);
  return c < 0 ? 2 * d / (root - c) : (root + c) / -a;
}

std::optional<Real> first_touch(Flight& a, Flight& b, Real within, Real touching) {
  constexpr int most_rounds = 100;
  Real t = 0;
  for (int round = 0; round < most_rounds; ++round) {
    const Body &body_a = a.at(t), &body_b = b.at(t);
    const Gap gap = gap_between(body_a, body_b);
    if (round > 0 && gap.distance <= touching) return t;
    a.look_along(gap.normal);
    b.look_along(gap.normal);
    const auto lower = [](const Flight::Corner& p, const Flight::Corner& q) { return p.height < q.height; };
    const Real highest = std::max_element(a.corners().begin(), a.corners().end(), lower)->height;
    const Real lowest = std::min_element(b.corners().begin(), b.corners().end(), lower)->height;
    const Real d = std::max(gap.distance, Real(0));
    const Real bend = gap.normal.dot(b.acceleration() - a.acceleration()) - a.bend() - b.bend();
    Real free = std::numeric_limits<Real>::infinity();
    for (const Flight::Corner& p : a.corners())
      for (const Flight::Corner& q : b.corners())
        free = std::min(free, first_root(d + (highest - p.height) + (q.height - lowest),
                                         q.speed - p.speed - a.slack() - b.slack(), bend));
    t += free;
    if (!(t < within)) return {};
  }
  return t;
}

}  // namespace pushback
