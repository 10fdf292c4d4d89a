/// Contact problems of single steps, and how much each method has to do until it has solved them to a residual.
#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "pushback/engine/direct/contact_problem.h"

namespace pushback::frozen {

struct FrozenProblem {
  std::string name;
  ContactProblem problem;
  SparseMatrix factor = {};  ///< B with W = B B^T, if the bodies are known
};

/// The contacts of scenes at the beginning of a step of 1/60 s, without a warm start. Some scenes are in their initial state, and some
/// have been played by the solver of chapter 12 until they rest or fail. The problems are the same, to the last bit, in every run.
std::vector<FrozenProblem> own_problems();

/// Pyramids and heaps of 283 to 3,866 contacts, made in the same way. The largest takes half a minute to make.
std::vector<FrozenProblem> large_problems();

/// Every .dat file of the folder, ordered by name. Throws InvalidInput if there is no such folder, if it has no such file, or if a
/// file is invalid.
std::vector<FrozenProblem> foreign_problems(const std::filesystem::path& folder);

inline constexpr std::array tolerances{1e-3, 1e-6, 1e-10};  ///< of relative_residual, descending

struct Limits {
  int sweeps = 100000;
  double seconds = 2;  ///< solving time after which no further sweeps or runs begin
  double work = 4e9;   ///< multiplications of `best` and `smoothed`, which take several seconds
};

/// The work of a method until its residual is at most a tolerance for the first time.
struct Reached {
  int sweeps = 0;
  int systems = 0;     ///< linear systems
  double seconds = 0;  ///< without the evaluation of the residual
};
using Progress = std::array<std::optional<Reached>, tolerances.size()>;  ///< nothing where the limits end it

/// One run from r = 0. A sweeping method is stopped after 0, 1, 2, 3 ... sweeps, and from 5 on each time the number has grown by a
/// quarter. `smoothed` and `best`, which give only their final result, run once for each tolerance.
Progress progress_of(const FrozenProblem& frozen, const std::string& method, const Limits& limits);

struct Compared {
  std::string problem;
  Eigen::Index contacts;
  std::vector<Progress> of_method;  ///< in the order of method_names(), with median times
};

/// Runs all methods on each problem in turn, in `rounds` rounds, or in at most three if a method takes long.
std::vector<Compared> compare(const std::vector<FrozenProblem>& problems, const Limits& limits, int rounds);

/// A table in Markdown for each tolerance: a row per problem, with its heading.
std::string tables_of(const std::vector<Compared>& rows);

/// A table in Markdown with a row per method. For each tolerance it has the number of problems on which the method reaches it, the
/// number on which it is the fastest, and the median ratio of its time to the time of the fastest, over the problems that it solves.
std::string reached_of(const std::vector<Compared>& rows);

}  // namespace pushback::frozen
