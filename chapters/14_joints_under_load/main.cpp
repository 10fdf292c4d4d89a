#include "pushback/chapters/11_substeps/substeps.h"
#include "pushback/chapters/13_joints/study.h"
#include "pushback/chapters/14_joints_under_load/jointed_solver.h"
#include "pushback/chapters/14_joints_under_load/structures.h"
#include "pushback/chapters/14_joints_under_load/study.h"
#include "pushback/common/experiment/experiment.h"
#include "pushback/common/experiment/marks.h"

using namespace pushback;
using namespace pushback::joints_scenes;
using namespace pushback::joints_under_load_scenes;

namespace {

using Warm = Solver<WarmJoints, Clamping, Baumgarte, Slop, Restitution, Friction,
                    WarmStart>;  // also stores the position correction
using Cold = Solver<Joints, Clamping, Baumgarte, Slop, Restitution, Friction, WarmStart>;

Real largest(const Run& run, const std::string& series) {
  const auto& values = run.series.at(series);
  return *std::max_element(values.begin(), values.end());
}
const HangingRope& closed_rope() {
  static const HangingRope closed;
  return closed;
}
/// The largest distance of a particle of the hanging rope from its closed form, m.
Real off_the_catenary(const World& world) {
  const HangingRope& closed = closed_rope();
  Real farthest = 0;
  for (std::size_t i = 0; i < closed.places.size(); ++i)
    farthest = std::max(farthest, (world.bodies[i + 1].position - closed.places[i]).norm());
  return farthest;
}

}  // namespace

