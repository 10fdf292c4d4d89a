/// The growth of a cost with size.
#pragma once

#include <cmath>
#include <utility>
#include <vector>

namespace pushback {

/// The exponent a in cost = c size^a, by least squares on the logarithms. `of`: sizes and costs, all above 0, with at least two
/// different sizes.
inline double growth_exponent(const std::vector<std::pair<double, double>>& of) {
  double x = 0, y = 0, xx = 0, xy = 0;
  for (const auto& [size, cost] : of) {
    x += std::log(size);
    y += std::log(cost);
    xx += std::log(size) * std::log(size);
    xy += std::log(size) * std::log(cost);
  }
  const double n = static_cast<double>(of.size());
  return (n * xy - x * y) / (n * xx - x * x);
}

}  // namespace pushback
