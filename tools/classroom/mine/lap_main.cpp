/// A lap of ./course mine race: a scene, played once by one solver, in a process of its own.
#include <algorithm>

#include "pushback/chapters/08_friction_cone/flat.h"
#include "pushback/chapters/21_detected_once/detected_once.h"
#include "pushback/common/basics/named.h"
#include "pushback/common/experiment/loaded_solver.h"
#include "pushback/common/experiment/program.h"
#include "pushback/common/world/measure.h"
#include "pushback/tools/catalogue/catalogue.h"
#include "pushback/tools/classroom/mine/lap.h"
#include "pushback/tools/measure/study/stopwatch.h"

using namespace pushback;

namespace {

struct Known {
  std::string name;
  AnySolver solver;
};

Real energy(const World& world) {
  return kinetic_energy(world) + potential_energy(world);
}

Lap lap_of(const NamedScene& scene, AnySolver solver, int steps) {
  World world;
  scene.fill(world);
  const std::vector<Body> start = world.bodies;
  const Real before = energy(world);
  Real overlap = 0, gained = 0, moved = 0;
  Stopwatch own;
  for (int i = 0; i < steps; ++i) {
    own.go();
    world.step(solver, Real(1) / 60);
    own.stop();
    const Real now = energy(world);
    if (!std::isfinite(now)) throw InvalidInput(fmt::format("a number is no longer finite after step {}", i + 1));
    overlap = std::max(overlap, deepest_overlap(world));
    gained = std::max(gained, now - before);
  }
  for (std::size_t i = 0; i < start.size(); ++i)
    if (start[i].movable()) moved = std::max(moved, (world.bodies[i].position - start[i].position).norm());
  return {.ms_per_step = 1000 * own.seconds() / steps,
          .overlap = static_cast<double>(1000 * overlap),
          .moved = static_cast<double>(1000 * moved),
          .speed = static_cast<double>(1000 * largest_speed(world)),
          .energy_gained = static_cast<double>(gained)};
}

}  // namespace

int main(int argc, char** argv) {
  CommandLine line("A scene, played once by one solver.");
  std::string scene, solver, mine;
  int steps = lap_steps;
  line.option("SCENE", scene, "By its name, as ./course effects lists them").required();
  line.option("--solver", solver, "Which of ours");
  line.option("--mine", mine, "A solver as a shared object, instead");
  line.option("--steps", steps, "So many, of 1/60 s").between(1, 100000).shows_default();
  return line.run(argc, argv, [&] {
    const std::vector<NamedScene> scenes = all_scenes();
    const NamedScene played = named("scene", scenes, scene);
    const std::vector<Known> ours{{plain_name, flat_08::FlatSolver{}}, {recommended_name, DetectedOnce{}}};
    const Lap lap = lap_of(played, mine.empty() ? named("solver", ours, solver).solver : loaded_solver(mine), steps);
    fmt::print("\n{}\n", line_of(lap));  // whatever the solver has printed
  });
}
