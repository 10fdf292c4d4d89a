// Diagrams: where their axes end.
#include "pushback/common/experiment/plot.h"

#include <cmath>

#include "pushback/common/experiment/marker.h"
#include "pushback/common/experiment/plot_layout.h"
#include "tests/support/call.h"

using namespace pushback;

namespace {

Curve straight(const std::string& label, Real from, Real to, std::size_t index = 0) {
  return {label, {0, 1}, {from, to}, line_colour(index)};
}

}  // namespace

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
