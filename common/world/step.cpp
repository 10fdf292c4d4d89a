#include "pushback/common/world/step.h"

#include <algorithm>
#include <tuple>

namespace pushback {

void StepSolver::integrate_positions(World& world, Real h) {
  for (Body& body : world.bodies) integrate_position(body, h);
}

void StepSolver::whole_step(World& world, Real dt, int sweeps) {
  AllBodies all_bodies{&plan(dt).workers->of_bodies(world.bodies.size())};
  step(world, *this, dt, sweeps, all_bodies);
}

void check_solvable(const World& world, const StepSolver& solver) {
  if (!solver.supports_joints()) check_no_joints(world.joints);
}

ForcesOfSubsteps::ForcesOfSubsteps(const World& world, const Plan& plan) {
  const auto feels = [](const Body& body) { return body.force != Vec3::Zero() || body.torque != Vec3::Zero(); };
  if (plan.all_substeps() == 1 || std::none_of(world.bodies.begin(), world.bodies.end(), feels)) return;
  for (const Body& body : world.bodies) by_hand_.emplace_back(body.force, body.torque);
}

void ForcesOfSubsteps::apply_by_hand(World& world) const {
  for (std::size_t i = 0; i < by_hand_.size(); ++i)
    if (!world.bodies[i].asleep) std::tie(world.bodies[i].force, world.bodies[i].torque) = by_hand_[i];
}

void ForcesOfSubsteps::apply(World& world) const {
  if (by_hand_.empty() && world.forces.empty()) return;
  apply_by_hand(world);
  for (const Force& force : world.forces) force.apply(world);
  for (Body& body : world.bodies) {
    if (body.asleep) body.force.setZero(), body.torque.setZero();
  }
}

bool ForcesOfSubsteps::turn_bodies(const World& world) const {
  return !world.forces.empty() ||
         std::any_of(by_hand_.begin(), by_hand_.end(), [](const auto& of) { return of.second != Vec3::Zero(); });
}

void start_from_last_substep(World& world) {
  std::erase_if(world.contacts, [count = world.bodies.size()](const Contact& contact) {
    return contact.parted || contact.id.body_b >= count;
  });
  if (!world.last_impulses_known) return;
  for (Contact& contact : world.contacts) contact.impulse = contact.last_impulse;
  world.last_impulses_known = false;
}

void remember_contacts(World& world) {
  start_from_last_substep(world);
  world.contacts_before.swap(world.contacts);
}

void ImpulseSums::add(const World& world) {
  Contacts all;
  auto before = sums_.begin();  // both lists ascend, so go through them in parallel
  for (const Contact& contact : world.contacts) {
    for (; before != sums_.end() && before->id < contact.id; ++before) all.push_back(*before);
    all.push_back(contact);
    if (before != sums_.end() && before->id == contact.id) all.back().impulse += (before++)->impulse;
  }
  all.insert(all.end(), before, sums_.end());
  sums_.swap(all);
}

void ImpulseSums::write_to(World& world) {
  auto now = world.contacts.begin();
  std::erase_if(sums_, [&](Contact& sum) {
    if (now != world.contacts.end() && now->id == sum.id) return ++now, false;
    sum.parted = true;
    sum.last_impulse.setZero();
    return sum.impulse.isZero(0);
  });
  world.contacts.swap(sums_);
}

void World::begin_step(Real dt) {
  AllBodies all_bodies;
  detect(*this, all_bodies, {});
  integrate_velocities(*this, dt, all_bodies);
}

void World::step(StepSolver& solver, Real dt, int sweeps) {
  solver.whole_step(*this, dt, sweeps);
  break_joints(*this, dt);
}

void World::step(StepSolver& solver, Real dt) {
  step(solver, dt, solver.plan(dt).sweeps);
}

}  // namespace pushback
