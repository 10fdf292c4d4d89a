#include "pushback/engine/half_step/first_touch.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "pushback/common/world/measure.h"
#include "pushback/engine/half_step/gap.h"
#include "pushback/engine/half_step/half_step.h"

namespace pushback {

namespace {

/// Whether a line that turns keeps a shadow of it.
bool bounded(const Body& body) {
  return !std::holds_alternative<HalfSpace>(body.shape);
}

}  // namespace

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
  jerk_ = 6 * reach * fastest * (fastest * fastest * (1 + fastest * within) + angular.norm());
  little_ = within * std::sqrt(std::numeric_limits<Real>::epsilon());
}

/// All but its place, and the second half of what turns it faster.
Body Flight::turned_after(Real t) const {
  Body body = begin_;
  body.velocity.setZero();
  body.angular_velocity += t / 2 * angular_;
  drift(body, t);
  return body;
}

const Body& Flight::at(Real t) {
  time_ = t;
  if (turns_) {
    const Body turned = turned_after(t);
    moved_.orientation = turned.orientation;
    moved_.angular_velocity = turned.angular_velocity + t / 2 * angular_;
  }
  moved_.position = begin_.position + t * (begin_.velocity + t / 2 * linear_);
  return moved_;
}

/// The speed of a rotation in a step, which is not w, because the step rotates by 2 atan(w t / 2).
const std::vector<Flight::Corner>& Flight::look() {
  ++looks_;
  const Quat& q = moved_.orientation;
  const Quat later = turns_ ? turned_after(time_ + little_).orientation : q;
  const Vec3 velocity = this->velocity(), &w = moved_.angular_velocity;
  const Vec3 torque = q.conjugate() * spin_momentum(moved_).cross(w);
  const Vec3 turning = angular_ + q * Vec3(begin_.principal_inverse_inertia.cwiseProduct(torque));
  seen_.clear();
  for (const Vec3& corner : core_) {
    const Vec3 arm = q * corner;
    seen_.push_back({arm, velocity, linear_});
    if (!turns_) continue;
    seen_.back().velocity += (later * corner - arm) / little_;
    seen_.back().acceleration += turning.cross(arm) + w.cross(w.cross(arm));
  }
  return seen_;
}

Real first_root(Real d, Real c, Real a) {
  const Real discriminant = c * c - 2 * a * d;
  if (discriminant < 0 || (c >= 0 && a >= 0)) return std::numeric_limits<Real>::infinity();
  const Real root = std::sqrt(discriminant);
  return c < 0 ? 2 * d / (root - c) : (root + c) / -a;
}

namespace {

/// Where a corner is on a line, m, m/s and m/s^2.
struct Shadow {
  Real height, speed, acceleration;
};

/// The corners of two bodies, as A's position sees them.
class Approach {
 public:
  Approach(Flight& a, Flight& b, const Vec3& between, const Vec3& velocity)
      : corners_a_(a.look()), corners_b_(b.look()), between_(between), velocity_(velocity), of_a_(a.acceleration()) {
    slack_ = a.slack() + b.slack();
    bend_ = a.bend() + b.bend();
    jerk_ = a.jerk() + b.jerk();
    pulls_ = b.acceleration() - a.acceleration();
  }

  /// s: until then nothing touches, within `within` s, as the shadows on n are d apart, and do not meet. `turn`: how n turns, rad/s.
  Real free(const Vec3& n, Real d, const Vec3& turn, Real within) {
    look_along(corners_a_, Vec3::Zero(), n, turn, shadows_a_);
    look_along(corners_b_, between_, n, turn, shadows_b_);
    const auto lower = [](const Shadow& p, const Shadow& q) { return p.height < q.height; };
    const Real highest = std::max_element(shadows_a_.begin(), shadows_a_.end(), lower)->height,
               lowest = std::min_element(shadows_b_.begin(), shadows_b_.end(), lower)->height;
    const Real bend = turn.isZero(0) ? n.dot(pulls_) - bend_ : -std::numeric_limits<Real>::infinity();
    const Real changes = jerk(turn.norm(), within) * within / 3;
    Real free = std::numeric_limits<Real>::infinity();
    for (const Shadow& p : shadows_a_)
      for (const Shadow& q : shadows_b_)
        free = std::min(free, first_root(d + (highest - p.height) + (q.height - lowest), q.speed - p.speed - slack_,
                                         std::max(bend, q.acceleration - p.acceleration - changes)));
    return free;
  }

