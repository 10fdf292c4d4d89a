#include "pushback/engine/islands/island_solver.h"

#include <utility>

#include "pushback/common/world/step.h"

namespace pushback {

namespace {

constexpr int steps_after_failing = 10;  // steps; twice as many after each further failure,
constexpr int most_failures = 4;         // up to this many
constexpr int most_meetings = 8;      // in a step that is taken again for them; then the bodies that meet get substeps
constexpr Real stiffest = Real(1e9);  // Hz: SoftContacts makes it the largest that substeps hold, 1 / (8 h)
constexpr double of_resting_contact =
    750;  // multiplications, for a contact that bears the same load in a half step as before

/// Whether half steps have let a contact in that was not detected. Islands that were deep before are left out: a press has no room.
bool lets_in(const IslandWorld& island, const StepClassifier& classifier) {
  const Real before = classifier.deepest(island.lowest()),
             most = std::max(ImpactCuts::most_sinking, before + ImpactCuts::most_sinking / 10);
  return before <= 10 * ImpactCuts::most_sinking &&
         std::any_of(island.world.contacts.begin(), island.world.contacts.end(),
                     [most](const Contact& at) { return !at.parted && at.depth > most; });
}

/// All bodies of a world whose contacts have been found.
struct WithFoundContacts : AllBodies {
  Contacts& found;
  void find_contacts(World& world, const Margin& /*margin*/) const { world.contacts.swap(found); }
};

/// Half of the kick, the drift, and the other half.
void fly(Body& body, const Vec3& gravity, int parts, Real dt) {
  const Vec3 force = body.force, torque = body.torque;
  keep_velocity(body);
  integrate_velocity(body, gravity, dt / 2);
  for (int i = 0; i < parts; ++i) move(body, dt / static_cast<Real>(parts));
  body.force = force, body.torque = torque;
  integrate_velocity(body, gravity, dt / 2);
}

}  // namespace

void IslandSolver::whole_step(World& world, Real dt, int sweeps) {
  check_step(dt, sweeps, world.gravity);
  AllBodies::check(world);
  IslandSettings::check();
  given.check(world.bodies.size());
  substep_solver.check_settings(world, dt);
  pile_solver.check_settings(world, dt);
  const Plan plan = substep_solver.plan(dt);
  contacts_.find(world, classifier_, plan, dt);
  memory_.resize(world.bodies.size());
  for (IslandMemory& memory : memory_) memory.steps_to_wait = std::max(0, memory.steps_to_wait - 1);
  spent_.assign(world.bodies.size(), 0);
  call_by_call_ = false;
  solved_ = {};
  for (int meetings = 0;; ++meetings) {
    const bool too_many = meetings == most_meetings;
    classify(world, too_many, dt);
    step_islands(world, plan, dt);
    if (too_many || !others_were_met(world, dt)) break;
  }
  fall_back(world);
  step_piles(world, dt, sweeps);
  add_up(step_remaining(world, dt, sweeps));
  commit(world, dt);
}

void IslandSolver::solve(World& world, Real h, int sweeps) {
  call_by_call_ = true;
  inner().solve(world, h, sweeps);
}

int IslandSolver::half_steps_of(int body) {
  if (step_of(body) != StepType::half_steps) return 0;
  return memory_[std::size_t(classifier_.island_of(body))].substeps;
}

/// Makes islands, and a world of each that gets half steps. Islands that have to wait, or cannot pay, get substeps.
void IslandSolver::classify(World& world, bool too_many_meetings, Real dt) {
  ClassifierLimits now = limits;
  if (too_many_meetings) now.most = now.most_kept = now.most_single_contacts = 0;
  if (!given.of_body.empty()) now.large_pile = std::numeric_limits<int>::max();
  const Real threshold = given.of_body.empty() ? substep_solver.threshold : given.threshold;
  classifier_.classify(world, contacts_.found, dt, threshold, now);
  budgets_.pool(world, classifier_, budget);
  for (const Body& body : world.bodies) {
    if (step_of(body.index) != StepType::half_steps) continue;
    const int island = classifier_.island_of(body.index);
    if (memory_[std::size_t(island)].steps_to_wait > 0)
      classifier_.leave_to_substeps(body.index, StepReason::failed_before);
    else if (!budgets_.can_pay(island, classifier_, budget))
      classifier_.leave_to_substeps(body.index, StepReason::no_savings);
  }
  islands_.divide(world, classifier_, contacts_.found);
}

void IslandSolver::step_islands(World& world, const Plan& plan, Real dt) {
  const IslandStep step{world, classifier_, *this, dt};
  plan.workers->each(islands_.size(), 4, [&](Part part) {
    for (std::size_t i = part.begin; i < part.end; ++i)
      if (classifier_.step_of(islands_[i].lowest()) == StepType::half_steps) step_island(islands_[i], step);
  });
  islands_.give_joints(world);
}

/// Multiplications that the last tries of its bodies took, earlier in this step. An island that has met others is tried again, with what
/// is left of twice `most_work`.
double IslandSolver::most_spent(const IslandWorld& island, const World& world) const {
  double most = 0;
  for (const int body : island.bodies())
    if (world.body(body).movable()) most = std::max(most, spent_[std::size_t(body)]);
  return most;
}

void IslandSolver::step_island(IslandWorld& island, const IslandStep& step) {
  const int lowest = island.lowest();
  const bool joints = !island.world.joints.empty(), many = classifier_.many_contacts(lowest);
  island.impact = classifier_.impact(lowest) || (joints && classifier_.near(lowest));
  island.set(joints ? joint_half_step : contact_half_step);
  island.set_order();
  HalfStep& solver = island.half_step;
  if (island.has_joints_and_may_touch()) {
    solver.threshold = contact_half_step.threshold;
    solver.tolerance = std::min(solver.tolerance, at_impacts().tolerance);
  }
  WorkBudget& saved = budgets_.of(lowest);
  const double price = WorkBudgets::price(lowest, classifier_, budget);
  if (many) {
    solver.most_work = std::min(saved.saved(), budget.at_once * price);
    solver.fall_back_to_full_solve = false;
  }
  const double spent = most_spent(island, step.whole);
  if (!many && !joints && given.of_body.empty())
    solver.most_work = std::clamp(2 * solver.most_work - spent, 1.0, solver.most_work);
  IslandMemory& memory = memory_[std::size_t(lowest)];
  const auto control = [&] {
    if (given.of_body.empty()) control_by_energy(island, memory, step);
    else take_given_steps(island, memory, step);
  };
  control();
  if (island.moved && !island.impact && !many && lets_in(island, classifier_)) {
    island.impact = true;
    classifier_.mark_impact(lowest);
    island.set(contact_half_step);
    island.set_order();
    control();
  }
  for (const int body : island.bodies())
    if (step.whole.body(body).movable()) spent_[std::size_t(body)] = spent + solver.work();
  if (many) {
    const double work = solver.work() + of_resting_contact * classifier_.contacts(lowest) * memory.substeps;
    if (island.moved) saved.succeed(price - work, budget.most * price);
    else saved.fail(work, budget.at_once);
  }
  if (!island.moved && (!many || solver.too_large())) {  // too large, and it stays so while the same bodies touch
    const int failures = many || island.has_joints_and_may_touch() ? memory.failures : 0;
    memory = {.steps_to_wait = steps_after_failing << failures, .failures = std::min(failures + 1, most_failures)};
  }
  if (island.moved) memory.failures = 0;
}

/// Whether bodies may have come upon others, which are not of their island: bodies that have bounced, and bodies that joints have made
/// faster than detection expected. Looks as far as the speeds of both, before and after, can bring them in dt, and adds the contacts
/// that it finds. Then the bodies are one island.
bool IslandSolver::others_were_met(const World& world, Real dt) {
  std::vector<bool> may_meet(world.bodies.size(), false);
  std::vector<Real> ways;
  for (const Body& body : world.bodies) ways.push_back(dt * body.velocity.norm());
  bool any = false;
  for (std::size_t i = 0; i < islands_.size(); ++i) {
    const IslandWorld& island = islands_[i];
    if (!island.moved) continue;
    const bool bounced = island.impact && island.half_step.events() > 0, joints = !island.world.joints.empty();
    for (const Body& after : island.world.bodies) {
      const auto at = std::size_t(island.bodies()[std::size_t(after.index)]);
      if (!after.movable()) continue;
      const Real expected = ways[at] + substep_solver.margin / 2;
      const auto reaches = [joints, dt](const Body& body) {
        return dt * body.velocity.norm() + (joints ? way_of_tips(body, dt) : 0);
      };
      ways[at] = std::max(reaches(world.bodies[at]), reaches(after));
      may_meet[at] = bounced || (joints && ways[at] > expected);
      any |= may_meet[at];
    }
  }
  return any && contacts_.add_near(world, ways, [&](std::size_t p, std::size_t q) {
    if (!may_meet[p] && !may_meet[q]) return false;
    const int first = static_cast<int>(p), second = static_cast<int>(q);
    const bool both = world.bodies[p].movable() && world.bodies[q].movable();
    return !both || classifier_.island_of(first) != classifier_.island_of(second);
  });
}

/// Islands that half steps could not move get substeps, or are moved as piles.
void IslandSolver::fall_back(const World& world) {
  for (std::size_t i = 0; i < islands_.size(); ++i) {
    const IslandWorld& island = islands_[i];
    if (island.moved) {
      add_up(island.half_step.stats());
      continue;
    }
    if (step_of(island.lowest()) != StepType::half_steps) continue;
    for (const int body : island.bodies())
      if (world.body(body).movable()) classifier_.leave_to_substeps(body, StepReason::failed);
  }
  budgets_.share_out(world, classifier_, budget);
}

void IslandSolver::step_piles(const World& world, Real dt, int sweeps) {
  pile_solver.workers = substep_solver.workers;
  islands_.give_found(world, classifier_, contacts_.found);
  for (std::size_t i = 0; i < islands_.size(); ++i) {
    IslandWorld& island = islands_[i];
    if (!classifier_.is_moved_by_fast(island.lowest())) continue;
    island.copy_bodies(world);
    const Plan plan = pile_solver.plan(dt);
    WithFoundContacts bodies{{&plan.workers->of_bodies(island.world.bodies.size())}, island.found};
    pushback::step(island.world, pile_solver, plan, dt, sweeps, bodies);
    island.moved = true;
    island.substeps = plan.all_substeps();
    add_up(pile_solver.stats());
  }
}

SolveStats IslandSolver::step_remaining(World& world, Real dt, int sweeps) {
  const auto step = [&] {
    return remaining_.step(world, classifier_, contacts_.found, {substep_solver, inner(), *this, dt, sweeps});
  };
  if (given.of_body.empty()) return step();
  const int substeps = std::exchange(substep_solver.substeps, given.substeps);
  const Real hertz = std::exchange(substep_solver.spring.hertz, stiffest);
  const Real threshold = std::exchange(substep_solver.threshold, given.threshold);
  const SolveStats stats = step();
  substep_solver.substeps = substeps, substep_solver.spring.hertz = hertz, substep_solver.threshold = threshold;
  return stats;
}

void IslandSolver::commit(World& world, Real dt) {
  for (Body& body : world.bodies)
    if (step_of(body.index) == StepType::flight) {
      const bool in_parts = tumbles(body) && !given.of_body.empty();  // its position is exact in one
      fly(body, world.gravity, in_parts ? given.of_body[std::size_t(body.index)] : 1, dt);
    }
  islands_.commit(world, world.dt_before / dt);
}

void IslandSolver::add_up(const SolveStats& solved) {
  solved_ = {solved_.rows + solved.rows, std::max(solved_.residual, solved.residual)};
}

}  // namespace pushback
