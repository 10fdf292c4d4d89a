#include <fmt/format.h>

#include "pushback/chapters/02_clamping/clamping.h"
#include "pushback/chapters/02_clamping/scenes.h"
#include "pushback/common/experiment/experiment.h"
#include "pushback/common/experiment/marks.h"
#include "pushback/common/experiment/row_by_row.h"

using namespace pushback;
using namespace pushback::clamping_scenes;

namespace {

/// Fastest way up of any body after the first touch, m/s.
Real rebound(const Run& run) {
  const auto& speeds = run.series.at("speed upwards");
  return std::max(Real(0), *std::max_element(speeds.begin(), speeds.end()));
}

/// How far the middles of the columns have moved sideways, at most, mm.
Real out_of_line(const World& world) {
  Real largest = 0;
  for (const Body& body : world.bodies) largest = std::max(largest, std::hypot(body.position.x(), body.position.z()));
  return 1000 * largest;
}

/// Of the column that lands flat, m/s.
Real upwards(const World& world) {
  return world.bodies[1].velocity.y();
}

/// Of the column that lands turning, from the vertical, °.
Real tilt(const World& world) {
  const Vec3 up = world.bodies[2].orientation * Vec3::UnitY();
  return std::acos(std::clamp(up.y(), Real(-1), Real(1))) * 180 / pi;
}

/// How far the velocities are from the exact ones after 1, 2, ... sweeps of the step in which the column lands.
template <class ContactSolver>
Curve error_after_sweeps(const LandingColumn& landing, const std::string& label, ContactSolver solver,
                         std::size_t colour) {
  Curve curve{label, {}, {}, line_colour(colour), Curve::Style::line_and_points};
  const Real dt = Real(1) / 60;
  World world;
  landing(world);
  ContactSolver untouched = solver;
  while (deepest_overlap(world) == 0) {
    world.begin_step(dt);
    if (world.contacts.empty()) world.move(dt);
  }
  // The exact outcome of a flat, inelastic landing: everything at rest.
  const std::vector<Body> before = world.bodies;
  for (int sweeps = 1; sweeps <= 40; ++sweeps) {
    world.bodies = before;
    solver = untouched;
    solver.solve(world, dt, sweeps);
    const Body& column = world.bodies[1];
    curve.x.push_back(static_cast<Real>(sweeps));
    curve.y.push_back(std::max(std::hypot(column.velocity.norm(), column.angular_velocity.norm()), Real(1e-17)));
  }
  return curve;
}

}  // namespace

int main(int argc, char** argv) {
  Experiment e("02_clamping", "A contact must not pull. Which quantity must not become negative?");
  LandingColumn landing;
  e.parameter({"--fall", "", "m", "Drop height of the column", 0.05, 1}, &landing.fall);
  StackedColumns columns;
  e.parameter({"--columns", "n", "", "Columns in the stack", 2, 6}, &columns.count);
  return e.run(argc, argv, [&] {
    const auto three_ways = [&](int sweeps) {
      e.variant("no limits", Solver<>{}).with_sweeps(sweeps).without_curves();  // those of the last
      e.variant("each correction ≥ 0", Solver<ClampingEachCorrection>{}).with_sweeps(sweeps);
      e.variant("their sum ≥ 0", Solver<Clamping>{}).with_sweeps(sweeps);
    };
    e.scene({.name = "one column lands flat, one lands turning",
             .fill = TwoLandings{landing},
             .camera = {{Real(0.5), Real(1.2), Real(5.6)}, {0, Real(1.1), 0}, Real(0.46)},
             .seconds = Real(1.2),
             .instants = {0, Real(0.2), Real(0.4), Real(0.6)},
             .caption =
                 "The yellow column lands flat and should stand in its outline. The red one turns as it lands and "
                 "should tip over. Only the last row does both.",
             .marks =
                 [](Picture& picture, const World&, Real) {
                   add_outline(picture,
                               box({Real(0.25), Real(0.8), Real(0.25)}, 1).at({-TwoLandings::aside, Real(0.8), 0}));
                 },
             .guess = Guess{{0, 1, 2}}});
    three_ways(e.sweeps());
    e.series("speed upwards", "m/s", upwards);
    e.number("rebound speed", "m/s", rebound);
    e.number("tilt of the turning column", "°", [](const Run& run) { return std::round(tilt(run.world)); });

    e.scene({.name = fmt::format("{} columns on each other, dropped", spelled(columns.count)),
             .fill = columns,
             .seconds = 2,
             .pictures = false});
    three_ways(50);
    e.series("out of line", "mm", out_of_line);
    e.number("out of line after 2 s", "mm", [](const Run& run) { return out_of_line(run.world); });

    // The column of the page's table, with m = 1 kg and v = 1 m/s.
    const auto by_hand = [&e](const auto& solver) {
      return row_by_row(on_two_corners(1, {Real(0.25), Real(0.75), Real(0.25)}, 1, {0, -1, 0}), solver, e.dt(), 8);
    };
    e.rows("their sum ≥ 0", [=] { return by_hand(Solver<Clamping>{}); });
    e.rows("each correction ≥ 0", [=] { return by_hand(Solver<ClampingEachCorrection>{}); });

    e.study([&e, &landing] {
      e.panel({.title = "the landing step: distance from the exact velocities",
               .x_label = "sweeps",
               .y_label = "√(|v|² + |ω|²) left, m/s and rad/s",
               .log_y = true,
               .curves = {error_after_sweeps(landing, "no limits", Solver<>{}, 0),
                          error_after_sweeps(landing, "each correction ≥ 0", Solver<ClampingEachCorrection>{}, 1),
                          error_after_sweeps(landing, "their sum ≥ 0", Solver<Clamping>{}, 2)}});
    });
  });
}
