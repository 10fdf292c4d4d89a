/// The solvers that are tried on the hard cases: one a chapter, and what came after.
#pragma once

#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "pushback/tools/catalogue/solvers.h"

namespace pushback {

/// Moves a world on by dt. Holds a solver with its memory: one for each world.
struct Stepper {
  std::function<void(World&, Real dt)> step;
  /// Whether the latest step was half steps of this body; none: of nobody.
  std::function<bool(int body)> half_steps = {};
};

/// How a solver comes by its contacts: a solver with a step of its own finds them itself, unless they are given.
enum class GivenContacts { none, once, twice };

struct Stage : NamedSolver {
  /// From so many starts at most is a case played: what takes long is played once.
  int most_starts = std::numeric_limits<int>::max();
  /// What flies, or slides alone, is moved by half steps (chapter 24).
  bool half_steps = false;
  /// The program, and its arguments, that plays a case under it by a process of its own, as it may crash or never end. Empty: it is
  /// played here.
  std::vector<std::string> apart = {};
  /// Its outcome is on each case the best of these, which are tried until one passes. Empty: its own.
  std::vector<Stage> tries = {};
  /// The rounding unit of the numbers that it computes with.
  Real epsilon = std::numeric_limits<Real>::epsilon();

  /// Into how many it divides a step of dt.
  int substeps(Real dt = Real(1) / 60) const { return solver.plan(dt).all_substeps(); }

  Stepper begin(GivenContacts given = GivenContacts::none) const;
};

/// All of the catalogue's solvers.
const std::vector<Stage>& stages();
/// How many of them, the first ones, are chapters.
inline constexpr std::size_t chapter_stages = 8;

/// The columns of the table: all stages, and all contacts solved directly in each step, within a count of multiplications.
const std::vector<Stage>& table_stages();

/// Of the table's. Throws InvalidInput, naming those that there are.
const Stage& stage_named(std::string_view name);

}  // namespace pushback
