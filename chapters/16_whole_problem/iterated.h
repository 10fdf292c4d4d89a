/// The contacts of a scene's first step, for a page that solves them iteration by iteration.
#pragma once

#include <memory>

#include "pushback/common/experiment/iterated_problem.h"
#include "pushback/engine/direct/row_matrix.h"
#include "pushback/engine/direct/sweeping_methods.h"

namespace pushback {

/// Each method keeps a pointer to the problem.
using SharedProblem = std::shared_ptr<const ContactProblem>;

template <class Fill>
SharedProblem first_step(const Fill& fill, Real dt) {
  World world;
  fill(world);
  world.begin_step(dt);
  return std::make_shared<const ContactProblem>(problem_of(world));
}

/// The problem without its methods.
inline IteratedProblem iterated(const SharedProblem& problem) {
  return {.matrix = problem->w,
          .block = 3,
          .block_name = "contact",
          .iteration = "a sweep over all contacts",
          .measure = "relative residual",
          .residual = [problem](const Vector& r) { return relative_residual(*problem, r); }};
}

inline IteratedProblem::Method swept(const SharedProblem& problem, const std::string& method, const std::string& name) {
  return {name, [problem, sweep = sweep_of(*problem, method)](Vector& r) {
            sweep(r);
            return true;
          }};
}

inline IteratedProblem swept_in_all_ways(const SharedProblem& step) {
  IteratedProblem problem = iterated(step);
  problem.methods = {swept(step, "pgs", "pgs"), swept(step, "scaled-back", "scaled back"), swept(step, "cone", "cone"),
                     swept(step, "nscg", "cone, conjugate")};
  return problem;
}

}  // namespace pushback