  /// rad/s: so n stays across the edge of each body that is nearest to the other, or 0 if they are parallel.
  Vec3 turn_of_edges(const Vec3& n) const {
    const auto [edge_a, spread_a] = edge(corners_a_, n);
    const auto [edge_b, spread_b] = edge(corners_b_, -n);
    const Vec3 across = edge_a.cross(edge_b);
    const Real volume = n.dot(across);
    if (!(std::abs(volume) > Real(1e-3) * edge_a.norm() * edge_b.norm())) return Vec3::Zero();
    // n' in the plane across n, with n' edge_a = -n spread_a and n' edge_b = -n spread_b
    const Vec3 n1 = (n.dot(spread_a) * n.cross(edge_b) - n.dot(spread_b) * n.cross(edge_a)) / volume;
    return n.cross(n1);
  }

 private:
  /// From the corner that lies farthest along n to the next one, and what their velocities differ by.
  static std::pair<Vec3, Vec3> edge(const std::vector<Flight::Corner>& corners, const Vec3& n) {
    const Flight::Corner *first = &corners[0], *second = nullptr;
    for (const Flight::Corner& at : corners) {
      if (&at == first) continue;
      if (n.dot(at.arm) > n.dot(first->arm)) second = std::exchange(first, &at);
      else if (!second || n.dot(at.arm) > n.dot(second->arm)) second = &at;
    }
    if (!second) return {Vec3::Zero(), Vec3::Zero()};
    return {second->arm - first->arm, second->velocity - first->velocity};
  }
  void look_along(const std::vector<Flight::Corner>& corners, const Vec3& from, const Vec3& n, const Vec3& turn,
                  std::vector<Shadow>& shadows) const {
    const Vec3 n1 = turn.cross(n), n2 = turn.cross(n1);
    shadows.clear();
    for (const auto& [arm, velocity, acceleration] : corners) {
      const Vec3 place = from + arm, speed = velocity - velocity_;
      shadows.push_back({n.dot(place), n.dot(speed) + n1.dot(place),
                         n.dot(acceleration - of_a_) + 2 * n1.dot(speed) + n2.dot(place)});
    }
  }
  /// m/s^3: the most by which the acceleration of a distance changes, if n turns at w rad/s.
  Real jerk(Real w, Real within) const {
    if (w == 0) return jerk_;
    Real accelerated = 0, fast = 0, far = 0;
    for (const auto* corners : {&corners_a_, &corners_b_}) {
      Vec3 most = Vec3::Zero();
      for (const auto& [arm, velocity, acceleration] : *corners)
        most = most.cwiseMax(Vec3((acceleration - of_a_).norm(), (velocity - velocity_).norm(), arm.norm()));
      accelerated += most[0], fast += most[1], far += most[2];
    }
    accelerated += jerk_ * within;
    fast += accelerated * within;
    far += between_.norm() + fast * within;
    return jerk_ + w * (3 * accelerated + w * (3 * fast + w * far));
  }

  const std::vector<Flight::Corner>&corners_a_, &corners_b_;
  Vec3 between_, velocity_, of_a_, pulls_;
  Real slack_, bend_, jerk_;
  std::vector<Shadow> shadows_a_, shadows_b_;
};

}  // namespace

std::optional<Real> first_touch(Flight& a, Flight& b, Real within, Real touching) {
  constexpr int most_rounds = 100;
  Real t = 0;
  for (int round = 0; round < most_rounds; ++round) {
    const Body &body_a = a.at(t), &body_b = b.at(t);
    const Gap gap = gap_between(body_a, body_b);
    if (round > 0 && gap.distance <= touching) return t;
    const Real d = std::max(gap.distance, Real(0)), left = within - t;
    Approach approach(a, b, body_b.position - body_a.position, a.velocity());
    Real free = approach.free(gap.normal, d, Vec3::Zero(), left);
    if (free < left && bounded(body_a) && bounded(body_b))
      for (const Vec3& turn : {body_a.angular_velocity, body_b.angular_velocity, approach.turn_of_edges(gap.normal)})
        if (!turn.isZero(0)) free = std::max(free, approach.free(gap.normal, d, turn, left));
    t += free;
    if (!(t < within)) return {};
  }
  return t;
}

}  // namespace pushback
