#include "pushback/chapters/27_which_error/play_within.h"

#include <algorithm>
#include <cmath>
#include <ctime>

#include "pushback/chapters/27_which_error/scenes.h"

namespace pushback {

using namespace which_error_scenes;

namespace {

constexpr Real diverged = 100;        // times the error: beyond it, places are meaningless
constexpr Real at_once = Real(0.25);  // s

std::string way_of(const BodyError& known) {
  switch (known.how) {
    case StepType::flight:
      return "in flight";
    case StepType::half_steps:
      return "half steps";
    case StepType::substeps:
      return "substeps";
    case StepType::none:
      break;
  }
  return "not at all";
}

}  // namespace

double Played::seconds() const {
  double all = 0;
  for (const PlayedStep& step : steps) all += step.seconds;
  return all;
}

double computing_time() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

Played play_within(World world, Real error, int steps) {
  TwinSolver solver;
  solver.error = error;
  Played played;
  for (int i = 0; i < steps; ++i) {
    const double began = computing_time();
    world.step(solver, dt_within);
    PlayedStep step;
    step.seconds = computing_time() - began;
    for (Body& body : world.bodies) {
      if (!body.movable()) continue;
      const BodyError known = solver.error_of(body.index);
      body.coloured(static_cast<int>(paint_of(known)));
      ++step.bodies;
      step.bodies_kept += known.kept;
      if (known.place >= step.most.place) step.most = known;
      ++step.ways[way_of(known)];
    }
    step.known = step.most.place;
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
