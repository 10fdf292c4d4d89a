#include "pushback/tools/methods/avbd.h"

#include <Eigen/Cholesky>
#include <Eigen/LU>

#include "pushback/chapters/01_velocity_constraint/row.h"
#include "pushback/chapters/01_velocity_constraint/rows_solved.h"
#include "pushback/chapters/10_position_correction/displace.h"
#include "pushback/tools/methods/plain_joints.h"

namespace pushback {

namespace {

/// J V.
Real speed(const Jacobian& j, const Body& a, const Body& b) {
  return j.n.dot(b.velocity - a.velocity) + j.rb_n.dot(b.angular_velocity) - j.ra_n.dot(a.angular_velocity);
}

/// J of one of the two bodies.
Eigen::Matrix<Real, 6, 1> of_side(const Jacobian& j, bool is_a) {
  Eigen::Matrix<Real, 6, 1> side;
  if (is_a) side << -j.n, -j.ra_n;
  else side << j.n, j.rb_n;
  return side;
}

void place(Body& body, const Vec3& position, const Quat& orientation) {
  body.position = position;
  body.orientation = orientation;
  body.refresh_inertia();
}

/// To where its velocities lead from there, which stay.
void lead(Body& body, const Vec3& position, const Quat& orientation, Real h) {
  const Vec3 spin = body.angular_velocity;
  place(body, position, orientation);
  move(body, h);
  body.angular_velocity = spin;
}

/// The slope that a force has on average, which changed by so much over c instead of by k c.
Real secant(Real change, Real c, Real k) {
  return c != 0 ? std::min(k, std::abs(change / c)) : k;
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
    bonds_.push_back({a.index, b.index, forces_.size(), at.friction > 0 ? 3u : 1u, nullptr, at.friction});
    for (std::size_t i = 0; i < bonds_.back().rows; ++i) {
      const Vec3& n = i == 0 ? at.normal : i == 1 ? t1 : t2;
      Force& row = forces_.emplace_back();
      row.jacobian = Jacobian::along(n, a, b, at.point);
      row.c0 = i > 0 ? 0 : at.depth > 0 ? -(1 - error_kept) * at.depth : -at.depth;
      row.unit = Row(world, at, n, 0).effective_mass / (h * h);
      row.k = (stiff ? std::clamp(penalty_kept * known->k[i], least_penalty, most_penalty) : least_penalty) * row.unit;
      row.lambda = warm ? scale * old->impulse.dot(n) : 0;
    }
  }
}

void Avbd::add_joints(World& world, Real h) {
  bends_.clear();
  for (Joint& joint : world.joints) {
    Body &a = world.body(joint.a), &b = world.body(joint.b);
    equations_.clear();
    joint.ask(a, b, {world.time, h}, equations_);
    joint.impulses.resize(equations_.size(), 0);
    joint.last_impulses.resize(equations_.size(), 0);
    if (!a.movable() && !b.movable()) continue;
    bonds_.push_back({joint.a, joint.b, forces_.size(), equations_.size(), &joint});
    for (std::size_t i = 0; i < equations_.size(); ++i) {
      const std::size_t index = bends_.size();
      Force& row = forces_.emplace_back();
      row.jacobian = equations_[i].jacobian;
      row.c0 = error_kept * equations_[i].error;
      row.unit = Row(a, b, row.jacobian, 0).effective_mass / (h * h);
      if (index == known_joints_.size()) known_joints_.push_back(least_penalty);
      row.k = std::clamp(penalty_kept * known_joints_[index], least_penalty, most_penalty) * row.unit;
      row.lambda = world.impulse_scale(h) / h * error_kept * penalty_kept * joint.last_impulses[i];
      bends_.push_back({Vec6::Zero(), Vec6::Zero()});
    }
    bend(world, bonds_.back(), h);
  }
}

/// By small displacements of either body, to each of six sides.
void Avbd::bend(World& world, const Bond& bond, Real h) {
  constexpr Real small = Real(1e-3);  // m or rad
  const std::size_t first = bends_.size() - bond.rows;
  for (const int side : {0, 1}) {
    Body& body = world.body(side == 0 ? bond.a : bond.b);
    if (!body.movable()) continue;
    const Vec3 position = body.position;
    const Quat orientation = body.orientation;
    for (int way = 0; way < 6; ++way) {
      Vec6 moved = Vec6::Zero();
      moved[way] = small;
      displace(body, moved.head<3>(), moved.tail<3>());
      equations_.clear();
      bond.joint->ask(world.body(bond.a), world.body(bond.b), {world.time, h}, equations_);
      place(body, position, orientation);
      for (std::size_t i = 0; i < bond.rows; ++i)
        bends_[first + i][static_cast<std::size_t>(side)][way] =
            (of_side(equations_[i].jacobian, side == 0) - of_side(rows_of(bond)[i].jacobian, side == 0)).norm() / small;
    }
  }
}

void Avbd::begin(World& world, Real h) {
  of_.assign(world.bodies.size(), {});
  starts_.clear();
  for (const Body& body : world.bodies)
    starts_.push_back({body.velocity, body.angular_velocity,
                       body.movable() ? Mat3(body.inverse_inertia.inverse()) : Mat3(Mat3::Zero()), body.position,
                       body.orientation});
  for (std::size_t i = 0; i < bonds_.size(); ++i)
    for (const int body : {bonds_[i].a, bonds_[i].b}) {
      if (body == the_world || !world.body(body).movable()) continue;
      of_[static_cast<std::size_t>(body)].push_back(i);
      starts_[static_cast<std::size_t>(body)].joined |= bonds_[i].joint != nullptr;
    }
  const bool known = velocities_before_.size() == world.bodies.size() && world.dt_before > 0;
  for (std::size_t i = 0; i < world.bodies.size(); ++i) {
    Body& body = world.bodies[i];
    if (of_[i].empty()) continue;
    const Vec3 gained =
        known ? Vec3(h / world.dt_before * (body.velocity_before - velocities_before_[i])) : Vec3::Zero();
    const Vec3 forces = body.velocity - body.velocity_before;
    const Real squared = forces.squaredNorm();
    if (squared > 0)
      body.velocity = body.velocity_before + std::clamp(gained.dot(forces) / squared, Real(0), Real(1)) * forces;
    if (starts_[i].joined) lead(body, starts_[i].position, starts_[i].orientation, h);
  }
  velocities_before_.clear();
  for (const Body& body : world.bodies) velocities_before_.push_back(body.velocity_before);
}

void Avbd::answer(const World& world, Bond& bond, Real h) {
  const Body &a = world.body(bond.a), &b = world.body(bond.b);
  const auto rows = rows_of(bond);
  if (bond.joint != nullptr) {
    equations_.clear();
    bond.joint->ask(a, b, {world.time, h}, equations_);
  }
  for (std::size_t i = 0; i < rows.size(); ++i) {
    Force& row = rows[i];
    if (bond.joint != nullptr) row.jacobian = equations_[i].jacobian;
    row.c = bond.joint != nullptr ? equations_[i].error - row.c0 : row.c0 + h * speed(row.jacobian, a, b);
    row.f = row.lambda - row.k * row.c;
    row.stiffness = row.k;
  }
  if (bond.joint != nullptr) return;
  Force& normal = rows[0];
  if (normal.f < 0) {
    normal.f = 0;
    normal.stiffness = secant(normal.lambda, normal.c, normal.k);
  }
  if (rows.size() == 1) return;
  Force &one = rows[1], &two = rows[2];
  const Real length = std::hypot(one.f, two.f), radius = bond.friction * normal.f;
  bond.sticks = length <= radius;
  if (bond.sticks) return;
  one.f *= radius / length, two.f *= radius / length;
  const Real change = std::hypot(one.f - one.lambda, two.f - two.lambda), slip = std::hypot(one.c, two.c);
  one.stiffness = secant(change, slip, one.k);
  two.stiffness = secant(change, slip, two.k);
}

void Avbd::descend(World& world, std::size_t body, Real h) {
  using Mat6 = Eigen::Matrix<Real, 6, 6>;
  Body& own = world.bodies[body];
  const Start& start = starts_[body];
  Mat6 system = Mat6::Zero();
  system.diagonal().head<3>().setConstant(1 / own.inverse_mass);
  system.bottomRightCorner<3, 3>() = start.inertia;
  Vec6 rest;
  rest << (start.velocity - own.velocity) / own.inverse_mass,
      start.inertia * (start.angular_velocity - own.angular_velocity);
  for (const std::size_t index : of_[body]) {
    Bond& bond = bonds_[index];
    answer(world, bond, h);
    const bool is_a = bond.a == own.index;
    const auto rows = rows_of(bond);
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const Vec6 j = of_side(rows[i].jacobian, is_a);
      rest += h * rows[i].f * j;
      system += h * h * rows[i].stiffness * j * j.transpose();
      if (bond.joint != nullptr)
        system.diagonal() += h * h * std::abs(rows[i].f) * bends_[bond.first + i - contact_rows_][is_a ? 0 : 1];
    }
    rows_solved += rows.size();
  }
  const Vec6 change = system.ldlt().solve(rest);
  own.velocity += change.head<3>();
  own.angular_velocity += change.tail<3>();
  if (start.joined) lead(own, start.position, start.orientation, h);
}

