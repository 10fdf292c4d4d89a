/// The same solver with any of the three push-outs, and the jitter of a stack with this solver.
#pragma once

#include "pushback/chapters/03_baumgarte/tuning.h"
#include "pushback/chapters/07_warm_start/full_solver.h"
#include "pushback/chapters/10_position_correction/nonlinear_gauss_seidel.h"
#include "pushback/chapters/10_position_correction/split_impulse.h"

namespace pushback::position_correction_scenes {

/// `PushOut`: Baumgarte, SplitImpulse or NonlinearGaussSeidel. With Baumgarte it is equivalent to FullSolver.
template <class PushOut>
using With = CorrectingSolver<Clamping, PushOut, Slop, Restitution, Friction, WarmStart>;

/// The jitter of a stack against beta, which is the root mean square of the speed in the last of ten seconds, mm/s.
template <class PushOut>
Curve jitter_curve(const std::string& name, std::size_t colour, int boxes, Real dt, With<PushOut> solver) {
  Curve jitter{name, {}, {}, line_colour(colour), Curve::Style::line_and_points};
  for (const Real beta : {Real(0.05), Real(0.1), Real(0.2), Real(0.4), Real(0.6), Real(0.8), Real(1)}) {
    solver.beta = beta;
    jitter.x.push_back(beta);
    jitter.y.push_back(1000 * baumgarte_scenes::jitter_of_stack(boxes, solver, 10, dt, 10));
  }
  return jitter;
}

}  // namespace pushback::position_correction_scenes
