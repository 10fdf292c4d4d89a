#include "pushback/chapters/10_position_correction/flat.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace pushback::flat_10 {

namespace {

/// M^-1 J^T and K, of J.
void weigh(Row& row) {
  const Body &a = *row.a, &b = *row.b;
  row.dva = -a.inverse_mass * row.n;
  row.dwa = -a.inverse_inertia * row.ra_n;
  row.dvb = b.inverse_mass * row.n;
  row.dwb = b.inverse_inertia * row.rb_n;
  // K = 1/m_A + 1/m_B + (r_A x n) . I_A^-1 (r_A x n) + (r_B x n) . I_B^-1 (r_B x n)
  row.effective_mass = 1 / (a.inverse_mass + b.inverse_mass + row.rb_n.dot(row.dwb) - row.ra_n.dot(row.dwa));
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
  weigh(row);
  return row;
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

}  // namespace

void FlatSolver::solve(World& world, Real dt, int sweeps) {
  make_rows(world);
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

    // 04: a little overlap is left alone, so that contacts survive.   C = min(0, -depth + slop)
    normal.separation = std::min(Real(0), -c.depth + slop);

    // 05: the bounce, from the velocities before gravity and impulses.   b = e v_n
    const auto [a, b] = world.bodies_of(c);
    const Vec3 va = a.velocity_before + a.angular_velocity_before.cross(c.point - a.position);
    const Vec3 vb = b.velocity_before + b.angular_velocity_before.cross(c.point - b.position);
    const Real approach = (vb - va).dot(c.normal);
    if (approach < -threshold) normal.bias = std::min(normal.bias, c.restitution * approach);

    // 06: two rows along tangents, where the pair has friction
    if (c.friction == 0) continue;
    const auto [tangent1, tangent2] = tangents_of(c.normal);
    tangents_.push_back(row_of(world, i, tangent1));
    tangents_.push_back(row_of(world, i, tangent2));
    step_sizes_.push_back(step_size(tangents_.end()[-2], tangents_.back()));  // 08
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

void FlatSolver::sweep(const Contacts& contacts, int sweeps) {
  // Sequential Impulses: one row after the other, each as if it were alone, over and over.
  for (int sweep = 0; sweep < sweeps; ++sweep) {
    // 01: J V + b = 0.   lambda = -(J V + b) / K
    for (Row& row : normals_) {
      const Real lambda = -row.effective_mass * (speed(row) + row.bias);
      reach(row, row.impulse + lambda);
    }
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

/// 10: the bodies have moved, and velocities are what they are. The normals once more, for pseudo-velocities V' that begin
/// at 0, move the bodies, and are forgotten.   J V' + b' = 0,   b' = (beta / h) min(0, C + h J V)
void FlatSolver::after_move(World& world, Real dt) {
  for (Row& row : normals_) {
    row.impulse = 0;
    row.bias = 0;
    if (row.separation == 0) continue;
    // 03: the part beta of the overlap that is left should be gone after this step.
    const Real left = std::min(Real(0), row.separation + dt * speed(row));
    row.bias = std::max(beta * left, -most) / dt;
  }
  velocities_.clear();
  for (Body& body : world.bodies) {
    velocities_.emplace_back(body.velocity, body.angular_velocity);
    body.velocity.setZero();
    body.angular_velocity.setZero();
  }
  for (int round = 0; round < rounds; ++round) {
    for (Row& row : normals_) {
      const Real lambda = -row.effective_mass * (speed(row) + row.bias);
      reach(row, row.impulse + lambda);
    }
  }
  for (std::size_t i = 0; i < world.bodies.size(); ++i) {
    Body& body = world.bodies[i];
    body.position += dt * body.velocity;  // x += h v',   q += h/2 (0, w') q
    const Vec3 half = dt * body.angular_velocity / 2;
    if (half != Vec3::Zero()) {
      body.orientation = (Quat(1, half.x(), half.y(), half.z()) * body.orientation).normalized();
      body.refresh_inertia();
    }
    std::tie(body.velocity, body.angular_velocity) = velocities_[i];
  }
}

}  // namespace pushback::flat_10
