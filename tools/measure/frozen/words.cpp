#include "pushback/tools/measure/frozen/words.h"

#include <fmt/ranges.h>

#include <algorithm>

#include "pushback/common/basics/input.h"
#include "pushback/common/basics/quantile.h"
#include "pushback/tools/measure/frozen/methods.h"
#include "pushback/tools/measure/results/markdown.h"

namespace pushback::frozen {

namespace {

std::string counted(double count) {
  if (count < 1e4) return fmt::format("{:.0f}", count);
  return count < 1e6 ? fmt::format("{:.0f}k", count / 1e3) : fmt::format("{:.1f}M", count / 1e6);
}

std::string milliseconds(double seconds) {
  return seconds < 1 ? fmt::format("{:.3g}", 1e3 * seconds) : fmt::format("{:.0f}", 1e3 * seconds);
}

/// "3 to 50, median 20".
std::string from_to(const std::vector<double>& values) {
  if (values.empty()) return "no";
  const auto [least, most] = std::minmax_element(values.begin(), values.end());
  return fmt::format("{:.0f} to {:.0f} (median {:.0f})", *least, *most, median(values));
}

/// The least residual that it stays at: three quarters of its sweeps, a hundred at least, took off less than 1 %. 0: it does not.
double floor_of(const std::vector<FrozenPoint>& points) {
  if (points.empty() || points.back().sweeps < 100 || points.back().residual < 1e-9) return 0;
  double early = not_reached, late = not_reached;
  for (const FrozenPoint& point : points) {
    double& least = 4 * point.sweeps < points.back().sweeps ? early : late;
    least = std::min(least, point.residual);
  }
  return late > 0.99 * early ? std::min(early, late) : 0;
}

/// "nscg 12, cone 3": what is 0 is left out.
std::string listed(const std::vector<std::string>& names, const std::vector<int>& counts) {
  std::vector<std::string> words;
  for (std::size_t m = 0; m < names.size(); ++m)
    if (counts[m] > 0) words.push_back(fmt::format("{} {}", names[m], counts[m]));
  return words.empty() ? "none" : fmt::format("{}", fmt::join(words, ", "));
}

/// Whether any of its points took linear systems, so that row solves are not all of its work.
bool solves_systems(std::size_t method, const FrozenPoints& all) {
  for (const FrozenPoints::Problem& of : all.problems)
    for (const FrozenPoint& point : of.of_method[method])
      if (point.systems > 0) return true;
  return false;
}

/// How many numbers a row of its W has, on average.
double row_length(const std::string& name, const std::vector<FrozenProblem>& problems) {
  for (const FrozenProblem& frozen : problems)
    if (frozen.name == name)
      return static_cast<double>(frozen.problem.w.nonZeros()) / static_cast<double>(frozen.problem.w.rows());
  throw InvalidInput(fmt::format(
      "frozen.csv has the problem '{}', which is none of ours: --problems with the folder of its file is needed",
      name));
}

std::string said_of(double tolerance, const FrozenPoints& all) {
  const Costs times = times_to(tolerance, all);
  std::vector<int> reached(all.methods.size()), fastest(all.methods.size());
  std::vector<std::string> unsolved;
  for (std::size_t p = 0; p < times.size(); ++p) {
    const auto first = std::min_element(times[p].begin(), times[p].end());
    for (std::size_t m = 0; m < times[p].size(); ++m) reached[m] += times[p][m] < not_reached ? 1 : 0;
    if (*first < not_reached) ++fastest[static_cast<std::size_t>(first - times[p].begin())];
    else unsolved.push_back(all.problems[p].name);
  }
  return fmt::format("{:.0e}: of {} problems reached on: {}; fastest on: {}; no method on: {}", tolerance,
                     all.problems.size(), listed(all.methods, reached), listed(all.methods, fastest),
                     unsolved.empty() ? "none" : fmt::format("{}", fmt::join(unsolved, ", ")));
}

std::string said_of_floors(std::size_t method, const FrozenPoints& all) {
  std::vector<double> floors;
  for (const FrozenPoints::Problem& of : all.problems)
    if (const double at = floor_of(of.of_method[method]); at > 0) floors.push_back(at);
  if (floors.empty()) return fmt::format("{} stands still nowhere", all.methods[method]);
  const auto [least, most] = std::minmax_element(floors.begin(), floors.end());
  return fmt::format("{} stops above 0 on {} of {} problems, at {:.0e} to {:.0e}, median {:.0e}", all.methods[method],
                     floors.size(), all.problems.size(), *least, *most, median(floors));
}

}  // namespace

std::vector<std::string> tables_of(const FrozenPoints& all) {
  std::vector<std::string> tables;
  for (const double tolerance : tolerances) {
    std::string table = fmt::format(
        "Median time in ms / row solves (+ linear systems; of Siconos: iterations) to a relative residual of {:.0e}; "
        "the fastest is bold:\n\n",
        tolerance);
    std::vector<std::string> heads{"problem", "contacts"};
    heads.insert(heads.end(), all.methods.begin(), all.methods.end());
    table += markdown_heads(heads);
    const Costs times = times_to(tolerance, all);
    for (std::size_t p = 0; p < all.problems.size(); ++p) {
      std::vector<std::string> row{all.problems[p].name, std::to_string(all.problems[p].contacts)};
      for (std::size_t m = 0; m < times[p].size(); ++m) {
        const FrozenPoint* point = reaching(tolerance, all.problems[p].of_method[m]);
        row.emplace_back("-");
        if (point == nullptr) continue;
        const bool fastest = times[p][m] == *std::min_element(times[p].begin(), times[p].end());
        row.back() =
            fmt::format("{0}{1}{0} / {2}", fastest ? "**" : "", milliseconds(point->seconds),
                        point->row_solves ? counted(*point->row_solves) : fmt::format("{} it.", point->sweeps));
        if (point->systems > 0) row.back() += fmt::format(" + {}", point->systems);
      }
      table += markdown_row(row);
    }
    tables.push_back(table);
  }
  return tables;
}

std::string reached_of(const FrozenPoints& all) {
  std::vector<std::string> heads{"method"};
  for (const double tolerance : tolerances) heads.push_back(fmt::format("{:.0e}", tolerance));
  std::string table =
      fmt::format("Of {} problems: reached, fastest, and the median multiple of the fastest time:\n\n{}",
                  all.problems.size(), markdown_heads(heads));
  for (std::size_t m = 0; m < all.methods.size(); ++m) {
    std::vector<std::string> row{all.methods[m]};
    for (const double tolerance : tolerances) {
      int first = 0;
      std::vector<double> multiples;
      for (const std::vector<double>& of : times_to(tolerance, all)) {
        const double fastest = *std::min_element(of.begin(), of.end());
        if (of[m] < not_reached) multiples.push_back(of[m] / fastest);
        if (of[m] < not_reached && of[m] == fastest) ++first;
      }
      row.push_back(multiples.empty() ? "0, –"
                                      : fmt::format("{}, {}, {:.3g} x", multiples.size(), first, median(multiples)));
    }
    table += markdown_row(row);
  }
  return table;
}

std::vector<std::string> remarks_of(const FrozenPoints& all, const std::vector<FrozenProblem>& problems) {
  std::vector<std::string> remarks;
  for (const double tolerance : tolerances) remarks.push_back(said_of(tolerance, all));
  std::vector<double> spread, cost_of_row, length_of_row;
  for (const FrozenPoints::Problem& of : all.problems) length_of_row.push_back(row_length(of.name, problems));
  for (std::size_t m = 0; m < all.methods.size(); ++m) {
    const bool sweeps_only = !solves_systems(m, all) && !is_siconos(all.methods[m]);
    for (const FrozenPoints::Problem& of : all.problems) {
      if (of.of_method[m].empty()) continue;
      const FrozenPoint& last = of.of_method[m].back();
      spread.push_back((last.upper_quartile - last.lower_quartile) / last.seconds);
      if (sweeps_only && last.sweeps >= 100) cost_of_row.push_back(1e9 * last.seconds / *last.row_solves);
    }
    if (sweeps_only) remarks.push_back(said_of_floors(m, all));
  }
  remarks.push_back(fmt::format("a row of W holds {} numbers, and a row solve takes {} ns", from_to(length_of_row),
                                from_to(cost_of_row)));
  if (!spread.empty())
    remarks.push_back(
        fmt::format("between the quartiles of a time there are {:.0f} % of it (median of all)", 100 * median(spread)));
  return remarks;
}

}  // namespace pushback::frozen
