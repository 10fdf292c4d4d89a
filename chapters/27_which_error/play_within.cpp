#include "pushback/chapters/27_which_error/play_within.h"

#include <algorithm>
#include <cmath>

#include "pushback/chapters/27_which_error/scenes.h"
#include "pushback/common/basics/stopwatch.h"
#include "pushback/engine/islands/scene_questions.h"

namespace pushback {

using namespace which_error_scenes;

namespace {

constexpr Real diverged = 100;        // times the error: beyond it, places are meaningless
constexpr Real at_once = Real(0.25);  // s

}  // namespace

double Played::seconds() const {
  double all = 0;
  for (const PlayedStep& step : steps) all += step.seconds;
  return all;
}

Played play_within(World world, Real error, int steps) {
  TwinSolver solver;
  solver.error = error;
  Played played;
  for (int i = 0; i < steps; ++i) {
    PlayedStep step;
    step.seconds = computing_time([&] { world.step(solver, dt_within); });
    for (Body& body : world.bodies) {
      if (!body.movable()) continue;
      const BodyError known = solver.error_of(body.index);
      body.coloured(static_cast<int>(paint_of(known)));
      ++step.bodies;
      step.bodies_kept += known.kept;
      if (known.position_error >= step.most.position_error) step.most = known;
      ++step.ways[known.step_type == StepType::flight ? "in flight" : name_of(known.step_type)];
    }
    step.known = step.most.position_error;
    played.steps.push_back(step);
    played.worlds.push_back(world);
  }
  return played;
}

std::vector<Real> off(World world, const Played& played, Real error, int finer) {
  TwinSolver truth;
  truth.error = error / static_cast<Real>(finer);
  truth.substep_solver.reference_step /= static_cast<Real>(finer);  // as many substeps, in each of the shorter steps
  std::vector<Real> off;
  for (const World& at : played.worlds) {
    for (int i = 0; i < finer; ++i) world.step(truth, dt_within / static_cast<Real>(finer));
    off.push_back(apart(at, world));
  }
  return off;
}

std::optional<Real> growth(const std::vector<Real>& differences, Real error, Real dt) {
  const auto first = std::find_if(differences.begin(), differences.end(), [&](Real x) { return x > error; });
  const auto last = std::find_if(first, differences.end(), [&](Real x) { return x > diverged * error; });
  const Real seconds = dt * static_cast<Real>(last - first);
  if (last == differences.end() || seconds < at_once) return {};
  return std::log(*last / *first) / seconds;
}

}  // namespace pushback
