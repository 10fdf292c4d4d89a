/// The direct methods, for a page that follows them iteration by iteration.
#pragma once

#include "pushback/chapters/16_whole_problem/iterated.h"
#include "pushback/engine/direct/proximal_newton.h"
#include "pushback/engine/direct/smoothed_newton.h"

namespace pushback {

inline constexpr double iterated_to = 1e-12;  // relative_residual, near the rounding error of these problems

/// An iteration is a linear system. The method is deterministic, so each iteration runs it again with one more system.
inline IteratedProblem::Method smoothed(const SharedProblem& problem, const std::string& name) {
  return {name, [problem, systems = 0](Vector& r) mutable {
            const SmoothedSolution farther =
                solve_smoothed(*problem, {.tolerance = iterated_to, .systems = systems + 1});
            if (farther.systems <= systems) return false;
            systems = farther.systems;
            r = farther.r;
            return true;
          }};
}

/// The course of `best`: `sweeps` sweeps, then Newton's method, whose iterations are rounds of linear systems.
inline IteratedProblem::Method swept_then_newton(const SharedProblem& problem, int sweeps, const std::string& name) {
  return {name, [problem, left = sweeps, sweep = sweep_of(*problem, "nscg"), from = Vector(), rounds = 0,
                 systems = 0](Vector& r) mutable {
            if (left-- > 0) {
              sweep(r);
              from = r;
              return true;
            }
            Vector farther = from;
            const ProximalStats work = solve_proximal(*problem, farther, {iterated_to, ++rounds, 1.5e10});
            if (work.systems <= systems) return false;
            systems = work.systems;
            r = farther;
            return true;
          }};
}

inline IteratedProblem swept_and_solved(const SharedProblem& step) {
  IteratedProblem problem = iterated(step);
  problem.iteration += "; of Newton's method a round of linear systems, of the smoothed one a single system";
  problem.methods = {swept(step, "cone", "sweeps"), swept(step, "nscg", "conjugate sweeps"),
                     swept_then_newton(step, 200, "best: 200 of these, then Newton"),
                     smoothed(step, "smoothed: Newton alone")};
  return problem;
}

}  // namespace pushback
