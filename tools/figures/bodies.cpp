// Two bodies that overlap, as collision detection finds them.
#include "pushback/common/collision/collide.h"
#include "pushback/common/world/world.h"
#include "pushback/tools/figures/figures.h"
#include "pushback/tools/figures/svg.h"

namespace pushback::figures {

namespace {

struct View {
  Place origin;
  double scale;  // px/m
  Place operator()(const Vec3& at) const { return origin + scale * Place(double(at.x()), -double(at.y())); }
};

/// Its outline in the plane z = 0, from the front.
std::vector<Place> outline_of(const Body& body, const View& view) {
  const Vec3& half = std::get<Box>(body.shape).half_extents;
  std::vector<Place> corners;
  for (const auto& [x, y] : {std::pair<Real, Real>{-1, -1}, {1, -1}, {1, 1}, {-1, 1}})
    corners.push_back(view(body.position + body.orientation * Vec3(x * half.x(), y * half.y(), 0)));
  return corners;
}

void draw_bodies(Svg& svg, const Body& a, const Body& b, const View& view, double line) {
  svg.polygon(outline_of(a, view), hue::pale_blue, {hue::blue, line});
  svg.polygon(outline_of(b, view), hue::pale_vermilion, {hue::vermilion, line});
  svg.polygon(outline_of(a, view), hue::none, {hue::blue, line});  // where both are, both outlines show
}

void draw_velocities(Svg& svg, const Place& centre, double angle, double from, const char* v, const char* omega,
                     const Place& v_at, const Place& omega_at) {
  svg.arrow(centre, centre + towards(angle, 74), {hue::grey, 2});
  svg.arc(centre, 30, from, from + 2.0, {hue::grey, 2}, true);
  svg.text(centre + v_at, v, {.size = 18, .colour = hue::grey});
  svg.text(centre + omega_at, omega, {.size = 18, .colour = hue::grey});
}

void draw_dot(Svg& svg, const Place& at, const char* colour) {
  svg.circle(at, 4.5, colour, {hue::white, 1.2});
}

}  // namespace

std::string two_bodies() {
  World world;
  world.add(box({Real(1.7), Real(0.62), 1}, 1).turned(Real(0.16), Vec3::UnitZ()).at({0, 0, 0}));
  world.add(box({Real(0.95), Real(0.6), 1}, 1).turned(Real(0.7), Vec3::UnitZ()).at({Real(-0.05), Real(1.5), 0}));
  world.find_contacts();
  const Contact& contact = world.contacts.at(0);
  const auto [a, b] = world.bodies_of(contact);
  Vec3 midway = contact.point;
  midway.z() = 0;  // B's edge touches along the line of sight: any of its points will do
  const Vec3 half_depth = contact.depth / 2 * contact.normal;
  const Place n(double(contact.normal.x()), -double(contact.normal.y())), along(-n.y(), n.x());

  Svg svg(830, 440, "Two bodies that overlap, and the names of what a row is made of");
  const View view{{245, 305}, 112};
  draw_bodies(svg, a, b, view, 2.5);
  const Place at = view(midway), centre_a = view(a.position), centre_b = view(b.position);
  svg.text(view(a.position + a.orientation * Vec3(Real(-1.5), Real(-0.45), 0)), "body $A$",
           {.size = 18, .colour = hue::blue, .bold = true});
  svg.text(view(b.position + b.orientation * Vec3(Real(0.1), Real(0.38), 0)) + Place(22, 0), "body $B$",
           {at_middle, 18, hue::vermilion, true});
  draw_velocities(svg, centre_a, 0.35, -1.9, "$v_A$", "$ω_A$", {50, -36}, {30, 44});
  draw_velocities(svg, centre_b, 3.0, -0.9, "$v_B$", "$ω_B$", {-92, 18}, {34, -12});
  svg.arrow(centre_a, at, {hue::blue, 3});
  svg.arrow(centre_b, at, {hue::vermilion, 3});
  draw_dot(svg, centre_a, hue::blue);
  draw_dot(svg, centre_b, hue::vermilion);
  svg.text(centre_a + Place(-12, 16), "$x_A$", {at_right, 18});
  svg.text(centre_b + Place(-8, -14), "$x_B$", {at_middle, 18});
  svg.text((centre_a + at) / 2 + Place(-12, 18), "$r_A$", {at_right, 20, hue::blue, true});
  svg.text((centre_b + at) / 2 + Place(14, 14), "$r_B$", {at_left, 20, hue::vermilion, true});

  // The same contact under a glass.
  const Place glass(652, 205), p = glass - Place(48, -4);
  constexpr double radius = 158, larger = 590;
  svg.circle(at, radius / larger * view.scale, hue::none, {hue::pale_grey, 2});
  svg.line(at + Place(18, -24), glass + towards(2.62, radius), {hue::pale_grey, 1.5});
  svg.line(at + Place(18, 24), glass + towards(-2.62, radius), {hue::pale_grey, 1.5});
  const View close{p - larger * Place(double(midway.x()), -double(midway.y())), larger};
  svg.clip(glass, radius);
  draw_bodies(svg, a, b, close, 3);
  svg.unclip();
  svg.circle(glass, radius, hue::none, {hue::pale_grey, 2.5});
  const Place p_a = close(midway + half_depth), p_b = close(midway - half_depth), aside = 104 * along;
  svg.line(p_b + 12 * along, p_b + 1.12 * aside, {hue::grey, 1.2});
  svg.measure(p_a + aside, p_b + aside, {hue::ink, 1.8});
  svg.text((p_a + p_b) / 2 + aside + Place(12, 6), "$d$", {.size = 20});
  const Place n_tip = p_a + 78 * n;
  svg.arrow(p_a, n_tip, {hue::green, 3.5});
  svg.text(n_tip + Place(14, 8), "$n$, from $A$ to $B$", {.size = 18, .colour = hue::green});
  draw_dot(svg, p_a, hue::blue);
  draw_dot(svg, p_b, hue::vermilion);
  draw_dot(svg, p, hue::ink);
  svg.text(p_a + Place(12, -8), "$P_A$", {at_left, 19, hue::blue, true});
  svg.text(p_b + Place(-10, 22), "$P_B$", {at_right, 19, hue::vermilion, true});
  svg.text(p + Place(10, 6), "$P$", {at_left, 18});
  svg.text({652, 404}, "$C = (P_B − P_A) · n = −d$", {at_middle, 18});
  return svg.str();
}

std::string one_step() {
  Svg svg(830, 250, "The parts of one step, from t to t + h");
  struct Part {
    const char *name, *first, *second, *colour, *pale;
  };
  const Part parts[] = {{"contacts", "points, normals,", "depths, ids", hue::grey, hue::haze},
                        {"forces", "$v$ += $h(g + F/m)$", "$ω$ += $hI^{−1}τ$", hue::blue, hue::pale_blue},
                        {"impulses", "one row after", "the other", hue::green, hue::pale_green},
                        {"motion", "$x$ += $hv$", "$q$ turns with $ω$", hue::vermilion, hue::pale_vermilion}};
  constexpr double wide = 154, high = 96, top = 92;
  double x = 50;
  for (const Part& part : parts) {
    svg.polygon({{x, top}, {x + wide, top}, {x + wide, top + high}, {x, top + high}}, part.pale, {part.colour, 2});
    svg.text({x + wide / 2, top + 27}, part.name, {at_middle, 17, part.colour, true});
    svg.text({x + wide / 2, top + 55}, part.first, {at_middle, 15});
    svg.text({x + wide / 2, top + 80}, part.second, {at_middle, 15});
    svg.arrow({x - 32, top + high / 2}, {x - 4, top + high / 2}, {hue::ink, 2.5});
    if (part.colour == hue::green) {
      svg.arc({x + wide / 2, top - 2}, 34, 0.12, 3.0, {hue::green, 2.5}, true);
      svg.text({x + wide / 2, top - 48}, "sweeps", {at_middle, 16, hue::green});
    }
    x += wide + 36;
  }
  svg.arrow({x - 32, top + high / 2}, {x - 2, top + high / 2}, {hue::ink, 2.5});
  svg.text({20, top + high + 40}, "$x$ and $v$ at time $t$", {at_left, 16});
  svg.text({602, top + high + 40}, "new $v$", {at_middle, 16});
  svg.text({812, top + high + 40}, "$x$ and $v$ at $t + h$", {at_right, 16});
  return svg.str();
}

}  // namespace pushback::figures
