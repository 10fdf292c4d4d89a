#include "pushback/chapters/07_warm_start/full_solver.h"
#include "pushback/chapters/20_only_what_is_needed/dispatch.h"
#include "pushback/chapters/20_only_what_is_needed/everything.h"
#include "pushback/chapters/20_only_what_is_needed/scenes.h"
#include "pushback/common/experiment/experiment.h"
#include "pushback/common/render/palette.h"

using namespace pushback;
using namespace pushback::only_what_is_needed_scenes;

namespace {

/// Chooses the effects in the first step.
struct Needed {
  std::optional<Sleep> sleep = {};
  std::optional<OnlyWhatIsNeeded> chosen = {};

  std::size_t operator()(World& world, Real dt, int sweeps) {
    if (!chosen) chosen.emplace(world, FullSolver{}, sleep);
    chosen->step(world, dt, sweeps);
    return chosen->rows().size();
  }
};

/// The largest distance of a body from its place under the solver with everything, mm.
std::function<Real(const Run&)> apart_from_everything(const std::function<void(World&)>& fill, int sweeps) {
  return [fill, sweeps](const Run& run) {
    World world;
    fill(world);
    Everything everything;
    for (std::size_t step = 0; step < run.samples.size(); ++step) world.step(everything, run.dt, sweeps);
    Real apart = 0;
    for (std::size_t i = 0; i < world.bodies.size(); ++i)
      apart = std::max(apart, (world.bodies[i].position - run.world.bodies[i].position).norm());
    return 1000 * apart;
  };
}

const std::string asleep = "called for, and asleep where it rests";

template <class Value>
Real mean(const Run& run, Value Sample::* what) {
  Real sum = 0;
  for (const Sample& sample : run.samples) sum += static_cast<Real>(sample.*what);
  return sum / static_cast<Real>(run.samples.size());
}

}  // namespace

int main(int argc, char** argv) {
  Experiment e("20_only_what_is_needed", "What may a scene leave out?");
  Sleep sleep;
  e.parameter({"--still-for", "s", "s", "Time at rest before a body may sleep", 0.01, 10}, &sleep.time_to_sleep);
  e.parameter({"--place", "p", "m", "Distance that a resting body may move", 0.0001, 0.5}, &sleep.rest_distance);
  FivePiles piles;
  e.parameter({"--speed", "v", "m/s", "Speed of the rolling ball", 1, 15}, &piles.speed);
  e.parameter({"--mass-ratio", "", "", "Mass of the ball, in box masses", 0.05, 50}, &piles.mass_ratio);
  return e.run(argc, argv, [&] {
    const Needed rested{.sleep = sleep};
    const auto measured = [&](const std::function<void(World&)>& fill) {
      e.number("contact points, mean of all steps", "", [](const Run& run) { return mean(run, &Sample::contacts); });
      e.number("rows, mean of all steps", "", [](const Run& run) { return mean(run, &Sample::rows); });
      e.number("apart from everything at the end", "mm", apart_from_everything(fill, e.sweeps()));
    };
    e.scene({.name = "five piles, and a ball for one of them",
             .fill = piles,
             .camera = {{0, Real(5.5), 12}, {0, Real(0.9), 0}},
             .seconds = 6,
             .instants = {Real(1.2), Real(1.6), 6},
             .caption = "Dark bodies sleep: they cost nothing. Only the pile that the ball hits wakes; the last row of "
                        "the strip is the ball.",
             .raster = Raster{"body",
                              [](const World& world) {
                                std::vector<int> column;
                                for (const Body& body : world.bodies)
                                  if (body.movable()) column.push_back(body.asleep ? 1 : 0);
                                return column;
                              },
                              {{body_ink(2), "awake"}, {asleep_ink(), "asleep"}}},
             .cell_height = 200});
    e.motion(asleep, rested).without_curves();
    e.number("contact points, mean of all steps", "", [](const Run& run) { return mean(run, &Sample::contacts); });

    e.scene({.name = "the same piles, three solvers", .fill = piles, .seconds = 6, .pictures = false});
    e.variant("everything", Everything{});
    e.motion("what is called for", Needed{});
    e.motion(asleep, rested);
    measured(piles);
    e.series("contact points", "", [](const World& world) { return static_cast<Real>(world.contacts.size()); });

    e.scene({.name = "cubes on ice: no friction, no bounce, no wobble",
             .fill = cubes_on_ice,
             .seconds = 4,
             .pictures = false});
    e.variant("everything", Everything{}).without_curves();
    e.motion("what is called for", Needed{}).without_curves();
    e.motion(asleep, rested).without_curves();
    measured(cubes_on_ice);
  });
}
