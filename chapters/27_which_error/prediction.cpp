#include "pushback/chapters/27_which_error/prediction.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "pushback/chapters/27_which_error/play_within.h"
#include "pushback/chapters/27_which_error/scenes.h"
#include "pushback/common/basics/input.h"
#include "pushback/common/basics/stopwatch.h"
#include "pushback/common/world/measure.h"

namespace pushback {

using namespace which_error_scenes;

namespace {

constexpr int longest = 4, shorter = longest / 2;  // times the step of the play
constexpr Real nothing = Real(1e-9);               // m
constexpr int most_impacts = 50;                   // in a rehearsal

/// As many substeps in a step, and as fast a turn, as if it were not longer.
void stretch(IslandSolver& solver, int times) {
  solver.substep_solver.reference_step *= static_cast<Real>(times);
  solver.limits.fast_turn *= static_cast<Real>(times);
}

/// In steps four times as long, within an error 16 times as large. Errors of second order are 16 times as large, so the bodies get the
/// same numbers of half steps as if they were played.
struct Rehearsal {
  std::vector<World> worlds;                  // after each step
  std::vector<std::vector<BodyError>> known;  // after each step, of each body
  std::vector<GivenSteps> given;              // in each step
  int impacts = 0;
  double seconds = 0;
};
Rehearsal rehearse(World world, Real error, int steps) {
  Rehearsal rehearsal;
  TwinSolver solver;
  solver.error = error * longest * longest;
  stretch(solver, longest);
  for (int i = 0; i < steps; i += longest) {
    rehearsal.seconds += computing_time([&] { world.step(solver, longest * dt_within); });
    rehearsal.worlds.push_back(world);
    rehearsal.given.push_back(solver.given);
    rehearsal.known.emplace_back();
    for (const Body& body : world.bodies) rehearsal.known.back().push_back(solver.error_of(body.index));
    for (std::size_t island = 0; island < solver.islands().size(); ++island)
      if (solver.islands()[island].moved) rehearsal.impacts += solver.islands()[island].half_step.events();
  }
  return rehearsal;
}

/// The same in steps half as long, with the same numbers of half steps in each, so that they are half as long too. Without a twin.
struct Again {
  std::vector<World> worlds;  // after each step of the first rehearsal
  double seconds = 0;
};
Again rehearse_again(World world, const Rehearsal& first) {
  Again again;
  IslandSolver solver;
  stretch(solver, shorter);
  for (const GivenSteps& given : first.given) {
    solver.given = given;
    for (int part = 0; part < longest / shorter; ++part)
      again.seconds += computing_time([&] { world.step(solver, shorter * dt_within); });
    again.worlds.push_back(world);
  }
  return again;
}

/// The ratio of what a twin says to the difference of the rehearsals: (r^p - 1) / 2 / (1 - 2^-p) is 3.3 to 3.5 for p = 1, and 10 to 13 for
/// p = 2.
struct Range {
  Real least, most;
};

/// A body that needs more half steps from the beginning gets one level more in each step, and steps of the play are shorter. The share of
/// an error of second order that is then left, if it is made evenly until step `end`.
Real left_if_sooner(const std::vector<GivenSteps>& given, std::size_t body, std::size_t end) {
  const auto made_in = [&](std::size_t step) { return 1 / std::pow(static_cast<Real>(given[step].of_body[body]), 2); };
  std::size_t enough = 0;
  while (enough < end && made_in(enough + 1) < made_in(enough)) ++enough;
  Real rehearsed = 0, played = 0;
  for (std::size_t i = 0; i <= end; ++i) {
    rehearsed += made_in(i);
    played += (made_in(i) + (longest - 1) * made_in(std::max(i, enough))) / longest;
  }
  return played / rehearsed;
}

/// The error of the play. An error e of a step of order p is e / 2^p in steps half as long, so the rehearsals differ by (1 - 2^-p) e, and
/// the play is off by e / 4^p. p is 2, and of substeps 1, unless something else decides: when a body stops, or what it meets first. Then
/// the difference does not fit the error that the twin of the first rehearsal says:
///
///   (r^p - 1) e / 2,  r = 4 to 4.5: the ratio of the numbers of half steps
void predict_error(Prediction& prediction, const Rehearsal& first, const Again& again, Real error) {
  std::vector<Real> differences;
  BodyError said;  // of the body that is farthest away in the other rehearsal
  std::size_t which = 0, when = 0;
  Real farthest = 0, most_said = 0;
  for (std::size_t i = 0; i < again.worlds.size(); ++i) {
    differences.push_back(apart(first.worlds[i], again.worlds[i]));
    for (const Body& body : again.worlds[i].bodies) {
      const auto at = std::size_t(body.index);
      const Real off = (body.position - first.worlds[i].bodies[at].position).norm();
      most_said = std::max(most_said, first.known[i][at].position_error);
      if (off <= farthest) continue;
      farthest = off;
      said = first.known[i][at];
      which = at, when = i;
    }
  }
  if (farthest <= nothing && most_said <= nothing) return;
  const bool substeps = said.step_type == StepType::substeps;
  const Real of_half = substeps ? Real(0.5) : Real(0.25);  // 2^-p
  const Range ratios = substeps ? Range{Real(2.5), 4} : Range{8, 18};
  prediction.error = farthest * of_half * of_half / (1 - of_half);
  if (!substeps) prediction.error *= left_if_sooner(first.given, which, when);
  const std::optional<Real> rate = growth(differences, error, longest * dt_within);
  if (rate) prediction.no_error = fmt::format("places part by a factor of e every {:.2g} s", 1 / *rate);
  else if (!(said.position_error >= ratios.least * farthest && said.position_error <= ratios.most * farthest))
    prediction.no_error = fmt::format(
        "in steps half as long a body is {:.2g} mm away, and its order says {:.2g} to {:.2g} mm", 1000 * farthest,
        1000 * said.position_error / ratios.most, 1000 * said.position_error / ratios.least);
  else if (first.impacts > most_impacts)
    prediction.no_error = fmt::format("{} impacts, of which each makes an error larger", first.impacts);
}

}  // namespace

Prediction predict(const World& begin, Real error, int steps) {
  Prediction prediction;
  const auto neither = [&](const std::string& why) { prediction.no_time = prediction.no_error = why; };
  World start = begin;
  start.find_contacts();
  if (const Real depth = deepest_overlap(start); depth > StepClassifier::too_deep) {
    neither(fmt::format("bodies begin {:.2g} mm deep in each other", 1000 * depth));
    return prediction;
  }
  try {
    const Rehearsal first = rehearse(begin, error, steps);
    const Again again = rehearse_again(begin, first);
    prediction.rehearsed = first.seconds + again.seconds;
    // The play has twice as many steps, and its twin takes 2 half steps for each 5.
    const double played = static_cast<double>(first.given.size() * longest);
    prediction.seconds = again.seconds * shorter * 7 / 5 * steps / played;
    predict_error(prediction, first, again, error);
  } catch (const InvalidInput& refused) {
    neither(fmt::format("a rehearsal ends early: {}", refused.what()));
  }
  return prediction;
}

}  // namespace pushback
