#include "pushback/common/experiment/plot_layout.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>
#include <set>

#include "pushback/common/render/canvas.h"

namespace pushback {

namespace {

constexpr int panel_width = 800, single_width = 1100, plot_height = 400;
constexpr int below_axis = 82, beside_names = 54, least_margin = 28;

// ---- axes ------------------------------------------------------------------------------------------------------------

Real length(const Axis& axis, Real value) {
  return axis.log ? std::log10(value) : value;
}

/// The least of 1, 2 or 5 times a power of ten that gives at most `most` ticks within `span`.
Real nice_step(Real span, int most) {
  Real step = std::pow(Real(10), std::floor(std::log10(span)) - 2);
  for (int i = 0; std::floor(span / step) + 1 > static_cast<Real>(most); ++i) step *= i % 3 == 1 ? Real(2.5) : Real(2);
  return step;
}

std::string power_of_ten(int exponent) {
  return fmt::format("10^{{{}}}", exponent);
}

void linear_ticks(Axis& axis, int most) {
  const Real low = std::min(axis.from, axis.to), high = std::max(axis.from, axis.to);
  const Real step = nice_step(high - low, most), slack = step / 1000;
  for (Real k = std::ceil((low - slack) / step); k * step <= high + slack; ++k)
    axis.ticks.emplace_back(k * step, fmt::format("{:.10g}", k == 0 ? Real(0) : k * step));
}

void log_ticks(Axis& axis, int most) {
  const Real slack = Real(1e-6);
  const int first = static_cast<int>(std::ceil(std::log10(axis.from) - slack));
  const int last = static_cast<int>(std::floor(std::log10(axis.to) + slack));
  const bool plain = first >= -3 && last <= 4;
  const int stride = std::max(1, (last - first + most) / most);
  for (int e = first; e <= last; ++e) {
    if (e % stride != 0) continue;
    const Real value = std::pow(Real(10), static_cast<Real>(e));
    axis.ticks.emplace_back(value, plain ? fmt::format("{:g}", value) : power_of_ten(e));
  }
  if (last - first >= 2) return;
  axis.ticks.clear();
  const bool wide = axis.to / axis.from > 100;  // where 2 and 5 as well would have no room
  const std::vector<Real> mantissas = wide ? std::vector<Real>{1, 3} : std::vector<Real>{1, 2, 5};
  for (int e = first - 1; e <= last; ++e) {
    for (const Real mantissa : mantissas) {
      const Real value = mantissa * std::pow(Real(10), static_cast<Real>(e));
      if (value >= axis.from * (1 - slack) && value <= axis.to * (1 + slack))
        axis.ticks.emplace_back(value, fmt::format("{:g}", value));
    }
  }
  if (axis.ticks.size() >= 2) return;
  axis.ticks.clear();
  linear_ticks(axis, most);
}

/// An axis for the range `given` or else for all finite values, with the fraction `room` of their range as a margin at both ends.
Axis axis_of(const std::vector<Real>& values, const Range& given, bool log, Real room, int most_ticks) {
  Axis axis{.log = log};
  if (given.from != given.to) {
    axis.from = given.from;
    axis.to = given.to;
  } else {
    Real low = std::numeric_limits<Real>::infinity(), high = -low;
    for (const Real value : values) {
      if (!std::isfinite(value)) continue;
      low = std::min(low, value);
      high = std::max(high, value);
    }
    if (low > high) low = high = 1;
    if (log) {
      const Real factor = std::max(std::pow(high / low, room), high / low < 2 ? Real(1.5) : Real(1));
      axis.from = low / factor;
      axis.to = high * factor;
    } else {
      // A span of rounding noise is widened.
      const Real least = std::max(Real(1e-6) * std::max(std::abs(low), std::abs(high)), Real(1e-12));
      const Real more = high - low < least ? least : room * (high - low);
      axis.from = low - more;
      axis.to = high + more;
    }
  }
  if (log) log_ticks(axis, most_ticks);
  else linear_ticks(axis, most_ticks);
  return axis;
}

void ticks_at(Axis& axis, const std::vector<Real>& values) {
  axis.ticks.clear();
  for (const Real value : std::set<Real>(values.begin(), values.end()))
    axis.ticks.emplace_back(value, fmt::format("{:g}", value));
}

/// Ends the axis at the floor, with a tick that says that values there may be lower.
void end_at_floor(Axis& axis, Real floor, bool something_below) {
  if (!something_below) return;
  axis.from = floor;
  std::erase_if(axis.ticks, [&](const auto& tick) { return axis.part(tick.first) < Real(0.08); });
  const int exponent = static_cast<int>(std::lround(std::log10(floor)));
  const bool power = std::abs(std::log10(floor) - exponent) < 1e-6;
  axis.ticks.emplace(axis.ticks.begin(), floor, "< " + (power ? power_of_ten(exponent) : fmt::format("{:g}", floor)));
}

int width_of_ticks(const Axis& axis) {
  int widest = 0;
  for (const auto& [value, label] : axis.ticks) {
    std::string shown = label;
    std::erase_if(shown, [](char c) { return c == '^' || c == '{' || c == '}'; });
    widest = std::max(widest, text_width(shown, plot_text));
  }
  return widest;
}

// ---- one panel -------------------------------------------------------------------------------------------------------

/// The last of the rightmost points; none if the curve has no point.
std::optional<std::size_t> right_end(const Panel& panel, const Curve& curve) {
  std::optional<std::size_t> end;
  for (std::size_t i = 0; i < curve.x.size(); ++i) {
    if (!std::isfinite(curve.x[i]) || !std::isfinite(drawn(panel, curve.y[i]))) continue;
    if (panel.log_x && curve.x[i] <= 0) continue;
    if (!end || curve.x[i] >= curve.x[*end]) end = i;
  }
  return end;
}

/// The sizes that do not depend on the panel's position. `left` and `right` are relative to the panel's corner.
PanelLayout widths(const Panel& panel, int width) {
  PanelLayout layout{.edge = least_margin};
  std::vector<Real> xs, ys;
  bool below = false, dots = false;
  for (const Curve& curve : panel.curves) {
    dots = dots || curve.style == Curve::Style::points || curve.style == Curve::Style::line_and_points;
    for (std::size_t i = 0; i < curve.x.size(); ++i) {
      if (!panel.log_x || curve.x[i] > 0) xs.push_back(curve.x[i]);
      ys.push_back(drawn(panel, curve.y[i]));
      below = below || (panel.log_y && panel.floor > 0 && curve.y[i] < panel.floor);
    }
  }
  layout.y = axis_of(ys, panel.y_range, panel.log_y, Real(0.04), 6);
  end_at_floor(layout.y, panel.floor, below);
  layout.title = wrapped(panel.title, plot_text, width - 2 * least_margin, true);
  layout.left = least_margin + width_of_ticks(layout.y);
  int names = 0;
  for (std::size_t c = 0; c < panel.curves.size(); ++c) {
    const Curve& curve = panel.curves[c];
    if (curve.label.empty()) continue;
    PlacedName name{
        .curve = c, .lines = wrapped(curve.label, plot_text, width * 3 / 10), .wanted = not_drawn, .end_x = not_drawn};
    for (const std::string& line : name.lines) names = std::max(names, text_width(line, plot_text));
    name.height = static_cast<Real>(plot_line_height * static_cast<int>(name.lines.size()));
    layout.names.push_back(std::move(name));
  }
  layout.right = width - (layout.names.empty() ? least_margin : beside_names + names + least_margin / 2);
  if (!panel.log_x && !xs.empty()) {  // an axis of data that begin at the first step begins at 0
    const auto [first, last] = std::minmax_element(xs.begin(), xs.end());
    if (*first > 0 && *first < *last / 20) xs.push_back(0);
  }
  layout.x = axis_of(xs, panel.x_range, panel.log_x, dots ? Real(0.02) : Real(0), (layout.right - layout.left) / 90);
  if (panel.ticks_at_points) ticks_at(layout.x, xs);
  return layout;
}

int title_height(const PanelLayout& layout) {
  return 22 + plot_line_height * static_cast<int>(layout.title.size() + 1);
}

int names_height(const PanelLayout& layout) {
  return static_cast<int>(std::accumulate(layout.names.begin(), layout.names.end(), Real(0),
                                          [](Real sum, const PlacedName& name) { return sum + name.height; }));
}

/// Shrinks the rectangle until a unit has the same length in both directions.
void equalise_units(PanelLayout& layout) {
  const Real across = static_cast<Real>(layout.right - layout.left) / std::abs(layout.x.to - layout.x.from);
  const Real down = static_cast<Real>(layout.bottom - layout.top) / std::abs(layout.y.to - layout.y.from);
  const Real scale = std::min(across, down);
  layout.right = layout.left + static_cast<int>(std::lround(scale * std::abs(layout.x.to - layout.x.from)));
  layout.bottom = layout.top + static_cast<int>(std::lround(scale * std::abs(layout.y.to - layout.y.from)));
}

/// The number of sampled points of the curves that lie in the rectangle. Its sides are fractions of the axes.
int in_the_way(const Panel& panel, const PanelLayout& layout, Real left, Real right, Real low, Real high) {
  int count = 0;
  for (const Curve& curve : panel.curves) {
    for (std::size_t i = 1; i < curve.x.size(); ++i) {
      const Real x0 = layout.x.part(curve.x[i - 1]), y0 = layout.y.part(drawn(panel, curve.y[i - 1]));
      const Real x1 = layout.x.part(curve.x[i]), y1 = layout.y.part(drawn(panel, curve.y[i]));
      if (!std::isfinite(x0 + y0 + x1 + y1)) continue;
      const int samples = std::min(100, 1 + static_cast<int>(60 * (std::abs(x1 - x0) + std::abs(y1 - y0))));
      for (int k = 0; k < samples; ++k) {
        const Real part = static_cast<Real>(k) / static_cast<Real>(samples);
        const Real x = x0 + part * (x1 - x0), y = y0 + part * (y1 - y0);
        count += x >= left && x <= right && y >= low && y <= high ? 1 : 0;
      }
    }
  }
  return count;
}

void place_lines(const Panel& panel, PanelLayout& layout) {
  const auto height = static_cast<Real>(layout.bottom - layout.top);
  for (const ReferenceLine& line : panel.lines) {
    const Real up = layout.y.part(line.value);
    if (!(up >= 0 && up <= 1)) continue;
    const Real part =
        static_cast<Real>(text_width(line.label, plot_text) + 16) / static_cast<Real>(layout.right - layout.left);
    const Real high = up + plot_line_height / height;
    const bool at_left =
        in_the_way(panel, layout, 0, part, up, high) <= in_the_way(panel, layout, 1 - part, 1, up, high);
    layout.lines.push_back({line.label, static_cast<Real>(layout.bottom) - up * height, at_left});
  }
}

void place_names(const Panel& panel, PanelLayout& layout) {
  const auto height = static_cast<Real>(layout.bottom - layout.top);
  const auto foot = static_cast<Real>(layout.bottom);
  for (PlacedName& name : layout.names) {
    const Curve& curve = panel.curves[name.curve];
    const std::optional<std::size_t> end = right_end(panel, curve);
    name.wanted = foot;
    if (!end) continue;
    const Real up = std::clamp(layout.y.part(drawn(panel, curve.y[*end])), Real(0), Real(1));
    const Real along = std::clamp(layout.x.part(curve.x[*end]), Real(0), Real(1));
    name.wanted = foot - up * height;
    name.end_x = static_cast<Real>(layout.left) + along * static_cast<Real>(layout.right - layout.left);
  }
  std::stable_sort(layout.names.begin(), layout.names.end(),
                   [](const PlacedName& a, const PlacedName& b) { return a.wanted < b.wanted; });
  std::vector<Real> wanted, heights;
  for (const PlacedName& name : layout.names) {
    wanted.push_back(name.wanted);
    heights.push_back(name.height);
  }
  const std::vector<Real> middles =
      spread(wanted, heights, static_cast<Real>(layout.top) - static_cast<Real>(plot_line_height) / 2,
             foot + static_cast<Real>(plot_line_height) / 2);
  for (std::size_t i = 0; i < middles.size(); ++i) layout.names[i].middle = middles[i];
}

}  // namespace

Real Axis::part(Real value) const {
  return (length(*this, value) - length(*this, from)) / (length(*this, to) - length(*this, from));
}

Real Axis::at(Real part) const {
  const Real value = length(*this, from) + part * (length(*this, to) - length(*this, from));
  return log ? std::pow(Real(10), value) : value;
}

Real drawn(const Panel& panel, Real y) {
  if (!panel.log_y) return y;
  if (panel.floor > 0 && y < panel.floor) return panel.floor;
  return y > 0 ? y : not_drawn;
}

std::vector<Real> spread(const std::vector<Real>& wanted, const std::vector<Real>& heights, Real low, Real high) {
  // If the heights above each item are subtracted, the tops only have to ascend. Items that do not are moved to their common mean.
  struct Block {
    Real sum;
    std::size_t count;
    Real mean() const { return sum / static_cast<Real>(count); }
  };
  std::vector<Block> blocks;
  Real above = 0;
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    blocks.push_back({wanted[i] - heights[i] / 2 - above, 1});
    while (blocks.size() > 1 && blocks[blocks.size() - 2].mean() > blocks.back().mean()) {
      const Block last = blocks.back();
      blocks.pop_back();
      blocks.back().sum += last.sum;
      blocks.back().count += last.count;
    }
    above += heights[i];
  }
  std::vector<Real> middles;
  Real before = 0;
  for (const Block& block : blocks) {
    const Real top = std::max(low, std::min(block.mean(), high - above));
    for (std::size_t k = 0; k < block.count; ++k) {
      const Real height = heights[middles.size()];
      middles.push_back(top + before + height / 2);
      before += height;
    }
  }
  return middles;
}

