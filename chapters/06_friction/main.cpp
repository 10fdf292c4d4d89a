#include "pushback/chapters/06_friction/by_weight.h"
#include "pushback/chapters/06_friction/scenes.h"
#include "pushback/common/experiment/experiment.h"

using namespace pushback;

namespace {

using Before = Solver<Clamping, Baumgarte, Slop, Restitution>;
using After = Solver<Clamping, Baumgarte, Slop, Restitution, Friction>;  // this chapter

using ByWeight = Solver<Clamping, Baumgarte, Slop, Restitution, FrictionByWeight>;

/// Where boxes sent out under headings of 0 to 90 degrees come to rest, seen from above.
Curve resting_places(Real h, int sweeps) {
  Curve curve{"where the boxes stop", {}, {}, line_colour(1), Curve::Style::line_and_points};
  for (int i = 0; i <= 16; ++i) {
    const Real heading = pi / 2 * static_cast<Real>(i) / 16;
    World world;
    slide(world, {heading});
    After solver;
    for (int step = 0; step < static_cast<int>(Real(1.5) / h); ++step) world.step(solver, h, sweeps);
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

}  // namespace

int main(int argc, char** argv) {
  Experiment e("06_friction", "What holds a box on a slope, and what stops it?");
  return e.run(argc, argv, [&] {
    const Real h = e.dt();
    constexpr Real seconds = Real(1.5);
    e.scene({.name = "μ = 0.8, 1.05 and 1.5 times tan θ, θ = 40°",
             .fill = slope,
             .camera = {{Real(-6), Real(6.8), Real(6.3)}, {Real(1.9), Real(1.6), 0}},
             .seconds = seconds,
             .instants = {0, Real(0.4), Real(0.8), Real(1.2)}});
    const Real a = g * (std::sin(theta) - grip[0] * std::tan(theta) * std::cos(theta));
    const Real steps = std::round(seconds / h);
    const auto should = [&](Variant& variant) {
      variant.expect("0.8 tan θ slides", way_of(a, h, steps)).expect("1.05 tan θ slides", 0);
    };
    should(e.variant("no friction", Before{}));
    should(e.variant("bounded by μ m g", ByWeight{}));
    should(e.variant("bounded by μ Σλₙ", After{}).reference("g (sin θ − μ cos θ) t²/2", [=](Real t) {
      return a * t * t / 2;
    }));
    e.series("way slid, μ = 0.8 tan θ", "m", [](const World& world) { return slid(world, 1); });
    e.number("0.8 tan θ slides", "m", [](const Run& run) { return slid(run.world, 1); });
    e.number("1.05 tan θ slides", "m", [](const Run& run) { return slid(run.world, 2); });

    e.scene({.name = "5 m/s under headings of 0°, 22.5° and 45°",
             .fill = [=](World& world) { slide_to_posts(world, three_headings, h); },
             .camera = {{Real(2.6), Real(5), Real(3.4)}, {Real(2.3), 0, Real(-0.95)}},
             .seconds = Real(1.2),
             .instants = {0, Real(0.3), Real(0.6), Real(1.2)}});
    e.variant("pyramid: each tangent by itself", After{})
        .expect("0°", stopping_distance(h))
        .expect("22.5°", stopping_distance(h))
        .expect("45°", stopping_distance(h))
        .reference("v₀ − μ g t", [](Real t) { return std::max(Real(0), v0 - mu * g * t); });
    for (std::size_t i = 0; i < three_headings.size(); ++i) {
      const std::string name = fmt::format("{:g}°", three_headings[i] * 180 / pi);
      e.number(name, "m", [i](const Run& run) {
        const Vec3 way = run.world.bodies[i + 1].position - start_of(three_headings[i]);
        return Vec3(way.x(), 0, way.z()).norm();
      });
      if (i == 2)
        e.series("speed under 45°", "m/s", [](const World& world) { return world.bodies[3].velocity.norm(); });
    }

    e.scene({.name = "a ball thrown without spin ends rolling",
             .fill = thrown_ball,
             .camera = {{0, Real(1.7), 7}, {0, Real(0.3), 0}},
             .seconds = Real(1.5),
             .instants = {0, Real(0.4), Real(0.8), Real(1.2)}});
    e.variant("frictionless", Before{});
    e.variant("friction", After{})
        .expect("speed at the end", v0 * 5 / 7)
        .expect("v − ω r", 0)
        .reference("5/7 v₀", [](Real) { return v0 * 5 / 7; });
    e.series("speed of the ball", "m/s", [](const World& world) { return world.bodies[1].velocity.x(); });
    e.number("speed at the end", "m/s", [](const Run& run) { return run.world.bodies[1].velocity.x(); });
    e.number("v − ω r", "m/s", [](const Run& run) {
      return run.world.bodies[1].velocity.x() + run.world.bodies[1].angular_velocity.z() * Real(0.3);
    });

    e.study([&e, h] {
      e.panel({.title = "seen from above: the pyramid's corner",
               .x_label = "way along t₁, m",
               .y_label = "way along t₂, m",
               .curves = {circle(stopping_distance(h)), resting_places(h, e.sweeps())},
               .extra = "set size ratio -1\nset xrange [0:2.8]\nset yrange [0:2.8]"});
    });
  });
}
