#include "pushback/tools/measure/frozen/trace.h"

#include <algorithm>
#include <cmath>

#include "pushback/chapters/17_direct_contacts/smoothed_newton.h"
#include "pushback/common/basics/quantile.h"
#include "pushback/tools/measure/frozen/methods.h"
#include "pushback/tools/measure/study/stopwatch.h"

namespace pushback::frozen {

double TracePoint::time(double part) const {
  return quantile(seconds, part);
}

Trace::Trace(const ContactProblem& problem, const std::string& method, const TraceLimits& limits,
             const SparseRows& factor)
    : problem_(problem), method_(method), limits_(limits), factor_(factor) {
  again();
}

void Trace::again() {
  if (is_siconos(method_) || !counts_sweeps(method_)) climb();
  else sweep_along();
}

bool Trace::counts_rows() const {
  return !is_siconos(method_);
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

TracePoint Trace::climbed_to(Rung& rung, double tolerance) const {
  while (is_siconos(method_)) {
    const SiconosAnswer found = solve_by_siconos(problem_, method_, rung.asked, rung.iterations, limits_.patience);
    const TracePoint point{found.iterations, 0, relative_residual(problem_, found.r), {found.seconds}};
    if (point.residual <= tolerance || found.seconds > limits_.seconds) return point;
    const double tighter = 0.5 * tolerance * problem_.q.norm() / siconos_unit(problem_, found.r);
    if (found.reached && tighter < 0.99 * rung.asked) rung.asked = tighter;
    else if (rung.iterations < limits_.sweeps) rung.iterations = std::min(4 * rung.iterations, limits_.sweeps);
    else return point;
  }
  Stopwatch solving;
  solving.go();
  const Solution found =
      method_ == "smoothed"
          ? Solution(solve_smoothed(problem_, {.tolerance = tolerance, .work = limits_.work}, factor_))
          : solve_best(problem_, {.tolerance = tolerance, .work = limits_.work});
  solving.stop();
  return {found.sweeps, found.systems, found.residual, {solving.seconds()}};
}

void Trace::climb() {
  if (!rungs_.empty()) {
    for (std::size_t i = 0; i < rungs_.size(); ++i) {
      Rung rung = rungs_[i].rung;
      points_[i].seconds.push_back(climbed_to(rung, rungs_[i].tolerance).seconds[0]);
    }
    return;
  }
  Rung rung{1, std::min(10, limits_.sweeps)};
  for (const double tolerance : limits_.ladder) {
    if (!points_.empty() && points_.back().residual <= tolerance) continue;  // met on the way to the last
    const bool is_asked = std::find(limits_.asked.begin(), limits_.asked.end(), tolerance) != limits_.asked.end();
    if (!is_asked && !points_.empty() && points_.back().seconds[0] > limits_.quick_run) continue;
    rung.asked = std::min(rung.asked, tolerance);
    const TracePoint point = climbed_to(rung, tolerance);
    if (!(point.residual <= tolerance) || point.seconds[0] > limits_.seconds) return;
    points_.push_back(point);
    rungs_.push_back({tolerance, rung});
  }
}

}  // namespace pushback::frozen
