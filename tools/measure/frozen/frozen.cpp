#include "pushback/tools/measure/frozen/frozen.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "pushback/chapters/17_direct_contacts/methods.h"
#include "pushback/common/basics/quantile.h"
#include "pushback/common/basics/stopwatch.h"
#include "pushback/engine/direct/smoothed_newton.h"
#include "pushback/tools/measure/results/markdown.h"

namespace pushback::frozen {

namespace {

Progress by_sweeps(const ContactProblem& problem, const std::string& method, const Limits& limits) {
  Progress progress;
  Stopwatch solving;
  solving.go();
  const Sweep sweep = sweep_of(problem, method);
  solving.stop();
  Vector r = Vector::Zero(problem.q.size());
  std::size_t next = 0;
  for (int done = 0; next < tolerances.size();) {
    const double residual = relative_residual(problem, r);
    for (; next < tolerances.size() && residual <= tolerances[next]; ++next)
      progress[next] = Reached{.sweeps = done, .seconds = solving.seconds()};
    if (!std::isfinite(residual) || solving.seconds() > limits.seconds || done >= limits.sweeps) break;
    const int upto = std::min(limits.sweeps, std::max(done + 1, done + done / 4));
    solving.go();
    for (; done < upto; ++done) sweep(r);
    solving.stop();
  }
  return progress;
}

Progress by_runs(const FrozenProblem& frozen, const std::string& method, const Limits& limits) {
  Progress progress;
  for (std::size_t i = 0; i < tolerances.size(); ++i) {
    Solution found;
    const double seconds = computing_time([&] {
      if (method == "smoothed")
        found = solve_smoothed(frozen.problem, {.tolerance = tolerances[i], .work = limits.work}, frozen.factor);
      else found = solve_best(frozen.problem, {.tolerance = tolerances[i], .work = limits.work});
    });
    if (!(found.residual <= tolerances[i]) || seconds > limits.seconds) break;
    progress[i] = Reached{found.sweeps, found.systems, seconds};
  }
  return progress;
}

constexpr double not_reached = std::numeric_limits<double>::infinity();

/// The times of all methods, s.
std::vector<double> times_of(const Compared& row, std::size_t tolerance) {
  std::vector<double> times;
  for (const Progress& progress : row.of_method)
    times.push_back(progress[tolerance] ? progress[tolerance]->seconds : not_reached);
  return times;
}

/// Each sweep solves a row for each normal and each tangent.
std::string row_solves(const Compared& row, const Reached& reached) {
  const double count = 3.0 * static_cast<double>(row.contacts) * reached.sweeps;
  std::string text = count < 1e4   ? fmt::format("{:.0f}", count)
                     : count < 1e6 ? fmt::format("{:.0f}k", count / 1e3)
                                   : fmt::format("{:.1f}M", count / 1e6);
  if (reached.systems > 0) text += fmt::format(" + {}", reached.systems);
  return text;
}

std::string milliseconds(double seconds) {
  return seconds < 1 ? fmt::format("{:.3g}", 1e3 * seconds) : fmt::format("{:.0f}", 1e3 * seconds);
}

std::string table_of(const std::vector<Compared>& rows, std::size_t tolerance) {
  std::vector<std::string> heads{"problem", "contacts"};
  for (const std::string& method : method_names()) heads.push_back(method);
  std::string table = markdown_heads(heads);
  for (const Compared& row : rows) {
    std::vector<std::string> cells{row.problem, std::to_string(row.contacts)};
    const std::vector<double> times = times_of(row, tolerance);
    for (std::size_t m = 0; m < times.size(); ++m) {
      cells.emplace_back("-");
      if (times[m] == not_reached) continue;
      const bool fastest = times[m] == *std::min_element(times.begin(), times.end());
      cells.back() = fmt::format("{0}{1}{0} / {2}", fastest ? "**" : "", milliseconds(times[m]),
                                 row_solves(row, *row.of_method[m][tolerance]));
    }
    table += markdown_row(cells);
  }
  return table;
}

}  // namespace

Progress progress_of(const FrozenProblem& frozen, const std::string& method, const Limits& limits) {
  return counts_sweeps(method) ? by_sweeps(frozen.problem, method, limits) : by_runs(frozen, method, limits);
}

std::vector<Compared> compare(const std::vector<FrozenProblem>& problems, const Limits& limits, int rounds) {
  const std::vector<std::string> methods = method_names();
  std::vector<Compared> rows;
  for (const FrozenProblem& frozen : problems) {
    Compared row{frozen.name, frozen.problem.contacts(), std::vector<Progress>(methods.size())};
    std::vector<std::array<std::vector<double>, tolerances.size()>> seconds(methods.size());
    double longest = 0;
    for (int round = 0; round < rounds && (round < 3 || longest < limits.seconds / 4); ++round)
      for (std::size_t m = 0; m < methods.size(); ++m) {
        Stopwatch whole;
        whole.go();
        const Progress progress = progress_of(frozen, methods[m], limits);
        whole.stop();
        longest = std::max(longest, whole.seconds());
        for (std::size_t i = 0; i < tolerances.size(); ++i) {
          if (!progress[i]) continue;
          row.of_method[m][i] = progress[i];
          seconds[m][i].push_back(progress[i]->seconds);
        }
      }
    for (std::size_t m = 0; m < methods.size(); ++m)
      for (std::size_t i = 0; i < tolerances.size(); ++i)
        if (row.of_method[m][i]) row.of_method[m][i]->seconds = median(seconds[m][i]);
    rows.push_back(row);
  }
  return rows;
}

std::string tables_of(const std::vector<Compared>& rows) {
  std::string page;
  for (std::size_t i = 0; i < tolerances.size(); ++i)
    page += fmt::format(
        "{}Median time in ms / row solves (+ linear systems) to a relative residual of {:.0e}; the fastest is "
        "bold:\n\n{}",
        i > 0 ? "\n" : "", tolerances[i], table_of(rows, i));
  return page;
}

std::string reached_of(const std::vector<Compared>& rows) {
  std::vector<std::string> heads{"method"};
  for (const double tolerance : tolerances) heads.push_back(fmt::format("{:.0e}", tolerance));
  std::string table =
      fmt::format("Of {} problems: reached, fastest, and the median multiple of the fastest time:\n\n{}", rows.size(),
                  markdown_heads(heads));
  const std::vector<std::string> methods = method_names();
  for (std::size_t m = 0; m < methods.size(); ++m) {
    std::vector<std::string> cells{methods[m]};
    for (std::size_t i = 0; i < tolerances.size(); ++i) {
      std::vector<double> multiples;
      for (const Compared& row : rows) {
        const std::vector<double> times = times_of(row, i);
        if (times[m] < not_reached) multiples.push_back(times[m] / *std::min_element(times.begin(), times.end()));
      }
      cells.push_back(multiples.empty()
                          ? "0, –"
                          : fmt::format("{}, {}, {:.3g} x", multiples.size(),
                                        std::count(multiples.begin(), multiples.end(), 1.0), median(multiples)));
    }
    table += markdown_row(cells);
  }
  return table;
}

}  // namespace pushback::frozen
