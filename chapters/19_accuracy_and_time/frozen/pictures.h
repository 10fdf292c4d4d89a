/// The diagrams of frozen problems, drawn from frozen.csv alone: again at any time, without solving anything.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "pushback/common/experiment/plot.h"

namespace pushback::frozen {

/// The first line of frozen.csv: what the others have, one a point.
inline constexpr const char* csv_heading =
    "problem,contacts,method,sweeps,row_solves,systems,residual,median_s,lower_quartile_s,upper_quartile_s";

struct FrozenPoint {
  int sweeps = 0, systems = 0;
  std::optional<double> row_solves = {};
  double residual = 0, seconds = 0;  ///< seconds: the median
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

/// Residual against time and against row solves, of the six problems that tell most.
std::vector<Panel> trace_panels(const FrozenPoints& all);
/// Performance profiles: three of time, one of row solves.
std::vector<Panel> profile_panels(const FrozenPoints& all);

}  // namespace pushback::frozen
