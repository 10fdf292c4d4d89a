/// A solver plays one of the study's motions.
#pragma once

#include "pushback/tools/measure/study/every_motion.h"
#include "pushback/tools/methods/methods.h"

namespace pushback {

/// With the slop of the motions, where it has one; bounces at every speed.
template <class ContactSolver>
ContactSolver made() {
  ContactSolver solver;
  if constexpr (requires { solver.slop; }) solver.slop = Real(1e-4);
  if constexpr (requires { solver.threshold; }) solver.threshold = 0;
  return solver;
}

/// m, the farthest that any body was from its true place in any frame.
template <class ContactSolver>
double error_of(const std::string& name, int substeps, int sweeps) {
  const Motion& motion = any_motion_named(name);
  const std::vector<Places> truth = motion.truth(motion.frames());
  World world;
  motion.begin(world);
  auto solver = made<ContactSolver>();
  double farthest = 0;
  for (const Places& places : truth) {
    for (int i = 0; i < substeps; ++i) world.step(solver, Real(1) / static_cast<Real>(60 * substeps), sweeps);
    for (std::size_t body = 0; body < places.size(); ++body)
      farthest = std::max(farthest, (world.bodies[body].position.template cast<double>() - places[body]).norm());
  }
  return farthest;
}

}  // namespace pushback
