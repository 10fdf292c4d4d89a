#include "pushback/engine/islands/energy_control.h"

#include <cmath>

#include "pushback/common/world/measure.h"

namespace pushback {

namespace {

constexpr Real of_contacts = Real(0.01);  // of T + m (h g)^2 / 2: if contacts add more, they were not solved
constexpr int more_where_few_meet = 4;    // times as many half steps, in a second try
constexpr int pays_in_fourth_order = 4;   // half steps of a twin; with fewer, fourth order is not more exact
constexpr Real of_their_own =
    Real(1) / 120;  // s: in shorter steps many contacts get one half step, as substeps are fewer, too

Real mass_of(const World& world) {
  Real mass = 0;
  for (const Body& body : world.bodies)
    if (body.movable()) mass += 1 / body.inverse_mass;
  return mass;
}

}  // namespace

StepOutcome try_half_steps(IslandWorld& island, const IslandStep& step, int substeps) {
  const bool worked_on = island.copy_bodies(step.whole);
  World& world = island.world;
  HalfStep& solver = island.half_step;
  solver.substeps = substeps;
  const Real kinetic_before = kinetic_energy(world), before = kinetic_before + potential_energy(world);
  StepOutcome outcome = solver.try_step(world, step.dt);
  if (island.has_joints_and_may_touch()) solver.most_work = std::max(1.0, solver.most_work - outcome.work);
  if (!outcome.converged) outcome.energy_error = infinite_error;
  if (!outcome.converged || worked_on) return outcome;
  const Real kinetic = kinetic_energy(world), gained = kinetic + potential_energy(world) - before;
  const Real mass = mass_of(world), freed = mass * world.gravity.norm() * step.classifier.overlap(island.lowest()),
             all = std::max(kinetic, kinetic_before) + mass * (step.dt * world.gravity).squaredNorm() / 2;
  if (world.joints.empty()) {  // contacts dissipate an unknown energy, and add none beyond what overlap frees
    outcome.energy_error = gained - freed > of_contacts * all ? infinite_error : 0;
    return outcome;
  }
  Real off = std::abs(gained);
  if (island.impact) {
    const Real left = gained + solver.dissipated_energy();
    off = std::max(gained, solver.contacts_held() ? left : std::abs(left)) - freed;
  }
  outcome.energy_error = off / (step.settings.energy * all);
  return outcome;
}

int most_half_steps(const IslandWorld& island, const IslandStep& step) {
  const int of_contacts_substeps = step.settings.contact_half_step.substeps;
  if (!island.world.joints.empty()) return step.settings.most_half_steps;
  if (!step.classifier.many_contacts(island.lowest())) return of_contacts_substeps;
  return std::min(of_contacts_substeps, static_cast<int>(std::ceil(step.dt / of_their_own)));
}

void take_given_steps(IslandWorld& island, IslandMemory& memory, const IslandStep& step) {
  const GivenSteps& given = step.settings.given;
  const bool many = step.classifier.many_contacts(island.lowest()), joints = !island.world.joints.empty();
  int count = 1;
  for (const int body : island.bodies())
    if (step.whole.bodies[std::size_t(body)].movable()) count = std::max(count, given.of_body[std::size_t(body)]);
  if (many) count = std::min(count, given.most_of_many);
  island.fourth = joints && !island.impact && count >= 4 * pays_in_fourth_order;
  island.set_order();
  HalfStep& solver = island.half_step;
  solver.threshold = 0;
  solver.tolerance = std::min(solver.tolerance, given.tolerance);
  if (!many) solver.most_work *= count;
  if (island.fourth) count = (count + 2) / static_cast<int>(suzuki.size());
  const int most_of_joints = step.settings.most_half_steps / static_cast<int>(island.fourth ? suzuki.size() : 1);
  for (const int most = joints ? std::max(count, most_of_joints) : 4 * count;; count *= 2) {
    const StepOutcome outcome = try_half_steps(island, step, memory.substeps = count);
    island.moved = std::isfinite(outcome.energy_error);
    const bool enough = island.moved && (!joints || outcome.energy_error <= 1);
    if (enough || 2 * count > most || !can_double(island, outcome)) break;
  }
  if (island.fourth) memory.substeps *= static_cast<int>(suzuki.size());
}

void control_by_energy(IslandWorld& island, IslandMemory& memory, const IslandStep& step) {
  const bool joints = !island.world.joints.empty();
  const bool few_meet = island.impact && !joints && !step.classifier.many_contacts(island.lowest());
  const int least = most_half_steps(island, step), most = few_meet ? more_where_few_meet * least : least;
  memory.substeps = joints ? std::max(memory.next_substeps, step.settings.joint_half_step.substeps) : least;
  StepOutcome outcome;
  for (;; memory.substeps *= few_meet ? more_where_few_meet : 2) {
    outcome = try_half_steps(island, step, memory.substeps);
    if (outcome.energy_error <= 1 || 2 * memory.substeps > most || !can_double(island, outcome)) break;
  }
  island.moved = outcome.energy_error <= 1;
  memory.next_substeps = outcome.energy_error < Real(0.125) ? memory.substeps / 2 : memory.substeps;
}

}  // namespace pushback