void Avbd::raise(Bond& bond) {
  const auto grow = [](Force& row) {
    row.k = std::min(row.k + growth * std::abs(row.c) * row.unit, most_penalty * row.unit);
  };
  const auto rows = rows_of(bond);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    rows[i].lambda = rows[i].f;
    if (bond.joint != nullptr || (i == 0 ? rows[i].f > 0 : bond.sticks)) grow(rows[i]);
  }
}

void Avbd::store(World& world, Real h) {
  known_.clear();
  for (std::size_t i = 0; i < world.contacts.size(); ++i) {
    const auto rows = rows_of(bonds_[i]);
    Contact& at = world.contacts[i];
    at.impulse.setZero();
    Penalties k{};
    for (std::size_t row = 0; row < rows.size(); ++row) {
      at.impulse += h * rows[row].lambda * rows[row].jacobian.n;
      k[row] = rows[row].k / rows[row].unit;
    }
    known_.push_back({at.id, k});
  }
  std::size_t index = contact_rows_;
  for (Joint& joint : world.joints) {
    if (!world.body(joint.a).movable() && !world.body(joint.b).movable()) continue;
    for (std::size_t i = 0; i < joint.impulses.size(); ++i, ++index) {
      joint.last_impulses[i] = h * forces_[index].lambda;
      joint.impulses[i] += joint.last_impulses[i];
      known_joints_[index - contact_rows_] = forces_[index].k / forces_[index].unit;
    }
  }
}

void Avbd::solve(World& world, Real h, int sweeps) {
  bonds_.clear();
  forces_.clear();
  add_contacts(world, h);
  contact_rows_ = forces_.size();
  add_joints(world, h);
  begin(world, h);
  for (int sweep = 0; sweep < sweeps; ++sweep) {
    for (std::size_t body = 0; body < of_.size(); ++body)
      if (!of_[body].empty()) descend(world, body, h);
    for (Bond& bond : bonds_) {
      answer(world, bond, h);
      raise(bond);
    }
  }
  for (std::size_t body = 0; body < of_.size(); ++body)
    if (starts_[body].joined) place(world.bodies[body], starts_[body].position, starts_[body].orientation);
  store(world, h);
}

}  // namespace pushback
