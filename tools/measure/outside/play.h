/// Plays a scene by a solver, and measures what comes of it.
#pragma once

#include "pushback/tools/measure/hard_cases/stages.h"
#include "pushback/tools/measure/outside/scene.h"

namespace pushback::outside {

/// A scene under a solver: a line of the results.
struct Played {
  std::string scene, solver;
  double number = 0;                             ///< by which the scene is judged
  double overlap_median = 0, overlap_worst = 0;  ///< mm, of the deepest overlaps of all steps
  double gained = 0;                             ///< %, of the energy that is turned over
  double slope = 0;                              ///< degrees, at the end; 0: not measured
  double ms_median = 0, ms_worst = 0;            ///< of a step of 1/60 s
  std::string broken = {};                       ///< what broke, or what the solver lacks; empty: nothing

  /// Whether the number is within its limit, no more energy was gained than the scene allows, and the median overlap is at most a
  /// tenth of the thinnest body's half thickness.
  bool passed(const OutsideScene& of) const;
};

/// Ends when the steps have taken so many seconds.
Played play(const OutsideScene& scene, const Stage& stage, double at_most = 60);

std::string line_of(const Played& played);
std::string text_of(const std::vector<Played>& all);
/// Back. Throws InvalidInput where the text is none of these.
std::vector<Played> read_lines(const std::string& text);
inline constexpr const char* heading =
    "scene,solver,number,overlap_median,overlap_worst,gained,slope,ms_median,ms_worst,broken";

}  // namespace pushback::outside
