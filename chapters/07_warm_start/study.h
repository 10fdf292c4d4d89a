/// Measures how well a given number of sweeps solves a stack at rest.
#pragma once

#include "pushback/chapters/07_warm_start/full_solver.h"
#include "pushback/common/experiment/plot.h"
#include "pushback/common/world/situations.h"
#include "pushback/common/world/steps_in.h"

namespace pushback::warm_start_scenes {

/// The largest residual of a row of a stack, averaged over the last of five seconds, m/s. `solver`: a solver that has not solved
/// anything yet.
template <class ContactSolver>
Real residual_of_stack(ContactSolver solver, int boxes, Real dt, int sweeps) {
  World world;
  stack(world, boxes);
  Real sum = 0;
  const int steps = steps_in(5, dt), last = steps_in(1, dt);
  for (int step = 0; step < steps; ++step) {
    world.step(solver, dt, sweeps);
    if (step < steps - last) continue;
    Real largest = 0;
    for (const Row& row : solver.rows()) largest = std::max(largest, row.error());
    sum += largest / static_cast<Real>(last);
  }
  return sum;
}

struct Study {
  Curve residual;       ///< m/s, against sweeps
  std::string verdict;  ///< a sentence with the number of sweeps for a residual below 1e-3 m/s
};

template <class ContactSolver>
Study study(const std::string& name, const ContactSolver& solver, int boxes, const std::vector<int>& sweep_counts,
            Real dt, std::size_t colour) {
  Study s{{name, {}, {}, line_colour(colour), Curve::Style::line_and_points},
          name + ": no number of sweeps tried leaves a residual below 1e-3 m/s"};
  bool found = false;
  for (const int sweeps : sweep_counts) {
    const Real residual = residual_of_stack(solver, boxes, dt, sweeps);
    s.residual.x.push_back(static_cast<Real>(sweeps));
    s.residual.y.push_back(residual);
    if (!found && residual < Real(1e-3)) {
      s.verdict = fmt::format("{}: a residual below 1e-3 m/s takes {} sweeps", name, sweeps);
      found = true;
    }
  }
  return s;
}

}  // namespace pushback::warm_start_scenes
