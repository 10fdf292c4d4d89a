/// The numbers that a reader may set, as data. --help, the range checks and the sliders of a page use the same list.
#pragma once

#include <string>
#include <variant>
#include <vector>

#include "pushback/common/basics/types.h"

namespace pushback {

struct Parameter {
  std::string flag;    ///< "--slop"
  std::string symbol;  ///< in formulas: "β"; empty: none
  std::string unit;    ///< "m"; empty: none
  std::string what;    ///< description, for --help
  double least, most;  ///< the ends of its range, both allowed
};

/// The variable that a parameter sets. It contains the default until the command line has been read. Commas separate a list's values.
using ParameterVariable = std::variant<Real*, int*, std::vector<Real>*, std::vector<int>*>;

/// A parameter of an experiment, and its default.
struct ParameterWithDefault {
  Parameter parameter;
  std::vector<double> defaults;  ///< one value, or a list of values to compare
  bool whole = false;            ///< whole numbers only
  ParameterVariable variable = {};
};

/// A JSON array with an object per parameter: flag, symbol, unit, what, default (an array), least, most, whole.
std::string in_json(const std::vector<ParameterWithDefault>& parameters);

/// A count in words, for a title: 0 to 99 ("five", "twenty-one"), "a hundred", "a thousand". Digits for any other number.
std::string spelled(double number);

}  // namespace pushback
