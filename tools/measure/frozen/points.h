/// frozen.csv: every point that was traced. Words (words.h) and pictures (pictures.h) are made of it alone, again at any time.
#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "pushback/tools/measure/frozen/profile.h"

namespace pushback::frozen {

inline constexpr std::array tolerances{1e-3, 1e-6, 1e-10};  ///< of relative_residual: what is asked for

/// The first line of frozen.csv: what the others have, one a point.
inline constexpr const char* csv_heading =
    "problem,contacts,method,sweeps,row_solves,systems,residual,median_s,lower_quartile_s,upper_quartile_s";

struct FrozenPoint {
  int sweeps = 0, systems = 0;
  std::optional<double> row_solves = {};  ///< not of Siconos, whose iterations are not over rows
  double residual = 0, seconds = 0;       ///< seconds: the median
  double lower_quartile = 0, upper_quartile = 0;
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

/// Throws InvalidInput where a line is not one of these.
FrozenPoints read_frozen_csv(const std::string& text);

/// Where the residual is that low for the first time; nullptr: nowhere.
inline const FrozenPoint* reaching(double tolerance, const std::vector<FrozenPoint>& points) {
  const auto found =
      std::find_if(points.begin(), points.end(), [&](const FrozenPoint& point) { return point.residual <= tolerance; });
  return found == points.end() ? nullptr : &*found;
}

/// What each method pays until its residual is that low, problem by problem.
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
/// Median s.
inline Costs times_to(double tolerance, const FrozenPoints& all) {
  return costs_to(tolerance, all, [](const FrozenPoint& point) { return point.seconds; });
}

}  // namespace pushback::frozen
