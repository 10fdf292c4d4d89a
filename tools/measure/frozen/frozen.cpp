#include "pushback/tools/measure/frozen/frozen.h"

#include <algorithm>
#include <cmath>

#include "pushback/common/basics/quantile.h"
#include "pushback/common/basics/stopwatch.h"
#include "pushback/engine/direct/smoothed_newton.h"
#include "pushback/tools/measure/frozen/siconos.h"
#include "pushback/tools/measure/results/csv.h"

namespace pushback::frozen {

namespace {

constexpr const char* csv_heading =
    "problem,contacts,method,sweeps,row_solves,systems,residual,median_s,lower_quartile_s,upper_quartile_s";

/// Where it is in the list; at its end, if it is new.
template <class List, class Is>
std::size_t place_in(List& list, const Is& is, typename List::value_type fresh) {
  const auto found = std::find_if(list.begin(), list.end(), is);
  const auto place = static_cast<std::size_t>(found - list.begin());
  if (found == list.end()) list.push_back(std::move(fresh));
  return place;
}

template <class Cost>
Costs costs_to(double tolerance, const FrozenPoints& all, const Cost& cost) {
  Costs costs;
  for (const FrozenPoints::Problem& of : all.problems) {
    costs.emplace_back();
    for (const std::vector<FrozenPoint>& points : of.of_method) {
      const FrozenPoint* point = reaching(tolerance, points);
      costs.back().push_back(point == nullptr ? not_reached : cost(*point));
    }
  }
  return costs;
}

}  // namespace

double FrozenPoint::time(double part) const {
  return quantile(seconds, part);
}

std::string csv_of(const FrozenPoints& all) {
  std::string text = fmt::format("{}\n", csv_heading);
  for (const FrozenPoints::Problem& of : all.problems)
    for (std::size_t m = 0; m < of.of_method.size(); ++m)
      for (const FrozenPoint& point : of.of_method[m])
        text += fmt::format("{},{},{},{},{},{},{:.6e},{:.3e},{:.3e},{:.3e}\n", of.name, of.contacts, all.methods[m],
                            point.sweeps, point.row_solves ? fmt::format("{:.0f}", *point.row_solves) : "-",
                            point.systems, point.residual, point.time(), point.time(0.25), point.time(0.75));
  return text;
}

FrozenPoints read_frozen_csv(const std::string& text) {
  FrozenPoints all;
  read_csv_lines(text, csv_heading, [&](const std::vector<std::string>& fields) {
    const auto middle = csv_number<double>(fields[7]), lower = csv_number<double>(fields[8]),
               upper = csv_number<double>(fields[9]);
    FrozenPoint point{.sweeps = csv_number<int>(fields[3]),
                      .systems = csv_number<int>(fields[5]),
                      .residual = csv_number<double>(fields[6]),
                      .seconds = {lower, lower, middle, upper, upper}};
    if (fields[4] != "-") point.row_solves = csv_number<double>(fields[4]);
    const std::string &name = fields[0], &method = fields[2];
    if (method.empty()) throw InvalidInput("a method is needed");
    const std::size_t m = place_in(all.methods, [&](const std::string& other) { return other == method; }, method);
    const std::size_t p = place_in(all.problems, [&](const FrozenPoints::Problem& other) { return other.name == name; },
                                   {name, csv_number<int>(fields[1]), {}});
    std::vector<std::vector<FrozenPoint>>& of_method = all.problems[p].of_method;
    of_method.resize(std::max(of_method.size(), m + 1));
    of_method[m].push_back(point);
  });
  for (FrozenPoints::Problem& of : all.problems) of.of_method.resize(all.methods.size());
  return all;
}

const FrozenPoint* reaching(double tolerance, const std::vector<FrozenPoint>& points) {
  const auto found =
      std::find_if(points.begin(), points.end(), [&](const FrozenPoint& point) { return point.residual <= tolerance; });
  return found == points.end() ? nullptr : &*found;
}

Costs times_to(double tolerance, const FrozenPoints& all) {
  return costs_to(tolerance, all, [](const FrozenPoint& point) { return point.time(); });
}

Costs row_solves_to(double tolerance, const FrozenPoints& all) {
  return costs_to(tolerance, all,
                  [](const FrozenPoint& point) { return std::max(1.0, point.row_solves.value_or(not_reached)); });
}

double part_within(const Costs& costs, std::size_t method, double tau) {
  std::size_t within = 0;
  for (const std::vector<double>& of : costs) {
    const double cheapest = *std::min_element(of.begin(), of.end());
    if (of[method] < not_reached && of[method] <= tau * cheapest) ++within;
  }
  return costs.empty() ? 0 : static_cast<double>(within) / static_cast<double>(costs.size());
}

// ---- traces ----

Trace::Trace(const ContactProblem& problem, const std::string& method, const TraceLimits& limits,
             const SparseMatrix& factor)
    : problem_(problem), method_(method), limits_(limits), factor_(factor) {
  again();
}

void Trace::again() {
  if (is_siconos(method_) || !counts_sweeps(method_)) climb();
  else sweep_along();
}

FrozenPoint Trace::point(int sweeps, int systems, double residual) const {
  FrozenPoint point{.sweeps = sweeps, .systems = systems, .residual = residual};
  // Each sweep solves a row for each normal and each tangent.
  if (!is_siconos(method_)) point.row_solves = 3.0 * static_cast<double>(problem_.contacts()) * sweeps;
  return point;
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
      points_.push_back(point(static_cast<int>(done), 0, residual));
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

FrozenPoint Trace::climbed_to(Rung& rung) const {
  while (is_siconos(method_)) {
    const SiconosAnswer found = solve_by_siconos(problem_, method_, rung.asked, rung.iterations, limits_.patience);
    FrozenPoint reached = point(found.iterations, 0, relative_residual(problem_, found.r));
    reached.seconds = {found.seconds};
    if (reached.residual <= rung.tolerance || found.seconds > limits_.seconds) return reached;
    const double tighter = 0.5 * rung.tolerance * problem_.q.norm() / siconos_unit(problem_, found.r);
    if (found.reached && tighter < 0.99 * rung.asked) rung.asked = tighter;
    else if (rung.iterations < limits_.sweeps) rung.iterations = std::min(4 * rung.iterations, limits_.sweeps);
    else return reached;
  }
  Stopwatch solving;
  solving.go();
  const Solution found =
      method_ == "smoothed"
          ? Solution(solve_smoothed(problem_, {.tolerance = rung.tolerance, .work = limits_.work}, factor_))
          : solve_best(problem_, {.tolerance = rung.tolerance, .work = limits_.work});
  solving.stop();
  FrozenPoint reached = point(found.sweeps, found.systems, found.residual);
  reached.seconds = {solving.seconds()};
  return reached;
}

void Trace::climb() {
  for (std::size_t i = 0; i < rungs_.size(); ++i) {
    Rung rung = rungs_[i];
    points_[i].seconds.push_back(climbed_to(rung).seconds[0]);
  }
  if (!rungs_.empty()) return;
  Rung rung{1, 1, std::min(10, limits_.sweeps)};
  for (const double tolerance : limits_.ladder) {
    if (!points_.empty() && points_.back().residual <= tolerance) continue;  // met on the way to the last
    const bool is_asked = std::find(limits_.asked.begin(), limits_.asked.end(), tolerance) != limits_.asked.end();
    if (!is_asked && !points_.empty() && points_.back().seconds[0] > limits_.quick_run) continue;
    rung.tolerance = tolerance;
    rung.asked = std::min(rung.asked, tolerance);
    const FrozenPoint reached = climbed_to(rung);
    if (!(reached.residual <= tolerance) || reached.seconds[0] > limits_.seconds) return;
    points_.push_back(reached);
    rungs_.push_back(rung);
  }
}

namespace {

TraceLimits limits_of(bool quick) {
  TraceLimits limits;
  limits.asked.assign(tolerances.begin(), tolerances.end());
  if (quick) {
    limits.seconds = 0.03;
    limits.work = 1e8;
    limits.ladder = limits.asked;
  }
  return limits;
}

FrozenPoints traced(const std::vector<FrozenProblem>& problems, const TraceLimits& limits, int rounds,
                    int rounds_of_long) {
  FrozenPoints all{frozen_methods(), {}};
  for (const FrozenProblem& frozen : problems) {
    std::vector<Trace> traces;
    for (const std::string& method : all.methods) traces.emplace_back(frozen.problem, method, limits, frozen.factor);
    const bool is_long = std::any_of(traces.begin(), traces.end(), [&](const Trace& trace) {
      return !trace.points().empty() && trace.points().back().time() > limits.seconds / 4;
    });
    for (int round = 1; round < (is_long ? rounds_of_long : rounds); ++round)
      for (Trace& trace : traces) trace.again();
    all.problems.push_back({frozen.name, static_cast<int>(frozen.problem.contacts()), {}});
    for (const Trace& trace : traces) all.problems.back().of_method.push_back(trace.points());
  }
  return all;
}

}  // namespace

FrozenPoints study_frozen(const std::vector<FrozenProblem>& problems, bool quick) {
  return traced(problems, limits_of(quick), quick ? 3 : 7, 3);
}

FrozenPoints study_large(const std::vector<FrozenProblem>& problems, bool quick) {
  TraceLimits limits = limits_of(quick);
  if (!quick) {
    limits.seconds = 10;
    limits.work = 2e10;
    limits.ladder = limits.asked;
  }
  return traced(problems, limits, 1, 1);
}

}  // namespace pushback::frozen
