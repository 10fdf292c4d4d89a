/// Numbers that a reader may set, as data: what --help says, what is refused, and what a page with sliders reads are one list.
#pragma once

#include <string>
#include <variant>
#include <vector>

#include "pushback/common/basics/types.h"

namespace pushback {

/// What a number may be: finite, and from `least` to `most`.
struct Allowed {
  double least, most;
  bool least_itself = true;

  bool holds(double value) const;
  std::string in_words() const;  ///< "a number from 0 to 1"
};
Allowed not_negative();
Allowed positive();
Allowed between(double least, double most);

struct Parameter {
  std::string flag;    ///< "--slop"
  std::string symbol;  ///< of the formulas: "β"; empty: it has none
  std::string unit;    ///< "m"; empty: it has none
  std::string what;    ///< what it changes
  Allowed allowed;
};

/// Where the value is, which is the default until the command line has been read. Several numbers are separated by commas.
using Value = std::variant<Real*, int*, std::vector<Real>*, std::vector<int>*>;

/// A parameter of an experiment, and its default.
struct NamedValue {
  Parameter parameter;
  std::vector<double> defaults;  ///< one; or those that are put side by side
  bool whole = false;            ///< whole numbers only
};

/// A JSON array, an object a parameter: flag, symbol, unit, what, default (an array), least, most (null: without end), whole.
std::string in_json(const std::vector<NamedValue>& parameters);

}  // namespace pushback
