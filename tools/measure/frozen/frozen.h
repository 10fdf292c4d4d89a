/// Contact problems for the comparison of methods, the residual of each method over its iterations, and tables and diagrams of these.
#pragma once

#include <array>
#include <filesystem>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "pushback/common/experiment/plot.h"
#include "pushback/engine/direct/contact_problem.h"

namespace pushback::frozen {

// ---- problems, each of which is one step of a scene of ours or a file from elsewhere ----

struct FrozenProblem {
  std::string name;  ///< a few words, without a comma
  ContactProblem problem;
  SparseMatrix factor = {};  ///< B with W = B B^T, if the bodies are known
  bool foreign = false;      ///< whether the problem comes from a file, not from a scene of ours
};

/// The contacts of scenes at the beginning of a step of 1/60 s, without a warm start. Some scenes are in their initial state, and some
/// have been played by the solver of chapter 12 until they rest or fail. The problems are the same, to the last bit, in every run.
std::vector<FrozenProblem> own_problems();

/// Pyramids and heaps of 283 to 3,866 contacts, made in the same way. The largest takes half a minute to make.
std::vector<FrozenProblem> large_problems();
inline constexpr int large_contacts =
    400;  ///< contacts; problems from elsewhere with at least this many are compared with these

/// Every .dat file of the folder, ordered by name. Throws InvalidInput if there is no such folder, if it has no such file, or if a
/// file is invalid.
std::vector<FrozenProblem> foreign_problems(const std::filesystem::path& folder);

// ---- frozen.csv contains every traced point. All tables and diagrams are made from this file only ----

inline constexpr std::array tolerances{1e-3, 1e-6, 1e-10};  ///< the tolerances of the tables, of relative_residual

/// The residual that a method has reached on a problem, and its cost so far.
struct FrozenPoint {
  int sweeps = 0;                         ///< or iterations, if the method counts these
  int systems = 0;                        ///< linear systems
  std::optional<double> row_solves = {};  ///< none for Siconos, whose iterations do not solve rows
  double residual = 0;
  /// The solving time up to this point, one for each round, s, without the evaluation of the residual. If read from a file, these are
  /// five times with the same median and quartiles.
  std::vector<double> seconds = {};

