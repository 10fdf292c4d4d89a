#include "pushback/chapters/13_joints/flat.h"

#include <algorithm>
#include <cmath>

namespace pushback::flat_13 {

namespace {

/// M^-1 J^T and K, of J.
void weigh(Row& row) {
  const Body &a = *row.a, &b = *row.b;
  row.dva = -a.inverse_mass * row.n;
  row.dwa = -a.inverse_inertia * row.ra_n;
  row.dvb = b.inverse_mass * row.n;
  row.dwb = b.inverse_inertia * row.rb_n;
  // K = 1/m_A + 1/m_B + (r_A x n) . I_A^-1 (r_A x n) + (r_B x n) . I_B^-1 (r_B x n)
  const Real linear = row.n.isZero(0) ? 0 : a.inverse_mass + b.inverse_mass;  // 13: 0 for angular equations
  row.effective_mass = 1 / (linear + row.rb_n.dot(row.dwb) - row.ra_n.dot(row.dwa));
}

/// A row of a contact along a direction: unit, world axes.
Row row_of(World& world, std::size_t contact, const Vec3& direction) {
  const Contact& c = world.contacts[contact];
  const auto [a, b] = world.bodies_of(c);
  Row row;
  row.contact = contact;
  row.a = &a;
  row.b = &b;
  row.n = direction;
  row.ra_n = (c.point - a.position).cross(direction);
  row.rb_n = (c.point - b.position).cross(direction);
  row.apart = b.position - a.position;
  weigh(row);
  return row;
}

/// 13: the row of an equation.   C' = J V + b
void place(Row& row, const Equation& equation) {
  row.n = equation.jacobian.n;
  row.ra_n = equation.jacobian.ra_n;
  row.rb_n = equation.jacobian.rb_n;
  weigh(row);
  row.bias = equation.bias;
}

/// J V, m/s: how fast B moves away from A along the row's direction, at the contact point.
Real speed(const Row& row) {
  return row.n.dot(row.b->velocity - row.a->velocity) +
         (row.rb_n.dot(row.b->angular_velocity) - row.ra_n.dot(row.a->angular_velocity));
}

/// Brings sum(lambda) to `total`, or as near as the limits let it.   V += M^-1 J^T lambda
void reach(Row& row, Real total) {
  // 02: the sum is clamped, not each lambda: a later sweep can take back what was too much.
  if (total < row.lo || total > row.hi) [[unlikely]]
    total = total < row.lo ? row.lo : row.hi;
  const Real lambda = total - row.impulse;  // what the sum gains after rounding is what the bodies get
  row.impulse = total;
  row.a->velocity += lambda * row.dva;
  row.a->angular_velocity += lambda * row.dwa;
  row.b->velocity += lambda * row.dvb;
  row.b->angular_velocity += lambda * row.dwb;
}

/// 08: both tangents take steps of the same size, 1 / k: only then is friction opposite to the slip where nothing
/// changes any more.   k: the larger eigenvalue of their 2 x 2 block of J M^-1 J^T
Real step_size(const Row& one, const Row& two) {
  const Real k11 = 1 / one.effective_mass, k22 = 1 / two.effective_mass;
  const Real k12 = two.n.dot(one.dvb - one.dva) + two.rb_n.dot(one.dwb) - two.ra_n.dot(one.dwa);
  return 1 / ((k11 + k22) / 2 + std::hypot((k11 - k22) / 2, k12));
}

/// J V + b + gamma sum(lambda) = 0.   lambda = -(J V + b + gamma sum(lambda)) / (K + gamma)
void solve_alone(Row& row) {
  const Real lambda = -row.effective_mass * (speed(row) + (row.bias + row.softness * row.impulse));
  reach(row, row.impulse + lambda);
}

/// 12: the bodies have moved past each other, and one impulse has to act on both at one point, or it turns the pair.
/// r_A x n - r_B x n = (x_B - x_A) x n. What that has changed by the arms share: the body that turns less gets more of
/// it, so J V stays, and a rolling body is not braked.
void carry(Row& row) {
  const Vec3 apart = row.b->position - row.a->position;
  const Vec3 m = (apart - row.apart).cross(row.n);
  const Real of_a = std::abs(m.dot(row.a->angular_velocity)), of_b = std::abs(m.dot(row.b->angular_velocity));
  const Real inverse_masses = row.a->inverse_mass + row.b->inverse_mass;
  const Real s = of_a + of_b > 0 ? of_b / (of_a + of_b) : row.b->inverse_mass / inverse_masses;
  row.ra_n += s * m;
  row.rb_n -= (1 - s) * m;
  row.apart = apart;
  weigh(row);
}

}  // namespace

void FlatSolver::solve(World& world, Real dt, int sweeps) {
  make_rows(world);
  add_springs(dt);
  make_joint_rows(world, dt);
  guess_impulses(world, dt);
  sweep(world.contacts, sweeps);
  keep_impulses(world.contacts);
}

void FlatSolver::make_rows(World& world) {
  Contacts& contacts = world.contacts;

  normals_.clear();
  tangents_.clear();
  step_sizes_.clear();
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    const Contact& c = contacts[i];
    // 01: a row along the normal
    normals_.push_back(row_of(world, i, c.normal));

    // 02: contacts push and never pull.   sum(lambda) in [0, inf)
    Row& normal = normals_.back();
    normal.lo = 0;
    normal.separation = -c.depth;  // 12

    // 05: the bounce, from the velocities before gravity and impulses.   b = e v_n
    const auto [a, b] = world.bodies_of(c);
    const Vec3 va = a.velocity_before + a.angular_velocity_before.cross(c.point - a.position);
    const Vec3 vb = b.velocity_before + b.angular_velocity_before.cross(c.point - b.position);
    const Real approach = (vb - va).dot(c.normal);
    if (approach < -threshold) normal.bias = std::min(normal.bias, c.restitution * approach);
    normal.bounce = normal.bias;  // 12

    // 06: two rows along tangents, where the pair has friction
    if (c.friction == 0) continue;
    const auto [tangent1, tangent2] = tangents_of(c.normal);
    tangents_.push_back(row_of(world, i, tangent1));
    tangents_.push_back(row_of(world, i, tangent2));
    step_sizes_.push_back(step_size(tangents_.end()[-2], tangents_.back()));  // 08
  }
}

