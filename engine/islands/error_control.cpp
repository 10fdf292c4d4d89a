#include "pushback/engine/islands/error_control.h"

#include <cmath>

#include "pushback/engine/half_step/gap.h"

namespace pushback {

namespace {

constexpr Real horizon = 1;                        // s: T
constexpr int least = 2;                           // half steps of a step that is taken twice: half of them is one
constexpr int most_of_few = 16, most_of_many = 2;  // half steps of few contacts, and of many
constexpr int most_of_second_order = 8;            // half steps of joints; beyond that they are composed
constexpr int fourth_for = 60;                     // steps; then half steps are tried again

std::ptrdiff_t sliding(const World& world) {
  return std::count_if(world.contacts.begin(), world.contacts.end(),
                       [](const Contact& contact) { return contact.state == ContactState::sliding; });
}

Real largest_friction(const World& world) {
  Real mu = 0;
  for (const Contact& contact : world.contacts) mu = std::max(mu, contact.friction);
  return mu;
}

bool bounced(const World& world) {
  return std::any_of(world.contacts.begin(), world.contacts.end(),
                     [](const Contact& contact) { return contact.restitution > 0 && !contact.impulse.isZero(0); });
}

/// rad/s.
Real fastest_spin(const World& world) {
  Real fastest = 0;
  for (const Body& body : world.bodies) fastest = std::max(fastest, body.angular_velocity.norm());
  return fastest;
}

}  // namespace

void ErrorControl::begin(const World& world) {
  checks_.resize(world.bodies.size());
  bodies_.resize(world.bodies.size());
}

void ErrorControl::end(const StepClassifier& classifier, Real dt) {
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    Errors& of = bodies_[i];
    const StepType how = classifier.step_of(static_cast<int>(i));
    if (how == StepType::flight || how == StepType::none) of.step_x = of.step_v = Vec3::Zero();
    if (how == StepType::substeps) of.step_v.setZero(), of.v.setZero();
    of.x += dt * of.v + of.step_x;
    of.v += of.step_v;
  }
}

BodyError ErrorControl::error_of(int body, StepClassifier& classifier, const IslandSettings& settings,
                                 int substeps) const {
  const auto i = static_cast<std::size_t>(body);
  if (i >= bodies_.size()) return {};
  const Errors& of = bodies_[i];
  BodyError known{.how = classifier.step_of(body), .place = of.x.norm()};
  known.step = of.step_x.norm() + horizon / 2 * of.step_v.norm();
  if (known.how == StepType::half_steps) {
    const LastErrorCheck& check = checks_[std::size_t(classifier.island_of(body))];
    known.order = check.order();
    known.substeps = substeps;
    known.kept = check.kept;
  } else if (known.how == StepType::substeps) {
    known.order = 1;
    known.substeps = substeps;
    known.place += sunken_;
    known.kept = substep_error(0, settings.error) <= 1 && !met_[std::size_t(classifier.island_of(body))];
  }
  return known;
}

void ErrorControl::forget_step(const IslandWorld& island, const World& whole) {
  for (const int body : island.bodies()) {
    Errors& of = bodies_[std::size_t(body)];
    if (whole.bodies[std::size_t(body)].movable()) of.step_x = of.step_v = Vec3::Zero();
  }
}

void ErrorControl::control(IslandWorld& island, IslandMemory& memory, const IslandStep& step) {
  LastErrorCheck& check = checks_[std::size_t(island.lowest())];
  const IslandSettings& settings = step.settings;
  const bool unchecked = std::isinf(settings.error);
  if (unchecked || (island.impact && step.classifier.many_contacts(island.lowest()))) {
    check = {.kept = unchecked};  // the order of the impacts is not known
    forget_step(island, step.whole);
    return control_by_energy(island, memory, step);
  }
  const int contacts = step.classifier.contacts(island.lowest());
  const bool joints = !island.world.joints.empty(), alone = joints && !island.impact;
  const bool meets = step.classifier.impact(island.lowest());
  Search search{island, memory, step, check, settings.error * step.dt / horizon, sliding(island.world)};
  const bool again_of_second_order = check.fourth == 1 || (check.fourth > 0 && !alone);
  check.fourth = alone ? std::max(0, check.fourth - 1) : 0;
  if (again_of_second_order) {
    memory.next = most_of_second_order;
    check.steps_since = settings.check_every;
  }
  search.begun = std::max(memory.next, joints ? least : 1);
  search.most = alone                                            ? most_of_second_order
                : joints                                         ? settings.most_half_steps
                : step.classifier.many_contacts(island.lowest()) ? most_of_many
                                                                 : most_of_few;
  if (check.fourth > 0) search.most = settings.most_half_steps;
  if (!meets && contacts == check.contacts && ++check.steps_since < settings.check_every && repeat_last(search)) return;
  check.steps_since = 0;
  check.contacts = contacts;
  const int begun = search.begun = std::max(search.begun, least);
  Real off = find_enough(search);
  if (alone && check.fourth == 0 && !check.kept) {
    check.fourth = fourth_for;
    search.begun = least, search.most = settings.most_half_steps;
    off = find_enough(search);
  }
  if (check.fourth > 0 && !island.held) {
    check.fourth = 0;
    search.begun = 2 * most_of_second_order, search.most = settings.most_half_steps;
    off = find_enough(search);
  }
  if (!island.held) return;
  const int needed = check.kept || joints ? memory.substeps : begun;
  if (meets && bounced(island.world)) check.kept = false;
  check.spin = fastest_spin(island.world);
  check.off = off;
  memory.next = fewer_will_do(off, check.order()) ? needed / 2 : needed;
}

