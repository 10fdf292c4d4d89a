#include "pushback/chapters/06_friction/by_weight.h"
#include "pushback/chapters/06_friction/scenes.h"
#include "pushback/common/experiment/experiment.h"
#include "pushback/common/experiment/marks.h"
#include "pushback/common/experiment/row_by_row.h"

using namespace pushback;
using namespace pushback::friction_scenes;

namespace {

using Before = Solver<Clamping, Baumgarte, Slop, Restitution>;
using After = Solver<Clamping, Baumgarte, Slop, Restitution, Friction>;  // this chapter

using ByWeight = Solver<Clamping, Baumgarte, Slop, Restitution, FrictionByWeight>;

/// Where boxes sent out under headings of 0 to 90 degrees come to rest, seen from above.
Curve resting_places(const Push& push, Real h, int sweeps) {
  Curve curve{"where the boxes stop", {}, {}, line_colour(2), Curve::Style::line_and_points};
  for (int i = 0; i <= 16; ++i) {
    const Real heading = pi / 2 * static_cast<Real>(i) / 16;
    World world;
    slide(world, {heading}, push);
    After solver;
    for (int step = 0; step < static_cast<int>(push.long_enough(Real(1.5)) / h); ++step) world.step(solver, h, sweeps);
    const Vec3 way = world.bodies[1].position - start_of(heading);
    curve.x.push_back(way.x());
    curve.y.push_back(-way.z());
  }
  return curve;
}
Curve circle(Real r) {
  Curve curve{"where they should", {}, {}, "#222222", Curve::Style::dashed};
  for (int i = 0; i <= 90; ++i) {
    curve.x.push_back(r * std::cos(pi / 180 * static_cast<Real>(i)));
    curve.y.push_back(r * std::sin(pi / 180 * static_cast<Real>(i)));
  }
  return curve;
}

constexpr Real thin = Real(1.5);  // pixels, of lines in a cell that is twice as high as others

/// A triangle beside the slope, one side of it level; where the three boxes began, as a line; and where each should be.
void mark_slope(Picture& picture, const BoxesOnSlope& slope, Real time) {
  const Vec3 along{std::cos(slope.theta), std::sin(slope.theta), 0};
  const Vec3 foot = Real(1.4) * along - Real(2.02) * Vec3::UnitZ(), top = foot + 3 * along;
  add_line(picture, {foot, Vec3(top.x(), foot.y(), foot.z()), top, foot}, near_black_colour(), thin);
  World start;
  slope(start);
  const Vec3 middle = start.bodies[2].position - Real(0.4) * along;
  add_line(picture, {middle - 2 * Vec3::UnitZ(), middle + 2 * Vec3::UnitZ()}, near_black_colour(), thin);
  for (std::size_t i = 0; i < grip.size(); ++i) {
    Body& box = start.bodies[i + 1];
    box.position -= std::max(Real(0), slope.acceleration(grip[i])) * time * time / 2 * along;
    add_outline(picture, box, near_black_colour(), thin);
  }
}
/// Ways of boxes on the floor, and the arc at `radius` from the origin on which they should end.
void mark_stops(Picture& picture, Real radius) {
  const auto at = [](Real heading, Real r) { return Vec3(r * std::cos(heading), Real(0.005), -r * std::sin(heading)); };
  std::vector<Vec3> arc;
  for (int degrees = -8; degrees <= 53; ++degrees) arc.push_back(at(static_cast<Real>(degrees) * pi / 180, radius));
  add_line(picture, arc);
  for (const Real heading : three_headings) add_line(picture, {at(heading, start), at(heading, radius)});
}
/// A line on the ball, from the side that faces us to the rim: it shows how far the ball has turned.
void mark_hand(Picture& picture, const World& world) {
  const Body& ball = world.bodies[1];
  std::vector<Vec3> hand;
  for (int degrees = 0; degrees <= 90; degrees += 10) {
    const Real angle = static_cast<Real>(degrees) * pi / 180;
    hand.emplace_back(ball.position + ball.orientation * (Real(0.302) * Vec3(0, std::sin(angle), std::cos(angle))));
  }
  add_line(picture, hand, {1, 1, 1}, 5);
}

}  // namespace

