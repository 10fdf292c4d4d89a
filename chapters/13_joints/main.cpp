#include "pushback/chapters/14_joints_under_load/jointed_solver.h"
#include "pushback/chapters/13_joints/scenes.h"
#include "pushback/chapters/14_joints_under_load/structures.h"
#include "pushback/chapters/14_joints_under_load/study.h"
#include "pushback/common/experiment/experiment.h"

using namespace pushback;

namespace {

using Rigid = Solver<WarmJoints>;                                                              // where nothing touches
using Warm = Solver<WarmJoints, Clamping, Baumgarte, Slop, Restitution, Friction, WarmStart>;  // remembers the push too
using Cold = Solver<Joints, Clamping, Baumgarte, Slop, Restitution, Friction, WarmStart>;

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
/// How far the rope that hangs is from its closed form, m: the farthest of its particles.
Real off_the_catenary(const World& world) {
  static const HangingRope closed;
  Real farthest = 0;
  for (std::size_t i = 0; i < closed.places.size(); ++i)
    farthest = std::max(farthest, (world.bodies[i + 1].position - closed.places[i]).norm());
  return farthest;
}

}  // namespace

int main(int argc, char** argv) {
  Experiment e("13_joints", "How does one row hold a bead, a door, a bridge?");
  Real beta = Real(0.2);
  e.parameter({"--beta", "β", "", "What a step of --dt takes away of a joint's error", 0, 1}, &beta);
  int substeps = 10;
  e.parameter({"--substeps", "", "", "Small steps in each step, where a variant has them", 2, 32}, &substeps);
  Pendulums pendulums;
  e.parameter({"--release", "θ₀", "rad", "From where the pendulums are let go; 0: hanging down", 0.1, 2.2},
              &pendulums.released_at);
  ChainWithWeight chain;
  e.parameter({"--links", "", "", "Links of the chain with the weight", 1, 20}, &chain.links);
  e.parameter({"--mass-ratio", "", "", "Mass of that weight, in masses of a link", 1, 1000}, &chain.mass_ratio);
  std::vector<int> sweep_counts{1, 2, 5, 10, 20, 50, 100, 200, 500, 1000};
  e.parameter({"--sweep-counts", "", "", "Numbers of sweeps for the diagram of the chain", 1, 10000}, &sweep_counts);
  return e.run(argc, argv, [&] {
    const std::string in_one = fmt::format("one step, β = {:.3g}", beta),
                      in_small = fmt::format("{} small steps, β = {:.3g}", substeps, beta);
    const auto joints_off = [&](const std::string& unit) {
      e.series("joints off by", unit, [](const World& world) { return 1000 * largest_joint_error(world); }, true);
      e.number("joints off by up to", unit, [](const Run& run) { return largest(run, "joints off by"); });
      e.number("off at the end", unit, [](const Run& run) { return run.series.at("joints off by").back(); });
    };
    const auto one = [&] { e.variant(in_one, with_joint_beta<JointedSolver>(beta)).with_exactly(10); };
    const auto small = [&]() -> Variant& {
      return e.variant(in_small, with_joint_beta<JointedSolver>(beta)).in_substeps(substeps).with_exactly(4);
    };

    e.scene({.name = "beads on wires",
             .fill = beads_on_wires,
             .camera = {{Real(0.25), Real(0.4), Real(8.8)}, {Real(0.25), Real(0.1), 0}},
             .seconds = 5,
             .instants = {0, 2, 5}});
    e.variant("β = 0", with_joint_beta<Rigid>(0)).with_exactly(1);
    if (beta > 0) e.variant(fmt::format("β = {:.3g}", beta), with_joint_beta<Rigid>(beta)).with_exactly(1);
    e.series("off the wires", "mm", [](const World& world) { return 1000 * largest_joint_error(world); });
    e.series("energy of the beads", "J",
             [](const World& world) { return kinetic_energy(world) + potential_energy(world); });
    e.number("off a wire by up to", "mm", [](const Run& run) { return largest(run, "off the wires"); });
    e.number("energy lost in all", "J",
             [](const Run& run) { return energy_at_first(beads_on_wires) - total_energy(run.samples.back()); });
    e.number("most won in a step", "J", [](const Run& run) {
      Real before = energy_at_first(beads_on_wires), most = -std::numeric_limits<Real>::infinity();
      for (const Sample& sample : run.samples) {
        most = std::max(most, total_energy(sample) - before);
        before = total_energy(sample);
      }
      return most;
    });

    e.scene({.name = "a ball on a rod, a plank on a hinge",
             .fill = pendulums,
             .camera = {{0, -Real(0.3), Real(7.6)}, {0, -Real(0.7), 0}},
             .seconds = 6,
             .instants = {0, Real(0.4), Real(0.8)}});
    const Real ball_period = pendulums.period(rod_length), plank_period = pendulums.period(length_of_plank());
    e.variant(in_one, with_joint_beta<Rigid>(beta))
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
             .camera = {{Real(1.5), Real(2.6), 7}, {Real(0.2), 1, 0}},
             .seconds = Real(2.5),
             .instants = {0, Real(0.5), 2}});
    one();
    joints_off("mm, mrad");

    const Real longer = static_cast<Real>(chain.links) / 10;
    e.scene({.name = fmt::format("{} link{}, and {} times the mass of one", spelled(chain.links),
                                 chain.links == 1 ? "" : "s", spelled(chain.mass_ratio)),
             .fill = chain,
             .camera = {longer * Vec3(Real(0.6), -2, 12), {0, -longer * Real(2.7), 0}},
             .seconds = 4,
             .instants = {0, 1, 4}});
    e.variant(fmt::format("cold, 10 sweeps, β = {:.3g}", beta), with_joint_beta<Cold>(beta)).with_exactly(10);
    e.variant(fmt::format("warm, 10 sweeps, β = {:.3g}", beta), with_joint_beta<Warm>(beta)).with_exactly(10);
    if (beta > 0) e.variant("warm, 10 sweeps, β = 0", with_joint_beta<Warm>(0)).with_exactly(10);
    e.variant(fmt::format("push apart, 10 sweeps, β = {:.3g}", beta), with_joint_beta<JointedSolver>(beta))
        .with_exactly(10);
    e.variant(fmt::format("push apart, 10 small steps of 1, β = {:.3g}", beta), with_joint_beta<JointedSolver>(beta))
        .in_substeps(10)
        .with_exactly(1);
    e.series("stretch", "%", [chain](const World& world) { return 100 * chain.stretch(world); });
    e.number("longest", "%", [](const Run& run) { return largest(run, "stretch"); });
    e.number("at the end", "%", [](const Run& run) { return run.series.at("stretch").back(); });

    e.scene({.name = "a suspension bridge, and three boxes",
             .fill = suspension_bridge,
             .camera = {{4, 5, 12}, {0, Real(2.1), 0}},
             .seconds = 5,
             .instants = {0, Real(0.7), 5}});
    e.variant(fmt::format("one step, β = {:.3g}, the push remembered", beta), with_joint_beta<Warm>(beta))
        .with_exactly(10);
    one();
    small();
    joints_off("mm");

    e.scene({.name = "a rope hung at both ends, a rope over a bar",
             .fill = ropes,
             .camera = {{1, Real(2.4), 8}, {Real(0.2), Real(1.25), 0}},
             .seconds = 12,
             .instants = {0, Real(0.4), 12}});
    small().expect("off the catenary", 0);
    joints_off("mm");
    e.number("off the catenary", "mm", [](const Run& run) { return 1000 * off_the_catenary(run.world); });

    e.scene({.name = "a cloth over a ball",
             .fill = cloth_over_ball,
             .camera = {{Real(2.6), Real(2.8), Real(4.2)}, {0, Real(0.65), 0}},
             .seconds = 4,
             .instants = {0, Real(0.5), 4}});
    small();
    joints_off("mm");

    e.study([=, &e] {
      const auto curve = [](const std::string& name, std::size_t colour) {
        return Curve{name, {}, {}, line_colour(colour), Curve::Style::line_and_points};
      };
      const auto add = [](Curve& to, Real x, Real y) {
        to.x.push_back(x);
        to.y.push_back(y);
      };
      Curve ball = curve("ball on a rod", 0), plank = curve("plank on a hinge", 1);
      Curve drifting = curve("β = 0", 0), fed_back = curve(fmt::format("β = {:.3g}", beta), 1);
      for (const int rate : {30, 60, 120, 240, 480, 960}) {
        const Real steps = static_cast<Real>(rate), h = 1 / steps;
        const Periods periods = measured_periods(h, beta, pendulums);
        add(ball, steps, 100 * std::abs(periods.ball / ball_period - 1));
        add(plank, steps, 100 * std::abs(periods.plank / plank_period - 1));
        add(drifting, steps, 1000 * farthest_off_the_wires(h, 0));
        add(fed_back, steps, 1000 * farthest_off_the_wires(h, beta));
      }
      const auto panel = [&](const std::string& title, const std::string& x, const std::string& y,
                             const std::vector<Curve>& curves) {
        e.panel({.title = title, .x_label = x, .y_label = y, .log_x = true, .log_y = true, .curves = curves});
      };
      panel("pendulums", "steps in a second", "error of the period, %", {ball, plank});
      panel("beads on wires", "steps in a second", "off a wire by up to, mm", {drifting, fed_back});

      Curve cold = curve("cold", 0), warm = curve("warm", 1), warm_only = curve("warm, β = 0", 2),
            cold_steps = curve("cold, small steps", 3), warm_steps = curve("warm, small steps, β = 0", 4),
            apart = curve("push apart", 5), apart_steps = curve("push apart, small steps", 6);
      for (const int sweeps : sweep_counts) {
        const auto with = [&](Curve& to, auto solver, int steps, int sweeps_in_each) {
          add(to, static_cast<Real>(sweeps),
              std::max(100 * worst_of_chain(chain, solver, e.dt(), steps, sweeps_in_each), Real(1e-6)));
        };
        with(cold, with_joint_beta<Cold>(beta), 1, sweeps);
        with(warm, with_joint_beta<Warm>(beta), 1, sweeps);
        with(warm_only, with_joint_beta<Warm>(0), 1, sweeps);
        with(apart, with_joint_beta<JointedSolver>(beta), 1, sweeps);
        if (sweeps > 100) continue;
        with(cold_steps, with_joint_beta<Cold>(beta), sweeps, 1);
        with(warm_steps, with_joint_beta<Warm>(0), sweeps, 1);
        with(apart_steps, with_joint_beta<JointedSolver>(beta), sweeps, 1);
      }
      panel(fmt::format("{} links and a weight, 1 s to 4 s", spelled(chain.links)),
            "sweeps in 1/60 s, or small steps of 1", "off its length by up to, %",
            {cold, warm, warm_only, apart, cold_steps, warm_steps, apart_steps});
    });
  });
}
