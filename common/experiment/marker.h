/// The shape that goes with a variant's colour: on the sheet, at its curve and in the tables.
#pragma once

#include <array>
#include <cstddef>
#include <string>

namespace pushback {

/// By the index of line_colour; starts again after the last, at another index than the colours do.
inline std::string marker_of(std::size_t index) {
  static constexpr std::array markers{"●", "■", "▲", "◆", "▼", "★", "✚"};
  return markers[index % markers.size()];
}

}  // namespace pushback
