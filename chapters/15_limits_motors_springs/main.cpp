#include "pushback/chapters/15_limits_motors_springs/cart.h"
#include "pushback/chapters/15_limits_motors_springs/ragdoll.h"
#include "pushback/chapters/15_limits_motors_springs/scenes.h"
#include "pushback/chapters/15_limits_motors_springs/study.h"
#include "pushback/common/experiment/experiment.h"
#include "pushback/common/experiment/marks.h"

using namespace pushback;
using namespace pushback::limits_motors_springs_scenes;

namespace {

/// A function that adds a joint to the scene.
template <class MakeJoint>
std::function<void(World&)> with(const MakeJoint& joint) {
  return [joint](World& world) { world.joints.push_back(joint(world)); };
}
void without_limits(World& world) {
  std::erase_if(world.joints,
                [](const Joint& joint) { return joint.name.ends_with("limits") || joint.name.ends_with("limit"); });
}

void bar_with_a_stop(Experiment& e, Real stop_at) {
  e.scene({.name = fmt::format("a bar, let go, and a stop at {:.3g}°", stop_at),
           .fill = [stop_at](World& world) { bar_and_stop(world, stop_at); },
           .camera = {{Real(0.3), Real(-0.5), 6}, {0, Real(-0.68), 0}, Real(0.31)},
           .seconds = 3,
           .instants = {Real(1.15)},
           .key = "limit",
           .caption = "The bar may go along the thin line, up to the plate; a stop may push it back, but not hold it.",
           .marks =
               [stop_at](Picture& picture, const World&, Real) {
                 std::vector<Vec3> line;
                 for (int i = 0; i <= 40; ++i) {
                   const Real angle = bar_lifted + (stop_at * pi / 180 - bar_lifted) * static_cast<Real>(i) / 40;
                   line.push_back(2 * bar_half * Vec3(std::sin(angle), -std::cos(angle), 0));
                 }
                 add_line(picture, line);
                 add_line(picture, {Vec3::Zero(), line.back()});
               },
           .in_brief = {{0, 1}}});
  e.variant("no limit", JointedSolver{});
  const auto stop = [stop_at](const World& world) { return stop_of_bar(world, stop_at); };
  const auto sucking = [stop_at](const World& world) { return stop_that_sucks(world, stop_at); };
  e.variant("limit, λ ≥ 0", JointedSolver{}).changing(with(stop)).expect("beyond the stop", 0);
  e.variant("the same without λ ≥ 0", JointedSolver{}).changing(with(sucking)).expect("beyond the stop", 0);
  e.series("angle of the bar", "degrees", angle_of_bar);
  e.number("beyond the stop", "°",
           [stop_at](const Run& run) { return std::max(Real(0), run.largest("angle of the bar") - stop_at); });
  e.number("angle at the end", "°", [](const Run& run) { return run.series.at("angle of the bar").back(); });
}

void pointers_that_follow(Experiment& e, Real torque, Real h) {
  e.scene({.name = fmt::format("θ = sin t, with {:.3g} N m", torque),
           .fill = [torque](World& world) { pointers(world, torque); },
           .camera = {{Real(0.3), Real(0.2), 6}, {0, 0, 0}, Real(0.33)},
           .seconds = 2 * pi,
           .instants = {Real(1.6), Real(3.2), Real(4.7)},
           .key = "motor",
           .caption = "The thin bar behind is where the thick one should be; the motor of the heavy one is too weak."});
  for (const Real mass : {light_pointer, heavy_pointer}) {
    Variant& variant =
        e.variant(fmt::format("{:.3g} kg m²: needs {:.3g} N m", inertia_of_pointer(mass), inertia_of_pointer(mass)),
                  JointedSolver{})
            .changing([mass](World& world) { weigh_pointer(world, mass); });
    if (inertia_of_pointer(mass) <= torque) variant.expect("off by up to, after 1 s", 0);
    variant.reference("sin t", [](Real t) { return std::sin(t); });
  }
  e.series("angle", "rad", angle_of_pointer);
  e.number("off by up to, after 1 s", "mrad", [h](const Run& run) {
    Real worst = 0;
    const auto& angle = run.series.at("angle");
    for (std::size_t i = 0; i < angle.size(); ++i) {
      const Real t = static_cast<Real>(i + 1) * h;
      if (t > 1) worst = std::max(worst, 1000 * std::abs(angle[i] - std::sin(t)));
    }
    return worst;
  });
}

void winches_lift(Experiment& e, const TwoWinches& winches) {
  e.scene({.name = "two winches, each 2 rad/s with 5 N m", .fill = winches, .seconds = Real(1.5), .pictures = false});
  const Real sinking = winches.acceleration(), load = winches.heavy_load;
  e.variant(fmt::format("1.5 kg (3.7 N m), {:.2g} kg ({:.2g} N m)", load, load * World::g * winch_radius),
            JointedSolver{})
      .expect("speed of the light load", winch_speed * winch_radius)
      .expect("acceleration of the heavy one", sinking);
  e.series_without_curves("speed of the heavy load", [](const World& world) { return world.bodies[3].velocity.y(); });
  e.number("speed of the light load", "m/s", [](const Run& run) { return run.world.bodies[1].velocity.y(); });
  e.number("acceleration of the heavy one", "m/s²",
           [](const Run& run) { return run.world.bodies[3].velocity.y() / run.samples.back().time; });
}

void pulleys_turn(Experiment& e, const TwoPulleys& pulleys) {
  e.scene({.name = "two pulleys: one radius, and two radii", .fill = pulleys, .seconds = Real(0.8), .pictures = false});
  const Real atwood = pulleys.acceleration_of_atwood();
  const std::string heavy = fmt::format("the {:.3g} kg", pulleys.heavy);
  e.variant(fmt::format("2 kg and {:.3g} kg on each", pulleys.heavy), JointedSolver{})
      .expect("acceleration of " + heavy, atwood)
      .expect("of the 2 kg at 0.4 m", pulleys.acceleration_of_stepped());
  e.series_without_curves("speed of " + heavy, [](const World& world) { return -world.bodies[2].velocity.y(); });
  const auto downwards = [](std::size_t body) {
    return [body](const Run& run) { return -run.world.bodies[body].velocity.y() / run.samples.back().time; };
  };
  e.number("acceleration of " + heavy, "m/s²", downwards(2));
  e.number("of the 2 kg at 0.4 m", "m/s²", downwards(5));
}

std::string of_hertz(const SpringsLetGo& springs) {
  return fmt::format("of {:.3g} Hz", springs.hertz);
}

void springs_swing(Experiment& e, const SpringsLetGo& springs) {
  const std::vector<Real>& ratios = springs.damping_ratios;
  e.scene({.name = fmt::format("{} spring{} {}: ζ = {}", spelled(static_cast<double>(ratios.size())),
                               ratios.size() == 1 ? "" : "s", of_hertz(springs), fmt::join(ratios, ", ")),
           .fill = springs,
           .seconds = 3,
           .pictures = false});
  e.variant("let go 0.6 m below", JointedSolver{});
  e.series_without_curves("below its place", [springs](const World& world) { return springs.below(world, 0); });
  for (std::size_t i = 0; i < ratios.size(); ++i) {
    e.number(fmt::format("off the closed form, ζ = {}", ratios[i]), "mm", [springs, i](const Run& run) {
      return 1000 * std::abs(springs.below(run.world, i) - springs.closed_form(i, run.samples.back().time));
    });
  }
}

void cart_climbs(Experiment& e, Real slope_degrees) {
  const Real slope = slope_degrees * pi / 180;
  e.scene({.name = fmt::format("a cart on a slope of {:.3g}°", slope_degrees),
           .fill =
               [slope](World& world) {
                 incline(world, slope, 1);
                 add_cart(world, slope, 0);
               },
           .seconds = Real(2.5),
           .pictures = false});
  const Cart cart{1, {2, 3, 4}};
  for (const Real each : {Real(4), Real(7)}) {
    e.variant(fmt::format("three motors of {} N m", each), JointedSolver{})
        .changing([=](World& world) { drive(world, cart, cart_speed, each); })
        .reference(each == 4 ? "closed form" : "", [=](Real t) { return acceleration_of_cart(slope, each) * t; })
        .expect("acceleration", acceleration_of_cart(slope, each));
  }
  e.series("speed up the slope", "m/s", [cart, slope](const World& world) {
    const Body& chassis = body_of(world, cart.chassis);
    return chassis.velocity.dot(Vec3(std::cos(slope), std::sin(slope), 0));
  });
  e.number("acceleration", "m/s²", [](const Run& run) {
    const auto& speeds = run.series.at("speed up the slope");
    const std::size_t second = std::min(speeds.size(), static_cast<std::size_t>(std::lround(1 / run.dt)));
    return speeds[second - 1] / (static_cast<Real>(second) * run.dt);
  });
}

void ragdoll_on_a_bench(Experiment& e) {
  e.scene({.name = "face down on a bench",
           .fill = [](World& world) { face_down_on_a_bench(world); },
           .camera = {{Real(1.4), Real(1.25), 5}, {Real(0.02), Real(0.58), 0}, Real(0.285)},
           .seconds = 2,
           .instants = {2},
           .contacts = Drawn::nothing,
           .key = "ragdoll",
           .caption = "The bench ends at the knees, and a knee cannot bend this way: the shins should stay up. "
                      "Without limits they hang.",
           .cell_height = 340});
  e.variant("no limits", JointedSolver{}).changing(without_limits);
  e.variant("limits", JointedSolver{});
  World lying;
  const Ragdoll lies = face_down_on_a_bench(lying);
  e.series_without_curves("wrong way", [lies](const World& world) { return bent_backwards(world, lies) * 180 / pi; });
  e.number("knee or elbow, the wrong way", "°", [](const Run& run) { return run.largest("wrong way"); });
}

void ragdoll_on_stairs(Experiment& e) {
  World probe;
  const Ragdoll man = down_the_stairs(probe);
  e.scene({.name = "down the stairs",
           .fill = [](World& world) { down_the_stairs(world); },
           .seconds = 3,
           .pictures = false,
           .key = "stairs"});
  e.variant("no limits", JointedSolver{}).changing(without_limits);
  e.variant("limits", JointedSolver{});
  e.series("knee or elbow, the wrong way", "degrees",
           [man](const World& world) { return bent_backwards(world, man) * 180 / pi; });
  e.number("knee or elbow, the wrong way", "°",
           [](const Run& run) { return run.largest("knee or elbow, the wrong way"); });
}

void study_of_steps(Experiment& e, const SpringsLetGo& springs, Real pump, Real h) {
  e.study([&e, springs, pump, h] {
    const std::string title = "springs " + of_hertz(springs);
    const WorkAndEnergy winch = work_of_winch(h);
    const auto panel = [&](const std::string& named, const std::string& y, const std::vector<Curve>& curves) {
      e.panel({.title = named, .x_label = "time, s", .y_label = y, .curves = curves});
    };
    panel("a wheel, 2 rad/s with 5 N m", "ω, rad/s", reaching_a_speed(h));
    panel(title, "below its place, m", springs_in_time(springs, h));
    e.panel({.title = title + ", after 1 s",
             .x_label = "step, s",
             .y_label = "off the closed form, m",
             .log_x = true,
             .log_y = true,
             .curves = springs_by_step(springs)});
    panel("a swing, pumped and not", "degrees", swings(h, pump));
    e.remark(fmt::format("the winch: work of the motor {:.6g} J, energy gained {:.6g} J", winch.work, winch.energy));
    for (const auto& [substeps, sweeps] : {std::pair(1, 10), std::pair(1, 30), std::pair(8, 2), std::pair(32, 1)}) {
      e.remark(fmt::format("the ragdoll, {} in 1/{:.0f} s with {}: stretched by up to {:.2g} %",
                           substeps == 1 ? "one step" : fmt::format("{} substeps", substeps), 1 / h,
                           sweeps == 1 ? "one sweep" : fmt::format("{} sweeps", sweeps),
                           100 * stretch_on_stairs(h, substeps, sweeps)));
    }
  });
}

}  // namespace

