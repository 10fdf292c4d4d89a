// Diagrams: what stands where in them, which files they go into, and that their curves can be told apart.
#include "pushback/common/experiment/plot.h"

#include <cmath>

#include "pushback/common/bodies/random.h"
#include "pushback/common/experiment/marker.h"
#include "pushback/common/experiment/plot_layout.h"
#include "pushback/common/render/canvas.h"
#include "tests/support/call.h"
#include "tests/support/colour_blind.h"

using namespace pushback;

namespace {

Curve straight(const std::string& label, Real from, Real to, std::size_t index = 0) {
  return {label, {0, 1}, {from, to}, line_colour(index)};
}

/// Curves that end anywhere, many of them at the same place; some have no end, some no points.
Panel random_panel(Random& random) {
  Panel panel{.title = random.below(2) == 0 ? "a stack"
                                            : "a title of many words that does not fit into one line, so it is broken",
              .x_label = "time, s",
              .y_label = "error, m",
              .log_x = random.below(2) == 0,
              .log_y = random.below(2) == 0};
  const std::size_t count = 1 + random.below(14);
  for (std::size_t c = 0; c < count; ++c) {
    Curve curve{random.below(3) == 0 ? "a name so long that it needs several lines" : "name", {}, {}, line_colour(c)};
    if (random.below(8) == 0) curve.label.clear();
    const std::size_t points = random.below(4) == 0 ? 0 : random.below(30);
    for (std::size_t i = 0; i < points; ++i) {
      curve.x.push_back(static_cast<Real>(i) + random.between(0, 1));
      const bool same_as_others = random.below(2) == 0;
      curve.y.push_back(random.below(9) == 0 ? std::numeric_limits<Real>::quiet_NaN()
                        : same_as_others     ? Real(0.5)
                                             : random.over_decades(Real(1e-14), 1000));
    }
    panel.curves.push_back(curve);
  }
  if (random.below(2) == 0) panel.floor = Real(1e-6);
  if (random.below(3) == 0) panel.equal_units = !panel.log_x && !panel.log_y;
  panel.lines = {{Real(1e-2), "1 cm"}, {Real(1e-3), "1 mm"}};
  return panel;
}

}  // namespace

TEST_CASE("names of curves never overlap, whatever the curves, and lie within the picture") {
  Random random(2);
  for (int trial = 0; trial < 200; ++trial) {
    std::vector<Panel> panels;
    for (std::size_t n = 1 + random.below(4); n > 0; --n) panels.push_back(random_panel(random));
    const FigureLayout figure = lay_out(panels);
    CHECK(figure.width <= 1600);
    REQUIRE(figure.panels.size() == panels.size());
    for (std::size_t p = 0; p < panels.size(); ++p) {
      const PanelLayout& layout = figure.panels[p];
      const int end = panels.size() == 1 ? figure.width : p % 2 == 0 ? figure.width / 2 : figure.width;
      CHECK(layout.left >= layout.edge);
      if (!panels[p].equal_units) CHECK(layout.right - layout.left >= 250);
      CHECK(layout.bottom > layout.top);
      CHECK(layout.bottom < figure.height);
      CHECK((layout.x.from < layout.x.to && layout.y.from < layout.y.to));
      CHECK(!layout.y.ticks.empty());
      for (const Axis* axis : {&layout.x, &layout.y}) {
        for (const auto& [value, label] : axis->ticks) {
          CHECK(axis->part(value) >= Real(-1e-3));
          CHECK(axis->part(value) <= Real(1 + 1e-3));
        }
      }
      for (const PlacedLine& line : layout.lines) CHECK((line.y >= layout.top && line.y <= layout.bottom));
      Real above = 0;
      std::size_t named = 0;
      for (const Curve& curve : panels[p].curves) named += curve.label.empty() ? 0 : 1;
      CHECK(layout.names.size() == named);
      for (const PlacedName& name : layout.names) {
        CHECK(name.middle - name.height / 2 >= above - Real(1e-6));
        above = name.middle + name.height / 2;
        for (const std::string& line : name.lines) CHECK(layout.right + 48 + text_width(line, plot_text) <= end);
        if (std::isfinite(name.end_x)) CHECK((name.end_x >= layout.left && name.end_x <= layout.right));
      }
      CHECK(above <= figure.height);
    }
  }
}

TEST_CASE("a floor ends a logarithmic axis, and says so, and without anything below it there is none") {
  Panel panel{.title = "", .x_label = "", .y_label = "", .log_y = true, .floor = Real(1e-6)};
  panel.curves = {straight("a", 1, Real(1e-2)), straight("b", 1, Real(1e-17)), straight("c", 1, 0)};
  const Axis floored = lay_out({panel}).panels[0].y;
  CHECK(floored.from == Real(1e-6));
  CHECK(floored.ticks.front() == std::pair<Real, std::string>(Real(1e-6), "< 10^{-6}"));
  CHECK(drawn(panel, Real(1e-17)) == Real(1e-6));
  CHECK(drawn(panel, 0) == Real(1e-6));
  CHECK(drawn(panel, Real(1e-2)) == Real(1e-2));
  panel.curves.resize(1);
  const Axis free = lay_out({panel}).panels[0].y;
  CHECK(free.from > Real(5e-3));
  for (const auto& [value, label] : free.ticks) CHECK(!contains(label, "<"));
  panel.floor = 0;
  CHECK(std::isnan(drawn(panel, 0)));
  panel.log_y = false;
  CHECK(drawn(panel, -3) == -3);
}

TEST_CASE("the colours of curves stay apart for the colour-blind") {
  for (const Mat3& eyes : ways_to_see()) {
    for (std::size_t a = 0; a < 8; ++a) {
      CHECK(apart(ink_of(line_colour(a)), {255, 255, 255}, eyes) > 30);
      for (std::size_t b = 0; b < a; ++b) {
        INFO(line_colour(a) << " " << line_colour(b));
        CHECK(apart(ink_of(line_colour(a)), ink_of(line_colour(b)), eyes) > 17);
      }
    }
  }
  CHECK(line_colour(8) == line_colour(0));
}
