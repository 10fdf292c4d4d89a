#include "pushback/chapters/21_detected_once/flat.h"

#include <algorithm>
#include <cmath>

namespace pushback::flat_21 {

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
  row.effective_mass = row.rigid_mass = 1 / (linear + row.rb_n.dot(row.dwb) - row.ra_n.dot(row.dwa));
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
/// 05: J V at the start of the substep, before its gravity and its impulses, m/s.
Real speed_before(const Row& row) {
  return row.n.dot(row.b->velocity_before - row.a->velocity_before) +
         (row.rb_n.dot(row.b->angular_velocity_before) - row.ra_n.dot(row.a->angular_velocity_before));
}

/// V += M^-1 J^T lambda
void apply(Row& row, Real lambda) {
  row.a->velocity += lambda * row.dva;
  row.a->angular_velocity += lambda * row.dwa;
  row.b->velocity += lambda * row.dvb;
  row.b->angular_velocity += lambda * row.dwb;
}

/// Brings sum(lambda) to `total`, or as near as the limits let it.
void reach(Row& row, Real total) {
  // 02: the sum is clamped, not each lambda: a later sweep can take back what was too much.
  if (total < row.lo || total > row.hi) [[unlikely]]
    total = total < row.lo ? row.lo : row.hi;
  const Real lambda = total - row.impulse;  // what the sum gains after rounding is what the bodies get
  row.impulse = total;
  apply(row, lambda);
}

/// 12: sets the equation of a row: J V + b + gamma sum(lambda) = 0.
void ask(Row& row, Real bias, Real gamma_by_K) {
  row.bias = bias;
  row.softness = gamma_by_K / row.rigid_mass;
  row.effective_mass = row.rigid_mass / (1 + gamma_by_K);  // 1 / (K + gamma)
}

/// 08: both tangents take steps of the same size, 1 / k: only then is friction opposite to the slip where nothing
/// changes any more.   k: the larger eigenvalue of their 2 x 2 block of J M^-1 J^T
Real step_size(const Row& one, const Row& two) {
  const Real k11 = 1 / one.rigid_mass, k22 = 1 / two.rigid_mass;
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

/// Once per step: builds the rows and sets their initial impulses.
void FlatSolver::detected(World& world, Real h) {
  make_contact_rows(world);
  guess_impulses(world, h);
  moved_.assign(world.bodies.size(), {});
  sums_.assign(world.contacts.size(), Vec3::Zero());
  fastest_ = 0;
}

void FlatSolver::make_contact_rows(World& world) {
  normals_.clear();
  tangents_.clear();
  step_sizes_.clear();
  for (std::size_t i = 0; i < world.contacts.size(); ++i) {
    const Contact& c = world.contacts[i];
    // 01: a row along the normal
    normals_.push_back(row_of(world, i, c.normal));
    normals_.back().found = -c.depth;
    // 02: contacts push and never pull.   sum(lambda) in [0, inf)
    normals_.back().lo = 0;
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
void FlatSolver::guess_impulses(World& world, Real h) {
  auto old = world.contacts_before.begin();
  for (Contact& c : world.contacts) {
    while (old != world.contacts_before.end() && old->id < c.id) ++old;
    c.impulse.setZero();
    if (old != world.contacts_before.end() && old->id == c.id) c.impulse = world.impulse_scale(h) * old->impulse;
    // 21: projected into the friction cone, because the normal may have turned and a bounce restores this guess.
    const Real pushed = c.impulse.dot(c.normal), bound = c.friction * std::max(Real(0), pushed);
    const Vec3 rubbed = c.impulse - pushed * c.normal;
    const Real size = rubbed.norm();
    c.impulse = std::max(Real(0), pushed) * c.normal + (size > bound ? bound / size : 1) * rubbed;
  }
  for (Row& row : normals_) row.impulse = world.contacts[row.contact].impulse.dot(row.n);
  for (Row& row : tangents_) row.impulse = world.contacts[row.contact].impulse.dot(row.n);
}

/// In each substep, after gravity.
void FlatSolver::solve(World& world, Real h, int sweeps) {
  forget_impacts();
  prepare_normals(world.contacts, h);
  prepare_joints(world, h);

  // 07: the impulses of the substep before are the initial guess.
  for (Row& row : joints_) reach(row, world.impulse_scale(h) * *row.kept);  // 14: of the same equation
  for (std::vector<Row>* rows : {&normals_, &tangents_}) {
    for (Row& row : *rows) {
      apply(row, row.impulse);
      row.start = row.impulse;
    }
  }

  sweep(world.contacts, sweeps);

  // 14: stores the impulses that carry loads, then adds those that close gaps, in as many passes.
  for (Row& row : joints_) {
    *row.kept = row.impulse;
    row.bias += row.push_out;
  }
  for (int pass = 0; pass < sweeps * passes; ++pass)
    for (Row& row : joints_) solve_alone(row);
}

/// Sets the target velocity of each normal for this substep.
void FlatSolver::prepare_normals(const Contacts& contacts, Real h) {
  // 12: an overlap is a spring with a damper.   w = 2 pi hertz,  k = w^2 / K,  c = 2 zeta w / K,  where 1/K cancels:
  const Real w = 2 * pi * std::min(hertz, 1 / (8 * h));               // no stiffer than eight steps to an oscillation
  const Real push_out_rate = w / (2 * damping_ratio + h * w);         // k / (c + h k)
  const Real gamma_by_K = 1 / (h * w * (2 * damping_ratio + h * w));  // gamma / K,  gamma = 1 / (h (c + h k))
  for (Row& row : normals_) {
    const Real C = separation(row), e = contacts[row.contact].restitution;
    const Real approach = e > 0 ? speed_before(row) : 0, arrives = C + h * approach;
    row.bounce = 0;
    if (approach < -threshold && arrives < 0) {
      // 05, 09: the bounce, computed at the surface, where half the square of the speed is S. C' = C + way is the separation
      // after the rest of the substep, back at e times that speed.
      //   S = u^2 / 2 + a C + h a u / 2,   v^2 / 2 + a C' - h a v / 2 = e^2 S      u = -approach, a: by forces, towards the surface
      const Real ha = std::max(Real(0), approach - speed(row)), a = ha / h;
      const Real S = std::max(Real(0), approach * approach / 2 + a * C - ha * approach / 2);
      const Real back = e * (h * std::sqrt(2 * S) - std::max(Real(0), C));
      const Real way = back - std::max(Real(0), C);
      const Real squared = ha * ha / 4 + 2 * (e * e * S - a * (C + way));
      row.bounce = -(ha / 2 + std::sqrt(std::max(Real(0), squared)));
      fastest_ = std::max(fastest_, -row.bounce);
      ask(row, -way / h, 0);
    } else if (C > 0) {
      // 21: a contact that is apart may close its gap, J V + C / h >= 0. One that bounces has no effect until it arrives.
      ask(row, e > 0 && C > h * threshold ? inf : C / h, 0);
    } else {
      // 12: b = k / (c + h k) C; rigid if that is too fast, because a spring with a limited push would sink for ever.
      const Real push_out = push_out_rate * C;
      if (push_out < -fastest_push_out) ask(row, -fastest_push_out, 0);
      else ask(row, push_out, gamma_by_K);
    }
  }
}

/// 13: a row for each equation of each joint.   J V + b + gamma lambda = 0,   b = b_C + (beta / h) C
void FlatSolver::prepare_joints(World& world, Real h) {
  joints_.clear();
  equations_.clear();
  for (Joint& joint : world.joints) {
    Row row;
    row.a = &world.body(joint.a);
    row.b = &world.body(joint.b);
    joint.ask(*row.a, *row.b, {world.time, h}, equations_);
    joint.last_impulses.resize(equations_.size() - joints_.size());
    for (Real& kept : joint.last_impulses) {
      const Equation& equation = equations_[joints_.size()];
      place(row, equation);
      row.bias += joint_beta / h * equation.error;
      row.softness = equation.softness;
      // 14: the push-out, which closes gaps, is separate from the bias under which joints carry loads. Springs have none.
      row.push_out = row.softness == 0 ? joint_beta / h * equation.error : 0;
      row.bias -= row.push_out;
      row.kept = &kept;
      row.effective_mass /= 1 + row.softness * row.effective_mass;  // 1 / (K + gamma)
      row.lo = h * equation.lo;                                     // the equation's limits are forces
      row.hi = h * equation.hi;
      joints_.push_back(row);
    }
  }
}

/// 12: in each substep, once the bodies have moved. The push-out's speed would add energy if it stayed, so one more sweep
/// solves rigid rows without push-out.
void FlatSolver::moved(World& world, Real h) {
  for (std::size_t i = 0; i < world.bodies.size(); ++i) {
    moved_[i].way += h * world.bodies[i].velocity;
    moved_[i].turn += h * world.bodies[i].angular_velocity;
  }
  // 21: bodies with a low relative velocity keep their rows. The other rows are carried, and their separation stays.
  const auto passes_by = [this](const Row& row) {
    return (row.b->velocity - row.a->velocity).squaredNorm() >= carried_from * carried_from;
  };
  for (Row& row : normals_) {
    if (passes_by(row)) {
      const Real C = separation(row);
      carry(row);
      row.found += C - separation(row);
    }
    // 21: a contact that was apart keeps C / h, because the current C would stop it before it arrives.
    ask(row, row.bounce < 0 ? row.bounce : std::max(row.bias, Real(0)), 0);
  }
  for (std::size_t t = 0; t < tangents_.size(); t += 2) {
    if (!passes_by(tangents_[t])) continue;
    carry(tangents_[t]);
    carry(tangents_[t + 1]);
    step_sizes_[t / 2] = step_size(tangents_[t], tangents_[t + 1]);
  }
  for (Row& row : joints_) reach(row, *row.kept);  // 14: takes back the impulses that closed gaps
  // 13: joints likewise, but not springs, because the speed that they add is intended
  equations_.clear();
  for (const Joint& joint : world.joints)
    joint.ask(world.body(joint.a), world.body(joint.b), {world.time, h}, equations_);
  for (std::size_t i = 0; i < joints_.size(); ++i)
    if (joints_[i].softness == 0) place(joints_[i], equations_[i]);

  sweep(world.contacts, 1);

  for (Row& row : joints_) *row.kept = row.impulse;  // 14
  for (const Row& row : normals_) sums_[row.contact] += row.impulse * row.n;
  for (const Row& row : tangents_) sums_[row.contact] += row.impulse * row.n;
}

/// 21: an impact is over in one substep, so the next one starts from the initial impulses of this one.
void FlatSolver::forget_impacts() {
  if (fastest_ > 0) {
    for (Row& row : normals_) row.impulse = row.start;
    for (Row& row : tangents_) row.impulse = row.start;
  }
  fastest_ = 0;
}

/// 21: C = C_0 + J dX, m.   dX: displacement of both bodies since detection
Real FlatSolver::separation(const Row& normal) const {
  const Moved &a = moved_[normal.a->index], &b = moved_[normal.b->index];
  return normal.found + normal.n.dot(b.way - a.way) + (normal.rb_n.dot(b.turn) - normal.ra_n.dot(a.turn));
}

/// Sequential Impulses: one row after the other, each as if it were alone, over and over.
void FlatSolver::sweep(const Contacts& contacts, int sweeps) {
  for (int sweep = 0; sweep < sweeps; ++sweep) {
    for (int pass = 0; pass < passes; ++pass)
      for (Row& row : joints_) solve_alone(row);
    // 09: one round; while a contact bounces, until the impact is solved, because no later step corrects its error.
    Real change = inf;
    for (int round = 0; round < (fastest_ > 0 ? most_rounds : 1) && change > precision * fastest_; ++round) {
      change = 0;
      for (Row& row : normals_) {
        const Real before = row.impulse;
        solve_alone(row);
        change = std::max(change, std::abs(row.impulse - before) / row.rigid_mass);
      }
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

/// Once per step: stores the impulses in the contacts and removes the contacts that did not touch.
void FlatSolver::done(World& world) {
  forget_impacts();
  for (Row& row : normals_) {
    Contact& c = world.contacts[row.contact];
    c.depth = -separation(row);
    c.impulse = sums_[row.contact];
    c.last_impulse = row.impulse * row.n;
  }
  for (const Row& row : tangents_) world.contacts[row.contact].last_impulse += row.impulse * row.n;
  std::erase_if(world.contacts, [](const Contact& c) { return c.depth < 0 && c.impulse.isZero(0); });
}

}  // namespace pushback::flat_21
