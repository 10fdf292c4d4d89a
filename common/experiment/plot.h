/// Diagrams, drawn by gnuplot.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "pushback/common/basics/types.h"

namespace pushback {

/// The colours of curves and variants, in order: Okabe and Ito's, which the colour-blind can tell apart.
/// "#rrggbb"; starts again after the last.
std::string line_colour(std::size_t index);

struct Curve {
  enum class Style { line, dashed, points, line_and_points };

  std::string label;  ///< UTF-8; empty: not in the key
  std::vector<Real> x, y;
  std::string colour;  ///< "#rrggbb"
  Style style = Style::line;
};

/// One diagram; several stand side by side in one picture.
struct Panel {
  std::string title, x_label, y_label;  ///< labels with their units
  bool log_x = false, log_y = false;
  std::vector<Curve> curves = {};
  std::string key = "outside right top";  ///< where the key stands: gnuplot's words
  std::string extra = "";                 ///< further gnuplot commands for this panel: ranges, labels
};

/// Throws InvalidInput where `file` cannot be written, std::runtime_error where gnuplot is missing or refuses.
void write_plot(const std::filesystem::path& file, const std::vector<Panel>& panels);

}  // namespace pushback