int main(int argc, char** argv) {
  Experiment e("15_limits_motors_springs", "How far may it turn, and who turns it?");
  Real torque = follow_torque;
  e.parameter({"--torque", "", "N m", "Torque limit of the motor following sin t", 0, 1000}, &torque);
  Real stop_at = bar_stop;
  e.parameter({"--stop", "", "°", "Angle of the bar's stop, from hanging down", -60, 60}, &stop_at);
  TwoWinches winches;
  e.parameter({"--load", "m", "kg", "Mass of the heavy load", 2.1, 10}, &winches.heavy_load);
  TwoPulleys pulleys;
  e.parameter({"--heavy", "", "kg", "Mass of the heavier load on each pulley", 2.1, 4}, &pulleys.heavy);
  SpringsLetGo springs;
  e.parameter({"--hertz", "", "Hz", "Frequency of the springs", 0.2, 5}, &springs.hertz);
  e.parameter({"--damping-ratio", "ζ", "", "Damping ratios of the springs, one each", 0, 20}, &springs.damping_ratios);
  Real incline_by = cart_slope;
  e.parameter({"--slope", "", "°", "Angle of the slope under the cart", 8, 30}, &incline_by);
  Real pump = Real(0.05);
  e.parameter({"--pump", "ε", "", "Relative change of the swing's length", 0, 0.08}, &pump);
  return e.run(argc, argv, [&] {
    bar_with_a_stop(e, stop_at);
    pointers_that_follow(e, torque, e.dt());
    winches_lift(e, winches);
    pulleys_turn(e, pulleys);
    springs_swing(e, springs);
    cart_climbs(e, incline_by);
    ragdoll_on_a_bench(e);
    ragdoll_on_stairs(e);
    study_of_steps(e, springs, pump, e.dt());
  });
}
