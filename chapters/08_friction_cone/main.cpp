#include "pushback/chapters/07_warm_start/full_solver.h"
#include "pushback/chapters/08_friction_cone/scaled_back.h"
#include "pushback/chapters/08_friction_cone/scenes.h"
#include "pushback/common/experiment/experiment.h"
#include "pushback/common/experiment/marks.h"

using namespace pushback;
using namespace pushback::friction_cone_scenes;
using namespace pushback::friction_scenes;

namespace {

template <class AnyFriction>
using With = Solver<Clamping, Baumgarte, Slop, Restitution, AnyFriction, WarmStart>;
using ScaledBack = With<FrictionScaledBack>;
using Cone = With<FrictionCone>;  // this chapter

/// Planks sent off from one place, one every five degrees: where they stop, and how far they came.
struct Wheel {
  Curve from_above, distance;
};
template <class ContactSolver>
Wheel turn_wheel(const std::string& name, std::size_t colour, Real half_length, const Push& push, Real h, int sweeps) {
  const Curve empty{name, {}, {}, line_colour(colour), Curve::Style::line_and_points};
  Wheel wheel{empty, empty};
  for (int degrees = 0; degrees <= 360; degrees += 5) {
    World world;
    world.add(ground().rough(1));
    world.add(plank(half_length, Vec3::Zero(), static_cast<Real>(degrees) * pi / 180, push));
    ContactSolver solver;
    for (int step = 0; step < static_cast<int>(push.long_enough(Real(1.5)) / h); ++step) world.step(solver, h, sweeps);
    const Vec3& stop = world.bodies[1].position;
    wheel.from_above.x.push_back(stop.x());
    wheel.from_above.y.push_back(-stop.z());
    wheel.distance.x.push_back(static_cast<Real>(degrees));
    wheel.distance.y.push_back(std::hypot(stop.x(), stop.z()));
  }
  return wheel;
}
/// What should have become of them.
Wheel closed_form(const Push& push, Real h) {
  const Real r = push.stopping_distance(h);
  Wheel wheel;
  wheel.from_above = {"where they should", {}, {}, "#222222", Curve::Style::dashed};
  wheel.distance = {"v₀²/(2μg) − v₀h/2", {0, 360}, {r, r}, "#222222", Curve::Style::dashed};
  for (int degrees = 0; degrees <= 360; degrees += 3) {
    wheel.from_above.x.push_back(r * std::cos(static_cast<Real>(degrees) * pi / 180));
    wheel.from_above.y.push_back(r * std::sin(static_cast<Real>(degrees) * pi / 180));
  }
  return wheel;
}

/// One contact, solved until nothing changes: degrees by which friction is off, against the direction of the slip.
template <class ContactSolver>
Curve directions(const std::string& name, std::size_t colour, const Push& push) {
  std::vector<std::pair<Real, Real>> found;
  for (int degrees = 0; degrees < 360; ++degrees) {
    Stick stick(static_cast<Real>(degrees) * pi / 180, push);
    ContactSolver solver;
    solver.solve(stick.world, Real(1) / 60, 200);
    const Vec3 slip = stick.slip();
    found.emplace_back(std::atan2(-slip.z(), slip.x()) * 180 / pi, direction_error(slip, stick.friction()));
  }
  std::sort(found.begin(), found.end());  // friction has turned the slip, each by another angle
  Curve curve{name, {}, {}, line_colour(colour), Curve::Style::line};
  for (const auto& [slip, off] : found) {
    curve.x.push_back(slip);
    curve.y.push_back(off);
  }
  return curve;
}
/// The angle between u and K_t^-1 u.
Curve scaled_back_closed_form() {
  Curve curve{"between u and Kₜ⁻¹u", {}, {}, "#222222", Curve::Style::dashed};
  Stick stick(0);
  const Row along(stick.world, stick.contact(), Vec3::UnitX(), 0),
      across(stick.world, stick.contact(), -Vec3::UnitZ(), 0);
  for (int degrees = -180; degrees <= 180; ++degrees) {
    const Real u1 = std::cos(static_cast<Real>(degrees) * pi / 180),
               u2 = std::sin(static_cast<Real>(degrees) * pi / 180);
    const Vec3 u(u1, u2, 0), solved(along.effective_mass * u1, across.effective_mass * u2, 0);  // K_t is diagonal here
    curve.x.push_back(static_cast<Real>(degrees));
    curve.y.push_back(direction_error(u, -solved));
  }
  return curve;
}

/// From above: the circle on which planks should stop, each of them there, and arrows to where they are.
void mark_errors(Picture& picture, const World& world, Real h, const Push& push) {
  const Vec3 above(0, Real(0.3), 0);
  add_ring(picture, Vec3(0, Real(0.01), 0), Vec3::UnitY(), rim + push.stopping_distance(h), near_black_colour(), 1);
  for (int i = 0; i < headings; ++i) {
    Body plank = world.bodies[static_cast<std::size_t>(i) + 1];
    const Vec3 is(plank.position.x(), 0, plank.position.z()), should = stop_of(i, h, push);
    plank.position = should + Vec3(0, plank_height, 0);
    plank.orientation.setIdentity();
    add_outline(picture, plank, near_black_colour(), Real(1.2));
    if (world.time > 0 && (is - should).norm() > plank_height)
      add_arrow(picture, should + above, is + above, linear({222, 0, 92}));
  }
}

/// The worst of what `error` says of each plank.
template <class Error>
Real worst(const World& world, Error error) {
  Real largest = 0;
  for (int i = 0; i < headings; ++i) largest = std::max(largest, std::abs(error(way_of(world, i))));
  return largest;
}

/// Mean over the steps up to `until`, s.
Real mean(const Run& run, const std::string& series, Real until) {
  const std::vector<Real>& values = run.series.at(series);
  const auto count = std::min(values.size(), static_cast<std::size_t>(until / run.dt));
  Real sum = 0;
  for (std::size_t i = 0; i < count; ++i) sum += values[i];
  return count > 0 ? sum / static_cast<Real>(count) : 0;
}

}  // namespace

