#include <algorithm>
#include <numeric>

#include "pushback/chapters/19_accuracy_and_time/frozen/methods.h"
#include "pushback/chapters/19_accuracy_and_time/frozen/pictures.h"
#include "pushback/chapters/19_accuracy_and_time/frozen/traced.h"
#include "pushback/common/basics/input.h"
#include "pushback/common/basics/quantile.h"

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
double floor_of(const Trace& trace) {
  const std::vector<TracePoint>& points = trace.points();
  if (points.empty() || points.back().sweeps < 100 || points.back().residual < 1e-9) return 0;
  double early = not_reached, late = not_reached;
  for (const TracePoint& point : points) {
    double& least = 4 * point.sweeps < points.back().sweeps ? early : late;
    least = std::min(least, point.residual);
  }
  return late > 0.99 * early ? std::min(early, late) : 0;
}

/// "nscg 12, cone 3": what is 0 is left out.
std::string listed(const std::vector<int>& counts) {
  const std::vector<std::string> names = frozen_methods();
  std::vector<std::string> words;
  for (std::size_t m = 0; m < names.size(); ++m)
    if (counts[m] > 0) words.push_back(fmt::format("{} {}", names[m], counts[m]));
  return words.empty() ? "none" : fmt::format("{}", fmt::join(words, ", "));
}

std::string said_of(double tolerance, const std::vector<Traced>& all) {
  const Costs times = times_to(tolerance, all);
  std::vector<int> reached(frozen_methods().size()), fastest(frozen_methods().size());
  std::vector<std::string> unsolved;
  for (std::size_t p = 0; p < times.size(); ++p) {
    const auto first = std::min_element(times[p].begin(), times[p].end());
    for (std::size_t m = 0; m < times[p].size(); ++m) reached[m] += times[p][m] < not_reached ? 1 : 0;
    if (*first < not_reached) ++fastest[static_cast<std::size_t>(first - times[p].begin())];
    else unsolved.push_back(all[p].frozen->name);
  }
  return fmt::format("{:.0e}: of {} problems reached on: {}; fastest on: {}; no method on: {}", tolerance, all.size(),
                     listed(reached), listed(fastest),
                     unsolved.empty() ? "none" : fmt::format("{}", fmt::join(unsolved, ", ")));
}

std::string said_of_floors(std::size_t method, const std::vector<Traced>& all) {
  std::vector<double> floors;
  for (const Traced& of : all)
    if (const double at = floor_of(of.traces[method]); at > 0) floors.push_back(at);
  if (floors.empty()) return fmt::format("{} stands still nowhere", frozen_methods()[method]);
  const auto [least, most] = std::minmax_element(floors.begin(), floors.end());
  return fmt::format("{} stops above 0 on {} of {} problems, at {:.0e} to {:.0e}, median {:.0e}",
                     frozen_methods()[method], floors.size(), all.size(), *least, *most, median(floors));
}

}  // namespace

Costs times_to(double tolerance, const std::vector<Traced>& all) {
  Costs costs;
  for (const Traced& of : all) {
    costs.emplace_back();
    for (const Trace& trace : of.traces) {
      const TracePoint* point = trace.reaching(tolerance);
      costs.back().push_back(point == nullptr ? not_reached : point->time());
    }
  }
  return costs;
}

bool solves_systems(std::size_t method, const std::vector<Traced>& all) {
  for (const Traced& of : all)
    for (const TracePoint& point : of.traces[method].points())
      if (point.systems > 0) return true;
  return false;
}

