// The smallest program of one's own, which README.md shows. test_student compares the two, and runs this one.
// page begins
#include <cstdio>
#include "pushback/engine/presets.h"

using namespace pushback;

int main() {
  World world;
  world.add(ground());
  for (Real y = 0.5; y < 10; ++y)  // ten boxes of 1 m and 100 kg: half sides, mass, centre
    world.add(box({0.5, 0.5, 0.5}, 100).at({0, y, 0}));
  Recommended solver;
  for (int i = 0; i < 600; ++i) world.step(solver, 1.0 / 60);
  std::printf("The top box is at %.4f m.\n", world.bodies.back().position.y());
}
// page ends
