/// The layout of a figure, with axes, ticks, and the names of the curves, in pixels from the top left corner.
#pragma once

#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "pushback/common/experiment/plot.h"

namespace pushback {

struct Axis {
  Real from = 0, to = 1;
  bool log = false;
  std::vector<std::pair<Real, std::string>> ticks = {};

  Real part(Real value) const;  ///< fraction of the axis: 0 at `from`, 1 at `to`, less or more beyond them
  Real at(Real part) const;
};

/// The name of a curve, to the right of the diagram.
struct PlacedName {
  std::size_t curve;
  std::vector<std::string> lines;
  Real wanted;      ///< y of the curve's end
  Real end_x;       ///< x of the curve's end; not_drawn: it has no points
  Real middle = 0;  ///< y of the name
  Real height = 0;
};

/// A reference line within the axes.
struct PlacedLine {
  std::string label;
  Real y;
  bool at_left;  ///< whether the label is at the left end, where fewer curves are in its way
};

struct PanelLayout {
  Axis x = {}, y = {};
  int left = 0, top = 0, right = 0, bottom = 0;  ///< of the rectangle that the axes span
  int edge = 0;                                  ///< x at which the title and the label of y begin
  std::vector<std::string> title = {};
  std::vector<PlacedLine> lines = {};
  std::vector<PlacedName> names = {};  ///< from top to bottom
};

struct FigureLayout {
  int width = 0, height = 0;
  std::vector<PanelLayout> panels = {};
};

/// For at most four panels. The panels still contain values below the floor and values that a logarithmic axis cannot show: see `drawn`.
FigureLayout lay_out(const std::vector<Panel>& panels);

/// The value as it is drawn, which is the floor for lower values, and not_drawn if a logarithmic axis cannot show it.
Real drawn(const Panel& panel, Real y);

/// The ascending middles nearest to `wanted` (ascending, too) at which items of these heights do not overlap, between `low` and `high`.
/// They minimise the sum of squared displacements. If there is no room for all, the items follow each other from `low` on.
std::vector<Real> spread(const std::vector<Real>& wanted, const std::vector<Real>& heights, Real low, Real high);

/// The places of markers on a path (x, y) in pixels: about ten, evenly spaced along x if x ascends, else along the path. The markers
/// of the `index`th of `count` curves lie between the markers of the others.
std::vector<std::pair<Real, Real>> marker_places(const std::vector<std::pair<Real, Real>>& path, Real width,
                                                 std::size_t index, std::size_t count);

/// Divides panels among figures, with at most four per figure, and consecutive ones with the same title together.
std::vector<std::vector<Panel>> in_figures(const std::vector<Panel>& panels);

inline constexpr Real not_drawn = std::numeric_limits<Real>::quiet_NaN();
inline constexpr float plot_text = 24.8F;  ///< the size in canvas.h that equals 16 points in gnuplot
inline constexpr int plot_line_height = 30;

}  // namespace pushback
