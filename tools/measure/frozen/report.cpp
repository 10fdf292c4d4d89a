#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "pushback/common/basics/input.h"
#include "pushback/common/basics/quantile.h"
#include "pushback/common/experiment/marker.h"
#include "pushback/tools/measure/frozen/frozen.h"
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

/// Whether row solves are all of its work: not linear systems, nor iterations of another kind.
bool is_all_rows(std::size_t method, const FrozenPoints& all) {
  const auto is_rows = [](const FrozenPoint& point) { return point.row_solves && point.systems == 0; };
  return std::all_of(all.problems.begin(), all.problems.end(), [&](const FrozenPoints::Problem& of) {
    return std::all_of(of.of_method[method].begin(), of.of_method[method].end(), is_rows);
  });
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
            fmt::format("{0}{1}{0} / {2}", fastest ? "**" : "", milliseconds(point->time()),
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
  std::vector<double> spread, cost_of_row, length_of_row;
  for (const FrozenPoints::Problem& of : all.problems) length_of_row.push_back(row_length(of.name, problems));
  for (std::size_t m = 0; m < all.methods.size(); ++m) {
    const bool sweeps_only = is_all_rows(m, all);
    for (const FrozenPoints::Problem& of : all.problems) {
      if (of.of_method[m].empty()) continue;
      const FrozenPoint& last = of.of_method[m].back();
      spread.push_back((last.time(0.75) - last.time(0.25)) / last.time());
      if (sweeps_only && last.sweeps >= 100) cost_of_row.push_back(1e9 * last.time() / *last.row_solves);
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

namespace {

/// Those that tell most, the first six that are there.
constexpr std::array telling{"stack of 20",          "pile of 48 shapes after 2 s", "KaplasTower-i1061-4.hdf5",
                             "heavy on four 1:1000", "twelve planks sliding",       "RockPile_tob1",
                             "arch of 11 stones",    "pyramid of 10 after 1 s"};

Curve curve_of(const std::string& method, std::size_t index) {
  return {method, {}, {}, line_colour(index), Curve::Style::line, marker_of(index)};
}

Panel trace_panel(const FrozenPoints& all, const FrozenPoints::Problem& of, bool against_time) {
  Panel panel{.title = fmt::format("{}, {} contacts", of.name.substr(0, of.name.find_first_of("-_")), of.contacts),
              .x_label = against_time ? "time, ms" : "row solves",
              .y_label = "relative residual",
              .log_x = true,
              .log_y = true,
              .floor = Real(1e-12)};
  for (std::size_t m = 0; m < all.methods.size(); ++m) {
    const std::vector<FrozenPoint>& points = of.of_method[m];
    Curve curve = curve_of(all.methods[m], m);
    if (points.empty()) {
      curve.label += ": not reached";
      if (against_time) panel.curves.push_back(curve);
      continue;
    }
    if (!against_time && !points[0].row_solves) continue;
    const auto at_start = [](const FrozenPoint& point) { return point.sweeps == 0 && point.systems == 0; };
    const bool wrong_law = curve.label == "pgs" || curve.label == "scaled-back", every_sweep = at_start(points[0]);
    if (wrong_law) curve.style = Curve::Style::dashed;
    if (!every_sweep) curve.style = Curve::Style::line_and_points;
    for (const FrozenPoint& point : points) {
      const double x = against_time ? 1e3 * point.time() : *point.row_solves;
      if (at_start(point) || x == 0) continue;  // no place for it on a logarithmic axis
      curve.x.push_back(static_cast<Real>(x));
      curve.y.push_back(static_cast<Real>(point.residual));
    }
    if (against_time || !curve.x.empty()) panel.curves.push_back(curve);
  }
  return panel;
}

Panel profile_panel(const std::string& title, const std::string& unit, const Costs& costs, const FrozenPoints& all,
                    const std::vector<std::size_t>& methods) {
  Panel panel{.title = title,
              .x_label = "times the " + unit + " of the cheapest",
              .y_label = "part of all problems",
              .log_x = true,
              .x_range = {1, 1000}};
  for (const std::size_t m : methods) {
    Curve curve = curve_of(all.methods[m], m);
    for (int i = 0; i <= 600; ++i) {
      const double tau = std::pow(10, i / 200.0);
      curve.x.push_back(static_cast<Real>(tau));
      curve.y.push_back(static_cast<Real>(part_within(costs, m, tau)));
    }
    panel.curves.push_back(curve);
  }
  return panel;
}

}  // namespace

std::vector<Panel> trace_panels(const FrozenPoints& all) {
  std::vector<Panel> panels;
  for (const char* name : telling) {
    for (const FrozenPoints::Problem& of : all.problems) {
      if (of.name != name || panels.size() == 12) continue;
      for (const bool against_time : {true, false}) panels.push_back(trace_panel(all, of, against_time));
    }
  }
  return panels;
}

std::vector<Panel> profile_panels(const FrozenPoints& all) {
  std::vector<std::size_t> every, sweeping;
  for (std::size_t m = 0; m < all.methods.size(); ++m) {
    every.push_back(m);
    if (is_all_rows(m, all)) sweeping.push_back(m);
  }
  std::vector<Panel> panels;
  for (const double tolerance : tolerances)
    panels.push_back(
        profile_panel(fmt::format("time to a residual of {:.0e}, {} problems", tolerance, all.problems.size()), "time",
                      times_to(tolerance, all), all, every));
  Costs rows = row_solves_to(tolerances[1], all);
  for (std::vector<double>& of : rows)  // nobody is held against what is not shown
    for (std::size_t m = 0; m < of.size(); ++m)
      if (std::find(sweeping.begin(), sweeping.end(), m) == sweeping.end()) of[m] = not_reached;
  panels.push_back(profile_panel(fmt::format("row solves to a residual of {:.0e}", tolerances[1]), "row solves", rows,
                                 all, sweeping));
  return panels;
}

}  // namespace pushback::frozen
