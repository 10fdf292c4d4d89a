/// Applies the tuning rule of the sources, which is to raise beta until the motion becomes unstable and to use half of that value.
#pragma once

#include "pushback/chapters/03_baumgarte/baumgarte.h"
#include "pushback/common/experiment/plot.h"
#include "pushback/common/world/measure.h"
#include "pushback/common/world/situations.h"
#include "pushback/common/world/steps_in.h"

namespace pushback::baumgarte_scenes {

template <class ContactSolver>
ContactSolver with_beta(Real beta) {
  ContactSolver solver;
  solver.beta = beta;
  return solver;
}

/// Jitter of a stack with this number of boxes, m/s, which is the root mean square of the speed in the last second.
template <class ContactSolver>
Real jitter_of_stack(int boxes, ContactSolver solver, Real seconds, Real dt, int sweeps) {
  World world;
  stack(world, boxes);
  Real sum = 0;
  const int steps = steps_in(seconds, dt), last = steps_in(1, dt);
  for (int step = 0; step < steps; ++step) {
    world.step(solver, dt, sweeps);
    if (step >= steps - last) sum += 2 * kinetic_energy(world) / static_cast<Real>(boxes * 100);
  }
  return std::sqrt(sum / static_cast<Real>(last));
}

struct Tuning {
  Panel panel;             ///< jitter against beta
  Real unstable_from = 0;  ///< the least beta that was unstable; 0: none up to 2 was
};

/// `unstable`: the jitter of a stack of three, m/s, above which its motion is called unstable. The stack gets so many sweeps
/// that only beta can be the cause.
inline Tuning tune_beta(Real unstable, Real dt) {
  Tuning tuning{.panel = {.title = "raise β until a stack of three is unstable, use half",
                          .x_label = "β",
                          .y_label = "jitter, m/s",
                          .log_y = true}};
  Curve jitter{"", {}, {}, line_colour(0), Curve::Style::line_and_points};
  for (int i = 1; i <= 40; ++i) {
    const Real beta = static_cast<Real>(i) * Real(0.05);
    jitter.x.push_back(beta);
    const auto solver = with_beta<Solver<Clamping, Baumgarte>>(beta);
    jitter.y.push_back(std::max(jitter_of_stack(3, solver, 5, dt, 30), Real(1e-9)));
    if (tuning.unstable_from == 0 && jitter.y.back() > unstable) tuning.unstable_from = beta;
  }
  tuning.panel.curves.push_back(std::move(jitter));
  if (tuning.unstable_from > 0) {
    const auto line = [](Real beta, const char* colour, const char* words, const char* place) {
      return fmt::format(
          "set arrow from {0}, graph 0 to {0}, graph 1 nohead lw 2 lc rgb '{1}'\n"
          "set label '{2} {0:.3g}' at {0}, graph {3},0\n",
          beta, colour, words, place);
    };
    tuning.panel.extra = line(tuning.unstable_from, "#d55e00", "unstable from", "0.08 offset 0.7") +
                         line(tuning.unstable_from / 2, "#009e73", "use", "0.92 right offset -0.7");
  }
  return tuning;
}

}  // namespace pushback::baumgarte_scenes
