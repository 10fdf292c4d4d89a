/// A stack for ten seconds, with so many small steps and so many sweeps in each.
#pragma once

#include <functional>

#include "pushback/chapters/11_substeps/substeps.h"
#include "pushback/common/experiment/plot.h"
#include "pushback/common/world/measure.h"
#include "pushback/common/world/situations.h"

namespace pushback {

/// How far its top body is from where it was, sideways, m. It started over the origin.
inline Real drift_of_top(const World& world) {
  const Vec3& top = world.bodies.back().position;
  return std::hypot(top.x(), top.z());
}

struct Budget {
  int substeps, sweeps;  ///< in each step of dt; in each small step
};

struct StackCurves {
  Curve drift, speed, overlap;  ///< mm, mm/s, mm, against what `along` says
};

/// `along`: what a budget is drawn at.
template <class ContactSolver>
StackCurves study(const std::string& name, std::size_t colour, int boxes, Real dt, const std::vector<Budget>& budgets,
                  const std::function<int(const Budget&)>& along) {
  Curve empty{name, {}, {}, line_colour(colour), Curve::Style::line_and_points};
  StackCurves stood{empty, empty, empty};
  const auto steps = static_cast<int>(std::lround(10 / dt)), second = static_cast<int>(std::lround(1 / dt));
  for (const Budget& budget : budgets) {
    World world;
    stack(world, boxes);
    ContactSolver solver;
    Real fastest = 0, deepest = 0;
    for (int step = 0; step < steps; ++step) {
      substeps(world, solver, dt, budget.substeps, budget.sweeps);
      deepest = std::max(deepest, deepest_overlap(world));
      if (step >= steps - second) fastest = std::max(fastest, largest_speed(world));
    }
    const auto add = [&](Curve& curve, Real value) {
      curve.x.push_back(static_cast<Real>(along(budget)));
      curve.y.push_back(std::max(1000 * value, Real(1e-6)));
    };
    add(stood.drift, drift_of_top(world));
    add(stood.speed, fastest);
    add(stood.overlap, deepest);
  }
  return stood;
}

}  // namespace pushback
