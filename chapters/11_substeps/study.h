/// Two scenes, and a stack for ten seconds with any number of substeps and sweeps. Chapters 11 and 12 use them.
#pragma once

#include "pushback/chapters/11_substeps/scenes.h"
#include "pushback/chapters/11_substeps/substeps.h"
#include "pushback/common/experiment/experiment.h"
#include "pushback/common/world/measure.h"

namespace pushback::substeps_scenes {

/// The horizontal displacement of the top body, m. It started above the origin.
inline Real drift_of_top(const World& world) {
  const Vec3& top = world.bodies.back().position;
  return std::hypot(top.x(), top.z());
}

/// Adds two numbers to the latest scene, the drift of its top body and the depth of contacts at the end.
inline void number_overlap(Experiment& e) {
  e.number("overlap at the end", "mm", [](const Run& run) { return 1000 * run.samples.back().overlap; });
}
inline Real drift_in_mm(const World& world) {
  return 1000 * drift_of_top(world);
}
inline void number_drift(Experiment& e) {
  e.series_without_curves("drift of the top", drift_in_mm);
  e.number("drift of the top", "mm", [](const Run& run) { return drift_in_mm(run.world); });
}

/// The measured values of a stack.
inline void watch_stack(Experiment& e) {
  e.series("drift of the top", "mm", drift_in_mm, true);
  e.number("drift of the top", "mm", [](const Run& run) { return drift_in_mm(run.world); });
  e.series_without_curves("largest speed", [](const World& world) { return 1000 * largest_speed(world); });
  e.number("speed in the last second", "mm/s", [](const Run& run) {
    const auto& speeds = run.series.at("largest speed");
    const auto second = std::min<std::ptrdiff_t>(std::ssize(speeds), std::lround(1 / run.dt));
    return *std::max_element(speeds.end() - second, speeds.end());
  });
  number_overlap(e);
}

/// The scene of a box on a lighter one, and its measurements. Variants are added afterwards.
inline void scene_of_heavy(Experiment& e, const HeavyOnLight& heavy) {
  e.scene({.name = spelled(heavy.mass_ratio) + " times heavier than what it lies on",
           .fill = heavy,
           .seconds = 5,
           .pictures = false});
  const std::string height = "height of the heavy one";
  e.series(height, "m", [](const World& world) { return world.bodies[2].position.y(); });
  e.number(height, "m", [height](const Run& run) { return run.series.at(height).back(); });
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
  Curve drift, speed, overlap;  ///< mm, mm/s, mm, against the budget `along`
};

/// `along`: the budget on the horizontal axis.
template <class ContactSolver>
StackCurves study(const std::string& name, std::size_t colour, int boxes, Real dt, const std::vector<Budget>& budgets,
                  const std::function<int(const Budget&)>& along) {
  Curve empty{name, {}, {}, line_colour(colour), Curve::Style::line_and_points};
  StackCurves stood{empty, empty, empty};
  const auto steps = static_cast<int>(std::lround(10 / dt)), second = static_cast<int>(std::lround(1 / dt));
  for (const Budget& budget : budgets) {
    World world;
    stack(world, boxes);
    Substeps<ContactSolver> solver({}, budget.substeps, budget.sweeps);
    Real fastest = 0, deepest = 0;
    for (int step = 0; step < steps; ++step) {
      world.step(solver, dt);
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
