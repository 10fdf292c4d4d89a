/// Checks of input. All values from outside are checked here, once, before the simulation uses them.
#pragma once

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>
#include <string_view>

#include "pushback/common/basics/types.h"

namespace pushback {

/// A value that the simulation cannot use. The message names the value and the allowed values. If the exception reaches
/// `main`, the program ends with exit status 2.
class InvalidInput : public std::invalid_argument {
 public:
  using std::invalid_argument::invalid_argument;
};

inline void require_finite(std::string_view what, Real value) {
  if (!std::isfinite(value)) throw InvalidInput(fmt::format("{} is {}: a finite number is needed", what, value));
}

inline void require_finite(std::string_view what, const Vec3& value) {
  if (!value.allFinite()) {
    throw InvalidInput(
        fmt::format("{} is ({}, {}, {}): three finite numbers are needed", what, value.x(), value.y(), value.z()));
  }
}

inline void require_positive(std::string_view what, Real value) {
  if (!(value > 0) || !std::isfinite(value)) {
    throw InvalidInput(fmt::format("{} is {}: a finite number above 0 is needed", what, value));
  }
}

inline void require_not_negative(std::string_view what, Real value) {
  if (!(value >= 0) || !std::isfinite(value)) {
    throw InvalidInput(fmt::format("{} is {}: a finite number, 0 or more, is needed", what, value));
  }
}

inline void require_between(std::string_view what, Real value, Real low, Real high) {
  if (!(value >= low && value <= high)) {
    throw InvalidInput(fmt::format("{} is {}: a number from {} to {} is needed", what, value, low, high));
  }
}

}  // namespace pushback
