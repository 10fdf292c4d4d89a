#include "pushback/tools/methods/avbd.h"

#include <Eigen/Cholesky>
#include <Eigen/LU>

#include "pushback/chapters/01_velocity_constraint/row.h"
#include "pushback/chapters/01_velocity_constraint/rows_solved.h"
#include "pushback/tools/methods/plain_joints.h"

namespace pushback {

namespace {

/// J V.
Real speed(const Jacobian& j, const Body& a, const Body& b) {
  return j.n.dot(b.velocity - a.velocity) + j.rb_n.dot(b.angular_velocity) - j.ra_n.dot(a.angular_velocity);
}

}  // namespace

void Avbd::check(World& world, Real h) {
  check_plain_joints(world, h, "AVBD");
}

void Avbd::add_contacts(World& world, Real h) {
  const Real scale = world.impulse_scale(h) / h * error_kept * penalty_kept;  // of an impulse to a force
  auto old = world.contacts_before.begin();  // three lists ascend, so go through them in parallel
  auto known = known_.begin();
  for (const Contact& at : world.contacts) {
    while (old != world.contacts_before.end() && old->id < at.id) ++old;
    while (known != known_.end() && known->id < at.id) ++known;
    const bool warm = old != world.contacts_before.end() && old->id == at.id;
    const bool stiff = known != known_.end() && known->id == at.id;
    const auto [t1, t2] = tangents_of(at.normal);
    const auto [a, b] = world.bodies_of(at);
    Bond& bond = bonds_.emplace_back(Bond{a.index, b.index, true, at.friction, at.friction > 0 ? 3 : 1, {}});
    for (int i = 0; i < bond.rows; ++i) {
      const Vec3& n = i == 0 ? at.normal : i == 1 ? t1 : t2;
      Force& row = bond.forces[static_cast<std::size_t>(i)];
      row.jacobian = Jacobian::along(n, a, b, at.point);
      row.c0 = i > 0 ? 0 : at.depth > 0 ? -(1 - error_kept) * at.depth : -at.depth;
      row.unit = Row(world, at, n, 0).effective_mass / (h * h);
      row.k = (stiff ? std::clamp(penalty_kept * known->k[static_cast<std::size_t>(i)], least_penalty, most_penalty)
                     : least_penalty) *
              row.unit;
      row.lambda = warm ? scale * old->impulse.dot(n) : 0;
    }
  }
}

void Avbd::add_joints(World& world, Real h) {
  Equations equations;
  std::size_t index = 0;
  for (Joint& joint : world.joints) {
    Body &a = world.body(joint.a), &b = world.body(joint.b);
    equations.clear();
    joint.ask(a, b, {world.time, h}, equations);
    joint.impulses.resize(equations.size(), 0);
    joint.last_impulses.resize(equations.size(), 0);
    if (!a.movable() && !b.movable()) continue;
    for (std::size_t i = 0; i < equations.size(); ++i, ++index) {
      Bond& bond = bonds_.emplace_back(Bond{joint.a, joint.b, false, 0, 1, {}});
      Force& row = bond.forces[0];
      row.jacobian = equations[i].jacobian;
      row.c0 = (1 - error_kept) * equations[i].error;
      row.unit = Row(a, b, row.jacobian, 0).effective_mass / (h * h);
      if (index == known_joints_.size()) known_joints_.push_back(least_penalty);
      row.k = std::clamp(penalty_kept * known_joints_[index], least_penalty, most_penalty) * row.unit;
      row.lambda = world.impulse_scale(h) / h * error_kept * penalty_kept * joint.last_impulses[i];
    }
  }
}

void Avbd::answer(const World& world, Bond& bond, Real h) {
  const Body &a = world.body(bond.a), &b = world.body(bond.b);
  for (int i = 0; i < bond.rows; ++i) {
    Force& row = bond.forces[static_cast<std::size_t>(i)];
    row.c = row.c0 + h * speed(row.jacobian, a, b);
    row.f = row.lambda - row.k * row.c;
  }
  if (!bond.contact) return;
  Force& normal = bond.forces[0];
  normal.f = std::max(Real(0), normal.f);
  if (bond.rows == 1) return;
  Real &f1 = bond.forces[1].f, &f2 = bond.forces[2].f;
  const Real length = std::hypot(f1, f2), radius = bond.friction * normal.f;
  bond.sticks = length <= radius;
  if (!bond.sticks) f1 *= radius / length, f2 *= radius / length;
}

void Avbd::descend(World& world, int body, const Vec3& velocity, const Vec3& angular_velocity, Real h) {
  using Vec6 = Eigen::Matrix<Real, 6, 1>;
  using Mat6 = Eigen::Matrix<Real, 6, 6>;
  Body& own = world.body(body);
  const Mat3 inertia = own.inverse_inertia.inverse();
  Mat6 system = Mat6::Zero();
  system.diagonal().head<3>().setConstant(1 / own.inverse_mass);
  system.bottomRightCorner<3, 3>() = inertia;
  Vec6 rest;
  rest << (velocity - own.velocity) / own.inverse_mass, inertia * (angular_velocity - own.angular_velocity);
  for (const std::size_t index : of_[static_cast<std::size_t>(body)]) {
    Bond& bond = bonds_[index];
    answer(world, bond, h);
    for (int i = 0; i < bond.rows; ++i) {
      const Force& row = bond.forces[static_cast<std::size_t>(i)];
      Vec6 j;
      if (bond.a == body) j << -row.jacobian.n, -row.jacobian.ra_n;
      else j << row.jacobian.n, row.jacobian.rb_n;
      rest += h * row.f * j;
      system += h * h * row.k * j * j.transpose();
    }
    rows_solved += static_cast<std::size_t>(bond.rows);
  }
  const Vec6 change = system.ldlt().solve(rest);
  own.velocity += change.head<3>();
  own.angular_velocity += change.tail<3>();
}

void Avbd::raise(Bond& bond) {
  const auto grow = [](Force& row) {
    row.k = std::min(row.k + growth * std::abs(row.c) * row.unit, most_penalty * row.unit);
  };
  for (int i = 0; i < bond.rows; ++i)
    bond.forces[static_cast<std::size_t>(i)].lambda = bond.forces[static_cast<std::size_t>(i)].f;
  Force& first = bond.forces[0];
  if (!bond.contact || first.f > 0) grow(first);
  if (!bond.sticks) return;
  grow(bond.forces[1]);
  grow(bond.forces[2]);
}

void Avbd::solve(World& world, Real h, int sweeps) {
  bonds_.clear();
  add_contacts(world, h);
  const std::size_t contacts = bonds_.size();
  add_joints(world, h);
  of_.assign(world.bodies.size(), {});
  for (std::size_t i = 0; i < bonds_.size(); ++i)
    for (const int body : {bonds_[i].a, bonds_[i].b})
      if (body != the_world && world.body(body).movable()) of_[static_cast<std::size_t>(body)].push_back(i);
  std::vector<std::pair<Vec3, Vec3>> free;  // V*
  for (const Body& body : world.bodies) free.emplace_back(body.velocity, body.angular_velocity);
  for (int sweep = 0; sweep < sweeps; ++sweep) {
    for (std::size_t body = 0; body < of_.size(); ++body)
      if (!of_[body].empty()) descend(world, static_cast<int>(body), free[body].first, free[body].second, h);
    for (Bond& bond : bonds_) {
      answer(world, bond, h);
      raise(bond);
    }
  }
  known_.clear();
  for (std::size_t i = 0; i < contacts; ++i) {
    const auto& forces = bonds_[i].forces;
    Contact& at = world.contacts[i];
    at.impulse.setZero();
    Penalties k{};
    for (std::size_t row = 0; row < static_cast<std::size_t>(bonds_[i].rows); ++row) {
      at.impulse += h * forces[row].lambda * forces[row].jacobian.n;
      k[row] = forces[row].k / forces[row].unit;
    }
    known_.push_back({at.id, k});
  }
  std::size_t bond = contacts, index = 0;
  for (Joint& joint : world.joints) {
    if (!world.body(joint.a).movable() && !world.body(joint.b).movable()) continue;
    for (std::size_t i = 0; i < joint.impulses.size(); ++i) {
      const Force& row = bonds_[bond++].forces[0];
      joint.last_impulses[i] = h * row.lambda;
      joint.impulses[i] += joint.last_impulses[i];
      known_joints_[index++] = row.k / row.unit;
    }
  }
}

}  // namespace pushback
