/// Numbers that a reader may set, as data: what --help says, what is refused, and what a page with sliders reads are one list.
#pragma once

#include <string>
#include <variant>
#include <vector>

#include "pushback/common/basics/types.h"

namespace pushback {

struct Parameter {
  std::string flag;    ///< "--slop"
  std::string symbol;  ///< of the formulas: "β"; empty: it has none
  std::string unit;    ///< "m"; empty: it has none
  std::string what;    ///< what it changes
  double least, most;  ///< the ends of a slider; both are allowed
};

/// The variable that a parameter sets; it holds the default until the command line has been read. A list is separated by commas.
using ParameterVariable = std::variant<Real*, int*, std::vector<Real>*, std::vector<int>*>;

/// A parameter of an experiment, and its default.
struct ParameterWithDefault {
  Parameter parameter;
  std::vector<double> defaults;  ///< one; or those that are put side by side
  bool whole = false;            ///< whole numbers only
  ParameterVariable variable = {};
};

/// A JSON array, an object a parameter: flag, symbol, unit, what, default (an array), least, most, whole.
std::string in_json(const std::vector<ParameterWithDefault>& parameters);

/// A number of things in a title: "five", "twenty-one", "a hundred", "a thousand"; digits where it is another one.
std::string spelled(double number);

}  // namespace pushback
