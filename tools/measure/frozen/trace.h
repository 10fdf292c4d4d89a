/// One method on one problem: the residual as it goes, and what was paid so far. And all methods on all problems, round after round.
#pragma once

#include "pushback/engine/direct/contact_problem.h"
#include "pushback/tools/measure/frozen/points.h"
#include "pushback/tools/measure/frozen/problems.h"

namespace pushback::frozen {

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
/// are there; times, and so who is fastest, are those of the day.
FrozenPoints study_frozen(const std::vector<FrozenProblem>& problems, bool quick);
/// The same of large problems: 10 s for each method, once.
FrozenPoints study_large(const std::vector<FrozenProblem>& problems, bool quick);

}  // namespace pushback::frozen
