// The pages that begin from nothing: a free spin, and how two boxes touch.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "pushback/docs/from_an_empty_file/names.h"
#include "pushback/tools/figures/figures.h"
#include "pushback/tools/figures/svg.h"

namespace pushback::figures {

namespace {

using empty_file::Body;

// ---- a free spin -----------------------------------------------------------------------------------------------------

/// Spins about its middle axis, but for a thousandth.
Body wing_nut() {
  Body body = empty_file::box({0.6, 0.1, 0.3}, 2);
  body.angular_velocity = {0.005, 0.005, 5};
  return body;
}

double energy(const Body& body) {
  const empty_file::Vec3 w = empty_file::axes_of(body).transpose() * body.angular_velocity;
  return w.dot(w.cwiseQuotient(body.inverse_inertia)) / 2;
}

/// How a step turns a body that nothing pushes.
enum class Spin { by_the_middle, by_the_start, velocity_kept };

void spin(Body& body, double h, Spin how) {
  const empty_file::Vec3 w = body.angular_velocity;
  const empty_file::Quat q = body.orientation;
  const empty_file::Vec3 momentum = empty_file::world_inverse_inertia(body).inverse() * w;
  empty_file::move(body, h);
  if (how == Spin::by_the_middle) return;
  body.orientation = empty_file::turned(q, w, h);
  body.angular_velocity = how == Spin::velocity_kept ? w : empty_file::world_inverse_inertia(body) * momentum;
}

/// A value of the body over five seconds, from step to step, until it is above `most`.
template <class Value>
std::vector<Place> curve(const Axes& axes, Spin how, double h, double most, Value value) {
  Body body = wing_nut();
  std::vector<Place> points;
  const int steps = static_cast<int>(std::lround(5 / h)), between = std::max(1, steps / 300);
  for (int step = 0; step <= steps; ++step) {
    const double is = value(body);
    if (step % between == 0 || is > most) points.push_back(axes(step * h, std::min(is, most)));
    if (is > most) break;
    spin(body, h, how);
  }
  return points;
}

void frame(Svg& svg, const Axes& axes, double low, double high,
           const std::vector<std::pair<double, const char*>>& marks, const char* title) {
  svg.text(axes(0, high) + Place(-44, -22), title, {at_left, 16, hue::ink, true});
  svg.line(axes(0, low), axes(0, high), {hue::grey, 1.5});
  svg.line(axes(0, low), axes(5.1, low), {hue::grey, 1.5});
  for (const auto& [value, words] : marks) {
    svg.line(axes(0, value), axes(5.1, value), {hue::haze, 1.5});
    svg.text(axes(0, value) + Place(-8, 5), words, {at_right, 15, hue::grey});
  }
  for (int second = 0; second <= 5; ++second)
    svg.text(axes(second, low) + Place(0, 22), fmt::format("{}", second), {at_middle, 15, hue::grey});
  svg.text(axes(5.1, low) + Place(0, 42), "time, s", {at_right, 15, hue::grey});
}

// ---- two boxes -------------------------------------------------------------------------------------------------------

struct FromTheSide {  // x to the right, y up
  Place origin;
  double scale;
  Place operator()(const empty_file::Vec3& at) const { return origin + scale * Place(at.x(), -at.y()); }
};

std::vector<Place> side_of(const Body& box, const FromTheSide& view) {
  std::vector<Place> corners;
  for (const auto& [x, y] : {std::pair{-1, -1}, {1, -1}, {1, 1}, {-1, 1}})
    corners.push_back(view(box.position + box.orientation * empty_file::Vec3(x * box.half.x(), y * box.half.y(), 0)));
  return corners;
}

/// The two intervals that the boxes cover along n, beside each other, and what they share.
void shadows(Svg& svg, const Body& a, const Body& b, const empty_file::Vec3& n, const Place& at, double scale,
             const std::string& words) {
  const Place along(n.x(), -n.y()), across(along.y(), -along.x());
  const auto place = [&](double value, double aside) { return Place(at + scale * value * along + aside * across); };
  const auto interval = [&](const Body& box, double aside, const char* colour) {
    const double middle = box.position.dot(n), reach = empty_file::reach(box, n);
    svg.line(place(middle - reach, aside), place(middle + reach, aside), {colour, 6});
    return std::pair{middle - reach, middle + reach};
  };
  const double top_of_a = interval(a, -8, hue::blue).second, bottom_of_b = interval(b, 8, hue::vermilion).first;
  for (const double end : {bottom_of_b, top_of_a}) svg.line(place(end, -20), place(end, 20), {hue::ink, 1.5, true});
  svg.text(place((top_of_a + bottom_of_b) / 2, 0) + Place(26, 6), words, {at_left, 16, hue::ink, false, true});
}

}  // namespace

std::string free_spin() {
  Svg svg(830, 330, "A box that spins freely about its middle axis, by three ways of turning it");
  const Axes left{{70, 150}, 60, 100};
  frame(svg, left, -1, 1, {{1, "1"}, {0, "0"}, {-1, "−1"}}, "how far its axis has turned over: cosine");
  const auto cosine = [](const Body& body) { return empty_file::axes_of(body).col(2).z(); };
  svg.polyline(curve(left, Spin::by_the_middle, 1. / 16384, 2, cosine), {hue::pale_grey, 8});
  const Axes right{{500, 250}, 56, 100};
  frame(svg, right, 0, 2, {{2, "2"}, {1, "1"}}, "kinetic energy, of that at the start");
  const double start = energy(wing_nut());
  const auto part = [start](const Body& body) { return energy(body) / start; };
  double x = 40;
  for (const auto& [how, colour, words] : {std::tuple{Spin::velocity_kept, hue::amber, "$ω$ kept"},
                                           {Spin::by_the_start, hue::vermilion, "$L$ kept, $ω$ of the start"},
                                           {Spin::by_the_middle, hue::blue, "$L$ kept, $ω$ of the middle"}}) {
    svg.polyline(curve(left, how, 1. / 60, 2, cosine), {colour, 3});
    svg.polyline(curve(right, how, 1. / 60, 2, part), {colour, 3});
    svg.line({x, 313}, {x + 30, 313}, {colour, 3});
    svg.text({x + 38, 318}, words, {at_left, 16});
    x += how == Spin::velocity_kept ? 130 : 265;
  }
  svg.line({x, 313}, {x + 30, 313}, {hue::pale_grey, 8});
  svg.text({x + 38, 318}, "truth", {at_left, 16});
  return svg.str();
}

std::string separating_axes() {
  Body a = empty_file::box({1, 0.5, 1}, 1), b = empty_file::box({0.6, 0.5, 1}, 1);
  a.position = {0, -0.5, 0};
  b.position = {0.55, 0.52, 0};
  b.orientation = Eigen::AngleAxisd(0.42, empty_file::Vec3::UnitZ());
  empty_file::Axis least;
  empty_file::least_overlap(a, b, least);
  const empty_file::Touches touches = empty_file::touch(a, b);
  Svg svg(830, 372, "Two boxes that overlap, and the intervals that they cover along three of their axes");
  const FromTheSide view{{410, 190}, 125};
  svg.polygon(side_of(a, view), hue::pale_blue, {hue::blue, 2.5});
  svg.polygon(side_of(b, view), hue::none, {hue::vermilion, 2.5});
  svg.text(view(a.position) + Place(-6, 6), "$A$", {at_middle, 20});
  svg.text(view(b.position) + Place(-6, 6), "$B$", {at_middle, 20});
  const empty_file::Vec3 other = empty_file::axes_of(b).col(1);
  const auto depth_along = [&](const empty_file::Vec3& n) {
    return empty_file::reach(a, n) + empty_file::reach(b, n) - n.dot(b.position - a.position);
  };
  shadows(svg, a, b, least.normal, {60, view(empty_file::Vec3::Zero()).y()}, 125,
          fmt::format("{:.0f} mm: the least", 1000 * least.depth));
  shadows(svg, a, b, other, {690, 200}, 125, fmt::format("{:.0f} mm", 1000 * depth_along(other)));
  svg.text(view(touches.front().point + 0.35 * least.normal) + Place(16, 12), "$n$", {at_left, 18});
  svg.text({24, 24}, "along the normal", {at_left, 16, hue::grey});
  svg.text({680, 50}, "along an axis of $B$", {at_middle, 16, hue::grey});
  for (const empty_file::Touch& touch : touches) {
    svg.arrow(view(touch.point), view(touch.point + 0.35 * touch.normal), {hue::ink, 2.5});
    svg.circle(view(touch.point), 6, hue::yellow, {hue::ink, 2});
  }
  return svg.str();
}

}  // namespace pushback::figures