/// 12: an overlap is a spring with a damper.   w = 2 pi hertz,  k = w^2 / K,  c = 2 zeta w / K,  where 1/K cancels
void FlatSolver::add_springs(Real dt) {
  const Real w = 2 * pi * std::min(hertz, 1 / (8 * dt));                // no stiffer than eight steps to an oscillation
  const Real push_out_rate = w / (2 * damping_ratio + dt * w);          // k / (c + h k)
  const Real gamma_by_K = 1 / (dt * w * (2 * damping_ratio + dt * w));  // gamma / K,  gamma = 1 / (h (c + h k))
  for (Row& normal : normals_) {
    // The push-out.   b = k / (c + h k) C
    if (normal.separation < 0 && normal.bias == 0) {
      const Real push_out = push_out_rate * normal.separation;
      normal.bias = std::max(push_out, -fastest_push_out);
      if (push_out >= -fastest_push_out) {  // else rigid: a spring that may not push harder would sink for ever
        normal.softness = gamma_by_K / normal.effective_mass;
        normal.effective_mass /= 1 + gamma_by_K;  // 1 / (K + gamma)
      }
    }
  }
}

/// 13: a row for each equation of each joint.   J V + b + gamma lambda = 0,   b = b_C + (beta / h) C
void FlatSolver::make_joint_rows(World& world, Real dt) {
  joints_.clear();
  equations_.clear();
  for (const Joint& joint : world.joints) {
    Row row;
    row.a = &world.body(joint.a);
    row.b = &world.body(joint.b);
    joint.ask(*row.a, *row.b, {world.time, dt}, equations_);
    while (joints_.size() < equations_.size()) {
      const Equation& equation = equations_[joints_.size()];
      place(row, equation);
      row.bias += joint_beta / dt * equation.error;
      row.softness = equation.softness;
      row.effective_mass /= 1 + row.softness * row.effective_mass;  // 1 / (K + gamma)
      row.lo = dt * equation.lo;                                    // the equation's limits are forces
      row.hi = dt * equation.hi;
      joints_.push_back(row);
    }
  }
}

