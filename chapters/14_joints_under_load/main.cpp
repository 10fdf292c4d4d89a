#include "pushback/chapters/13_joints/study.h"
#include "pushback/chapters/14_joints_under_load/jointed_solver.h"
#include "pushback/chapters/14_joints_under_load/structures.h"
#include "pushback/chapters/14_joints_under_load/study.h"
#include "pushback/common/experiment/experiment.h"

using namespace pushback;
using namespace pushback::joints_scenes;
using namespace pushback::joints_under_load_scenes;

namespace {

using Warm = Solver<WarmJoints, Clamping, Baumgarte, Slop, Restitution, Friction,
                    WarmStart>;  // remembers the position correction too
using Cold = Solver<Joints, Clamping, Baumgarte, Slop, Restitution, Friction, WarmStart>;

Real largest(const Run& run, const std::string& series) {
  const auto& values = run.series.at(series);
  return *std::max_element(values.begin(), values.end());
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
  Experiment e("14_joints_under_load", "Which part of a joint's impulse may the next step start from?");
  Real beta = Real(0.2);
  e.parameter({"--beta", "β", "", "What a step of --dt takes away of a joint's error", 0, 1}, &beta);
  int substeps = 10;
  e.parameter({"--substeps", "", "", "Substeps in each step, where a variant has them", 2, 32}, &substeps);
  ChainWithWeight chain;
  e.parameter({"--links", "", "", "Links of the chain with the weight", 1, 20}, &chain.links);
  e.parameter({"--mass-ratio", "", "", "Mass of that weight, in masses of a link", 1, 1000}, &chain.mass_ratio);
  std::vector<int> sweep_counts{1, 2, 5, 10, 20, 50, 100, 200, 500, 1000};
  e.parameter({"--sweep-counts", "", "", "Numbers of sweeps for the diagram of the chain", 1, 10000}, &sweep_counts);
  return e.run(argc, argv, [&] {
    const std::string in_one = fmt::format("one step, β = {:.3g}", beta),
                      in_substeps = fmt::format("{} substeps, β = {:.3g}", substeps, beta);
    const auto joints_off = [&] {
      e.series("joints off by", "mm", [](const World& world) { return 1000 * largest_joint_error(world); }, true);
      e.number("joints off by up to", "mm", [](const Run& run) { return largest(run, "joints off by"); });
      e.number("off at the end", "mm", [](const Run& run) { return run.series.at("joints off by").back(); });
    };
    const auto one = [&] { e.variant(in_one, with_joint_beta<JointedSolver>(beta)).with_exactly(10); };
    const auto many = [&]() -> Variant& {
      return e.variant(in_substeps, with_joint_beta<JointedSolver>(beta)).in_substeps(substeps).with_exactly(4);
    };

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
    e.variant(fmt::format("split impulse, 10 sweeps, β = {:.3g}", beta), with_joint_beta<JointedSolver>(beta))
        .with_exactly(10);
    e.variant(fmt::format("split impulse, 10 substeps of 1, β = {:.3g}", beta), with_joint_beta<JointedSolver>(beta))
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
    e.variant(fmt::format("one step, β = {:.3g}, the position correction remembered", beta),
              with_joint_beta<Warm>(beta))
        .with_exactly(10);
    one();
    many();
    joints_off();

    e.scene({.name = "a rope hung at both ends, a rope over a bar",
             .fill = ropes,
             .camera = {{1, Real(2.4), 8}, {Real(0.2), Real(1.25), 0}},
             .seconds = 12,
             .instants = {0, Real(0.4), 12}});
    many().expect("off the catenary", 0);
    joints_off();
    e.number("off the catenary", "mm", [](const Run& run) { return 1000 * off_the_catenary(run.world); });

    e.scene({.name = "a cloth over a ball",
             .fill = cloth_over_ball,
             .camera = {{Real(2.6), Real(2.8), Real(4.2)}, {0, Real(0.65), 0}},
             .seconds = 4,
             .instants = {0, Real(0.5), 4}});
    many();
    joints_off();

    e.study([=, &e] {
      const auto curve = [](const std::string& name, std::size_t colour) {
        return Curve{name, {}, {}, line_colour(colour), Curve::Style::line_and_points};
      };
      Curve cold = curve("cold", 0), warm = curve("warm", 1), warm_only = curve("warm, β = 0", 2),
            cold_steps = curve("cold, substeps", 3), warm_steps = curve("warm, substeps, β = 0", 4),
            split = curve("split impulse", 5), split_steps = curve("split impulse, substeps", 6);
      for (const int sweeps : sweep_counts) {
        const auto with = [&](Curve& to, auto solver, int steps, int sweeps_in_each) {
          to.x.push_back(static_cast<Real>(sweeps));
          to.y.push_back(std::max(100 * worst_of_chain(chain, solver, e.dt(), steps, sweeps_in_each), Real(1e-6)));
        };
        with(cold, with_joint_beta<Cold>(beta), 1, sweeps);
        with(warm, with_joint_beta<Warm>(beta), 1, sweeps);
        with(warm_only, with_joint_beta<Warm>(0), 1, sweeps);
        with(split, with_joint_beta<JointedSolver>(beta), 1, sweeps);
        if (sweeps > 100) continue;
        with(cold_steps, with_joint_beta<Cold>(beta), sweeps, 1);
        with(warm_steps, with_joint_beta<Warm>(0), sweeps, 1);
        with(split_steps, with_joint_beta<JointedSolver>(beta), sweeps, 1);
      }
      e.panel({.title = fmt::format("{} links and a weight, 1 s to 4 s", spelled(chain.links)),
               .x_label = "sweeps in 1/60 s, or substeps of 1",
               .y_label = "off its length by up to, %",
               .log_x = true,
               .log_y = true,
               .curves = {cold, warm, warm_only, split, cold_steps, warm_steps, split_steps}});
    });
  });
}
