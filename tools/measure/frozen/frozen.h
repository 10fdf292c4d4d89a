/// Contact problems to hold methods against, the residual of each method as it goes, and what is said and drawn of that.
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

// ---- problems: one step each, taken out of our scenes, and files of others ----

struct FrozenProblem {
  std::string name;  ///< a few words, no comma
  ContactProblem problem;
  SparseMatrix factor = {};  ///< B with W = B B^T, where the bodies are known
  bool foreign = false;      ///< of a file, not of a scene of ours
};

/// The contacts of scenes as a step of 1/60 s begins, with nothing remembered: some as they are built, some after they
/// have come to rest or into trouble, by the solver of chapter 12. Always the same, in the same bits.
std::vector<FrozenProblem> own_problems();

/// Pyramids and heaps of 283 to 3,866 contacts, made alike; the largest takes half a minute.
std::vector<FrozenProblem> large_problems();
inline constexpr int large_contacts =
    400;  ///< problems of others with at least so many contacts are compared with these

/// Every .dat file of the folder, by name. Throws InvalidInput where there is no such folder, none in it, or a bad one.
std::vector<FrozenProblem> foreign_problems(const std::filesystem::path& folder);

// ---- frozen.csv: every point that was traced. Tables and pictures are made of it alone, again at any time ----

inline constexpr std::array tolerances{1e-3, 1e-6, 1e-10};  ///< of relative_residual: what is asked for

/// How far a method has come on a problem, and what was paid so far.
struct FrozenPoint {
  int sweeps = 0;                         ///< or iterations, where that is what the method counts
  int systems = 0;                        ///< linear systems
  std::optional<double> row_solves = {};  ///< not of Siconos, whose iterations are not over rows
  double residual = 0;
  /// The time of solving up to here, one for each round, without the residual. Read from a file: five with the same median and quartiles.
  std::vector<double> seconds = {};

  double time(double part = 0.5) const;  ///< s: the median of the rounds; 0.25, 0.75: the quartiles
};

struct FrozenPoints {
  struct Problem {
    std::string name;
    int contacts;
    std::vector<std::vector<FrozenPoint>> of_method;  ///< empty where it has reached nothing
  };
  std::vector<std::string> methods;  ///< in the order in which the file names them
  std::vector<Problem> problems;
};

std::string csv_of(const FrozenPoints& all);
/// Throws InvalidInput where a line is not one of these.
FrozenPoints read_frozen_csv(const std::string& text);

/// Where the residual is that low for the first time; nullptr: nowhere.
const FrozenPoint* reaching(double tolerance, const std::vector<FrozenPoint>& points);

inline constexpr double not_reached = std::numeric_limits<double>::infinity();

/// costs[p][m]: what method m takes for problem p, in any unit, above 0; not_reached where it does not solve it.
using Costs = std::vector<std::vector<double>>;
/// Median s of each method until its residual is that low.
Costs times_to(double tolerance, const FrozenPoints& all);
/// Row solves likewise, 1 at least.
Costs row_solves_to(double tolerance, const FrozenPoints& all);

/// A performance profile: how far a method is behind the best one, and on how many problems.
///
///   f_m(tau) = the part of all problems that method m solves within tau times the cost of the cheapest method
///
/// f_m(1): where m is the cheapest. f_m(infinity): what it solves at all. E. Dolan, J. More, "Benchmarking optimization
/// software with performance profiles", 2002. A problem that no method solves counts for none. 0 if there are no problems.
double part_within(const Costs& costs, std::size_t method, double tau);

// ---- one method on one problem: the residual as it goes, and what was paid so far; all methods on all problems, round after round ----

struct TraceLimits {
  int sweeps = 100000;   ///< at most
  double seconds = 2;    ///< of solving, after which no new stretch is begun
  double patience = 60;  ///< s, after which a run of Siconos, which has no such limit, is ended
  /// Multiplications of `best` and `smoothed`, at most: some seconds, so that the limit above is the one that is met.
  double work = 4e9;
  double enough = 1e-12;  ///< of relative_residual
  std::vector<double> ladder{1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10, 1e-11, 1e-12};  ///< descending
  double quick_run = 0.1;     ///< s: after a run that took longer, only the tolerances below are tried
  std::vector<double> asked;  ///< of the ladder: tried however long the last run took
};

/// A sweeping method is looked at after 0, 1, 2, 3 ... sweeps, from 5 on after a quarter more each time. One that only
/// says how it ended (`smoothed`, `best`, Siconos) is run from r = 0 for one tolerance of the ladder after the other (where runs are
/// long, for those of the tables alone), and has a point for each that it reached by relative_residual. Siconos' runs begin with few
/// iterations, and have four times as many until one reaches the tolerance or has taken longer than the limit. Where it has reached it by its own
/// measure only (siconos_unit), it is asked for so much less.
class Trace {
 public:
  /// The first round: it finds how far the limits let it go. Keeps a reference to the problem. Throws InvalidInput where
  /// there is no such method. `factor`: B with W = B B^T, between whose bodies `smoothed` solves its systems.
  Trace(const ContactProblem& problem, const std::string& method, const TraceLimits& limits,
        const SparseMatrix& factor = {});
  /// The same sweeps once more, for the times.
  void again();

  const std::vector<FrozenPoint>& points() const { return points_; }

 private:
  struct Rung {
    double tolerance;
    double asked;    // of the method, by its own measure
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
  std::vector<Rung> rungs_;  // of the ladder, those that points_ are of
};

/// All methods on these problems. Takes minutes, or seconds if quick: a thirtieth of a second for each, fewer tolerances. Rounds
/// go over all methods, one after the other, and then over all again. Sweeps, systems and residuals are the same whenever they
/// are there. Times differ from run to run.
FrozenPoints study_frozen(const std::vector<FrozenProblem>& problems, bool quick);
/// The same of large problems: 10 s for each method, once.
FrozenPoints study_large(const std::vector<FrozenProblem>& problems, bool quick);

// ---- what is said and drawn, of frozen.csv alone ----

/// Markdown. One for each tolerance, with its heading.
std::vector<std::string> tables_of(const FrozenPoints& all);
/// Markdown. A row a method: on how many problems it comes that far, on how many it is the fastest, and its time as a multiple of the
/// fastest one's, the median of those it reaches. For each tolerance.
std::string reached_of(const FrozenPoints& all);
/// Further results, a sentence each. Throws InvalidInput where a problem is none of `problems`.
std::vector<std::string> remarks_of(const FrozenPoints& all, const std::vector<FrozenProblem>& problems);

/// Residual against time and against row solves, of the six problems that tell most.
std::vector<Panel> trace_panels(const FrozenPoints& all);
/// Performance profiles: three of time, one of row solves.
std::vector<Panel> profile_panels(const FrozenPoints& all);

}  // namespace pushback::frozen
