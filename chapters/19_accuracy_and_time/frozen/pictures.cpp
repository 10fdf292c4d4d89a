#include <algorithm>
#include <cmath>

#include "pushback/chapters/19_accuracy_and_time/frozen/methods.h"
#include "pushback/chapters/19_accuracy_and_time/frozen/traced.h"
#include "pushback/common/basics/input.h"

namespace pushback::frozen {

namespace {

/// Those that tell most, the first six that are there.
constexpr std::array telling{"stack of 20",          "pile of 48 shapes after 2 s", "KaplasTower-i1061-4.hdf5",
                             "heavy on four 1:1000", "twelve planks sliding",       "RockPile_tob1",
                             "arch of 11 stones",    "pyramid of 10 after 1 s"};

std::string title_of(const FrozenProblem& frozen) {
  std::string name = frozen.name.substr(0, frozen.name.find_first_of("-_"));  // gnuplot lowers what follows a _
  return fmt::format("{}, {} contacts", name, frozen.problem.contacts());
}

/// The same: Siconos' NSN_AC.
std::string label_of(std::string method) {
  std::replace(method.begin(), method.end(), '_', '-');
  return method;
}

Panel trace_panel(const Traced& of, bool against_time) {
  Panel panel{.title = title_of(*of.frozen),
              .x_label = against_time ? "time, ms" : "row solves",
              .y_label = "relative residual",
              .log_x = true,
              .log_y = true,
              .floor = 1e-13};
  for (std::size_t m = of.traces.size(); m-- > 0;) {  // the first on top: dashed, they show what they coincide with
    const std::string method = frozen_methods()[m];
    if (!against_time && !of.traces[m].counts_rows()) continue;
    const std::vector<TracePoint>& points = of.traces[m].points();
    if (points.empty()) {
      panel.curves.push_back({label_of(method) + ": not reached", {}, {}, line_colour(m)});
      continue;
    }
    const bool wrong_law = method == "pgs" || method == "scaled-back", every_sweep = points[0].sweeps == 0;
    Curve curve{label_of(method), {}, {}, line_colour(m), Curve::Style::line};
    if (wrong_law) curve.style = Curve::Style::dashed;
    if (!every_sweep) curve.style = Curve::Style::line_and_points;
    for (const TracePoint& point : points) {
      if (point.sweeps == 0) continue;  // no place for it on a logarithmic axis
      const double x = against_time ? 1e3 * point.time() : of.traces[m].row_solves(point);
      curve.x.push_back(static_cast<Real>(x));
      curve.y.push_back(static_cast<Real>(std::max(point.residual, 1e-13)));
    }
    panel.curves.push_back(curve);
  }
  return panel;
}

Panel profile_panel(const std::string& title, const std::string& unit, const Costs& costs,
                    const std::vector<std::size_t>& methods) {
  Panel panel{.title = title,
              .x_label = "times the " + unit + " of the cheapest",
              .y_label = "part of all problems",
              .log_x = true,
              .x_range = {1, 1000}};
  for (const std::size_t m : methods) {
    Curve curve{label_of(frozen_methods()[m]), {}, {}, line_colour(m), Curve::Style::line};
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

std::vector<Panel> trace_panels(const std::vector<Traced>& all) {
  std::vector<const Traced*> shown;
  for (const char* name : telling)
    for (const Traced& of : all)
      if (of.frozen->name == name && shown.size() < 6) shown.push_back(&of);
  std::vector<Panel> panels;
  for (std::size_t first = 0; first < shown.size(); first += 3)
    for (const bool against_time : {true, false})
      for (std::size_t i = first; i < std::min(first + 3, shown.size()); ++i)
        panels.push_back(trace_panel(*shown[i], against_time));
  return panels;
}

std::vector<Panel> profile_panels(const std::vector<Traced>& all) {
  std::vector<std::size_t> every, sweeping;
  for (std::size_t m = 0; m < frozen_methods().size(); ++m) {
    every.push_back(m);
    if (!solves_systems(m, all) && !is_siconos(frozen_methods()[m])) sweeping.push_back(m);
  }
  std::vector<Panel> panels;
  for (const double tolerance : tolerances)
    panels.push_back(profile_panel(fmt::format("time to a residual of {:.0e}, {} problems", tolerance, all.size()),
                                   "time", times_to(tolerance, all), every));
  Costs rows = row_solves_to(tolerances[1], all);
  for (std::vector<double>& of : rows)  // nobody is held against what is not shown
    for (std::size_t m = 0; m < of.size(); ++m)
      if (std::find(sweeping.begin(), sweeping.end(), m) == sweeping.end()) of[m] = not_reached;
  panels.push_back(
      profile_panel(fmt::format("row solves to a residual of {:.0e}", tolerances[1]), "row solves", rows, sweeping));
  return panels;
}

}  // namespace pushback::frozen
