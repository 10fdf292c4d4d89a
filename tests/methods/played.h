/// A solver plays one of the study's motions.
#pragma once

#include "pushback/tools/measure/study/every_motion.h"
#include "pushback/tools/measure/study/ours.h"
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
  return play(motion, motion.truth(motion.frames()), {.name = "", .title = "", .begin = by_ours(made<ContactSolver>())},
              {.substeps = substeps, .sweeps = sweeps}, {.at_least = 0, .at_most = 600})
      .error;
}

}  // namespace pushback
