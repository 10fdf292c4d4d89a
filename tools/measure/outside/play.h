/// Plays a scene with a solver, and measures the result.
#pragma once

#include "pushback/tools/measure/hard_cases/stages.h"
#include "pushback/tools/measure/outside/scene.h"

namespace pushback::outside {

/// The result of one scene with one solver, a line of the results.
struct Played {
  std::string scene, solver;
  double number = 0;                             ///< the number by which the scene is judged
  double overlap_median = 0, overlap_worst = 0;  ///< mm, of the deepest overlap of each step, over all steps
  double gained = 0;                             ///< energy gain, % of the energy that is turned over
  double slope = 0;                              ///< degrees, at the end; 0: not measured
  double ms_median = 0, ms_worst = 0;            ///< of a step of 1/60 s
  std::string broken = {};  ///< the violated invariant, or the feature that the solver lacks; empty: none

  /// Whether the number is within its limit, no more energy was gained than the scene allows, and the median overlap is at most a
  /// tenth of the thinnest body's half thickness.
  bool passed(const OutsideScene& of) const;
};

/// Plays the scene. Ends when the steps have taken `at_most` seconds of computing time.
Played play(const OutsideScene& scene, const Stage& stage, double at_most = 60);

std::string line_of(const Played& played);
std::string text_of(const std::vector<Played>& all);
/// Reads lines back. Throws InvalidInput if the text does not have this format.
std::vector<Played> read_lines(const std::string& text);
inline constexpr const char* heading =
    "scene,solver,number,overlap_median,overlap_worst,gained,slope,ms_median,ms_worst,broken";

}  // namespace pushback::outside
