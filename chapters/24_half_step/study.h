/// The error of a motion, by the number of substeps. The slope is the order.
#pragma once

#include "pushback/chapters/19_accuracy_and_time/motion.h"
#include "pushback/chapters/24_half_step/plain.h"
#include "pushback/common/world/any_solver.h"
#include "pushback/engine/half_step/half_step.h"

namespace pushback::half_step_scenes {

/// A bob released at 60 degrees.
inline plain_24::Bob bob_let_go() {
  return {{std::sin(pi / 3), -std::cos(pi / 3), 0}, Vec3::Zero(), 1};
}

/// The fourth-order composition of plain half steps.
inline void composed_step(plain_24::Bob& bob, const Vec3& g, Real h) {
  for (const Real part : suzuki) half_step(bob, g, part * h);
}

/// The places of a bob after each 1/60 s of 2 s, m.
template <class Step>
std::vector<Vec3> places_of_bob(const Step& step, int substeps) {
  plain_24::Bob bob = bob_let_go();
  std::vector<Vec3> places;
  for (int frame = 0; frame < 2 * frames_per_second; ++frame) {
    for (int i = 0; i < substeps; ++i)
      step(bob, Vec3(0, -World::g, 0), Real(1) / static_cast<Real>(frames_per_second * substeps));
    places.push_back(bob.x);
  }
  return places;
}
/// The largest distance from the truth, m.
inline Real largest_distance(const std::vector<Vec3>& places, const std::vector<Vec3>& truth) {
  Real largest = 0;
  for (std::size_t i = 0; i < places.size(); ++i) largest = std::max(largest, (places[i] - truth[i]).norm());
  return largest;
}

/// The largest distance of a body of a motion from its true place after whole frames, m.
inline Real largest_error(const Motion& motion, const std::vector<Places>& truth, AnySolver solver) {
  World world;
  motion.begin(world);
  double largest = 0;
  for (const Places& places : truth) {
    world.step(solver, Real(1) / frames_per_second);
    for (std::size_t i = 0; i < places.size(); ++i)
      largest = std::max(largest, (world.bodies[i].position.cast<double>() - places[i]).norm());
  }
  return static_cast<Real>(largest);
}

inline HalfStep in_substeps(int count, HalfStep step = {}) {
  step.substeps = count;
  step.threshold = 0;  // so that bounces at every speed are compared
  return step;
}

}  // namespace pushback::half_step_scenes