std::vector<std::string> tables_of(const std::vector<Traced>& all) {
  std::vector<std::string> tables;
  for (const double tolerance : tolerances) {
    std::string table = fmt::format(
        "Median time in ms / row solves (+ linear systems; of Siconos: iterations) to a relative residual of {:.0e}; "
        "the fastest is bold:\n\n",
        tolerance);
    table += fmt::format("| problem | contacts | {} |\n| --- | --- |", fmt::join(frozen_methods(), " | "));
    for (std::size_t m = 0; m < frozen_methods().size(); ++m) table += " --- |";
    const Costs times = times_to(tolerance, all);
    for (std::size_t p = 0; p < all.size(); ++p) {
      table += fmt::format("\n| {} | {} |", all[p].frozen->name, all[p].frozen->problem.contacts());
      for (std::size_t m = 0; m < times[p].size(); ++m) {
        const TracePoint* point = all[p].traces[m].reaching(tolerance);
        if (point == nullptr) {
          table += " - |";
          continue;
        }
        const bool fastest = times[p][m] == *std::min_element(times[p].begin(), times[p].end());
        const Trace& trace = all[p].traces[m];
        table +=
            fmt::format(" {0}{1}{0} / {2}", fastest ? "**" : "", milliseconds(point->time()),
                        trace.counts_rows() ? counted(trace.row_solves(*point)) : fmt::format("{} it.", point->sweeps));
        table += point->systems > 0 ? fmt::format(" + {} |", point->systems) : " |";
      }
    }
    tables.push_back(table + "\n");
  }
  return tables;
}

std::string reached_of(const std::vector<Traced>& all) {
  std::string table = fmt::format(
      "Of {} problems: reached, fastest, and the median multiple of the fastest time:\n\n| method |", all.size());
  for (const double tolerance : tolerances) table += fmt::format(" {:.0e} |", tolerance);
  table += "\n| --- |";
  for (std::size_t i = 0; i < tolerances.size(); ++i) table += " --- |";
  for (std::size_t m = 0; m < frozen_methods().size(); ++m) {
    table += fmt::format("\n| {} |", frozen_methods()[m]);
    for (const double tolerance : tolerances) {
      int first = 0;
      std::vector<double> multiples;
      for (const std::vector<double>& of : times_to(tolerance, all)) {
        const double fastest = *std::min_element(of.begin(), of.end());
        if (of[m] < not_reached) multiples.push_back(of[m] / fastest);
        if (of[m] < not_reached && of[m] == fastest) ++first;
      }
      table += multiples.empty() ? " 0, – |"
                                 : fmt::format(" {}, {}, {:.3g} x |", multiples.size(), first, median(multiples));
    }
  }
  return table + "\n";
}

std::vector<std::string> remarks_of(const std::vector<Traced>& all) {
  std::vector<std::string> remarks;
  for (const double tolerance : tolerances) remarks.push_back(said_of(tolerance, all));
  std::vector<double> spread, cost_of_row, length_of_row;
  for (const Traced& of : all)
    length_of_row.push_back(static_cast<double>(of.frozen->problem.w.nonZeros()) /
                            static_cast<double>(of.frozen->problem.w.rows()));
  for (std::size_t m = 0; m < frozen_methods().size(); ++m) {
    const bool sweeps_only = !solves_systems(m, all) && !is_siconos(frozen_methods()[m]);
    for (const Traced& of : all) {
      if (of.traces[m].points().empty()) continue;
      const TracePoint& last = of.traces[m].points().back();
      spread.push_back((last.time(0.75) - last.time(0.25)) / last.time());
      if (sweeps_only && last.sweeps >= 100) cost_of_row.push_back(1e9 * last.time() / of.traces[m].row_solves(last));
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

std::string csv_of(const std::vector<Traced>& all) {
  std::string text = fmt::format("{}\n", csv_heading);
  for (const Traced& of : all)
    for (std::size_t m = 0; m < of.traces.size(); ++m)
      for (const TracePoint& point : of.traces[m].points())
        text += fmt::format("{},{},{},{},{},{},{:.6e},{:.3e},{:.3e},{:.3e}\n", of.frozen->name,
                            of.frozen->problem.contacts(), frozen_methods()[m], point.sweeps,
                            of.traces[m].counts_rows() ? fmt::format("{:.0f}", of.traces[m].row_solves(point)) : "-",
                            point.systems, point.residual, point.time(), point.time(0.25), point.time(0.75));
  return text;
}

}  // namespace pushback::frozen
