#include "pushback/chapters/07_warm_start/full_solver.h"
#include "pushback/chapters/13_joints/scenes.h"
#include "pushback/chapters/13_joints/study.h"
#include "pushback/common/experiment/experiment.h"

using namespace pushback;
using namespace pushback::joints_scenes;

namespace {

using Rigid = Solver<Joints>;  // for scenes without contacts
using Jointed = Solver<Joints, Clamping, Baumgarte, Slop, Restitution, Friction, WarmStart>;

Real largest(const Run& run, const std::string& series) {
  const auto& values = run.series.at(series);
  return *std::max_element(values.begin(), values.end());
}
Real total_energy(const Sample& sample) {
  return sample.kinetic_energy + sample.potential_energy;
}
Real energy_at_first(const std::function<void(World&)>& fill) {
  World world;
  fill(world);
  return kinetic_energy(world) + potential_energy(world);
}

}  // namespace

int main(int argc, char** argv) {
  Experiment e("13_joints", "How do rows hold a bead on its wire, a door on its hinge?");
  Real beta = Real(0.2);
  e.parameter({"--beta", "β", "", "Fraction of a joint's error removed per step", 0, 1}, &beta);
  Pendulums pendulums;
  e.parameter({"--release", "θ₀", "rad", "Release angle of the pendulums, from hanging down", 0.1, 2.2},
              &pendulums.released_at);
  return e.run(argc, argv, [&] {
    const std::string fed_back = fmt::format("β = {:.3g}", beta);

    e.scene({.name = "beads on wires",
             .fill = beads_on_wires,
             .camera = {{Real(0.05), Real(0.1), Real(8.8)}, {Real(0.05), -Real(0.05), 0}, Real(0.45)},
             .seconds = 5,
             .instants = {0, 2, Real(3.5), 5},
             .key = "beads",
             .caption = "Each bead should stay on its wire.",
             .cell_height = 220});
    e.variant("β = 0", with_joint_beta<Rigid>(0)).with_exactly(1);
    if (beta > 0) e.variant(fed_back, with_joint_beta<Rigid>(beta)).with_exactly(1);
    e.series("off the wires", "mm", [](const World& world) { return 1000 * largest_joint_error(world); });
    e.series("energy of the beads", "J",
             [](const World& world) { return kinetic_energy(world) + potential_energy(world); });
    e.number("off a wire by up to", "mm", [](const Run& run) { return largest(run, "off the wires"); });
    e.number("energy lost in all", "J",
             [](const Run& run) { return energy_at_first(beads_on_wires) - total_energy(run.samples.back()); });
    e.number("largest gain in a step", "J", [](const Run& run) {
      Real before = energy_at_first(beads_on_wires), most = -std::numeric_limits<Real>::infinity();
      for (const Sample& sample : run.samples) {
        most = std::max(most, total_energy(sample) - before);
        before = total_energy(sample);
      }
      return most;
    });

    e.scene({.name = "a ball on a rod, a plank on a hinge", .fill = pendulums, .seconds = 6, .pictures = false});
    const Real ball_period = pendulums.period(rod_length), plank_period = pendulums.period(length_of_plank());
    e.variant(fed_back, with_joint_beta<Rigid>(beta))
        .expect("period of the ball", 1000 * ball_period)
        .expect("of the plank", 1000 * plank_period);
    e.series("angle of the ball", "rad", angle_of_ball);
    e.series("angle of the plank", "rad", angle_of_plank);
    e.number("period of the ball", "ms",
             [](const Run& run) { return 1000 * period_of(run.series.at("angle of the ball"), run.dt); });
    e.number("of the plank", "ms",
             [](const Run& run) { return 1000 * period_of(run.series.at("angle of the plank"), run.dt); });

    e.scene({.name = "a door on a hinge, two boxes welded",
             .fill = door_and_weld,
             .camera = {{-Real(0.1), Real(1.9), 8}, {Real(0.15), Real(1.1), 0}, Real(0.57)},
             .seconds = Real(2.5),
             .instants = {2},
             .contacts = Drawn::nothing,
             .key = "door",
             .caption = "The ball has hit the door. A hinge leaves the door one freedom; a weld leaves the two boxes, "
                        "which have been thrown, none.",
             .cell_height = 400});
    World jointed;
    door_and_weld(jointed);
    e.variant("no joints", with_joint_beta<Jointed>(beta))
        .with_exactly(10)
        .changing([](World& world) { world.joints.clear(); })
        .without_curves();
    e.variant("hinge and weld", with_joint_beta<Jointed>(beta)).with_exactly(10);
    e.series(
        "joints off by", "mm, mrad",
        [joints = jointed.joints](World world) {
          world.joints = joints;  // also for a variant without joints
          return 1000 * largest_joint_error(world);
        },
        true);
    e.number("joints off by up to", "mm, mrad", [](const Run& run) { return largest(run, "joints off by"); });
    e.number("off at the end", "mm, mrad", [](const Run& run) { return run.series.at("joints off by").back(); });

    e.study([=, &e] {
      const auto curve = [](const std::string& name, std::size_t colour) {
        return Curve{name, {}, {}, line_colour(colour), Curve::Style::line_and_points};
      };
      const auto add = [](Curve& to, Real x, Real y) {
        to.x.push_back(x);
        to.y.push_back(y);
      };
      Curve ball = curve("ball on a rod", 0), plank = curve("plank on a hinge", 1);
      Curve drifting = curve("β = 0", 0), held = curve(fed_back, 1);
      for (const int rate : {30, 60, 120, 240, 480, 960}) {
        const Real steps = static_cast<Real>(rate), h = 1 / steps;
        const Periods periods = measured_periods(h, beta, pendulums);
        add(ball, steps, 100 * std::abs(periods.ball / ball_period - 1));
        add(plank, steps, 100 * std::abs(periods.plank / plank_period - 1));
        add(drifting, steps, 1000 * farthest_off_the_wires(h, 0));
        add(held, steps, 1000 * farthest_off_the_wires(h, beta));
      }
      const auto panel = [&](const std::string& title, const std::string& y, const std::vector<Curve>& curves) {
        e.panel({.title = title,
                 .x_label = "steps in a second",
                 .y_label = y,
                 .log_x = true,
                 .log_y = true,
                 .curves = curves});
      };
      panel("pendulums", "error of the period, %", {ball, plank});
      panel("beads on wires", "off a wire by up to, mm", {drifting, held});
    });
  });
}
