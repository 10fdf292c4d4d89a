// Chapters 03 and 04: what is made of the separation C, along one axis.
#include <fmt/format.h>

#include "pushback/chapters/04_slop/slop.h"
#include "pushback/tools/figures/figures.h"
#include "pushback/tools/figures/svg.h"

namespace pushback::figures {

namespace {

constexpr Real dt = Real(1) / 60, millimetre = Real(0.001);

void ball_at(World& world, Real separation) {
  world.add(ground());
  world.add(sphere(Real(0.5), 100).at({0, Real(0.5) + separation, 0}));
}

/// -b, m/s: how fast the solver wants the ball to leave the ground, into which it has sunk.
template <class ContactSolver>
Real wanted_speed(ContactSolver solver, Real separation) {
  World world;
  ball_at(world, separation);
  world.find_contacts();
  solver.solve(world, dt, 0);
  return -solver.rows().at(0).bias;
}

/// C after each step, m, of a ball that starts there.
template <class ContactSolver>
std::vector<Real> way_of(ContactSolver solver, Real separation, int steps) {
  World world;
  ball_at(world, separation);
  std::vector<Real> way{separation};
  for (int step = 0; step < steps; ++step) {
    world.step(solver, dt);
    way.push_back(world.bodies[1].position.y() - Real(0.5));
  }
  return way;
}

struct Diagram {
  Svg svg;
  Axes to;  // mm to the right, m/s up
  Place at(Real separation, Real speed) const { return to(double(separation / millimetre), double(speed)); }
};

/// A ball whose lowest point is at C, above the diagram: 1.3 px for a millimetre.
void draw_ball(Diagram& diagram, Real separation, double ground_y, const char* words) {
  const double x = diagram.at(separation, 0).x(), radius = 26, low = ground_y - 1.3 * double(separation / millimetre);
  diagram.svg.circle({x, low - radius}, radius, hue::pale_vermilion, {hue::vermilion, 2.5});
  diagram.svg.line({x - 48, ground_y}, {x + 48, ground_y}, {hue::grey, 2.5});
  diagram.svg.text({x, ground_y - 68}, words, {at_middle, 15});
}

template <class ContactSolver>
void draw_wanted(Diagram& diagram, const ContactSolver& solver, Real from, const Pen& pen) {
  std::vector<Place> line;
  for (int half = int(std::lround(from / millimetre * 2)); half <= 0; ++half) {
    const Real separation = static_cast<Real>(half) * millimetre / 2;
    line.push_back(diagram.at(separation, wanted_speed(solver, separation)));
  }
  diagram.svg.polyline(line, pen);
}

/// The separations after each step, as dots on a line below the axis.
void draw_way(Diagram& diagram, const std::vector<Real>& way, double below, const char* colour, std::size_t numbered) {
  for (std::size_t k = 0; k < way.size(); ++k) {
    const Place at = diagram.at(way[k], 0) + Place(0, below);
    diagram.svg.circle(at, 4.5, colour, {hue::white, 1});
    if (k < numbered) diagram.svg.text(at + Place(0, -10), fmt::format("{}", k), {at_middle, 14, hue::grey});
  }
}

Diagram diagram(const char* title, double zero) {
  Diagram made{Svg(830, 490, title), {{zero, 310}, 27, 620}};
  return made;
}

/// Axes and what they are called; `from`, `to`: their ends, mm.
void draw_axes(Diagram& diagram, double from, double to, double top, const std::vector<int>& ticks) {
  Svg& svg = diagram.svg;
  const Axes& at = diagram.to;
  svg.arrow(at(from, 0), at(to, 0), {hue::grey, 1.5});
  svg.arrow(at(0, 0), at(0, top) + Place(0, -14), {hue::grey, 1.5});
  for (const int tick : ticks) {
    svg.line(at(tick, 0), at(tick, 0) + Place(0, 6), {hue::grey, 1.5});
    svg.text(at(tick, 0) + Place(0, 24), fmt::format("{}{}", tick < 0 ? "−" : "", std::abs(tick)),
             {at_middle, 14, hue::grey});
  }
  svg.text(at(to, 0) + Place(4, -12), "$C$, mm", {at_right, 17});
}

}  // namespace

std::string bias_along_separation() {
  Diagram d = diagram("The speed that Baumgarte's bias asks for, against the separation", 620);
  const Solver<Clamping, Baumgarte> feeding;
  draw_ball(d, -20 * millimetre, 110, "overlap, $C < 0$");
  draw_ball(d, 0, 110, "$C = 0$");
  draw_ball(d, 5 * millimetre, 110, "no contact");
  draw_axes(d, -21.6, 7, 0.26, {-20, -15, -10, -5, 0, 5});
  d.svg.line(d.at(-Real(0.0216), 0), d.at(0, 0), {hue::blue, 4});
  draw_wanted(d, feeding, -Real(0.021), {hue::vermilion, 4});
  d.svg.text(d.to(-15.2, 0.21), "$−b = −(β/h)C$", {.size = 18, .colour = hue::vermilion});
  d.svg.text(d.to(-20, 0) + Place(0, -12), "chapters 01 and 02: $b = 0$", {.size = 15, .colour = hue::blue});
  d.svg.text(d.at(0, Real(0.26)) + Place(12, 0), "wanted speed $−b$", {.size = 16});
  const Real deepest = wanted_speed(feeding, -20 * millimetre);
  d.svg.circle(d.at(-20 * millimetre, deepest), 5, hue::vermilion, {hue::white, 1});
  d.svg.text(d.at(-20 * millimetre, deepest) + Place(12, -8), fmt::format("{:.2f} m/s", deepest),
             {.size = 14, .colour = hue::vermilion});
  d.svg.text({60, 378}, "A ball that starts 20 mm deep: $C$ after each step of 1/60 s, $β = 0.2$", {.size = 15});
  draw_way(d, way_of(feeding, -20 * millimetre, 40), 105, hue::vermilion, 7);
  d.svg.text(d.to(-20, 0) + Place(-6, 145), "each step leaves the part $1 − β$ of the overlap",
             {.size = 15, .colour = hue::grey});
  d.svg.text(d.to(0, 0) + Place(0, 145), "$C = 0$", {at_middle, 16});
  return d.svg.str();
}

std::string slop_along_separation() {
  Diagram d = diagram("The speed that Baumgarte's bias asks for with slop, against the separation", 620);
  Solver<Clamping, Baumgarte, Slop> with_slop;
  const Solver<Clamping, Baumgarte> without;
  const Real slop = with_slop.slop;
  d.svg.polygon({d.at(-slop, 0), d.at(-slop, Real(0.25)), d.at(0, Real(0.25)), d.at(0, 0)}, hue::pale_green,
                {hue::none, 0});
  draw_ball(d, -20 * millimetre, 110, "pushed out");
  draw_ball(d, -slop / 2, 110, "held");
  draw_ball(d, 5 * millimetre, 110, "no contact");
  draw_axes(d, -21.6, 7, 0.26, {-20, -15, -10, -5, 0, 5});
  draw_wanted(d, without, -Real(0.021), {hue::grey, 2, true});
  draw_wanted(d, with_slop, -Real(0.021), {hue::vermilion, 4});
  d.svg.text(d.to(-14.6, 0.22), "without slop: $−b = −(β/h)C$", {.size = 16, .colour = hue::grey});
  d.svg.text(d.to(-21, 0.022), "$−b = −(β/h) min(0, C + slop)$", {.size = 16, .colour = hue::vermilion});
  d.svg.text(d.at(0, Real(0.26)) + Place(12, 0), "wanted speed $−b$", {.size = 16});
  d.svg.text(d.at(-slop / 2, Real(0.2)), "slop: $b = 0$", {at_middle, 15, hue::green, true});
  d.svg.line(d.at(-slop, 0) + Place(0, 82), d.at(-slop, 0) + Place(0, 122), {hue::green, 1.5, true});
  d.svg.text({60, 378}, "Two balls that start 20 mm and 3 mm deep: $C$ after each step", {.size = 15});
  draw_way(d, way_of(with_slop, -20 * millimetre, 40), 105, hue::vermilion, 6);
  draw_way(d, way_of(with_slop, -3 * millimetre, 40), 105, hue::green, 1);
  d.svg.text(d.to(-20, 0) + Place(-6, 145), "it comes up to the slop, not to 0",
             {.size = 15, .colour = hue::vermilion});
  d.svg.text(d.at(-3 * millimetre, 0) + Place(16, 145), "it stays where it is", {at_left, 15, hue::green});
  return d.svg.str();
}

}  // namespace pushback::figures
