#include "chapters/14_accuracy_and_time/frozen/trace.h"

#include <algorithm>
#include <cmath>

#include "chapters/13_global_solve/methods.h"
#include "chapters/14_accuracy_and_time/quantile.h"
#include "chapters/14_accuracy_and_time/stopwatch.h"

namespace pushback {

double TracePoint::time(double part) const {
  return quantile(seconds, part);
}

Trace::Trace(const ContactProblem& problem, const std::string& method, const TraceLimits& limits)
    : problem_(problem), method_(method), limits_(limits) {
  again();
}

void Trace::again() {
  if (sweep_of(problem_, method_)) sweep_along();
  else climb();
}

const TracePoint* Trace::reaching(double tolerance) const {
  const auto found = std::find_if(points_.begin(), points_.end(),
                                  [&](const TracePoint& point) { return point.residual <= tolerance; });
  return found == points_.end() ? nullptr : &*found;
}

void Trace::sweep_along() {
  const bool first = points_.empty();
  Stopwatch solving;
  solving.go();
  const Sweep sweep = sweep_of(problem_, method_);
  solving.stop();
  Vector r = Vector::Zero(problem_.q.size());
  for (std::size_t i = 0, done = 0; first || i < points_.size(); ++i) {
    if (first) {
      const double residual = relative_residual(problem_, r);
      if (!std::isfinite(residual)) return;  // it has left the range of numbers
      points_.push_back({static_cast<int>(done), 0, residual});
    }
    points_[i].seconds.push_back(solving.seconds());
    const auto most = static_cast<std::size_t>(limits_.sweeps);
    if (first && (points_[i].residual <= limits_.enough || solving.seconds() > limits_.seconds || done >= most)) return;
    if (!first && i + 1 == points_.size()) return;
    const std::size_t upto =
        first ? std::min(most, std::max(done + 1, done + done / 4)) : static_cast<std::size_t>(points_[i + 1].sweeps);
    solving.go();
    for (; done < upto; ++done) sweep(r);
    solving.stop();
  }
}

void Trace::climb() {
  const auto timed = [&](double tolerance) {
    Stopwatch solving;
    solving.go();
    const Effort effort{.tolerance = tolerance, .work = limits_.work};
    const Solution found =
        method_ == "best" ? solve_best(problem_, effort) : solve(problem_, method_, limits_.sweeps, tolerance);
    solving.stop();
    return TracePoint{found.sweeps, found.systems, found.residual, {solving.seconds()}};
  };
  if (rungs_.empty()) {
    for (const double tolerance : limits_.ladder) {
      if (!points_.empty() && points_.back().residual <= tolerance) continue;  // met on the way to the last
      const TracePoint point = timed(tolerance);
      if (!(point.residual <= tolerance) || point.seconds[0] > limits_.seconds) return;
      points_.push_back(point);
      rungs_.push_back(tolerance);
    }
  } else {
    for (std::size_t i = 0; i < rungs_.size(); ++i) points_[i].seconds.push_back(timed(rungs_[i]).seconds[0]);
  }
}

}  // namespace pushback
