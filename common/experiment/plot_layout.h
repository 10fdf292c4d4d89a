/// What stands where in a figure: axes and their ticks, and the names of the curves. In pixels from the top left corner.
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

  Real part(Real value) const;  ///< 0 at `from`, 1 at `to`, and on beyond them
  Real at(Real part) const;
};

/// The name of a curve, beside the diagram.
struct PlacedName {
  std::size_t curve;
  std::vector<std::string> lines;
  Real wanted;      ///< where the curve ends
  Real end_x;       ///< and how far to the right; not_drawn: it has no points
  Real middle = 0;  ///< where the name stands
  Real height = 0;
};

/// A line to compare with, that lies within the axes.
struct PlacedLine {
  std::string label;
  Real y;
  bool at_left;  ///< the label stands at the end where fewer curves are in its way
};

struct PanelLayout {
  Axis x = {}, y = {};
  int left = 0, top = 0, right = 0, bottom = 0;  ///< of the rectangle that the axes span
  int edge = 0;                                  ///< of what is written: title and label of y begin here
  std::vector<std::string> title = {};
  std::vector<PlacedLine> lines = {};
  std::vector<PlacedName> names = {};  ///< from the top down
};

struct FigureLayout {
  int width = 0, height = 0;
  std::vector<PanelLayout> panels = {};
};

/// For at most four panels. What is floored or has no place on a logarithmic axis is still in the panels: see `drawn`.
FigureLayout lay_out(const std::vector<Panel>& panels);

/// The value as it is drawn: at the floor if it is below; not_drawn where a logarithmic axis has no place for it.
Real drawn(const Panel& panel, Real y);

/// The middles nearest to `wanted`, ascending, at which things so high do not overlap, between `low` and `high`; in sequence
/// from `low` where there is no room for all. The sum of the squares of the ways is the least.
std::vector<Real> spread(const std::vector<Real>& wanted, const std::vector<Real>& heights, Real low, Real high);

/// At which points of the pixels' path (x, y) a shape stands: about ten, evenly along x where x ascends, else along the path;
/// those of the `index`th of `count` curves lie between those of the others.
std::vector<std::pair<Real, Real>> marker_places(const std::vector<std::pair<Real, Real>>& path, Real width,
                                                 std::size_t index, std::size_t count);

/// A panel's place among others: at most four a figure, those of one title together.
std::vector<std::vector<Panel>> in_figures(const std::vector<Panel>& panels);

inline constexpr Real not_drawn = std::numeric_limits<Real>::quiet_NaN();
inline constexpr float plot_text = 24.8F;  ///< canvas.h's size of what gnuplot calls 16 points
inline constexpr int plot_line_height = 30;

}  // namespace pushback
