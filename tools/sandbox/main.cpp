/// The sandbox of the book: a pile, the effects of chapters 00 to 08 as switches, and boxes and balls that a reader adds. What a
/// reader does is a list of actions, each with its step, so the list makes the same motion again.
#include <fmt/format.h>

#include "pushback/chapters/00_naive_impulses/naive.h"
#include "pushback/common/experiment/experiment.h"
#include "pushback/tools/sandbox/chosen_effects.h"

using namespace pushback;

namespace {

/// As the parameter lists it: four numbers.
struct Action {
  enum Kind : long { flip, box, ball, kind_count };

  long step;
  Kind kind;
  Real x,
      y;  ///< flip: which switch, and whether it is on; box: x, m; ball: the point of the plane z = 0 at which it is thrown, m
};

std::vector<Action> actions_in(const std::vector<Real>& numbers) {
  constexpr std::size_t each = 4;
  if (numbers.size() % each != 0) throw InvalidInput("--actions: each action is four numbers: step, kind, x, y");
  std::vector<Action> actions;
  for (std::size_t i = 0; i < numbers.size(); i += each) {
    const Action action{std::lround(numbers[i]), static_cast<Action::Kind>(std::lround(numbers[i + 1])), numbers[i + 2],
                        numbers[i + 3]};
    const bool known = action.kind >= 0 && action.kind < Action::kind_count &&
                       (action.kind != Action::flip || (action.x >= 0 && action.x < Real(switch_count)));
    if (!known)
      throw InvalidInput(
          fmt::format("--actions: there is no action {}, {}: 0 and a switch from 0 to {}, 1 or 2 are needed",
                      numbers[i + 1], numbers[i + 2], switch_count - 1));
    actions.push_back(action);
  }
  return actions;
}

/// Above all that is near x.
Body dropped(const World& world, Real x) {
  Real top = 0;
  for (const Body& body : world.bodies)
    if (body.movable() && std::abs(body.position.x() - x) < Real(1.5)) top = std::max(top, body.position.y());
  return box(Vec3::Constant(Real(0.5)), 100).at({x, top + Real(1.6), 0}).bouncy(Real(0.1));
}

/// On a parabola from the reader's side to the point, as fast as it is when it arrives.
Body thrown(Real x, Real y) {
  constexpr Real away = 9, speed = 16;  // m, m/s
  const Real time = away / speed;
  const Vec3 from(x / 2, Real(2.5), away);
  const Vec3 velocity = (Vec3(x, y, 0) - from) / time + Vec3(0, World::g * time / 2, 0);
  return sphere(Real(0.4), 150).at(from).moving(velocity).bouncy(Real(0.4));
}

/// Adds what the step adds. Returns the switches as they are then.
Switches act(World& world, const std::vector<Action>& actions, long step) {
  Switches on;
  on.fill(true);
  for (const Action& action : actions) {
    if (action.kind == Action::flip) {
      if (action.step <= step) on[static_cast<std::size_t>(action.x)] = action.y != 0;
    } else if (action.step == step) {
      world.add(action.kind == Action::box ? dropped(world, action.x) : thrown(action.x, action.y));
    }
  }
  return on;
}

long step_of(const World& world, Real dt) {
  return std::lround(world.time / dt);
}

/// The latest step's impulses are in the world, so each step may have a solver of its own.
std::size_t step_with(StepSolver&& solver, World& world, Real dt, int sweeps) {
  world.step(solver, dt, sweeps);
  return static_cast<std::size_t>(solver.stats().rows);
}

std::size_t step_as_switched(World& world, Real dt, int sweeps, const std::vector<Action>& actions) {
  const Switches on = act(world, actions, step_of(world, dt));
  if (!on[velocity_constraint]) return step_with(NaiveOnce{}, world, dt, sweeps);
  Solver<ChosenEffects> solver;
  solver.effects = effects_of(on);
  return step_with(std::move(solver), world, dt, sweeps);
}

using AllEffects = Solver<Clamping, Baumgarte, Slop, Restitution, FrictionCone, WarmStart>;

}  // namespace

int main(int argc, char** argv) {
  Experiment e("sandbox", "What does each effect do?");
  std::vector<Real> numbers;
  e.parameter({"--actions", "", "", "What was done: step, kind, x, y", -1000, 100000}, &numbers);
  return e.run(argc, argv, [&] {
    const std::vector<Action> actions = actions_in(numbers);
    constexpr int base = 9, few_sweeps = 3;  // so that a step without warm starting is seen to be worse
    e.scene({.name = "a pyramid",
             .fill =
                 [](World& world) {
                   pyramid(world, base);
                   for (Body& body : world.bodies) body.bouncy(Real(0.1));
                 },
             .camera = {{4, 8, 22}, {0, Real(4.6), 0}, Real(0.55)},
             .seconds = 60,
             .instants = {0},
             .contacts = Drawn::nothing});
    e.motion("as switched", [=](World& world, Real dt, int sweeps) {
       return step_as_switched(world, dt, sweeps, actions);
     }).with_sweeps(few_sweeps);
    e.motion("all effects", [=](World& world, Real dt, int sweeps) {
       act(world, actions, step_of(world, dt));
       return step_with(AllEffects{}, world, dt, sweeps);
     }).with_sweeps(few_sweeps);
    e.scene({.name = "a stack of five",
             .fill = [](World& world) { stack(world, 5); },
             .camera = {{2, 5, 13}, {0, Real(2.4), 0}, Real(0.62)},
             .seconds = 6,
             .pictures = false});
    e.variant("each contact alone", NaiveOnce{});
    e.variant("all effects", AllEffects{});
  });
}
