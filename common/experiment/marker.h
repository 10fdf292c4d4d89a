/// The colour and the marker of a variant on the sheet, at its curve and in the tables.
#pragma once

#include <array>
#include <cstddef>
#include <string>

namespace pushback {

/// Six colours of Okabe and Ito, a dark grey and a violet, which the colour-blind can tell apart.
inline constexpr std::array line_colours{"#0072b2", "#d55e00", "#009e73", "#cc79a7",
                                         "#e69f00", "#56b4e9", "#444444", "#8a2be2"};

/// "#rrggbb"; wraps around after eight colours.
inline std::string line_colour(std::size_t index) {
  return line_colours[index % line_colours.size()];
}

/// For the same index as line_colour. Wraps around after seven markers.
inline std::string marker_of(std::size_t index) {
  static constexpr std::array markers{"●", "■", "▲", "◆", "▼", "★", "✚"};
  return markers[index % markers.size()];
}

}  // namespace pushback
