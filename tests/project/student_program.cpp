// The program that docs/your_own_scene.md shows. test_student compares the two.
// page begins
#include "pushback/chapters/07_warm_start/full_solver.h"
#include "pushback/chapters/27_which_error/choose.h"
#include "pushback/common/experiment/experiment.h"
#include "pushback/engine/presets.h"

using namespace pushback;

int main(int argc, char** argv) {
  Experiment e("my_experiment", "Do the boxes stand, does the brick stop, does the ball bounce?");
  e.command("--choose", "a scene within an error", choose);
  return e.run(argc, argv, [&] {
    const auto fill = [](World& world) {
      stack(world, 3);  // boxes of 1 m and 100 kg, on the ground
      world.add(box({0.4, 0.2, 0.4}, 30).at({-4, 0.2, 0}).moving({4, 0, 0}));
      world.add(sphere(0.4, 20).at({2, 3, 0}).bouncy(0.6));
    };
    e.scene({.name = "my scene", .fill = fill});
    e.variant("without friction", Solver<Clamping, Baumgarte, Slop, Restitution>{});
    e.variant("all seven chapters", FullSolver{});
    e.variant("recommended", Recommended{});
    e.number("speed of the brick", "m/s", [](const Run& run) { return run.world.bodies[4].velocity.norm(); });
  });
}
// page ends
