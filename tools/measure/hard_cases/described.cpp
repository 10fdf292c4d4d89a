#include <fmt/format.h>

#include <algorithm>

#include "pushback/common/experiment/experiment.h"
#include "pushback/tools/measure/hard_cases/table.h"

namespace pushback {

namespace {

constexpr Real least_time = 5;  // s: the picture of a case may be of its first instants

Scene scene_of(const HardCase& hard_case) {
  Scene scene = hard_case.scene;
  scene.key = hard_case.name;
  scene.caption = fmt::format("Hard because: {}. Asked: {}.", hard_case.stresses, criteria_of(hard_case));
  scene.seconds = std::max(scene.seconds, least_time);
  return scene;
}

}  // namespace

void describe_hard_cases(Experiment& experiment) {
  for (const HardCase& hard_case : hard_cases()) {
    experiment.scene(scene_of(hard_case));
    for (const Stage& stage : stages()) {
      experiment.variant(stage.name, stage.solver).checked =
          false;  // a stage that refuses a case says so where it is played
    }
    experiment.series("fastest body", "m/s", largest_speed);
    experiment.series("deepest overlap", "mm", [](const World& world) { return 1000 * deepest_overlap(world); });
    experiment.number("fastest body now", "m/s", [](const Run& run) { return largest_speed(run.world); });
    experiment.number("deepest overlap so far", "mm", [](const Run& run) {
      Real deepest = 0;
      for (const Sample& sample : run.samples) deepest = std::max(deepest, 1000 * sample.overlap);
      return deepest;
    });
    experiment.number("energy gained since the first step", "J", [](const Run& run) {
      const auto energy = [](const Sample& sample) { return sample.kinetic_energy + sample.potential_energy; };
      return energy(run.samples.back()) - energy(run.samples.front());
    });
  }
}

}  // namespace pushback
