/// Diagrams, drawn by gnuplot. Each curve's name stands at its right end, in its colour; a shape on the curve tells it from the
/// others where colours do not. What stands where is computed here (plot_layout.h), so that names never overlap.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "pushback/common/basics/types.h"
#include "pushback/common/experiment/marker.h"

namespace pushback {

struct Curve {
  enum class Style { line, dashed, points, line_and_points };

  std::string label;  ///< UTF-8; empty: no name. Without any points, the name stands at the foot: "pgs: not reached"
  std::vector<Real> x, y;
  std::string colour;  ///< "#rrggbb"
  Style style = Style::line;
  std::string marker = "";  ///< of marker.h; empty: the one of the colour, none if that is not line_colour's
};

/// A value to compare with, as a thin line across: {1e-3, "1 mm"}.
struct ReferenceLine {
  Real value;
  std::string label;
};

/// Where an axis begins and ends, to - from of either sign. Equal: as the data have it.
struct Range {
  Real from = 0, to = 0;
};

/// One diagram; up to four stand together in one figure.
struct Panel {
  std::string title, x_label, y_label;  ///< labels with their units
  bool log_x = false, log_y = false;
  std::vector<Curve> curves = {};
  std::vector<ReferenceLine> lines = {};  ///< drawn where they lie within the range of the data
  Real floor = 0;  ///< of a logarithmic y: what is less is drawn here, and the axis ends here and says so; 0: none
  Range x_range = {}, y_range = {};
  bool ticks_at_points = false;  ///< of x, where curves have a few points, all at the same few x
  bool equal_units = false;      ///< a unit of x is as long as one of y, on linear axes
  std::string extra = "";        ///< further gnuplot commands for this panel; not its ranges and margins
};

inline constexpr std::size_t panels_in_a_figure = 4;

/// Draws `file`, and, where there are more than four panels, further ones beside it: plot.png, plot_2.png, plot_3.png. Panels of
/// the same title that follow each other stay together, unless there are more than four of them. Returns the files, after
/// removing those of a higher number. Throws InvalidInput where `file` cannot be written, std::runtime_error where gnuplot
/// is missing or refuses.
std::vector<std::filesystem::path> write_plot(const std::filesystem::path& file, const std::vector<Panel>& panels);

}  // namespace pushback