std::vector<std::pair<Real, Real>> marker_places(const std::vector<std::pair<Real, Real>>& path, Real width,
                                                 std::size_t index, std::size_t count) {
  std::vector<std::pair<Real, Real>> places;
  const bool ascends = std::is_sorted(path.begin(), path.end(), [](auto a, auto b) { return a.first < b.first; });
  const Real every = width / 10;
  Real next = every * (static_cast<Real>(index) + Real(0.5)) / static_cast<Real>(count), way = 0;
  for (std::size_t i = 1; i < path.size(); ++i) {
    const auto [x0, y0] = path[i - 1];
    const auto [x1, y1] = path[i];
    const Real step = ascends ? x1 - x0 : std::hypot(x1 - x0, y1 - y0);
    for (; next < way + step; next += every) {
      const Real part = (next - way) / step;
      places.emplace_back(x0 + part * (x1 - x0), y0 + part * (y1 - y0));
    }
    way += step;
  }
  return places;
}

FigureLayout lay_out(const std::vector<Panel>& panels) {
  const std::size_t columns = std::min<std::size_t>(panels.size(), 2);
  const int width = columns == 1 ? single_width : panel_width;
  FigureLayout figure{.width = width * static_cast<int>(columns)};
  for (const Panel& panel : panels) figure.panels.push_back(widths(panel, width));
  for (std::size_t first = 0; first < panels.size(); first += columns) {
    const std::size_t end = std::min(first + columns, panels.size());
    int titles = 0, inner = plot_height;
    for (std::size_t i = first; i < end; ++i) {
      titles = std::max(titles, title_height(figure.panels[i]));
      inner = std::max(inner, names_height(figure.panels[i]));
    }
    for (std::size_t i = first; i < end; ++i) {
      PanelLayout& layout = figure.panels[i];
      const int shift = width * static_cast<int>(i - first);
      layout.edge += shift;
      layout.left += shift;
      layout.right += shift;
      layout.top = figure.height + titles;
      layout.bottom = layout.top + inner;
      if (panels[i].equal_units) equalise_units(layout);
      place_lines(panels[i], layout);
      place_names(panels[i], layout);
    }
    figure.height += titles + inner + below_axis;
  }
  return figure;
}

}  // namespace pushback
