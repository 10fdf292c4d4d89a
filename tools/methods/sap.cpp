#include "pushback/tools/methods/sap.h"

#include <Eigen/LU>
#include <numbers>

#include "pushback/chapters/01_velocity_constraint/row.h"
#include "pushback/common/basics/input.h"

namespace pushback {

namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

SapProblem::Vec6 velocities_of(const Vec3& velocity, const Vec3& spin) {
  SapProblem::Vec6 v;
  v << velocity.cast<double>(), spin.cast<double>();
  return v;
}

/// How a push on a contact moves its two points apart, 1/kg, where r leads from the body to the contact.
Matrix3d mobility(const Body& body, const Vec3& r) {
  const Mat3 cross = skew(r);
  return (body.inverse_mass * Mat3::Identity() - cross * body.inverse_inertia * cross).cast<double>();
}

/// The velocity of the body's point at r.
SapProblem::Contact::Jacobian point_at(const Vec3& r) {
  SapProblem::Contact::Jacobian j;
  j << Matrix3d::Identity(), -skew(r).cast<double>();
  return j;
}

}  // namespace

void Sap::check(World&, Real) {
  require_positive("period of contacts", period);
}

double Sap::rigid() const {
  return static_cast<double>(period * period) / (4 * std::numbers::pi * std::numbers::pi);
}

int Sap::place_of(const Body& body) {
  if (!body.movable()) return SapProblem::nothing_moves;
  int& place = places_[static_cast<std::size_t>(body.index)];
  if (place != SapProblem::nothing_moves) return place;
  SapProblem::Mat6 mass = SapProblem::Mat6::Zero();
  mass.diagonal().head<3>().setConstant(1 / static_cast<double>(body.inverse_mass));
  mass.bottomRightCorner<3, 3>() = body.inverse_inertia.cast<double>().inverse();
  taken_.push_back(body.index);
  return place = problem_.add(mass, velocities_of(body.velocity, body.angular_velocity));
}

template <class Bond, class Law>
void Sap::tie(std::vector<Bond>& bonds, const Body& a, const Body& b, const typename Bond::Jacobian& j_a,
              const typename Bond::Jacobian& j_b, const Law& law) {
  typename Bond::Rows rest = Bond::Rows::Zero();
  if (!a.movable()) rest += j_a * velocities_of(a.velocity, a.angular_velocity);
  if (!b.movable()) rest += j_b * velocities_of(b.velocity, b.angular_velocity);
  bonds.push_back({place_of(a), place_of(b), j_a, j_b, rest, law});
}

void Sap::add_contacts(const World& world, Real h) {
  const double feedback = 1 / static_cast<double>(h + tau(h));
  for (const Contact& at : world.contacts) {
    const auto [a, b] = world.bodies_of(at);
    const Vec3 r_a = at.point - a.position, r_b = at.point - b.position;
    const double w = (mobility(a, r_a) + mobility(b, r_b)).norm() / 3;
    SapContactLaw law{.n = at.normal.cast<double>(),
                      .mu = static_cast<double>(at.friction),
                      .r_t = slip * w,
                      .r_n = rigid() * w,
                      .wanted = feedback * static_cast<double>(at.depth)};
    if (lagged) {
      const Vec3 u = b.velocity_before + b.angular_velocity_before.cross(r_b) - a.velocity_before -
                     a.angular_velocity_before.cross(r_a);
      const double opening = feedback * static_cast<double>(tau(h) * u.dot(at.normal));
      law.lagged = at.depth > 0 ? std::max(0.0, law.wanted - opening) / law.r_n : 0;
      law.slow = std::max(slow, law.mu * law.r_t * *law.lagged);
    }
    tie(problem_.contacts, a, b, -point_at(r_a), point_at(r_b), law);
  }
}

void Sap::add_joints(World& world, Real h) {
  Equations equations;
  for (Joint& joint : world.joints) {
    Body &a = world.body(joint.a), &b = world.body(joint.b);
    equations.clear();
    joint.ask(a, b, {world.time, h}, equations);
    joint.impulses.resize(equations.size(), 0);
    if (!a.movable() && !b.movable()) continue;
    for (const Equation& one : equations) {
      const Jacobian& j = one.jacobian;
      const double w = 1 / static_cast<double>(Row(a, b, j, 0).effective_mass);
      tie(problem_.rows, a, b, -velocities_of(j.n, j.ra_n).transpose(), velocities_of(j.n, j.rb_n).transpose(),
          SapRowLaw{.r = one.softness > 0 ? static_cast<double>(one.softness) : rigid() * w,
                    .wanted = static_cast<double>(-one.error / (h + tau(h)) - one.bias),
                    .lo = static_cast<double>(h * one.lo),
                    .hi = static_cast<double>(h * one.hi)});
    }
  }
}

SapProblem::Vector Sap::start(const World& world) const {
  SapProblem::Vector before(problem_.free().size());
  for (std::size_t i = 0; i < taken_.size(); ++i) {
    const Body& body = world.body(taken_[i]);
    before.segment<6>(6 * static_cast<Eigen::Index>(i)) =
        velocities_of(body.velocity_before, body.angular_velocity_before);
  }
  return problem_.cost(before) < problem_.cost(problem_.free()) ? before : problem_.free();
}

void Sap::write(World& world, const SapProblem::Vector& v) const {
  for (std::size_t i = 0; i < taken_.size(); ++i) {
    Body& body = world.body(taken_[i]);
    const SapProblem::Vec6 its = v.segment<6>(6 * static_cast<Eigen::Index>(i));
    body.velocity = its.head<3>().cast<Real>();
    body.angular_velocity = its.tail<3>().cast<Real>();
  }
  for (std::size_t i = 0; i < world.contacts.size(); ++i) {
    const SapProblem::Contact& bond = problem_.contacts[i];
    const Vector3d u = bond.along(v) + bond.rest;
    world.contacts[i].impulse = bond.law.at(u).impulse.cast<Real>();
    world.contacts[i].state = bond.law.sticks(u) ? ContactState::sticking : ContactState::sliding;
  }
  auto row = problem_.rows.begin();
  for (Joint& joint : world.joints) {
    if (!world.body(joint.a).movable() && !world.body(joint.b).movable()) continue;
    for (Real& impulse : joint.impulses) {
      impulse += static_cast<Real>(row->law.at(row->along(v) + row->rest).impulse[0]);
      ++row;
    }
  }
}

void Sap::solve(World& world, Real h, int /*sweeps*/) {
  problem_.clear();
  places_.assign(world.bodies.size(), SapProblem::nothing_moves);
  taken_.clear();
  add_contacts(world, h);
  add_joints(world, h);
  SapProblem::Vector v = start(world);
  problem_.minimise(v, tolerance, most_steps);
  write(world, v);
}

}  // namespace pushback
