/// The solvers that are tried on the hard cases: one a chapter, and what came after.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "pushback/common/world/world.h"

namespace pushback {

/// Moves a world on by dt. Holds a solver with its memory: one for each world.
using Stepper = std::function<void(World&, Real dt)>;

struct Stage {
  std::string name;  ///< short, for the head of a column: "07 warm start"
  std::string what;  ///< what it is, in a line: the solver's type, sweeps, small steps
  std::function<Stepper()> begin;
  std::function<Stepper()> begin_doubled;  ///< the same, with every contact given to the solver twice
  int small_steps = 1;                     ///< into how many it divides a step
  /// Both once more, through the dispatch of chapter 15: with what the world calls for when the stepper first sees it.
  std::function<Stepper()> begin_only_needed = {}, begin_doubled_only_needed = {};
};

/// In the order of the chapters, one each; behind them what came after.
const std::vector<Stage>& stages();
/// How many of them, the first ones, are chapters.
inline constexpr std::size_t chapter_stages = 8;

/// The stage that begins through that dispatch wherever this one does not. Bits are to be the same.
Stage only_what_is_needed(Stage stage);

/// Throws InvalidInput, naming those that there are.
const Stage& stage_named(const std::string& name);

}  // namespace pushback