  double time(double part = 0.5) const;  ///< s, quantile of the rounds: 0.5 is the median, 0.25 and 0.75 the quartiles
};

struct FrozenPoints {
  struct Problem {
    std::string name;
    int contacts;
    std::vector<std::vector<FrozenPoint>> of_method;  ///< empty if it has reached nothing
  };
  std::vector<std::string> methods;  ///< in the order of the file
  std::vector<Problem> problems;
};

std::string csv_of(const FrozenPoints& all);
/// Throws InvalidInput if a line does not have this format.
FrozenPoints read_frozen_csv(const std::string& text);

/// The first point whose residual is at most `tolerance`, or nullptr if there is none.
const FrozenPoint* reaching(double tolerance, const std::vector<FrozenPoint>& points);

inline constexpr double not_reached = std::numeric_limits<double>::infinity();

/// costs[p][m] is the cost of method m on problem p, above 0, in any unit, or not_reached if it does not solve the problem.
using Costs = std::vector<std::vector<double>>;
/// The median time of each method until its residual is at most `tolerance`, s.
Costs times_to(double tolerance, const FrozenPoints& all);
/// The number of row solves likewise, at least 1.
Costs row_solves_to(double tolerance, const FrozenPoints& all);

/// A performance profile, which shows by which factor a method is slower than the best one, and on how many problems.
///
///   f_m(tau) = the fraction of all problems that method m solves within tau times the cost of the cheapest method
///
/// f_m(1) is the fraction on which m is the cheapest, f_m(infinity) the fraction that it solves at all. A problem that no method solves
/// counts for none. The result is 0 if there are no problems.
/// E. Dolan, J. More, "Benchmarking optimization software with performance profiles", 2002.
double part_within(const Costs& costs, std::size_t method, double tau);

// ---- traces of residual and cost, for one method on one problem, and for all methods on all problems, in rounds ----

struct TraceLimits {
  int sweeps = 100000;   ///< maximum number
  double seconds = 2;    ///< solving time after which no further sweeps or runs begin
  double patience = 60;  ///< s, after which a run of Siconos is ended, because Siconos has no time limit
  /// The most multiplications of `best` and `smoothed`. They take several seconds, so the limit of `seconds` is reached first.
  double work = 4e9;
  double enough = 1e-12;  ///< relative_residual at which a trace ends
  std::vector<double> ladder{1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10, 1e-11, 1e-12};  ///< descending
  double quick_run = 0.1;     ///< s; after a run that took longer, only the tolerances `asked` are tried
  std::vector<double> asked;  ///< tolerances of the ladder that are tried however long the last run took
};

/// The trace of a sweeping method has a point after 0, 1, 2, 3 ... sweeps, and from 5 on each time the number has grown by a quarter.
/// A method that returns only its final result (`smoothed`, `best`, Siconos) is run from r = 0 for each tolerance of the ladder in
/// turn, or only for the tolerances of the tables if runs are long. Its trace has a point for each tolerance that it reaches by
/// relative_residual. Runs of Siconos begin with few iterations. The number is multiplied by four until a run reaches the tolerance or
/// takes longer than the limit. If a run reaches it only by Siconos' own measure (siconos_unit), the next run gets a smaller tolerance.
class Trace {
 public:
  /// Runs the first round, which finds how far the limits let the method go. Keeps a reference to the problem. Throws InvalidInput if
  /// there is no such method. `factor`: B with W = B B^T, with which `smoothed` solves its systems for bodies.
  Trace(const ContactProblem& problem, const std::string& method, const TraceLimits& limits,
        const SparseMatrix& factor = {});
  /// Runs the same sweeps once more, to measure their times again.
  void again();

  const std::vector<FrozenPoint>& points() const { return points_; }

 private:
  struct Rung {
    double tolerance;
    double asked;    // the tolerance that the method gets, by its own measure
    int iterations;  // at most
  };
  FrozenPoint point(int sweeps, int systems, double residual) const;
  FrozenPoint climbed_to(Rung& rung) const;
  void sweep_along();
  void climb();

  const ContactProblem& problem_;
  std::string method_;
  TraceLimits limits_;
  SparseMatrix factor_;
  std::vector<FrozenPoint> points_;
  std::vector<Rung> rungs_;  // the tolerances of the ladder to which points_ belong
};

/// Runs all methods on these problems. Takes minutes, or seconds if quick, with 1/30 s per method and fewer tolerances. Each round
/// runs every method once. Sweeps, systems and residuals are the same in every run, as far as a run gets. Times differ from run to run.
FrozenPoints study_frozen(const std::vector<FrozenProblem>& problems, bool quick);
/// The same for large problems, with 10 s for each method, in one round.
FrozenPoints study_large(const std::vector<FrozenProblem>& problems, bool quick);

// ---- tables and diagrams, made from frozen.csv only ----

/// One table in Markdown for each tolerance, with its heading.
std::vector<std::string> tables_of(const FrozenPoints& all);
/// A table in Markdown with a row per method. For each tolerance it has the number of problems on which the method reaches it, the
/// number on which it is the fastest, and the median ratio of its time to the time of the fastest, over the problems that it solves.
std::string reached_of(const FrozenPoints& all);
/// Further results, one sentence each. Throws InvalidInput if a problem is not one of `problems`.
std::vector<std::string> remarks_of(const FrozenPoints& all, const std::vector<FrozenProblem>& problems);

/// Residual against time and against row solves, for the six most informative problems.
std::vector<Panel> trace_panels(const FrozenPoints& all);
/// Performance profiles, three for time and one for row solves.
std::vector<Panel> profile_panels(const FrozenPoints& all);

}  // namespace pushback::frozen
