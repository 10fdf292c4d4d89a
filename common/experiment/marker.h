/// A variant's colour and the shape that goes with it: on the sheet, at its curve and in the tables.
#pragma once

#include <array>
#include <cstddef>
#include <string>

namespace pushback {

/// Seven of Okabe and Ito, and a violet: the colour-blind can tell them apart.
inline constexpr std::array line_colours{"#0072b2", "#d55e00", "#009e73", "#cc79a7",
                                         "#e69f00", "#56b4e9", "#444444", "#8a2be2"};

/// "#rrggbb"; starts again after the last.
inline std::string line_colour(std::size_t index) {
  return line_colours[index % line_colours.size()];
}

/// By the index of line_colour; starts again after the last, at another index than the colours do.
inline std::string marker_of(std::size_t index) {
  static constexpr std::array markers{"●", "■", "▲", "◆", "▼", "★", "✚"};
  return markers[index % markers.size()];
}

}  // namespace pushback
