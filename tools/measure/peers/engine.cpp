#include "pushback/tools/measure/peers/engine.h"

#include <algorithm>

#include "pushback/common/basics/input.h"
#include "pushback/common/world/step.h"
#include "pushback/tools/measure/hard_cases/watcher.h"

namespace pushback {

InvalidInput not_had(const std::string& what) {
  return InvalidInput(fmt::format("{}: {}", not_possible, what));
}

namespace {

bool same_solid(const Shape& one, const Shape& other) {
  if (one.index() != other.index()) return false;
  if (const auto* ball = std::get_if<Sphere>(&one)) return ball->radius == std::get<Sphere>(other).radius;
  if (const auto* box = std::get_if<Box>(&one)) return box->half_extents == std::get<Box>(other).half_extents;
  if (const auto* capsule = std::get_if<Capsule>(&one)) {
    const auto& that = std::get<Capsule>(other);
    return capsule->radius == that.radius && capsule->half_length == that.half_length;
  }
  if (const auto* half_space = std::get_if<HalfSpace>(&one))
    return half_space->normal == std::get<HalfSpace>(other).normal;
  return std::get<Hull>(one).solid == std::get<Hull>(other).solid;
}

/// All that an engine is built with.
bool same_body(const Body& one, const Body& other) {
  return one.inverse_mass == other.inverse_mass && one.principal_inverse_inertia == other.principal_inverse_inertia &&
         one.friction == other.friction && one.restitution == other.restitution && same_solid(one.shape, other.shape);
}

bool same_joint(const Joint& one, const Joint& other) {
  return one.name == other.name && one.a == other.a && one.b == other.b && one.colliding == other.colliding;
}

bool same_state(const Body& one, const Body& other) {
  return one.position == other.position && one.orientation.coeffs() == other.orientation.coeffs() &&
         one.velocity == other.velocity && one.angular_velocity == other.angular_velocity;
}

}  // namespace

void check_plain(const Body& body) {
  if (body.skin != 0) throw not_had("a skin around a body");
  if (body.conveys) throw not_had("a conveyor");
  if (body.groups != 1 || body.touches != every_group) throw not_had("groups of bodies that do not touch");
}

void EngineSolver::check(World&, Real) {
  throw not_had("contacts from outside");
}

void EngineSolver::hand_over(const World& world) {
  std::vector<bool> driven;
  for (const Body& body : world.bodies) driven.push_back(is_driven(body));
  // One that begins to be driven is another one to an engine; one that stops is not.
  bool same = engine_ && gravity_ == world.gravity &&
              std::equal(left_.begin(), left_.end(), world.bodies.begin(), world.bodies.end(), same_body) &&
              std::equal(joints_.begin(), joints_.end(), world.joints.begin(), world.joints.end(), same_joint);
  for (std::size_t i = 0; same && i < driven.size(); ++i) same = driven_[i] || !driven[i];
  if (!same) {
    for (const Body& body : world.bodies) check_plain(body);
    engine_ = begin_(world, setting_);
    joints_ = world.joints;
    gravity_ = world.gravity;
    driven_ = driven;
    return;
  }
  for (std::size_t i = 0; i < left_.size(); ++i)
    if (!same_state(left_[i], world.bodies[i])) engine_->put(world.bodies[i]);
}

void EngineSolver::substep(World& world, Real h) {
  for (Body& body : world.bodies) {
    if (!is_driven(body)) continue;
    const Body now = body;
    move(body, h);
    engine_->drive(now, body);
  }
  for (const Body& body : world.bodies)
    if (body.movable()) engine_->push(body);
  engine_->step(static_cast<double>(h));
  for (Body& body : world.bodies) {
    keep_velocity(body);
    body.force.setZero();
    body.torque.setZero();
    if (body.movable()) engine_->get(body);
    body.refresh_inertia();
  }
  world.time += h;
  world.dt_before = h;
}

void EngineSolver::whole_step(World& world, Real dt, int sweeps) {
  check_step(dt, sweeps, world.gravity);
  AllBodies::check(world);
  hand_over(world);
  const ForcesOfSubsteps forces(world, {.substeps = setting_.substeps});  // the engine's own have them alike
  for (const Force& force : world.forces) force.apply(world);
  for (int i = 0; i < setting_.substeps; ++i) {
    if (i > 0) forces.apply(world);
    substep(world, dt / static_cast<Real>(setting_.substeps));
  }
  world.contacts.clear();
  if (finite(world)) world.find_contacts();
  world.last_impulses_known = true;
  left_ = world.bodies;
}

}  // namespace pushback
