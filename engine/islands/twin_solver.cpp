#include "pushback/engine/islands/twin_solver.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "pushback/common/basics/input.h"
#include "pushback/engine/half_step/gap.h"

namespace pushback {

namespace {

constexpr Real horizon = 1;  // s
struct Level {
  int fine, coarse;  // half steps in a step, without a common divisor
};
constexpr std::array levels{Level{5, 2}, Level{9, 2}, Level{19, 4}, Level{37, 8}, Level{73, 16}};
constexpr int most_level = static_cast<int>(levels.size()) - 1, most_level_of_substeps = 1;
constexpr Level of_many{2, 1};          // at the most
constexpr int in_a_half_step = 8;       // substeps
constexpr Real needs_more = Real(0.1);  // of `error`: an impact may make ten times as much of it
constexpr Real needs_less = needs_more / 30;
constexpr Real of_half_as_many = 4;      // times the way that is lost in a stop
constexpr int waits_for_less = 8;        // steps
constexpr Real impact = 3;               // times what gravity does in a step
constexpr Real any_energy = Real(1e30);  // the twin may be as coarse as it is meant to be
constexpr Real lost_beyond = 10;         // times `error`

bool same(const BodyState& before, const Body& now) {
  return before.position == now.position && before.velocity == now.velocity &&
         before.angular_velocity == now.angular_velocity && before.orientation.coeffs() == now.orientation.coeffs();
}

/// m: the distance of a point of the body from where the twin has it, in half a second.
Real expected(const Body& body, const Body& twin) {
  const Real reach = reach_of_core(body);
  return (body.position - twin.position).norm() + reach * body.orientation.angularDistance(twin.orientation) +
         horizon / 2 *
             ((body.velocity - twin.velocity).norm() + reach * (body.angular_velocity - twin.angular_velocity).norm());
}

/// Whether contacts changed its velocity by more than a load at rest does, m/s. Substeps and half steps solve such an impact differently. More
/// substeps do not change that, so the twin does not show by how much.
bool struck(const BodyState& before, const Body& body, Real at_rest) {
  return (body.velocity - before.velocity).norm() +
             reach_of_core(body) * (body.angular_velocity - before.angular_velocity).norm() >
         impact * at_rest;
}

}  // namespace

void TwinSolver::whole_step(World& world, Real dt, int sweeps) {
  if (!(error > 0)) throw InvalidInput(fmt::format("error is {}: a length above 0 is needed", error));
  if (std::isinf(error)) {
    forget_errors();
    given = {};
    return IslandSolver::whole_step(world, dt, sweeps);
  }
  if (twin_.bodies.empty() || twin_.bodies.size() > world.bodies.size() || twin_.time != world.time) begin(world);
  follow(world);
  give_steps(dt);
  twin_.step(coarse_, dt, sweeps);  // first, because the world must not have moved if it is refused
  IslandSolver::whole_step(world, dt, sweeps);
  twin_.time = world.time;  // the sum of other substeps differs by rounding
  compare(world, dt);
}

/// Begins with another world, or after errors have been forgotten.
void TwinSolver::begin(const World& world) {
  twin_ = world;
  coarse_ = *this;
  known_.clear();
  for (const Body& body : world.bodies) known_.push_back({.after = BodyState(body), .begun = world.time});
}

/// Makes the changes in the twin that the program has made in the world.
void TwinSolver::follow(const World& world) {
  static_cast<IslandSettings&>(coarse_) = *this;
  coarse_.energy = any_energy;
  twin_.gravity = world.gravity;
  twin_.forces = world.forces;
  for (std::size_t i = 0; i < world.joints.size(); ++i) {
    if (i == twin_.joints.size()) twin_.joints.push_back(world.joints[i]);
    Joint joint = world.joints[i];
    std::swap(joint.impulses, twin_.joints[i].impulses);
    std::swap(joint.last_impulses, twin_.joints[i].last_impulses);
    twin_.joints[i] = std::move(joint);
  }
  twin_.joints.resize(world.joints.size(), {"", 0, 0, {}});
  for (std::size_t i = twin_.bodies.size(); i < world.bodies.size(); ++i) {
    twin_.bodies.push_back(world.bodies[i]);
    known_.push_back({.after = BodyState(world.bodies[i]), .begun = world.time});
  }
  for (std::size_t i = 0; i < world.bodies.size(); ++i) {
    const BodyState twin(twin_.bodies[i]);
    twin_.bodies[i] = world.bodies[i];
    if (world.bodies[i].movable() && same(known_[i].after, world.bodies[i])) {
      twin.restore(twin_.bodies[i]);
      twin_.bodies[i].refresh_inertia();
    } else {
      known_[i] = {.after = BodyState(world.bodies[i]), .level = known_[i].level, .begun = world.time};
    }
  }
}

void TwinSolver::give_steps(Real dt) {
  given.of_body.clear();
  coarse_.given.of_body.clear();
  int of_substeps = 0;
  for (std::size_t i = 0; i < known_.size(); ++i) {
    const int level = known_[i].level;
    given.of_body.push_back(levels[std::size_t(level)].fine);
    coarse_.given.of_body.push_back(levels[std::size_t(level)].coarse);
    if (step_of(static_cast<int>(i)) == StepType::substeps) of_substeps = std::max(of_substeps, level);
  }
  given.most_of_many = of_many.fine;
  coarse_.given.most_of_many = of_many.coarse;
  const Level substeps = levels[std::size_t(std::min(of_substeps, most_level_of_substeps))];
  given.substeps = in_a_half_step * substeps.fine;
  coarse_.given.substeps = in_a_half_step * substeps.coarse;
  given.tolerance = coarse_.given.tolerance = error * dt / horizon / 100;
  given.threshold = coarse_.given.threshold = std::min(substep_solver.threshold, error / horizon);
}

void TwinSolver::compare(const World& world, Real dt) {
  count_stops(world, dt);
  std::vector<bool> lost(world.bodies.size(), false);
  bool any = false;
  const Real enough = needs_more * error;
  for (std::size_t i = 0; i < world.bodies.size(); ++i) {
    const Body &body = world.bodies[i], &twin = twin_.bodies[i];
    Known& of = known_[i];
    const BodyState before = std::exchange(of.after, BodyState(body));
    if (!body.movable()) continue;
    if (step_of(body.index) == StepType::substeps && struck(before, body, dt * world.gravity.norm()))
      of.lost = world.time;
    const Real off = (body.position - twin.position).norm() / 2 + of.stopped, soon = expected(body, twin) / 2;
    const Real more = std::max(Real(0), soon - std::exchange(of.soon, soon)) * horizon / dt;
    const Real allowed = error * std::max(Real(1), (world.time - of.begun) / horizon);
    of.place = of.carried + off;
    of.kept = off <= allowed && world.time - of.lost >= horizon;
    if (!(off <= allowed)) {  // or it is not a number
      any |= lost[i] = !(off <= lost_beyond * allowed);
    } else if ((soon > enough && more > enough) || of.early > enough) {
      of.level = std::min(of.level + 1, most_level);
      of.unneeded = 0;
    } else if (more > needs_less * error || of_half_as_many * of.early > enough) {
      of.unneeded = 0;
    } else if (++of.unneeded >= waits_for_less) {
      of.level = std::max(of.level - 1, 0);
      of.unneeded = 0;
    }
  }
  if (any) begin_again(world, std::move(lost));
}

/// A body stops, or begins to roll, at the start of a half step, and loses up to mu g h^2 / 2 of its way there. If this is the start of
/// the whole step, its twin loses the same.
void TwinSolver::count_stops(const World& world, Real dt) {
  std::vector<Real> early(known_.size(), 0), sticks = early;  // m, of each body
  for (const Contact& contact : world.contacts)
    for (const std::uint32_t body : {contact.id.body_a, contact.id.body_b}) {
      const Real h = dt / static_cast<Real>(std::max(1, error_of(static_cast<int>(body)).substeps)),
                 loses = contact.friction * world.gravity.norm() * h * h / 2;
      if (contact.state == ContactState::sliding) early[body] = std::max(early[body], loses);
      if (contact.state == ContactState::sticking) sticks[body] = std::max(sticks[body], loses);
    }
  for (std::size_t i = 0; i < known_.size(); ++i) {
    const Real before = std::exchange(known_[i].early, early[i]);
    if (before > 0 && early[i] == 0) known_[i].stopped += std::min(before, sticks[i]);
  }
}

/// Makes the twins of lost bodies equal to them. The same holds for all bodies that touch lost bodies or are joined to them, in the world
/// or in the twin.
void TwinSolver::begin_again(const World& world, std::vector<bool> lost) {
  StepClassifier fine = classifier(), coarse = coarse_.classifier();
  const auto spread = [&](StepClassifier& islands) {
    std::vector<bool> island(world.bodies.size(), false);
    for (const Body& body : world.bodies)
      if (lost[std::size_t(body.index)]) island[std::size_t(islands.island_of(body.index))] = true;
    bool more = false;
    for (const Body& body : world.bodies) {
      if (!body.movable() || lost[std::size_t(body.index)] || !island[std::size_t(islands.island_of(body.index))])
        continue;
      lost[std::size_t(body.index)] = more = true;
    }
    return more;
  };
  while (spread(fine) || spread(coarse)) {
  }
  for (std::size_t i = 0; i < world.bodies.size(); ++i) {
    if (!lost[i]) continue;
    twin_.bodies[i] = world.bodies[i];
    Known& of = known_[i];
    of = {.after = of.after,
          .level = of.level,
          .begun = world.time,
          .carried = of.place,
          .place = of.place,
          .lost = world.time,
          .kept = false};
  }
}

BodyError TwinSolver::error_of(int body) {
  const auto i = static_cast<std::size_t>(body);
  if (i >= known_.size() || std::isinf(error)) return {};
  BodyError known{.step_type = step_of(body), .position_error = known_[i].place, .kept = known_[i].kept};
  if (known.step_type == StepType::half_steps) known.substeps = half_steps_of(body);
  if (known.step_type == StepType::substeps) known.substeps = given.substeps;
  return known;
}

}  // namespace pushback
