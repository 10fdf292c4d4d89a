/// frozen.csv: every point that was traced. Tables and pictures (report.h) are made of it alone, again at any time.
#pragma once

#include <array>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace pushback::frozen {

inline constexpr std::array tolerances{1e-3, 1e-6, 1e-10};  ///< of relative_residual: what is asked for

/// How far a method has come on a problem, and what was paid so far.
struct FrozenPoint {
  int sweeps = 0;                         ///< or iterations, where that is what the method counts
  int systems = 0;                        ///< linear systems
  std::optional<double> row_solves = {};  ///< not of Siconos, whose iterations are not over rows
  double residual = 0;
  /// Of solving up to here, one a round: the residual and other programs not counted. Read again, five of the same median and quartiles.
  std::vector<double> seconds = {};

  double time(double part = 0.5) const;  ///< s: the median of the rounds; 0.25, 0.75: the quartiles
};

struct FrozenPoints {
  struct Problem {
    std::string name;
    int contacts;
    std::vector<std::vector<FrozenPoint>> of_method;  ///< empty where it has reached nothing
  };
  std::vector<std::string> methods;  ///< in the order in which the file names them
  std::vector<Problem> problems;
};

std::string csv_of(const FrozenPoints& all);
/// Throws InvalidInput where a line is not one of these.
FrozenPoints read_frozen_csv(const std::string& text);

/// Where the residual is that low for the first time; nullptr: nowhere.
const FrozenPoint* reaching(double tolerance, const std::vector<FrozenPoint>& points);

inline constexpr double not_reached = std::numeric_limits<double>::infinity();

/// costs[p][m]: what method m takes for problem p, in any unit, above 0; not_reached where it does not solve it.
using Costs = std::vector<std::vector<double>>;
/// Median s of each method until its residual is that low.
Costs times_to(double tolerance, const FrozenPoints& all);
/// Row solves likewise, 1 at least.
Costs row_solves_to(double tolerance, const FrozenPoints& all);

/// A performance profile: who is how far behind the best, on how many problems.
///
///   f_m(tau) = the part of all problems that method m solves within tau times the cost of whoever is cheapest there
///
/// f_m(1): where m is the cheapest. f_m(infinity): what it solves at all. E. Dolan, J. More, "Benchmarking optimization
/// software with performance profiles", 2002. A problem that nobody solves counts against all. 0 where there are no problems.
double part_within(const Costs& costs, std::size_t method, double tau);

}  // namespace pushback::frozen