int main(int argc, char** argv) {
  Experiment e("06_friction", "What holds a box on a slope, and what stops it?");
  BoxesOnSlope slope;
  e.parameter({"--slope", "θ", "rad", "Angle of the slope, which sets μ", 0.05, 0.9}, &slope.theta);
  Push push;
  e.parameter({"--mu", "μ", "", "Friction on level ground", 0.3, 1.5}, &push.mu);
  e.parameter({"--speed", "v₀", "m/s", "Initial speed on level ground", 1, 8}, &push.v0);
  return e.run(argc, argv, [&] {
    const Real h = e.dt();
    constexpr Real seconds = Real(1.5);
    const Vec3 along{std::cos(slope.theta), std::sin(slope.theta), 0}, middle = Real(3.05) * along;
    e.scene({.name = fmt::format("μ = 0.8, 1.05 and 1.5 times tan θ, θ = {:.0f}°", slope.theta * 180 / pi),
             .fill = slope,
             .camera = {middle + Vec3(Real(-10), Real(3.4), Real(-7)), middle - Vec3(0, 0, Real(0.3)), Real(0.36)},
             .seconds = seconds,
             .instants = {Real(0.9)},
             .contacts = Drawn::points,
             .key = "slope",
             .caption =
                 "Only the box in front, with μ = 0.8 tan θ, should slide, as far as its outline. All three started "
                 "at the line across the slope. The distances are those after 1.5 s.",
             .colours = {{body_ink(colours[0]), "μ = 0.8 tan θ"},
                         {body_ink(colours[1]), "1.05 tan θ"},
                         {body_ink(colours[2]), "1.5 tan θ"}},
             .start_shown = false,
             .marks = [slope](Picture& picture, const World&, Real time) { mark_slope(picture, slope, time); },
             .cell_height = 420,
             .guess = Guess{{0, 1, 2}}});
    const Real a = slope.acceleration(grip[0]);
    const Real steps = std::round(seconds / h);
    const auto should = [&](Variant& variant) {
      variant.expect("0.8 tan θ slides", way_of(a, h, steps)).expect("1.05 tan θ slides", 0);
    };
    should(e.variant("no friction", Before{}));
    should(e.variant("bounded by μ m g", ByWeight{}));
    should(e.variant("bounded by μ Σλₙ", After{}).reference("g (sin θ − μ cos θ) t²/2", [=](Real t) {
      return a * t * t / 2;
    }));
    e.series("distance slid, μ = 0.8 tan θ", "m", [slope](const World& world) { return slope.slid(world, 1); });
    e.number("0.8 tan θ slides", "m", [slope](const Run& run) { return slope.slid(run.world, 1); });
    e.number("1.05 tan θ slides", "m", [slope](const Run& run) { return slope.slid(run.world, 2); });

    const Real stop = push.stopping_distance(h), sliding = push.long_enough(Real(1.2));
    const Vec3 fan = (start + stop) * Vec3(Real(0.67), 0, Real(-0.31));
    e.scene({.name = fmt::format("{:.3g} m/s, at 0°, 22.5° and 45° to a tangent", push.v0),
             .fill = [=](World& world) { slide(world, three_headings, push); },
             .camera = {fan + stop * Vec3(Real(-0.3), Real(3.6), Real(1.6)), fan, Real(0.32)},
             .seconds = sliding,
             .instants = {sliding / 4, sliding / 2, sliding},
             .arrow = Real(0.9),
             .key = "headings",
             .caption =
                 "All three boxes should stop on the arc. Each tangent has a bound of its own, so friction is 1.41 "
                 "times as large as it should be while a box slips along both. The box at 45° does so to the end.",
             .colours = {{body_ink(colours[0]), "0°"}, {body_ink(colours[1]), "22.5°"}, {body_ink(colours[2]), "45°"}},
             .start_shown = false,
             .marks = [=](Picture& picture, const World&, Real) { mark_stops(picture, start + stop); },
             .cell_height = 420});
    e.variant("bounded by μ Σλₙ", After{})
        .expect("0°", stop)
        .expect("22.5°", stop)
        .expect("45°", stop)
        .reference("v₀ − μ g t", [push](Real t) { return std::max(Real(0), push.v0 - push.mu * World::g * t); });
    for (std::size_t i = 0; i < three_headings.size(); ++i) {
      const std::string name = fmt::format("{:g}°", three_headings[i] * 180 / pi);
      e.number(name, "m", [i](const Run& run) {
        const Vec3 way = run.world.bodies[i + 1].position - start_of(three_headings[i]);
        return Vec3(way.x(), 0, way.z()).norm();
      });
      if (i == 2) e.series("speed at 45°", "m/s", [](const World& world) { return world.bodies[3].velocity.norm(); });
    }

    e.scene(
        {.name = "a ball thrown without spin ends rolling",
         .fill = [push](World& world) { thrown_ball(world, push); },
         .camera = {{0, Real(1.2), 12}, {0, Real(0.33), 0}, Real(0.091)},
         .seconds = Real(1.2),
         .key = "ball",
         .caption = "The white line is painted on the ball. Without friction the ball never turns. With friction it "
                    "ends rolling, at 5/7 of its first speed.",
         .strobe = Strobe{.every = Real(0.2), .shift_per_second = Vec3::Zero(), .height = 240, .marks = mark_hand}});
    e.variant("no friction", Before{});
    e.variant("bounded by μ Σλₙ", After{})
        .expect("speed at the end", push.v0 * 5 / 7)
        .expect("v − ω r", 0)
        .reference("5/7 v₀", [push](Real) { return push.v0 * 5 / 7; });
    e.series("speed of the ball", "m/s", [](const World& world) { return world.bodies[1].velocity.x(); });
    e.number("speed at the end", "m/s", [](const Run& run) { return run.world.bodies[1].velocity.x(); });
    e.number("v − ω r", "m/s", [](const Run& run) {
      return run.world.bodies[1].velocity.x() + run.world.bodies[1].angular_velocity.z() * Real(0.3);
    });

    // Three boxes that land while they slide, in one step.
    e.rows("bounded by μ Σλₙ", [h] {
      return row_by_row(on_two_corners(3, Vec3::Constant(Real(0.5)), 1, {1, -1, 0}, Real(0.5)), After{}, h, 2);
    });

    e.study([&e, push, stop, h] {
      const Real shown = std::ceil(11 * stop) / 10;
      e.panel({.title = "seen from above: the pyramid's corner",
               .x_label = "distance along t₁, m",
               .y_label = "distance along t₂, m",
               .curves = {circle(stop), resting_places(push, h, e.sweeps())},
               .x_range = {0, shown},
               .y_range = {0, shown},
               .equal_units = true});
    });
  });
}
