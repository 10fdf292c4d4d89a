/// A figure as text: lines, arrows, areas and labels in SVG, in one style.
#pragma once

#include <numbers>
#include <string>
#include <string_view>
#include <vector>

#include "pushback/common/basics/types.h"

namespace pushback::figures {

/// A place on a figure, pixels to the right and down; or a way on it.
using Place = Eigen::Vector2d;

/// Okabe and Ito's colours, which the colour-blind can tell apart, as in the plots; and greys.
namespace hue {
inline constexpr const char *blue = "#0072b2", *vermilion = "#d55e00", *green = "#009e73", *purple = "#a3488a",
                            *amber = "#e69f00", *yellow = "#ffe600";
inline constexpr const char *ink = "#1c202a", *grey = "#5b6270", *pale_grey = "#c3c9d2", *haze = "#eef1f4",
                            *white = "#ffffff", *none = "none";
inline constexpr const char *pale_blue = "#d3e6f3", *pale_vermilion = "#fbe2d2", *pale_green = "#d3efe6",
                            *pale_amber = "#fbecc8";
}  // namespace hue

struct Pen {
  const char* colour = hue::ink;
  double width = 2;
  bool dashed = false;
};

/// How a label is written. At the width of a page, 830 px, nothing is smaller than 14 px.
struct Lettering {
  enum class At { left, middle, right };
  At at = At::left;
  double size = 16;
  const char* colour = hue::ink;
  bool bold = false;
  bool halo = false;  ///< white around the letters, where they lie on lines
};
inline constexpr Lettering::At at_left = Lettering::At::left, at_middle = Lettering::At::middle,
                               at_right = Lettering::At::right;

class Svg {
 public:
  Svg(double width, double height, std::string_view title);

  void line(const Place& from, const Place& to, const Pen& pen = {});
  /// Its head ends at `to`.
  void arrow(const Place& from, const Place& to, const Pen& pen = {});
  void polyline(const std::vector<Place>& points, const Pen& pen = {});
  void polygon(const std::vector<Place>& points, const char* fill, const Pen& pen = {});
  void circle(const Place& centre, double radius, const char* fill, const Pen& pen = {});
  /// Part of a circle, from one angle to another, rad, counter-clockwise from the right; with a head at its end if wanted.
  void arc(const Place& centre, double radius, double from, double to, const Pen& pen = {}, bool head = false);
  /// A line whose two ends both have heads.
  void measure(const Place& from, const Place& to, const Pen& pen = {});
  /// One line. Between dollars stand formulas: letters are slanted there, `_` and `^` set what follows (one character,
  /// or a group in braces) below or above the line.
  void text(const Place& baseline, std::string_view words, const Lettering& lettering = {});
  /// What is drawn until `unclip` is seen inside this circle only.
  void clip(const Place& centre, double radius);
  void unclip();

  std::string str() const;

 private:
  double width_, height_;
  std::string body_;
  int clips_ = 0;
};

/// The way of this length, px, at this angle, rad, counter-clockwise from the right.
inline Place towards(double angle, double length = 1) {
  return length * Place(std::cos(angle), -std::sin(angle));
}
/// Where a diagram's values are on the figure.
struct Axes {
  Place origin;         ///< of the value (0, 0)
  double x = 1, y = 1;  ///< px for a value of 1, to the right and up
  Place operator()(double to_the_right, double up) const { return origin + Place(to_the_right * x, -up * y); }
};

}  // namespace pushback::figures