int main(int argc, char** argv) {
  Experiment e("14_joints_under_load", "Which part of a joint's impulse may the next step start from?");
  Real beta = Real(0.2);
  e.parameter({"--beta", "β", "", "Fraction of a joint's error removed per step", 0, 1}, &beta);
  int substeps = 10;
  e.parameter({"--substeps", "", "", "Substeps per step, in variants with substeps", 2, 32}, &substeps);
  ChainWithWeight chain;
  e.parameter({"--links", "", "", "Links of the loaded chain", 1, 20}, &chain.links);
  e.parameter({"--mass-ratio", "", "", "Mass of the weight, in link masses", 1, 1000}, &chain.mass_ratio);
  std::vector<int> sweep_counts{1, 2, 5, 10, 20, 50, 100, 200, 500, 1000};
  e.parameter({"--sweep-counts", "", "", "Numbers of sweeps for the diagram", 1, 10000}, &sweep_counts);
  return e.run(argc, argv, [&] {
    const auto in_tens = [&]() -> Variant& {
      return e
          .variant(fmt::format("split impulse, {} substeps of 4", substeps),
                   Substeps(with_joint_beta<JointedSolver>(beta), substeps, 4))
          .with_exactly(4);
    };
    const auto joints_off = [&] {
      e.series("joints off by", "mm", [](const World& world) { return 1000 * largest_joint_error(world); }, true);
      e.number("joints off by up to", "mm", [](const Run& run) { return largest(run, "joints off by"); });
      e.number("off at the end", "mm", [](const Run& run) { return run.series.at("joints off by").back(); });
    };
    const auto stretched = [&] {
      e.number("longest", "%", [](const Run& run) { return largest(run, "stretch"); });
      e.number("at the end", "%", [](const Run& run) { return run.series.at("stretch").back(); });
    };
    const auto stretch = [chain](const World& world) { return 100 * chain.stretch(world); };

    const Real length = static_cast<Real>(chain.links) * link_length, longer = length / 3;
    e.scene({.name = fmt::format("{} link{}, and {} times the mass of one", spelled(chain.links),
                                 chain.links == 1 ? "" : "s", spelled(chain.mass_ratio)),
             .fill = chain,
             .camera = {longer * Vec3(Real(0.6), -Real(2.6), Real(11.5)), {0, -longer * Real(3.15), 0}},
             .seconds = 4,
             .instants = {4},
             .key = "chain",
             .caption =
                 "The weight should hang where the outline is, and never move. Grey bars mark the upper end of the "
                 "chain and the underside of the outline.",
             .start_shown = false,
             .marks =
                 [length](Picture& picture, const World&, Real) {
                   add_line(picture, {Vec3::Zero(), {0, -length, 0}});
                   add_outline(picture, box(Vec3::Constant(weight_half), 1).at({0, -length - weight_half, 0}));
                 },
             .cell_height = 560});
    e.variant("cold", with_joint_beta<Cold>(beta)).with_exactly(10);
    e.variant("warm", with_joint_beta<Warm>(beta)).with_exactly(10);
    e.variant("split impulse", with_joint_beta<JointedSolver>(beta)).with_exactly(10);
    e.series("stretch", "%", stretch);
    stretched();

    e.scene({.name = "the same chain: no feedback, and substeps", .fill = chain, .seconds = 4, .pictures = false});
    e.variant("warm, β = 0", with_joint_beta<Warm>(0)).with_exactly(10);
    e.variant("split impulse, 10 substeps of 1", Substeps(with_joint_beta<JointedSolver>(beta), 10)).with_exactly(1);
    e.series_without_curves("stretch", stretch);
    stretched();

    e.scene({.name = "a suspension bridge, and three boxes",
             .fill = suspension_bridge,
             .camera = {{3, 4, 12}, {0, Real(1.9), 0}, Real(0.46)},
             .seconds = 5,
             .instants = {0, Real(0.7), 2, 5},
             .key = "bridge",
             .caption = "The warm start also keeps the position correction, and the bridge tears under three boxes.",
             .start_shown = false});
    e.variant("warm", with_joint_beta<Warm>(beta)).with_exactly(10);
    e.variant("split impulse", with_joint_beta<JointedSolver>(beta)).with_exactly(10);
    joints_off();

    e.scene({.name = "the same bridge in substeps", .fill = suspension_bridge, .seconds = 5, .pictures = false});
    in_tens();
    joints_off();

    e.scene({.name = "a rope hung at both ends",
             .fill = hanging_rope,
             .camera = {{rope_x, Real(2.1), 8}, {rope_x, Real(1.75), 0}, Real(0.295)},
             .seconds = 12,
             .instants = {12},
             .contacts = Drawn::nothing,
             .key = "rope",
             .caption = "The rope should come to rest on the thin line, the catenary.",
             .marks =
                 [](Picture& picture, const World&, Real) {
                   const Vec3 front(0, 0, Real(0.06)), half(rope_span / 2, 0, 0), middle(rope_x, rope_y, 0);
                   std::vector<Vec3> line{middle - half + front};
                   for (const Vec3& place : closed_rope().places) line.push_back(place + front);
                   line.push_back(middle + half + front);
                   add_line(picture, line);
                 },
             .cell_height = 440});
    e.variant("cold", with_joint_beta<Cold>(beta)).with_exactly(10).without_curves().expect("off the catenary", 0);
    in_tens().expect("off the catenary", 0);
    joints_off();
    e.number("off the catenary", "mm", [](const Run& run) { return 1000 * off_the_catenary(run.world); });

    e.scene({.name = "a cloth over a ball", .fill = cloth_over_ball, .seconds = 4, .pictures = false});
    in_tens();
    joints_off();

    e.study([=, &e] {
      const auto curve = [](const std::string& name, std::size_t colour) {
        return Curve{name, {}, {}, line_colour(colour), Curve::Style::line_and_points};
      };
      Curve cold = curve("cold", 0), warm = curve("warm", 1), split = curve("split impulse", 2),
            warm_only = curve("warm, β = 0", 3);
      Curve cold_steps = cold, warm_steps = warm_only, split_steps = split;
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
      const auto panel = [&](const std::string& title, const std::string& x, const std::vector<Curve>& curves) {
        e.panel({.title = title,
                 .x_label = x,
                 .y_label = "off its length by up to, %",
                 .log_x = true,
                 .log_y = true,
                 .curves = curves,
                 .floor = Real(1e-6)});
      };
      panel(fmt::format("{} links, 1 s to 4 s: one step", spelled(chain.links)), "sweeps in 1/60 s",
            {cold, warm, warm_only, split});
      panel("the same in substeps", "substeps of one sweep", {cold_steps, warm_steps, split_steps});
    });
  });
}
