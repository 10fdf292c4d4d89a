// Diagrams: what stands where in them, which files they go into, and that their curves can be told apart.
#include "pushback/common/experiment/plot.h"

#include <array>
#include <cmath>

#include "pushback/common/basics/files.h"
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

int pixels_of(const Image& image, const std::string& colour, int left, int top, int right, int bottom) {
  const unsigned long rgb = std::stoul(colour.substr(1), nullptr, 16);
  int count = 0;
  for (int y = std::max(0, top); y < std::min(image.height, bottom); ++y) {
    for (int x = std::max(0, left); x < std::min(image.width, right); ++x) {
      const std::uint8_t* at = image.at(x, y);
      count += at[0] == (rgb >> 16 & 255) && at[1] == (rgb >> 8 & 255) && at[2] == (rgb & 255) ? 1 : 0;
    }
  }
  return count;
}

}  // namespace

TEST_CASE("things that are spread do not overlap, keep their order, and move no more than they must") {
  Random random(1);
  for (int trial = 0; trial < 500; ++trial) {
    std::vector<Real> wanted, heights;
    const std::size_t count = 1 + random.below(9);
    for (std::size_t i = 0; i < count; ++i) {
      wanted.push_back(random.below(3) == 0 ? 200 : random.between(0, 400));
      heights.push_back(random.between(10, 44));
    }
    std::sort(wanted.begin(), wanted.end());
    const std::vector<Real> middles = spread(wanted, heights, 0, 400);
    REQUIRE(middles.size() == count);
    CHECK(middles.front() - heights.front() / 2 >= Real(-1e-9));
    CHECK(middles.back() + heights.back() / 2 <= Real(400 + 1e-9));
    // Those that touch each other stand around the mean of where they want to be, unless an end is in their way.
    for (std::size_t first = 0, end = 0; first < count; first = end) {
      Real sum = 0;
      do sum += middles[end] - wanted[end], ++end;
      while (end < count && middles[end] - middles[end - 1] < (heights[end] + heights[end - 1]) / 2 + Real(1e-9));
      const bool at_low = middles[first] - heights[first] / 2 < Real(1e-9);
      const bool at_high = middles[end - 1] + heights[end - 1] / 2 > Real(400 - 1e-9);
      if (!at_low) CHECK(sum <= Real(1e-6));
      if (!at_high) CHECK(sum >= Real(-1e-6));
      if (end < count) CHECK(middles[end] - heights[end] / 2 >= middles[end - 1] + heights[end - 1] / 2);
    }
  }
  CHECK(spread({100, 100}, {30, 30}, 0, 400) == std::vector<Real>{85, 115});
  CHECK(spread({0, 390}, {30, 30}, 0, 400) == std::vector<Real>{15, 385});
  CHECK(spread({50, 60}, {30, 30}, 0, 40) == std::vector<Real>{15, 45});  // no room: one after the other
}

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