int main(int argc, char** argv) {
  Experiment e("08_friction_cone", "Does friction know north from east?");
  Real half_length = longest_half;
  e.parameter({"--half-length", "", "m", "Half the length of a plank", 0.05, static_cast<double>(longest_half)},
              &half_length);
  Push push;
  e.parameter({"--mu", "μ", "", "Friction between planks and ground", 0.25, 0.65}, &push.mu);
  e.parameter({"--speed", "v₀", "m/s", "Speed of each plank at the start", 1, 7}, &push.v0);
  return e.run(argc, argv, [&] {
    const Real h = e.dt(), stop = push.stopping_distance(h), sliding = push.long_enough(Real(1.2));
    const std::string off = "friction off its direction by";
    e.scene({.name = "twelve planks, and where they should stop",
             .fill = [=](World& world) { planks(world, half_length, push); },
             .camera = {{0, 30, 4}, {0, 0, Real(0.05)}, Real(0.315) / Real(4.1) * (rim + stop)},
             .seconds = sliding,
             .instants = {sliding},
             .contacts = Drawn::nothing,
             .caption = "Seen from above. All twelve planks should stop on the circle, each in its outline; an arrow "
                        "goes from where a plank should be to where it is.",
             .start_shown = false,
             .marks = [=](Picture& picture, const World& world, Real) { mark_errors(picture, world, h, push); },
             .cell_height = 500,
             .guess = Guess{{0, 1, 2}}});
    const auto should = [](Variant& variant) {
      variant.expect("distance off by up to", 0).expect("aside by up to", 0).expect("direction off by", 0);
    };
    should(e.variant("pyramid", FullSolver{}));
    should(e.variant("scaled back", ScaledBack{}));
    should(e.variant("cone", Cone{}));
    e.series(off, "degrees", [h](const World& world) { return largest_direction_error(world, h); });
    e.number("distance off by up to", "%", [stop](const Run& run) {
      return 100 * worst(run.world, [stop](const Way& way) { return std::hypot(way.ahead, way.aside) / stop - 1; });
    });
    e.number("aside by up to", "mm",
             [](const Run& run) { return 1000 * worst(run.world, [](const Way& way) { return way.aside; }); });
    e.number("direction off by", "°", [off, until = sliding / 2](const Run& run) { return mean(run, off, until); });

    e.study([&e, half_length, push, stop, h] {
      const Real shown = std::ceil(12 * stop) / 10;
      Panel above{.title = "where planks stop, seen from above",
                  .x_label = "along t₁, m",
                  .y_label = "along t₂, m",
                  .x_range = {-shown, shown},
                  .y_range = {-shown, shown},
                  .equal_units = true};
      Panel distance{.title = "how far planks come",
                     .x_label = "heading, degrees",
                     .y_label = "distance, m",
                     .x_range = {0, 360},
                     .y_range = {stop / 2, shown},
                     .extra = "set xtics 90"};
      for (Wheel& w :
           std::vector<Wheel>{turn_wheel<FullSolver>("pyramid", 0, half_length, push, h, e.sweeps()),
                              turn_wheel<ScaledBack>("scaled back", 1, half_length, push, h, e.sweeps()),
                              turn_wheel<Cone>("cone", 2, half_length, push, h, e.sweeps()), closed_form(push, h)}) {
        above.curves.push_back(std::move(w.from_above));
        distance.curves.push_back(std::move(w.distance));
      }
      e.panel(above);
      e.panel(distance);
      e.panel({.title = "one contact: a stick on its foot",
               .x_label = "direction of the slip, degrees; 0: where the stick leans",
               .y_label = "friction off its direction by, degrees",
               .curves = {directions<FullSolver>("pyramid", 0, push), directions<ScaledBack>("scaled back", 1, push),
                          directions<Cone>("cone", 2, push), scaled_back_closed_form()},
               .x_range = {0, 180},
               .y_range = {-1, 50},
               .extra = "set xtics 45"});
    });
  });
}
