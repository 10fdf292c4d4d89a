/// What chapters 11 and 12 both look at: two scenes, and a stack for ten seconds with any number of substeps and sweeps.
#pragma once

#include "pushback/chapters/11_substeps/scenes.h"
#include "pushback/chapters/11_substeps/substeps.h"
#include "pushback/common/experiment/experiment.h"
#include "pushback/common/world/measure.h"

namespace pushback::substeps_scenes {

/// How far its top body is from where it was, sideways, m. It started over the origin.
inline Real drift_of_top(const World& world) {
  const Vec3& top = world.bodies.back().position;
  return std::hypot(top.x(), top.z());
}

/// Of the latest scene: how far its top body drifts, and how deep contacts are at the end.
inline void number_overlap(Experiment& e) {
  e.number("overlap at the end", "mm", [](const Run& run) { return 1000 * run.samples.back().overlap; });
}
inline void watch_drift(Experiment& e) {
  e.series("drift of the top", "mm", [](const World& world) { return 1000 * drift_of_top(world); }, true);
  e.number("drift of the top", "mm", [](const Run& run) { return 1000 * drift_of_top(run.world); });
}

/// The scene of a stack before two posts, and what is measured of it; variants are to follow.
inline void scene_of_stack(Experiment& e, int boxes) {
  const Real top = static_cast<Real>(boxes);
  e.scene({.name = "a stack of " + spelled(boxes),
           .fill = [boxes](World& world) { stack_before_posts(world, boxes); },
           .camera = {{0, top - Real(3.5), 12}, {0, top - Real(2.8), 0}},
           .seconds = 10,
           .instants = {0, 2, Real(3.5), 6}});
  watch_drift(e);
  e.series("largest speed", "mm/s", [](const World& world) { return 1000 * largest_speed(world); }, true);
  e.number("speed in the last second", "mm/s", [](const Run& run) {
    const auto& speeds = run.series.at("largest speed");
    const auto second = std::min<std::ptrdiff_t>(std::ssize(speeds), std::lround(1 / run.dt));
    return *std::max_element(speeds.end() - second, speeds.end());
  });
  number_overlap(e);
}

/// And that of a box on one that is lighter.
inline void scene_of_heavy(Experiment& e, const HeavyOnLight& heavy) {
  e.scene({.name = spelled(heavy.mass_ratio) + " times heavier than what it lies on",
           .fill = heavy,
           .camera = {{2, Real(1.8), 5}, {0, Real(0.95), 0}},
           .seconds = 5,
           .instants = {0, Real(0.25), Real(0.5), 5}});
  e.series("deepest overlap", "mm", [](const World& world) { return 1000 * deepest_overlap(world); }, true);
  e.number("height of the heavy one", "m", [](const Run& run) { return run.world.bodies[2].position.y(); });
  e.number("deepest of all", "mm", [](const Run& run) {
    Real deepest = 0;
    for (const Sample& sample : run.samples) deepest = std::max(deepest, sample.overlap);
    return 1000 * deepest;
  });
  number_overlap(e);
}

struct Budget {
  int substeps, sweeps;  ///< in each step of dt; in each substep
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

inline Panel study_panel(const std::string& title, const std::string& x, const std::string& y,
                         const std::vector<Curve>& curves) {
  return {.title = title, .x_label = x, .y_label = y, .log_x = true, .log_y = true, .curves = curves};
}

}  // namespace pushback::substeps_scenes
