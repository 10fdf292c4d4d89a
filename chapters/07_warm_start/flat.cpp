#include "pushback/chapters/07_warm_start/flat.h"

#include <algorithm>

namespace pushback::flat_07 {

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

}  // namespace

void FlatSolver::solve(World& world, Real dt, int sweeps) {
  make_rows(world, dt);
  guess_impulses(world, dt);
  sweep(world.contacts, sweeps);
  keep_impulses(world.contacts);
}

void FlatSolver::make_rows(World& world, Real dt) {
  Contacts& contacts = world.contacts;

  normals_.clear();
  tangents_.clear();
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    const Contact& c = contacts[i];
    // 01: a row along the normal
    normals_.push_back(row_of(world, i, c.normal));

    // 02: contacts push and never pull.   sum(lambda) in [0, inf)
    Row& normal = normals_.back();
    normal.lo = 0;

    // 03: the part beta of the overlap should be gone after this step.   b = beta / h C
    // 04: a little overlap is left alone, so that contacts survive.   C = min(0, -depth + slop)
    const Real separation = std::min(Real(0), -c.depth + slop);
    normal.bias = beta / dt * separation;

    // 05: or the bounce, whichever asks for more; from the velocities before gravity and impulses.   b = min(b, e v_n)
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
    // 06: friction stops the slip, as far as the normal impulse lets it.   |sum(lambda)| <= mu sum(lambda_n)
    for (Row& row : tangents_) {
      const Real bound = contacts[row.contact].friction * normals_[row.contact].impulse;
      row.lo = -bound;
      row.hi = bound;
      const Real lambda = -row.effective_mass * speed(row);
      reach(row, row.impulse + lambda);
    }
  }
}

void FlatSolver::keep_impulses(Contacts& contacts) {
  // Each contact keeps its impulse.
  for (Contact& c : contacts) c.impulse.setZero();
  for (const Row& row : normals_) contacts[row.contact].impulse += row.impulse * row.n;
  for (const Row& row : tangents_) contacts[row.contact].impulse += row.impulse * row.n;
}

}  // namespace pushback::flat_07
