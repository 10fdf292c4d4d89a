/// A solver that colours chapter 26's yard by how each body was moved, and the distance between two worlds.
#pragma once

#include "pushback/chapters/26_to_each_its_own/scenes.h"
#include "pushback/engine/islands/twin_solver.h"

namespace pushback::which_error_scenes {

/// Indices of the palette: mustard, teal, blue and brick.
enum class Paint { flight = 2, few = 1, more = 0, substeps = 4 };

inline std::vector<std::pair<Paint, std::string>> named_paints() {
  return {{Paint::flight, "in flight"},
          {Paint::few, "up to five half steps"},
          {Paint::more, "more half steps"},
          {Paint::substeps, "substeps"}};
}

constexpr int few_half_steps = 5;  // the fewest that a body with few contacts gets

inline Paint paint_of(const BodyError& known) {
  if (known.step_type == StepType::flight) return Paint::flight;
  if (known.step_type == StepType::substeps) return Paint::substeps;
  return known.substeps > few_half_steps ? Paint::more : Paint::few;
}

/// After each step, colours every movable body by how it was moved.
class Painted : public ForwardingSolver {
 public:
  TwinSolver within;

  explicit Painted(Real error) { within.error = error; }
  SolveStats stats() const override { return within.stats(); }
  Plan plan(Real /*dt*/) const override { return {}; }  // each island has its own plan
  void whole_step(World& world, Real dt, int sweeps) override {
    within.whole_step(world, dt, sweeps);
    for (Body& body : world.bodies)
      if (body.movable()) body.coloured(static_cast<int>(paint_of(within.error_of(body.index))));
  }

 private:
  StepSolver& inner() override { return within; }
  const StepSolver& inner() const override { return within; }
};

/// The largest distance between the same body in two worlds, m.
inline Real apart(const World& a, const World& b) {
  Real largest = 0;
  for (std::size_t i = 0; i < a.bodies.size(); ++i)
    largest = std::max(largest, (a.bodies[i].position - b.bodies[i].position).norm());
  return largest;
}

}  // namespace pushback::which_error_scenes
