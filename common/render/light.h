/// Converts between the 8-bit sRGB of files and screens and linear light, in which averages and shading are correct.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

namespace pushback {

/// The linear light, from 0 to 1, of a level from 0 to 255.
inline float linear_of(std::uint8_t level) {
  static const std::array<float, 256> table = [] {
    std::array<float, 256> made{};
    for (std::size_t i = 0; i < made.size(); ++i) {
      const double x = static_cast<double>(i) / 255;
      made[i] = static_cast<float>(x <= 0.04045 ? x / 12.92 : std::pow((x + 0.055) / 1.055, 2.4));
    }
    return made;
  }();
  return table[level];
}

/// The level nearest to a linear light, which is clamped to 0 to 1.
inline std::uint8_t level_of(float light) {
  const float x = std::clamp(light, 0.0f, 1.0f);
  const float encoded = x <= 0.0031308f ? 12.92f * x : 1.055f * std::pow(x, 1 / 2.4f) - 0.055f;
  return static_cast<std::uint8_t>(255 * encoded + 0.5f);
}

}  // namespace pushback