void ErrorControl::set_order(Search& search) {
  IslandWorld& island = search.island;
  island.fourth = search.check.fourth > 0;
  island.set_order();
  if (island.fourth) island.set(search.step.settings.joint_half_step);
  island.half_step.tolerance = std::min(island.half_step.tolerance, search.allowed / 100);
}

/// Takes the step as the last one. Returns whether that is enough, because nothing has changed since its error was checked.
bool ErrorControl::repeat_last(Search& search) {
  IslandWorld& island = search.island;
  set_order(search);
  search.memory.substeps = search.begun;
  island.held = try_half_steps(island, search.step, search.begun).energy_error <= 1;
  const LastErrorCheck& check = search.check;
  const Real quicker = fastest_spin(island.world) / check.spin;
  const bool whips = search.joints() && off_when(quicker, check.off, check.order()) > 1;
  const bool met = island.impact && island.half_step.events() > 0;
  if (island.held && !whips && !met && sliding(island.world) == search.sliding) return true;
  if (island.held && whips && 2 * search.begun <= search.most && island.half_step.halvings() == 0) {
    search.coarse = island.world.bodies;
    search.begun *= 2;
  }
  return false;
}

/// m: the error of the island, which has been moved in twice as many substeps as `coarse`.
Real ErrorControl::difference(const Search& search) {
  const Real parts = parts_of_difference(search.check.order());
  Real largest = 0;
  for (std::size_t i = 0; i < search.coarse.size(); ++i) {
    const Body &coarse = search.coarse[i], &fine = search.island.world.bodies[i];
    if (!fine.movable()) continue;
    Errors& of = bodies_[std::size_t(search.island.bodies()[i])];
    of.step_x = (coarse.position - fine.position) / parts;
    of.step_v = (coarse.velocity - fine.velocity) / parts;
    largest = std::max(largest, of.step_x.norm() + horizon / 2 * of.step_v.norm());
  }
  return largest;
}

/// A step in `memory.substeps`, with its position error, if `coarse` is known.
StepOutcome ErrorControl::try_twice(Search& search) {
  IslandWorld& island = search.island;
  StepOutcome outcome = try_half_steps(island, search.step, search.memory.substeps);
  const Real energy_error = outcome.energy_error;
  island.held = island.joined_and_near() ? energy_error <= 1 : std::isfinite(energy_error);
  outcome.position_error = infinite_error;
  if (!island.held || search.coarse.empty()) return outcome;
  outcome.position_error = std::max(energy_error, difference(search) / search.allowed);
  if (sliding(island.world) == search.sliding) return outcome;
  // A change between sliding and sticking happens once, not in each step. Half of the error may be spent on it.
  const Real slows = largest_friction(island.world) * search.step.whole.gravity.norm();
  const Real substep = search.step.dt / static_cast<Real>(search.memory.substeps);
  outcome.position_error =
      std::max(outcome.position_error, sticks_early(slows, substep) / (search.step.settings.error / 2));
  return outcome;
}

/// Doubles the substeps until they are enough. Returns the error of the last ones, as a fraction of what is allowed.
Real ErrorControl::find_enough(Search& search) {
  IslandWorld& island = search.island;
  IslandMemory& memory = search.memory;
  set_order(search);
  // A step that had to be divided is like two, and tells nothing about their error.
  const auto undivided = [&] { return island.half_step.halvings() == 0; };
  if (search.coarse.empty() && std::isfinite(try_half_steps(island, search.step, search.begun / 2).energy_error) &&
      undivided())
    search.coarse = island.world.bodies;
  Real off = infinite_error;
  int kept = 0, no_better = 0;
  for (memory.substeps = search.begun;; memory.substeps *= 2) {
    const Real before = off;
    const StepOutcome outcome = try_twice(search);
    Worth now = Worth::more;
    if (island.held && !search.coarse.empty()) {
      off = outcome.position_error;
      now = worth(off, before);
    }
    search.check.kept = now == Worth::kept;
    // If a body comes to rest or begins to slide, two steps can have the same error.
    if (search.check.kept && ++kept < (sliding(island.world) == search.sliding ? 1 : 2)) now = Worth::more;
    // A chain has nothing to decide. If it whips, so few substeps are far from their limit.
    if (search.joints() && now == Worth::no_better && ++no_better < 2) now = Worth::more;
    if (now != Worth::more || 2 * memory.substeps > search.most || !can_double(island, outcome)) break;
    search.coarse.clear();
    if (island.held && undivided()) search.coarse = island.world.bodies;
  }
  search.coarse.clear();
  return off;
}

}  // namespace pushback
