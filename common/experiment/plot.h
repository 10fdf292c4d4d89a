/// Draws diagrams with gnuplot. Each curve has its name at its right end, in its colour, and markers that distinguish it if colours do
/// not. plot_layout.h computes all positions, so that names never overlap.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "pushback/common/basics/types.h"
#include "pushback/common/experiment/marker.h"

namespace pushback {

struct Curve {
  enum class Style { line, dashed, points, line_and_points };

  std::string label;  ///< UTF-8; empty: no name. A curve without points has its name at the foot: "pgs: not reached"
  std::vector<Real> x, y;
  std::string colour;  ///< "#rrggbb"
  Style style = Style::line;
  std::string marker = "";  ///< from marker.h; empty: the colour's, or none for a colour not in line_colours
};

/// A value to compare with, drawn as a thin horizontal line: {1e-3, "1 mm"}.
struct ReferenceLine {
  Real value;
  std::string label;
};

/// The two ends of an axis, in either order. If they are equal, the data determine the range.
struct Range {
  Real from = 0, to = 0;
};

/// One diagram. A figure contains up to four.
struct Panel {
  std::string title, x_label, y_label;  ///< labels with their units
  bool log_x = false, log_y = false;
  std::vector<Curve> curves = {};
  std::vector<ReferenceLine> lines = {};  ///< drawn if they lie within the range of y
  Real floor = 0;  ///< of a logarithmic y: lower values are drawn here, where the axis ends with a tick "<"; 0: none
  Range x_range = {}, y_range = {};
  bool ticks_at_points = false;  ///< x ticks are at the points, for curves that share a few x
  bool equal_units = false;      ///< a unit has the same length on both axes, which are linear
  std::string extra = "";        ///< further gnuplot commands for this panel, except for ranges and margins
};

inline constexpr std::size_t panels_in_a_figure = 4;

/// Draws `file` and, for more than four panels, further files next to it: plot.png, plot_2.png, plot_3.png. Consecutive panels with
/// the same title stay together, unless there are more than four of them. Removes files with higher numbers, and returns the files
/// drawn. Throws InvalidInput if `file` cannot be written, std::runtime_error if gnuplot is missing or fails.
std::vector<std::filesystem::path> write_plot(const std::filesystem::path& file, const std::vector<Panel>& panels);

}  // namespace pushback
