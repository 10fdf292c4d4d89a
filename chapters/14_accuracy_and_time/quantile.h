/// Medians and quartiles, of times mostly.
#pragma once

#include <algorithm>
#include <vector>

namespace pushback {

/// What the part `part` (0 ... 1) of the values lies below, between two of them by proportion; 0.5: the median. One or more.
inline double quantile(std::vector<double> values, double part) {
  std::sort(values.begin(), values.end());
  const double at = part * static_cast<double>(values.size() - 1);
  const auto below = static_cast<std::size_t>(at), above = std::min(below + 1, values.size() - 1);
  return values[below] + (at - static_cast<double>(below)) * (values[above] - values[below]);
}

}  // namespace pushback
