/// The same solver with one push-out or another, and how a stack trembles under it.
#pragma once

#include "pushback/chapters/07_warm_start/full_solver.h"
#include "pushback/chapters/11_position_correction/nonlinear_gauss_seidel.h"
#include "pushback/chapters/11_position_correction/split_impulse.h"
#include "pushback/common/experiment/plot.h"
#include "pushback/common/world/measure.h"
#include "pushback/common/world/situations.h"

namespace pushback {

/// FullSolver, if it is Baumgarte.
template <class PushOut>
using With = CorrectingSolver<Clamping, PushOut, Slop, Restitution, Friction, WarmStart>;

/// The root mean square of the speed in the last of ten seconds, mm/s, of a stack; against beta.
template <class PushOut>
Curve jitter_of_stack(const std::string& name, std::size_t colour, int boxes, Real dt, With<PushOut> solver) {
  Curve jitter{name, {}, {}, line_colour(colour), Curve::Style::line_and_points};
  const auto steps = static_cast<int>(std::lround(10 / dt));
  const auto last = std::max(1, static_cast<int>(std::lround(1 / dt)));
  for (const Real beta : {Real(0.05), Real(0.1), Real(0.2), Real(0.4), Real(0.6), Real(0.8), Real(1)}) {
    World world;
    stack(world, boxes);
    With<PushOut> its_own = solver;
    its_own.beta = beta;
    Real sum = 0;
    for (int step = 0; step < steps; ++step) {
      world.step(its_own, dt, 10);
      if (step >= steps - last) sum += 2 * kinetic_energy(world) / (static_cast<Real>(boxes) * 100);
    }
    jitter.x.push_back(beta);
    jitter.y.push_back(1000 * std::sqrt(sum / static_cast<Real>(last)));
  }
  return jitter;
}

}  // namespace pushback
