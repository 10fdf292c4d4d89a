#include "pushback/tools/measure/frozen/pictures.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "pushback/common/experiment/marker.h"

namespace pushback::frozen {

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
      const double x = against_time ? 1e3 * point.seconds : *point.row_solves;
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
    const auto only_sweeps = [](const FrozenPoint& point) { return point.row_solves && point.systems == 0; };
    if (std::all_of(all.problems.begin(), all.problems.end(), [&](const FrozenPoints::Problem& of) {
          return std::all_of(of.of_method[m].begin(), of.of_method[m].end(), only_sweeps);
        }))
      sweeping.push_back(m);
  }
  std::vector<Panel> panels;
  for (const double tolerance : tolerances)
    panels.push_back(
        profile_panel(fmt::format("time to a residual of {:.0e}, {} problems", tolerance, all.problems.size()), "time",
                      times_to(tolerance, all), all, every));
  Costs rows = costs_to(tolerances[1], all,
                        [](const FrozenPoint& point) { return std::max(1.0, point.row_solves.value_or(not_reached)); });
  for (std::vector<double>& of : rows)  // nobody is held against what is not shown
    for (std::size_t m = 0; m < of.size(); ++m)
      if (std::find(sweeping.begin(), sweeping.end(), m) == sweeping.end()) of[m] = not_reached;
  panels.push_back(profile_panel(fmt::format("row solves to a residual of {:.0e}", tolerances[1]), "row solves", rows,
                                 all, sweeping));
  return panels;
}

}  // namespace pushback::frozen