/// 07: warm start: the initial guess is the impulse of the same point one step before. Both lists ascend by id, so one
/// walk along both finds the pairs.
void FlatSolver::guess_impulses(World& world, Real dt) {
  Contacts& contacts = world.contacts;
  auto old = world.contacts_before.begin();
  for (Contact& c : contacts) {
    while (old != world.contacts_before.end() && old->id < c.id) ++old;
    c.impulse.setZero();
    if (old != world.contacts_before.end() && old->id == c.id) c.impulse = world.impulse_scale(dt) * old->impulse;
  }
  for (Row& row : normals_) reach(row, contacts[row.contact].impulse.dot(row.n));
  for (Row& row : tangents_) reach(row, contacts[row.contact].impulse.dot(row.n));
}

/// 12: the push-out has moved the bodies. Its speed, if it stayed, would be energy fed in: so one more sweep with rows
/// that are rigid, and do not push out.
void FlatSolver::after_move(World& world, Real dt) {
  for (Row& row : normals_) {
    carry(row);
    row.bias = row.bounce;
    row.softness = 0;
  }
  for (Row& row : tangents_) carry(row);
  for (std::size_t t = 0; t < tangents_.size(); t += 2) step_sizes_[t / 2] = step_size(tangents_[t], tangents_[t + 1]);
  // 13: joints likewise, but not springs, because the speed that they add is intended
  equations_.clear();
  for (const Joint& joint : world.joints)
    joint.ask(world.body(joint.a), world.body(joint.b), {world.time, dt}, equations_);
  for (std::size_t i = 0; i < joints_.size(); ++i)
    if (joints_[i].softness == 0) place(joints_[i], equations_[i]);
  sweep(world.contacts, 1);
  keep_impulses(world.contacts);
}

void FlatSolver::sweep(const Contacts& contacts, int sweeps) {
  // Sequential Impulses: one row after the other, each as if it were alone, over and over.
  for (int sweep = 0; sweep < sweeps; ++sweep) {
    for (Row& row : normals_) solve_alone(row);
    for (Row& row : joints_) solve_alone(row);
    // 06: friction stops the slip, as far as the normal impulse lets it.
    // 08: the two sums together stay within a disc.   |(sum(lambda_1), sum(lambda_2))| <= mu sum(lambda_n)
    for (std::size_t t = 0; t < tangents_.size(); t += 2) {
      Row &one = tangents_[t], &two = tangents_[t + 1];
      const Real bound = contacts[one.contact].friction * normals_[one.contact].impulse;
      Real total1 = one.impulse - step_sizes_[t / 2] * speed(one);  // both read V before either changes it
      Real total2 = two.impulse - step_sizes_[t / 2] * speed(two);
      const Real squared = total1 * total1 + total2 * total2;
      if (squared > bound * bound) [[unlikely]] {  // outside the disc: back to its edge, towards the centre
        const Real kept = bound / std::sqrt(squared);
        total1 *= kept;
        total2 *= kept;
      }
      reach(one, total1);
      reach(two, total2);
    }
  }
}

void FlatSolver::keep_impulses(Contacts& contacts) {
  // Each contact keeps its impulse.
  for (Contact& c : contacts) c.impulse.setZero();
  for (const Row& row : normals_) contacts[row.contact].impulse += row.impulse * row.n;
  for (const Row& row : tangents_) contacts[row.contact].impulse += row.impulse * row.n;
}

}  // namespace pushback::flat_13
