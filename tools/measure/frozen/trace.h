/// One method on one problem: the residual as it goes, and what was paid so far.
#pragma once

#include <string>
#include <vector>

#include "pushback/chapters/16_whole_problem/contact_problem.h"

namespace pushback::frozen {

struct TraceLimits {
  int sweeps = 100000;   ///< at most
  double seconds = 2;    ///< of solving, after which no new stretch is begun
  double patience = 60;  ///< s, after which a run of Siconos, which has no such limit, is ended
  double work =
      4e9;  ///< multiplications of `best` and `smoothed`, at most: some seconds, so that the limit above is the one that is met
  double enough = 1e-12;  ///< of relative_residual
  std::vector<double> ladder{1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10, 1e-11, 1e-12};  ///< descending
  double quick_run = 0.1;     ///< s: after a run that took longer, only the tolerances below are tried
  std::vector<double> asked;  ///< of the ladder: tried however long the last run took
};

struct TracePoint {
  int sweeps = 0;   ///< or iterations, where that is what the method counts
  int systems = 0;  ///< linear systems
  double residual = 0;
  std::vector<double> seconds =
      {};  ///< of solving up to here, one a round: the residual and other programs not counted

  /// 0.5: the median of the rounds; 0.25, 0.75: the quartiles.
  double time(double part = 0.5) const;
};

/// A sweeping method is looked at after 0, 1, 2, 3 ... sweeps, from 5 on after a quarter more each time. One that only
/// says how it ended (`smoothed`, `best`, Siconos) is run from r = 0 for one tolerance of the ladder after the other (where runs are long, for
/// those of the tables alone), and has a point for each that it reached by relative_residual. Siconos' runs begin with few iterations, and have
/// four times as many until one reaches the tolerance or has taken longer than the limit. Where it has reached it by its own
/// measure only (siconos_unit), it is asked for so much less.
class Trace {
 public:
  /// The first round: it finds how far the limits let it go. Keeps a reference to the problem. Throws InvalidInput where
  /// there is no such method. `factor`: B with W = B B^T, between whose bodies `smoothed` solves its systems.
  Trace(const ContactProblem& problem, const std::string& method, const TraceLimits& limits,
        const SparseRows& factor = {});
  /// The same sweeps once more, for the times.
  void again();

  const std::vector<TracePoint>& points() const { return points_; }
  /// Where its residual is that low for the first time; nullptr: nowhere.
  const TracePoint* reaching(double tolerance) const;
  /// Whether its sweeps are over rows: those of Siconos are not.
  bool counts_rows() const;
  /// Each sweep solves a row for each normal and each tangent.
  double row_solves(const TracePoint& point) const {
    return 3.0 * static_cast<double>(problem_.contacts()) * point.sweeps;
  }

 private:
  struct Rung {
    double asked;    // of the method, by its own measure
    int iterations;  // at most
  };
  TracePoint climbed_to(Rung& rung, double tolerance) const;
  void sweep_along();
  void climb();

  const ContactProblem& problem_;
  std::string method_;
  TraceLimits limits_;
  SparseRows factor_;
  std::vector<TracePoint> points_;
  struct Reached {
    double tolerance;
    Rung rung;
  };
  std::vector<Reached> rungs_;  // of the ladder, those that points_ are of
};

}  // namespace pushback::frozen
