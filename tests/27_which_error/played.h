/// Worlds that are played within an error, and beside what is true.
#pragma once

#include <fmt/format.h>

#include "pushback/chapters/19_accuracy_and_time/true_places.h"
#include "pushback/engine/islands/island_solver.h"
#include "tests/support/yardstick.h"

namespace pushback::which_error_tests {

inline IslandSolver within(Real error) {
  IslandSolver solver;
  solver.substep_solver.threshold = solver.contact_half_step.threshold = 0;  // bounces are compared at every speed
  solver.error = error;
  return solver;
}

/// m.
inline Real farthest(const World& world, const Places& truth) {
  double largest = 0;
  for (std::size_t i = 0; i < truth.size(); ++i)
    largest = std::max(largest, (world.bodies[i].position.cast<double>() - truth[i]).norm());
  return static_cast<Real>(largest);
}

/// How a world fares within an error.
struct Fared {
  Real off = 0;      // at the most, in parts of the error
  bool said = true;  // that each step was within it
};
inline Fared fare(World world, Real error, const std::vector<Places>& truth) {
  IslandSolver solver = within(error);
  Fared fared;
  for (const Places& places : truth) {
    world.step(solver, h);
    for (const Body& body : world.bodies) fared.said &= solver.error_of(body.index).kept;
    fared.off = std::max(fared.off, farthest(world, places) / error);
  }
  return fared;
}

}  // namespace pushback::which_error_tests
