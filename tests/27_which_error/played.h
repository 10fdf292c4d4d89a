/// Worlds that are played within an error, as a user has it, and compared with what is true.
#pragma once

#include <functional>

#include "pushback/chapters/19_accuracy_and_time/motion.h"
#include "pushback/engine/half_step/half_step.h"
#include "pushback/engine/presets.h"
#include "tests/support/yardstick.h"

namespace pushback::which_error_tests {

using Change = std::function<void(World&)>;

inline Recommended within(Real error) {
  Recommended solver;
  solver.error = error;
  return solver;
}

inline Places places_of(const World& world) {
  Places places;
  for (const Body& body : world.bodies) places.push_back(body.position.cast<double>());
  return places;
}
/// m: the largest distance of a body from its place.
inline Real farthest(const Places& places, const Places& truth) {
  double largest = 0;
  for (std::size_t i = 0; i < truth.size(); ++i) largest = std::max(largest, (places[i] - truth[i]).norm());
  return static_cast<Real>(largest);
}

/// After each of `steps` steps. `change`: what the program changes after half of the time.
inline std::vector<Places> places_by(HalfStep solver, World world, int steps, const Change& change = {}) {
  std::vector<Places> places;
  for (int i = 0; i < steps; ++i) {
    if (change && i == steps / 2) change(world);
    world.step(solver, h);
    places.push_back(places_of(world));
  }
  return places;
}

/// The largest error that is said of a body, m, and whether each is said to be kept.
struct Said {
  Real position_error = 0;
  bool kept = true;
};
inline Said said_of(const World& world, TwinSolver& solver) {
  Said said;
  for (const Body& body : world.bodies) {
    const BodyError known = solver.error_of(body.index);
    said.position_error = std::max(said.position_error, known.position_error);
    said.kept &= known.kept;
  }
  return said;
}

/// How a world fares within an error.
struct Fared {
  Real off = 0, kept_off = 0;  // in parts of the error, at the most: in all steps, and until it is said not to be kept
  Real beyond = 0;             // m: by how much it was further off than had ever been said, at the most
  Real last_off = 0, last_said = 0;  // m: after the last step
  bool kept = true;                  // each step is said to be
};
inline Fared fare(World world, Real error, const std::vector<Places>& truth, const Change& change = {}) {
  Recommended solver = within(error);
  Fared fared;
  Real most_said = 0;
  for (std::size_t i = 0; i < truth.size(); ++i) {
    if (change && i == truth.size() / 2) change(world);
    world.step(solver, h);
    const Said said = said_of(world, solver);
    fared.last_off = farthest(places_of(world), truth[i]), fared.last_said = said.position_error;
    fared.kept &= said.kept;
    fared.off = std::max(fared.off, fared.last_off / error);
    if (fared.kept) fared.kept_off = fared.off;
    most_said = std::max(most_said, said.position_error);
    fared.beyond = std::max(fared.beyond, fared.last_off - most_said);
  }
  return fared;
}

}  // namespace pushback::which_error_tests
