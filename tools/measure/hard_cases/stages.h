/// The solvers that play the hard cases, one per chapter, and later solvers.
#pragma once

#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "pushback/tools/catalogue/solvers.h"

namespace pushback {

/// Advances a world by dt. Contains a solver with its stored data, so each world needs its own Stepper.
struct Stepper {
  std::function<void(World&, Real dt)> step;
  /// Whether the latest step moved this body by half steps. Empty if it moves no body so.
  std::function<bool(int body)> half_steps = {};
};

/// Whether a program gives the contacts to the solver, and how often. A solver with its own whole_step finds contacts itself otherwise.
enum class GivenContacts { none, once, twice };

struct Stage : NamedSolver {
  /// The most starts from which a case is played. Slow solvers play once.
  int most_starts = std::numeric_limits<int>::max();
  /// Whether bodies that fly, or slide without others, are moved by half steps (chapter 24).
  bool half_steps = false;
  /// The program with its arguments that plays a case in a separate process, because the solver may crash or not return. Empty if the
  /// case is played in this process.
  std::vector<std::string> apart = {};
  /// If not empty, the outcome of a case is the best of these stages, which are tried until one passes.
  std::vector<Stage> tries = {};
  /// The rounding unit of the solver's numbers.
  Real epsilon = std::numeric_limits<Real>::epsilon();

  /// The number of substeps in a step of dt.
  int substeps(Real dt = Real(1) / 60) const { return solver.plan(dt).all_substeps(); }

  Stepper begin(GivenContacts given = GivenContacts::none) const;
};

/// All solvers of the catalogue.
const std::vector<Stage>& stages();
/// The number of chapters among them, which come first.
inline constexpr std::size_t chapter_stages = 8;

/// The columns of the table, which are all stages and a direct solve of all contacts in each step, with a limit of multiplications.
const std::vector<Stage>& table_stages();

/// One of table_stages. Throws InvalidInput, listing all names, if there is no such stage.
const Stage& stage_named(std::string_view name);

}  // namespace pushback
