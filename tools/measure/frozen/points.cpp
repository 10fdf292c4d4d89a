#include "pushback/tools/measure/frozen/points.h"

#include <algorithm>

#include "pushback/common/basics/quantile.h"
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

}  // namespace pushback::frozen
