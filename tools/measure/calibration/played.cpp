#include "pushback/tools/measure/calibration/played.h"

#include <chrono>

#include "pushback/engine/presets.h"

namespace pushback::calibration {

namespace {

double seconds_of(const auto& act) {
  const auto began = std::chrono::steady_clock::now();
  act();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
}

}  // namespace

Played play(const Scene& scene, const Truth& truth) {
  Played played{.number = truth.number,
                .kind = scene.kind,
                .asked = scene.asked,
                .error = 0,
                .said = 0,
                .flagged = false,
                .steps = 0,
                .estimate = 0};
  World world = scene.world;
  Recommended solver;
  solver.error = scene.asked;
  std::vector<GivenSteps> given;
  double both = 0;
  for (int i = 0; i < frames; ++i) {
    both += seconds_of([&] { world.step(solver, dt); });
    given.push_back(solver.given);
    played.said = 0;
    for (const Body& body : world.bodies) {
      const BodyError known = solver.error_of(body.index);
      played.said = std::max(played.said, known.place);
      played.flagged |= !known.kept;
    }
  }
  played.error = truth.error(world);

  World again = scene.world;
  IslandSolver alone;
  for (const GivenSteps& steps : given) {
    alone.given = steps;
    played.steps += seconds_of([&] { again.step(alone, dt); });
  }
  played.estimate = both - played.steps;
  return played;
}

}  // namespace pushback::calibration