TEST_CASE("a name stands where its curve ends, and in sequence below each other where several end there") {
  const FigureLayout figure =
      lay_out({{.title = "",
                .x_label = "",
                .y_label = "",
                .curves = {straight("low", 1, 0), straight("high", 0, 1), straight("also", 1, 0)}}});
  const PanelLayout& layout = figure.panels[0];
  REQUIRE(layout.names.size() == 3);
  CHECK(layout.names[0].curve == 1);
  CHECK(layout.names[0].middle == layout.names[0].wanted);
  CHECK(layout.names[1].curve == 0);
  CHECK(layout.names[2].curve == 2);
  CHECK(layout.names[2].middle - layout.names[1].middle == layout.names[1].height);
  const Real up =
      (static_cast<Real>(layout.bottom) - layout.names[0].wanted) / static_cast<Real>(layout.bottom - layout.top);
  CHECK(std::abs(up - layout.y.part(1)) < 1e-9);
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

TEST_CASE("axes are tight, rounding noise is no span, and lines to compare with do not widen them") {
  Panel panel{.title = "", .x_label = "", .y_label = "", .curves = {straight("a", 2, 3)}};
  panel.lines = {{Real(2.5), "middle"}, {10, "far"}};
  const PanelLayout layout = lay_out({panel}).panels[0];
  CHECK(layout.y.from == Approx(1.96));
  CHECK(layout.y.to == Approx(3.04));
  REQUIRE(layout.lines.size() == 1);
  CHECK(layout.lines[0].label == "middle");
  panel.curves = {straight("a", 5, 5 + Real(1e-15))};
  const Axis flat = lay_out({panel}).panels[0].y;
  CHECK(flat.to - flat.from > Real(1e-6));
  panel.y_range = {10, 0};
  CHECK(lay_out({panel}).panels[0].y.part(0) == 1);  // downwards
  panel.x_range = {0, 5};
  panel.equal_units = true;
  const PanelLayout equal = lay_out({panel}).panels[0];
  CHECK(equal.bottom - equal.top == Approx(2 * (equal.right - equal.left)).margin(2));
}

TEST_CASE("an axis can have its ticks where the points are") {
  Panel panel{.title = "", .x_label = "", .y_label = "", .log_x = true};
  panel.curves = {{"a", {16, 32, 64}, {3, 2, 1}, "#000000"}, {"b", {8, 16}, {3, 2}, "#000000"}};
  panel.ticks_at_points = true;
  const Axis x = lay_out({panel}).panels[0].x;
  CHECK(x.ticks == std::vector<std::pair<Real, std::string>>{{8, "8"}, {16, "16"}, {32, "32"}, {64, "64"}});
  for (const auto& [value, label] : x.ticks) CHECK((x.part(value) >= 0 && x.part(value) <= 1));
}

TEST_CASE("the label of a line to compare with stands where fewer curves are in its way") {
  Panel panel{.title = "", .x_label = "", .y_label = "", .curves = {straight("down", 1, 0)}};
  panel.lines = {{Real(0.9), "line"}};
  CHECK(!lay_out({panel}).panels[0].lines[0].at_left);
  panel.curves = {straight("up", 0, 1)};
  CHECK(lay_out({panel}).panels[0].lines[0].at_left);
}

TEST_CASE("about ten shapes stand along a line, on it, and those of others between them") {
  std::vector<std::pair<Real, Real>> path;
  for (int i = 0; i <= 300; ++i) path.emplace_back(i, std::sin(Real(0.02) * static_cast<Real>(i)));
  std::vector<Real> all;
  for (const std::size_t index : {std::size_t(0), std::size_t(1), std::size_t(2)}) {
    const auto places = marker_places(path, 300, index, 3);
    CHECK(places.size() == 10);
    for (const auto& [x, y] : places) {
      CHECK(y == Approx(std::sin(Real(0.02) * x)).margin(1e-3));
      all.push_back(x);
    }
  }
  std::sort(all.begin(), all.end());
  for (std::size_t i = 1; i < all.size(); ++i) CHECK(all[i] - all[i - 1] == Approx(10));
  // Where x goes back, along the path.
  const std::vector<std::pair<Real, Real>> around{{0, 0}, {100, 0}, {100, 100}, {0, 100}, {0, 0}};
  CHECK(marker_places(around, 100, 0, 1).size() == 40);
}

TEST_CASE("at most four panels a figure, in their order, and those of one title stay together") {
  const auto titles = [](const std::vector<std::string>& of) {
    std::vector<Panel> panels;
    for (const std::string& title : of) panels.push_back({.title = title, .x_label = "", .y_label = ""});
    std::vector<std::string> figures;
    for (const std::vector<Panel>& figure : in_figures(panels)) {
      CHECK(figure.size() <= panels_in_a_figure);
      figures.emplace_back();
      for (const Panel& panel : figure) figures.back() += panel.title;
    }
    return figures;
  };
  CHECK(titles({}).empty());
  CHECK(titles({"a", "b", "c", "d"}) == std::vector<std::string>{"abcd"});
  CHECK(titles({"a", "b", "c", "d", "e"}) == std::vector<std::string>{"abcd", "e"});
  CHECK(titles({"a", "b", "c", "d", "d", "e"}) == std::vector<std::string>{"abc", "dde"});
  CHECK(titles({"a", "a", "a", "a", "a", "b"}) == std::vector<std::string>{"aaaa", "ab"});
}

TEST_CASE(
    "figures are drawn into numbered files, each name in its curve's colour, and older ones of higher numbers go") {
  const Scratch scratch;
  std::vector<Panel> panels;
  for (std::size_t i = 0; i < 5; ++i) {
    panels.push_back({.title = std::string(1, static_cast<char>('a' + i)), .x_label = "x", .y_label = "y"});
    for (std::size_t c = 0; c < 3; ++c) panels.back().curves.push_back(straight("name", 0, static_cast<Real>(c), c));
  }
  const fs::path file = scratch / "plot.png";
  const auto both = write_plot(file, panels);
  REQUIRE(both == std::vector<fs::path>{file, scratch / "plot_2.png"});
  CHECK(read_png(file).width == 1600);
  const Image single = read_png(both[1]);
  const FigureLayout figure = lay_out({panels[4]});
  CHECK((single.width == figure.width && single.height == figure.height));
  const PanelLayout& layout = figure.panels[0];
  for (const PlacedName& name : layout.names) {
    const auto top = static_cast<int>(name.middle - name.height / 2),
               foot = static_cast<int>(name.middle + name.height / 2);
    for (const PlacedName& other : layout.names) {
      const int found =
          pixels_of(single, panels[4].curves[other.curve].colour, layout.right + 26, top, layout.right + 44, foot);
      CHECK((found > 20) == (name.curve == other.curve));  // the shape beside the name
    }
  }
  write_text_file(scratch / "plot_3.png", "old");
  write_text_file(scratch / "plot_x.png", "another's");
  panels.resize(2);
  CHECK(write_plot(file, panels) == std::vector<fs::path>{file});
  CHECK(!fs::exists(scratch / "plot_2.png"));
  CHECK(!fs::exists(scratch / "plot_3.png"));
  CHECK(fs::exists(scratch / "plot_x.png"));

  panels[0].extra = "this is no command";
  CHECK_THROWS(write_plot(scratch / "bad.png", panels));
  for (const auto& entry : fs::directory_iterator(scratch / "."))
    CHECK(!contains(entry.path().filename().string(), "bad"));  // nothing half-drawn
}

TEST_CASE("curves of one colour are told apart by their shapes") {
  const Scratch scratch;
  std::vector<std::string> drawn_as;
  for (std::size_t index = 0; index < 7; ++index) {
    Curve curve = straight("", 0, 1);
    curve.marker = marker_of(index);
    write_plot(scratch / "plot.png", {{.title = "", .x_label = "", .y_label = "", .curves = {curve}}});
    drawn_as.push_back(text_of(scratch / "plot.png"));
    for (std::size_t other = 0; other < index; ++other) CHECK(drawn_as[other] != drawn_as[index]);
    CHECK(missing_characters(marker_of(index)) == 0);
  }
  // Without a shape of its own, a curve has that of its colour.
  write_plot(scratch / "plot.png", {{.title = "", .x_label = "", .y_label = "", .curves = {straight("", 0, 1)}}});
  CHECK(text_of(scratch / "plot.png") == drawn_as[0]);
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
