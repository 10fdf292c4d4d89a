// Chapters 06 and 08: what the two tangents' impulses may be, and what three solvers make of it.
#include <fmt/format.h>

#include <algorithm>

#include "pushback/chapters/08_friction_cone/scaled_back.h"
#include "pushback/chapters/08_friction_cone/scenes.h"
#include "pushback/tools/figures/figures.h"
#include "pushback/tools/figures/svg.h"

namespace pushback::figures {

namespace {

/// The foot of chapter 08's stick once its contact is solved. Along the tangents; impulses in units of mu sum(lambda_n).
struct Rubbed {
  Place slip;       // of unit length
  Place friction;   // to the right and up, as in a diagram
  double off;       // degrees between friction and what is opposite to the slip
  Place near_miss;  // the direction of K_t^-1 u, of unit length
};

template <class FrictionEffect>
Rubbed rubbed(Real heading) {
  friction_cone_scenes::Stick stick(heading);
  stick.world.bodies[1].velocity.y() = -Real(1e-4);  // a touch: friction hardly changes the slip
  Solver<Clamping, FrictionEffect> solver;
  const auto [t1, t2] = tangents_of(stick.contact().normal);
  const TangentBlock k({stick.world, stick.contact(), t1, 0}, {stick.world, stick.contact(), t2, 0});
  solver.solve(stick.world, Real(1) / 60, 200);
  const Vec3 slip = stick.slip(), friction = stick.friction() / (stick.contact().friction *
                                                                 stick.contact().impulse.dot(stick.contact().normal));
  const Real u1 = slip.dot(t1), u2 = slip.dot(t2);
  Rubbed found;
  found.slip = Place(double(u1), double(u2)).normalized();
  found.friction = Place(double(friction.dot(t1)), double(friction.dot(t2)));
  found.off = double(friction_cone_scenes::direction_error(slip, friction));
  found.near_miss = Place(double(k.k22 * u1 - k.k12 * u2), double(k.k11 * u2 - k.k12 * u1)).normalized();
  return found;
}

void draw_tangents(Svg& svg, const Axes& to, double reach) {
  svg.arrow(to(-reach, 0), to(reach, 0), {hue::pale_grey, 1.5});
  svg.arrow(to(0, -reach), to(0, reach), {hue::pale_grey, 1.5});
}
std::vector<Place> square_of(const Axes& to) {
  return {to(-1, -1), to(1, -1), to(1, 1), to(-1, 1)};
}
Place at_of(const Axes& to, const Place& value) {
  return to(value.x(), value.y());
}
double angle_of(const Place& value) {
  return std::atan2(value.y(), value.x());
}

/// Slip, what is opposite to it, friction, and the angle between the two last.
void draw_rubbed(Svg& svg, const Axes& to, const Rubbed& found, const char* colour) {
  const double opposite = angle_of(-found.slip);
  svg.line(to(0, 0), at_of(to, -1.4 * found.slip), {hue::grey, 1.8, true});
  svg.arrow(to(0, 0), at_of(to, 0.7 * found.slip), {hue::ink, 3});
  svg.text(at_of(to, 0.7 * found.slip) + Place(6, -6), "$u$", {.size = 19});
  svg.text(at_of(to, -1.4 * found.slip) + Place(-4, 16), "$−u$", {at_middle, 16, hue::grey});
  svg.arrow(to(0, 0), at_of(to, found.friction), {colour, 4});
  if (found.off < 1) return;
  const double turn = std::remainder(angle_of(found.friction) - opposite, 2 * std::numbers::pi);
  svg.arc(to(0, 0), 0.62 * to.x, opposite, opposite + turn, {colour, 2});
}

/// "1.41 mu sum(lambda_n), 15 degrees off".
std::string words_of(const Rubbed& found) {
  return fmt::format("{:.2f} $μΣλ_n$, {:.0f}° off", found.friction.norm(), found.off);
}

/// Cone and pyramid in space: t1 to the right, t2 away from the eye, the normal impulse up.
void draw_in_space(Svg& svg, const Place& apex) {
  const auto at = [&](double t1, double t2, double n) {
    return Place(apex.x() + 112 * t1 + 44 * t2, apex.y() - 225 * n - 34 * t2 + 12 * t1);
  };
  const Place tip = at(0, 0, 0);
  const std::vector<Place> square{at(-1, -1, 1), at(1, -1, 1), at(1, 1, 1), at(-1, 1, 1)};
  std::vector<Place> rim;
  for (int i = 0; i < 72; ++i) {
    const double angle = std::numbers::pi * i / 36;
    rim.push_back(at(std::cos(angle), std::sin(angle), 1));
  }
  // The cone's outline: the rim's two points that are seen farthest to the sides from its tip.
  const auto side = [&](const Place& p, const Place& q) {
    return (p.x() - tip.x()) * (tip.y() - q.y()) < (q.x() - tip.x()) * (tip.y() - p.y());
  };
  const auto [left, right] = std::minmax_element(rim.begin(), rim.end(), side);

  for (const std::size_t i : {0, 1, 2, 3})
    svg.polygon({tip, square[i], square[(i + 1) % 4]}, hue::pale_blue, {hue::none, 0});
  svg.polygon({tip, *left, *right}, hue::pale_green, {hue::none, 0});
  svg.polygon(square, hue::pale_blue, {hue::blue, 2.5});
  svg.polygon(rim, hue::pale_green, {hue::green, 2.5});
  svg.line(tip, *left, {hue::green, 2.5});
  svg.line(tip, *right, {hue::green, 2.5});
  for (const std::size_t i : {0, 1, 2}) svg.line(tip, square[i], {hue::blue, 2});
  svg.arrow(at(0, 0, 1), at(0, 0, 1.3), {hue::ink, 2});
  svg.arrow(at(0, 0, 1), at(1, 0, 1), {hue::ink, 1.8});
  svg.text(at(0, 0, 1.3) + Place(12, 14), "$Σλ_n$", {.size = 18});
  svg.text(at(0.5, 0, 1) + Place(-36, -12), "$μΣλ_n$", {.size = 16});
}

}  // namespace

std::string cone_and_pyramid() {
  Svg svg(830, 440, "Coulomb's cone and the pyramid around it");
  draw_in_space(svg, {205, 420});
  svg.text({24, 40}, "cone: Coulomb's law", {.size = 17, .colour = hue::green, .bold = true});
  svg.text({24, 66}, "pyramid: two rows, each bounded", {.size = 17, .colour = hue::blue, .bold = true});

  const Axes to{{620, 218}, 108, 108};
  const Rubbed pyramid = rubbed<Friction>(pi / 8), cone = rubbed<FrictionCone>(pi / 8);
  svg.polygon(square_of(to), hue::pale_blue, {hue::blue, 2.5});
  svg.circle(to(0, 0), 108, hue::pale_green, {hue::green, 2.5});
  draw_tangents(svg, to, 1.32);
  svg.text(to(1.32, 0) + Place(0, 24), "$Σλ_{t1}$", {at_middle, 17});
  svg.text(to(0, 1.32) + Place(12, 8), "$Σλ_{t2}$", {.size = 17});
  draw_rubbed(svg, to, pyramid, hue::blue);
  svg.arrow(to(0, 0), at_of(to, cone.friction), {hue::green, 4});
  svg.text({620, 40}, "seen from above, with the slip $u$", {at_middle, 17, hue::grey});
  svg.text({620, 386}, "pyramid: " + words_of(pyramid), {at_middle, 17, hue::blue});
  svg.text({620, 414}, "cone: " + words_of(cone), {at_middle, 17, hue::green});
  return svg.str();
}

std::string friction_of_three() {
  Svg svg(830, 400, "The friction that three solvers arrive at, beside the direction opposite to the slip");
  struct Panel {
    const char *name, *colour, *pale;
    Rubbed found;
  };
  const Panel panels[] = {
      {"pyramid", hue::blue, hue::pale_blue, rubbed<Friction>(pi / 3)},
      {"solved, then scaled back", hue::vermilion, hue::pale_vermilion, rubbed<FrictionScaledBack>(pi / 3)},
      {"cone", hue::green, hue::pale_green, rubbed<FrictionCone>(pi / 3)}};
  double x = 135;
  for (const Panel& panel : panels) {
    const Axes to{{x, 205}, 90, 90};
    if (panel.colour == hue::blue) svg.polygon(square_of(to), panel.pale, {panel.colour, 2.5});
    else svg.circle(to(0, 0), 90, panel.pale, {panel.colour, 2.5});
    draw_tangents(svg, to, 1.3);
    svg.text(to(1.3, 0) + Place(16, 22), "$Σλ_{t1}$", {at_right, 16});
    svg.text(to(0, 1.3) + Place(10, 6), "$Σλ_{t2}$", {.size = 16});
    if (panel.colour == hue::vermilion) {
      svg.line(to(0, 0), at_of(to, -1.3 * panel.found.near_miss), {panel.colour, 1.8, true});
      svg.text(at_of(to, -1.3 * panel.found.near_miss) + Place(-4, 18), "$−K_t^{−1}u$", {at_middle, 16, panel.colour});
    }
    draw_rubbed(svg, to, panel.found, panel.colour);
    svg.text({x, 40}, panel.name, {at_middle, 17, panel.colour, true});
    svg.text({x, 376}, words_of(panel.found), {at_middle, 17, panel.colour});
    x += 272;
  }
  return svg.str();
}

}  // namespace pushback::figures
