#include "pushback/common/world/step.h"

#include <algorithm>
#include <tuple>

namespace pushback {

void StepSolver::integrate_positions(World& world, Real h) {
  for (Body& body : world.bodies) integrate_position(body, h);
}

void StepSolver::whole_step(World& world, Real dt, int sweeps) {
  Everybody everybody{&plan(dt).workers->of_bodies(world.bodies.size())};
  step(world, *this, dt, sweeps, everybody);
}

void check_solvable(const World& world, const StepSolver& solver) {
  if (!solver.holds_joints()) check_no_joints(world.joints);
}

ForcesOfSubsteps::ForcesOfSubsteps(const World& world, const Plan& plan) {
  const auto feels = [](const Body& body) { return body.force != Vec3::Zero() || body.torque != Vec3::Zero(); };
  if (plan.substeps == 1 || std::none_of(world.bodies.begin(), world.bodies.end(), feels)) return;
  for (const Body& body : world.bodies) by_hand_.emplace_back(body.force, body.torque);
}

void ForcesOfSubsteps::apply(World& world) const {
  if (by_hand_.empty() && world.forces.empty()) return;
  for (std::size_t i = 0; i < by_hand_.size(); ++i)
    std::tie(world.bodies[i].force, world.bodies[i].torque) = by_hand_[i];
  for (const Force& force : world.forces) force.apply(world);
  for (Body& body : world.bodies) {
    if (body.asleep) body.force.setZero(), body.torque.setZero();
  }
}

bool ForcesOfSubsteps::turn_bodies(const World& world) const {
  return !world.forces.empty() ||
         std::any_of(by_hand_.begin(), by_hand_.end(), [](const auto& of) { return of.second != Vec3::Zero(); });
}

void remember_contacts(World& world) {
  world.contacts_before.swap(world.contacts);
  if (!world.last_impulses_known) return;
  for (Contact& contact : world.contacts_before) contact.impulse = contact.last_impulse;
  world.last_impulses_known = false;
}

void ImpulseSums::keep(const World& world) {
  sums_.clear();
  for (const Contact& contact : world.contacts) sums_.emplace_back(contact.id, contact.impulse);
}

void ImpulseSums::add(World& world, const Plan& plan) {
  world.last_impulses_known = true;
  if (plan.substeps > 1 && sums_.empty()) return;  // the solver has written both
  auto before = sums_.begin();                     // both lists ascend: walk them side by side
  for (Contact& contact : world.contacts) {
    if (plan.substeps == 1) contact.last_impulse = contact.impulse;
    while (before != sums_.end() && before->first < contact.id) ++before;
    if (before != sums_.end() && before->first == contact.id) contact.impulse += before->second;
  }
}

void World::begin_step(Real dt) {
  Everybody everybody;
  detect(*this, everybody, {});
  integrate_velocities(*this, dt, everybody);
}

void World::step(StepSolver& solver, Real dt, int sweeps) {
  solver.whole_step(*this, dt, sweeps);
}

void World::step(StepSolver& solver, Real dt) {
  step(solver, dt, solver.plan(dt).sweeps);
}

}  // namespace pushback
