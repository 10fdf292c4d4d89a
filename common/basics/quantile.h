/// Medians and quartiles, mostly of times.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "pushback/common/basics/input.h"

namespace pushback {

/// The value below which a fraction p (0 ... 1) of the values lies. It has the index p (n - 1) among the n ascending values,
/// interpolated linearly between neighbours. p = 0.5 is the median. Infinite values count too, and every point between a finite and
/// an infinite value is infinite. Throws InvalidInput for an empty list, a nan, a p outside 0 ... 1, and a point between -inf and
/// inf.
inline double quantile(std::vector<double> values, double p) {
  if (values.empty()) throw InvalidInput("a quantile of no values: one or more are needed");
  if (!(p >= 0 && p <= 1)) throw InvalidInput(fmt::format("p of a quantile is {}: 0 to 1 is needed", p));
  for (const double value : values)
    if (std::isnan(value)) throw InvalidInput("a quantile of values among which one is nan: numbers are needed");
  std::sort(values.begin(), values.end());
  const double at = p * static_cast<double>(values.size() - 1), floor = std::floor(at);
  const double below = values[static_cast<std::size_t>(floor)], above = values[static_cast<std::size_t>(std::ceil(at))];
  if (below == above) return below;  // inf - inf would be nan
  if (std::isinf(below) && std::isinf(above))
    throw InvalidInput(fmt::format("a quantile with p = {} between -inf and inf: no number lies there", p));
  if (std::isinf(below)) return below;  // -inf + inf would be nan
  return below + (at - floor) * (above - below);
}

inline double median(const std::vector<double>& values) {
  return quantile(values, 0.5);
}

}  // namespace pushback
