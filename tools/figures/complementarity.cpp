// Chapter 02: one solved row, and two rows that are solved in turn.
#include <fmt/format.h>

#include "pushback/chapters/01_velocity_constraint/row.h"
#include "pushback/tools/figures/figures.h"
#include "pushback/tools/figures/svg.h"
#include "pushback/tools/figures/two_point_column.h"

namespace pushback::figures {

namespace {

/// The axes of the diagram; what is not allowed is shaded, what is allowed is the thick line.
void draw_signorini(Svg& svg, const Axes& to) {
  const Place corner = to(0, 0);
  svg.polygon({to(-0.42, 1.1), to(0.85, 1.1), to(0.85, -0.42), to(-0.42, -0.42)}, hue::haze, {hue::none, 0});
  svg.arrow(to(-0.42, 0), to(0.95, 0), {hue::grey, 1.5});
  svg.arrow(to(0, -0.42), to(0, 1.2), {hue::grey, 1.5});
  svg.polyline({to(0, 1.1), corner, to(0.85, 0)}, {hue::green, 6});
  svg.text(to(0.95, 0) + Place(0, 28), "$JV + b$", {at_right, 18});
  svg.text(to(0, 1.2) + Place(-12, 12), "$Σλ$", {at_right, 18});
}

/// A ball and the ground, which part or do not.
void draw_case(Svg& svg, const Place& at, bool parts, const char* title, const char* law) {
  constexpr double radius = 26;
  const Place centre = at - Place(0, radius + (parts ? 14 : 0));
  svg.line(at - Place(40, 0), at + Place(40, 0), {hue::grey, 3});
  svg.circle(centre, radius, hue::pale_vermilion, {hue::vermilion, 2.5});
  if (parts) svg.arrow(centre, centre - Place(0, 52), {hue::grey, 3});
  else svg.arrow(at, at - Place(0, 58), {hue::green, 4});
  svg.text(at + Place(56, -34), title, {.size = 16, .bold = true});
  svg.text(at + Place(56, -6), law, {.size = 17});
}

}  // namespace

std::string complementarity() {
  Svg svg(830, 420, "What the impulse and the separating speed of a contact may be");
  const Axes to{{165, 300}, 285, 215};
  draw_signorini(svg, to);
  svg.text(to(-0.02, 0.96) + Place(-12, 0), "approaches", {at_right, 15, hue::grey});
  svg.text(to(0.43, 0.96), "pushes and separates", {at_middle, 15, hue::grey});
  svg.text(to(0.6, -0.3), "pulls", {at_middle, 15, hue::grey});

  // One row of the column that lands, and one that leaves, solved by the chapter's row; then what becomes of both corners.
  TwoPointColumn arriving;
  Row row = arriving.row(0);
  row.lo = 0;
  const Real before = row.speed();
  row.solve();
  const auto point = [&](const Row& solved) { return to(double(solved.speed()), double(solved.impulse)); };
  const Place hit = point(row);
  // The start is far to the left: its line enters where the diagram begins.
  const double slope = double(row.impulse / (row.speed() - before));
  svg.line(to(-0.42, slope * (-0.42 - double(before))), hit, {hue::blue, 2.2, true});
  svg.circle(hit, 6.5, hue::blue, {hue::white, 1.5});
  svg.text(hit + Place(14, -18), "one row, solved", {.size = 15, .colour = hue::blue});

  TwoPointColumn leaving;
  leaving.column().velocity = {0, Real(0.5), 0};
  Row free = leaving.row(0), clamped = leaving.row(1);
  clamped.lo = 0;
  clamped.solve();
  const Place parted = point(clamped);
  free.solve();
  svg.line(parted, point(free), {hue::blue, 2.2, true});
  svg.circle(point(free), 6.5, hue::vermilion, {hue::white, 1.5});
  svg.circle(parted, 6.5, hue::blue, {hue::white, 1.5});
  svg.text(point(free) + Place(14, 10), "no limits", {at_left, 15, hue::vermilion});

  const TwoPointColumn::Solved each = solved_in_turn(true);
  const Place stuck = to(double(each.speeds.back()[0]), double(each.sums.back()[0]));
  svg.circle(stuck, 6.5, hue::vermilion, {hue::white, 1.5});
  svg.text(stuck + Place(14, 20), "each correction ≥ 0", {.size = 15, .colour = hue::vermilion});

  draw_case(svg, {504, 130}, false, "pushes, does not separate", "$Σλ > 0,  JV + b = 0$");
  draw_case(svg, {504, 260}, true, "separates, does not push", "$Σλ = 0,  JV + b > 0$");
  svg.text({464, 330}, "both, and the corner between them:", {.size = 16, .colour = hue::green});
  svg.text({464, 360}, "$Σλ ≥ 0,  JV + b ≥ 0,  Σλ(JV + b) = 0$", {.size = 17, .colour = hue::green});
  return svg.str();
}

std::string two_points() {
  const TwoPointColumn::Solved sums = solved_in_turn(false), each = solved_in_turn(true);
  Svg svg(830, 500, "Two rows solved in turn, in the plane of their impulses");
  constexpr double right = 0.99, top = 0.58;
  const Axes to{{80, 425}, 650, 650};
  const TwoPointColumn column;
  const double k11 = double(column.coupling(0, 0)), k12 = double(column.coupling(0, 1)), middle = 1 / (k11 + k12);

  // f = lambda K lambda / 2 + lambda (J V), which no solve raises: level lines through the first stops.
  for (std::size_t stop = 1; stop < 4; ++stop) {
    const double e1 = double(sums.sums[stop][0]) - middle, e2 = double(sums.sums[stop][1]) - middle;
    const double size = std::sqrt(k11 * (e1 * e1 + e2 * e2) + 2 * k12 * e1 * e2);
    std::vector<Place> line;
    for (int i = 0; i <= 180; ++i) {
      const double angle = 2 * std::numbers::pi * i / 180;
      const double along = size * std::cos(angle) / std::sqrt(2 * (k11 + k12)),
                   across = size * std::sin(angle) / std::sqrt(2 * (k11 - k12));
      const double s1 = middle + along + across, s2 = middle + along - across;
      const bool inside = s1 >= 0 && s1 <= right && s2 >= 0 && s2 <= top;
      if (inside) line.push_back(to(s1, s2));
      if (inside && i < 180) continue;
      if (line.size() > 1) svg.polyline(line, {hue::pale_grey, 1.4});
      line.clear();
    }
  }
  svg.arrow(to(0, 0), to(right, 0), {hue::grey, 1.5});
  svg.arrow(to(0, 0), to(0, top), {hue::grey, 1.5});
  for (const double tick : {0.2, 0.4, 0.6, 0.8}) {
    svg.line(to(tick, 0), to(tick, 0) + Place(0, 6), {hue::grey, 1.5});
    svg.text(to(tick, 0) + Place(0, 24), fmt::format("{}", tick), {at_middle, 14, hue::grey});
    if (tick > top) continue;
    svg.line(to(0, tick), to(0, tick) - Place(6, 0), {hue::grey, 1.5});
    svg.text(to(0, tick) + Place(-12, 5), fmt::format("{}", tick), {at_right, 14, hue::grey});
  }
  svg.text(to(right, 0) + Place(0, 52), "$Σλ_1$, in units of $mv$", {at_right, 16});
  svg.text(to(0, 0) + Place(0, 52), "sweep, row: $Σλ_1$, $Σλ_2$", {.size = 15});
  svg.text(to(0, top) + Place(-24, -14), "$Σλ_2$", {at_left, 17});

  // K11 s1 + K12 s2 = 1 and the other way round.
  const auto on_first = [&](double s2) { return to((1 - k12 * s2) / k11, s2); };
  const auto on_second = [&](double s1) { return to(s1, (1 - k12 * s1) / k11); };
  svg.line(on_first(0), on_first(top), {hue::blue, 2});
  svg.line(on_second(0.36), on_second(0.97), {hue::purple, 2});
  svg.text(on_first(top) + Place(0, -10), "row 1 is solved: $Ċ_1 = 0$", {at_middle, 15, hue::blue});
  svg.text(on_second(0.97) + Place(108, 26), "row 2 is solved: $Ċ_2 = 0$", {at_right, 15, hue::purple});

  const auto path_of = [&](const TwoPointColumn::Solved& solved) {
    std::vector<Place> path;
    for (const auto& sum : solved.sums) path.push_back(to(double(sum[0]), double(sum[1])));
    return path;
  };
  const std::vector<Place> down = path_of(sums), stays = path_of(each);
  for (std::size_t i = 1; i < 5; ++i) svg.arrow(down[i - 1], down[i], {hue::green, 3.2});
  svg.polyline({down.begin() + 4, down.end()}, {hue::green, 2.5});
  svg.circle(stays.back(), 8, hue::vermilion, {hue::white, 1.5});
  svg.circle(down.back(), 8, hue::green, {hue::white, 1.5});
  const auto state = [&](std::size_t i) { return fmt::format("{:.3f}, {:.3f}", sums.sums[i][0], sums.sums[i][1]); };
  svg.text(down[0] + Place(14, -14), "start: 0, 0", {.size = 15});
  svg.text(down[1] + Place(14, -14), "1, row 1: " + state(1), {.size = 15});
  svg.text(down[2] + Place(16, -8), "1, row 2: " + state(2), {.size = 15});
  svg.text(down[2] + Place(16, -48), "each correction ≥ 0:", {.size = 15, .colour = hue::vermilion});
  svg.text(down[2] + Place(16, -29), "it stays here", {.size = 15, .colour = hue::vermilion});
  svg.text(down[3] + Place(-14, 22), "2, row 1: " + state(3), {.at = at_right, .size = 15, .halo = true});
  svg.text(down[4] + Place(14, -8), "2, row 2: " + state(4), {.size = 15, .halo = true});
  svg.text(down.back() + Place(-18, 22), fmt::format("the solution: {:.1f}, {:.1f}", middle, middle),
           {at_right, 15, hue::green, true, true});
  return svg.str();
}

}  // namespace pushback::figures
