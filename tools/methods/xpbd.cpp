#include "pushback/tools/methods/xpbd.h"

#include "pushback/chapters/01_velocity_constraint/rows_solved.h"
#include "pushback/chapters/05_restitution/restitution.h"
#include "pushback/chapters/10_position_correction/displace.h"
#include "pushback/common/world/step.h"
#include "pushback/tools/methods/plain_joints.h"

namespace pushback {

namespace {

/// x += M^-1 J^T lambda; kg m.
void shift(Row& row, Real lambda) {
  displace(*row.a, lambda * row.dva, lambda * row.dwa);
  displace(*row.b, lambda * row.dvb, lambda * row.dwb);
  ++rows_solved;
}

/// Of all equations with a direction, or of all about an axis, that one whose J is the sum of (C_i / |C|) J_i: along the error. The
/// directions of a joint are perpendicular to each other, so that of the sum is a unit vector.
Equation along_the_error(const Equations& equations, bool turns) {
  Equation sum;
  for (const Equation& one : equations) {
    if (one.jacobian.n.isZero(0) != turns) continue;
    sum.jacobian.ra_n += one.error * one.jacobian.ra_n;
    sum.jacobian.n += one.error * one.jacobian.n;
    sum.jacobian.rb_n += one.error * one.jacobian.rb_n;
    sum.error = std::hypot(sum.error, one.error);
  }
  if (sum.error == 0) return sum;
  sum.jacobian.ra_n /= sum.error;
  sum.jacobian.n /= sum.error;
  sum.jacobian.rb_n /= sum.error;
  return sum;
}

/// The displacement of the body's point in this step, m. A conveyor's point has moved with its belt.
Vec3 way_of(const Body& body, const Vec3& now, const Vec3& from, Real h) {
  if (body.conveys) return h * body.velocity_at(now);
  return now - from;
}

}  // namespace

void Xpbd::check(World& world, Real h) {
  if (substeps < 1) throw InvalidInput(fmt::format("substeps is {}: a whole number, 1 or more, is needed", substeps));
  require_not_negative("threshold", threshold);
  check_plain_joints(world, h, "XPBD");
}

void Xpbd::whole_step(World& world, Real dt, int sweeps) {
  check_step(dt, sweeps, world.gravity);
  const Plan its_plan = plan(dt);
  const Real h = dt / static_cast<Real>(substeps);
  AllBodies all_bodies{its_plan.workers};
  const ForcesOfSubsteps forces(world, {.detections = substeps});
  ImpulseSums sums;
  for (int i = 0; i < substeps || i == 0; ++i) {
    if (i > 0) forces.apply_by_hand(world);
    all_bodies.check(world);
    check(world, h);
    remember_contacts(world);
    for (const Force& force : world.forces) force.apply(world);
    integrate_velocities(world, h, all_bodies);
    solve(world, h, sweeps);
    world.move(h);
    all_bodies.find_contacts(world, its_plan.margin);
    after_detection(world, h);
    after_move(world, h);
    for (Contact& contact : world.contacts) contact.last_impulse = contact.impulse;
    world.last_impulses_known = true;
    sums.add(world);
  }
  sums.write_to(world);
}

void Xpbd::after_detection(World& world, Real) {
  touching_.clear();
  for (std::size_t i = 0; i < world.contacts.size(); ++i) {
    const Contact& at = world.contacts[i];
    const auto [a, b] = world.bodies_of(at);
    const Real approach = approach_speed(world, at);
    touching_.push_back({.row = Row(world, at, at.normal, i),
                         .n = at.normal,
                         .on = SurfacePoints(a, b, at),
                         .friction = at.friction,
                         .bounce = approach < -threshold ? -at.restitution * approach : 0});
  }
}

void Xpbd::keep(const World& world, Poses& poses) {
  poses.clear();
  for (const Body& body : world.bodies) poses.push_back({body.position, body.orientation});
}

void Xpbd::solve(World& world, Real, int sweeps) {
  sweeps_ = sweeps;
  keep(world, start_);
}

void Xpbd::hold(World& world, const Joint& joint, Real h) {
  Body &a = world.body(joint.a), &b = world.body(joint.b);
  if (!a.movable() && !b.movable()) return;
  for (const bool turns : {false, true}) {
    equations_.clear();
    joint.ask(a, b, {world.time, h}, equations_);
    const Equation error = along_the_error(equations_, turns);
    if (error.error == 0) continue;
    Row row(a, b, error.jacobian, 0);
    shift(row, -error.error * row.effective_mass);
  }
}

void Xpbd::press(Touch& at) {
  const Body &a = *at.row.a, &b = *at.row.b;
  const Vec3 on_a = point_of(a, at.on.on_a), on_b = point_of(b, at.on.on_b);
  const Real c = (on_b - on_a).dot(at.n);
  if (c >= 0) return;
  at.row.place(Jacobian::along(at.n, a, b, (on_a + on_b) / 2));
  const Real lambda = -c * at.row.effective_mass;
  shift(at.row, lambda);
  at.pressed += lambda;
  at.push += lambda * at.n;
}

void Xpbd::rub(Touch& at, Real h) {
  if (at.friction == 0 || at.pressed == 0) return;
  const Body &a = *at.row.a, &b = *at.row.b;
  const Vec3 on_a = point_of(a, at.on.on_a), on_b = point_of(b, at.on.on_b);
  Vec3 slip = way_of(b, on_b, at.from_b, h) - way_of(a, on_a, at.from_a, h);
  slip -= slip.dot(at.n) * at.n;
  const Real length = slip.norm();
  if (length == 0) return;
  const Vec3 t = slip / length;
  at.row.place(Jacobian::along(t, a, b, (on_a + on_b) / 2));
  const Real lambda = length * at.row.effective_mass;
  if (at.rubbed + lambda > at.friction * at.pressed) return;  // it slides, and the velocities handle friction
  shift(at.row, -lambda);
  at.rubbed += lambda;
  at.push -= lambda * t;
}

void Xpbd::settle(Touch& at, Real h) {
  if (at.pressed == 0) return;
  const Body &a = *at.row.a, &b = *at.row.b;
  const Vec3 middle = (point_of(a, at.on.on_a) + point_of(b, at.on.on_b)) / 2;
  const Vec3 u = b.velocity_at(middle) - a.velocity_at(middle), u_t = u - u.dot(at.n) * at.n;
  const Real slip = u_t.norm();
  if (slip > 0 && at.friction > 0) {
    at.row.place(Jacobian::along(u_t / slip, a, b, middle));
    const Real impulse = std::min(at.friction * at.pressed / h, slip * at.row.effective_mass);
    at.row.apply(-impulse);
    at.push -= h * impulse * at.row.n;
    ++rows_solved;
  }
  at.row.place(Jacobian::along(at.n, a, b, middle));
  const Real impulse = (at.bounce - at.row.speed()) * at.row.effective_mass;
  at.row.apply(impulse);
  at.push += h * impulse * at.n;
  ++rows_solved;
}

void Xpbd::after_move(World& world, Real h) {
  keep(world, moved_to_);
  for (Touch& at : touching_) {
    at.from_a = start_[static_cast<std::size_t>(at.row.a->index)].point_of(at.on.on_a);
    at.from_b = start_[static_cast<std::size_t>(at.row.b->index)].point_of(at.on.on_b);
  }
  for (int sweep = 0; sweep < sweeps_; ++sweep) {
    for (const Joint& joint : world.joints) hold(world, joint, h);
    for (Touch& at : touching_) press(at);
    for (Touch& at : touching_) rub(at, h);
  }
  for (std::size_t i = 0; i < world.bodies.size(); ++i) {
    Body& body = world.bodies[i];
    if (!body.movable()) continue;
    const Quat turn = body.orientation * moved_to_[i].orientation.conjugate();
    body.velocity += (body.position - moved_to_[i].position) / h;
    body.angular_velocity += 2 / (turn.w() * h) * turn.vec();
  }
  for (Touch& at : touching_) settle(at, h);
  for (std::size_t i = 0; i < touching_.size(); ++i) {
    const Touch& at = touching_[i];
    world.contacts[i].impulse = at.push / h;
    world.contacts[i].state = at.rubbed > 0 ? ContactState::sticking : ContactState::sliding;
  }
}

}  // namespace pushback
