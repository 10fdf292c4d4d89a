#include "pushback/chapters/04_slop/slop.h"
#include "pushback/chapters/14_joints_under_load/split_joints.h"
#include "pushback/chapters/18_direct_joints/chain_study.h"
#include "pushback/chapters/17_direct_contacts/direct_contacts.h"
#include "pushback/chapters/16_whole_problem/scenes.h"
#include "pushback/chapters/16_whole_problem/study.h"
#include "pushback/common/experiment/experiment.h"

using namespace pushback;

namespace {

using Cold = Solver<Clamping, Baumgarte, Slop, FrictionCone>;
using AtOnce = Solver<Clamping, Baumgarte, Slop, FrictionCone, DirectContacts>;  // this chapter

using SweptJoints = Solver<SplitJoints>;    // chapter 13's best, warm
using JointsAtOnce = Solver<DirectJoints>;  // this chapter

using Fill = std::function<void(World&)>;

}  // namespace

int main(int argc, char** argv) {
  Experiment e("16_whole_problem", "Sweep, or solve all at once?");
  StackInGate gate;
  e.parameter({"--boxes", "n", "", "Boxes of the stack", 1, 30}, &gate.boxes);
  LoadedChain chain;
  e.parameter({"--links", "", "", "Links of the chain with the load", 1, 40}, &chain.links);
  e.parameter({"--mass-ratio", "", "", "Mass of the load, in masses of a link; and of a box on four others", 1, 10000},
              &chain.load);
  return e.run(argc, argv, [&] {
    const std::string tall = "a stack of " + spelled(gate.boxes), times_the_mass = spelled(chain.load) + " times";
    const Real top = static_cast<Real>(gate.boxes);
    e.scene({.name = tall + ", every step from nothing",
             .fill = gate,
             .camera = {{0, top - Real(2.5), 11}, {0, top - Real(2.1), 0}},
             .seconds = 2,
             .instants = {0, Real(0.5), 1, 2}});
    e.variant("10 sweeps", Cold{}).with_exactly(10).expect("the top has sunk by", 0);
    e.variant("100 sweeps", Cold{}).with_exactly(100).expect("the top has sunk by", 0);
    e.variant("all at once", AtOnce{}).with_exactly(1).expect("the top has sunk by", 0);
    e.series("the top has sunk by", "m", [gate](const World& world) { return gate.height_lost_by_top(world); });
    e.number("the top has sunk by", "m", [gate](const Run& run) { return gate.height_lost_by_top(run.world); });

    e.scene({.name = fmt::format("{} link{}, and {} the mass of one", spelled(chain.links), chain.links == 1 ? "" : "s",
                                 times_the_mass),
             .fill = chain,
             .camera = {{Real(0.6), -2, 9}, {0, -Real(2.3), 0}},
             .seconds = 2,
             .instants = {0, Real(0.5), 1, 2}});
    e.variant("joints, 10 sweeps", SweptJoints{}).with_exactly(10).expect("longest", 0);
    e.variant("joints, 100 sweeps", SweptJoints{}).with_exactly(100).expect("longest", 0);
    e.variant("joints at once", JointsAtOnce{}).with_exactly(1).expect("longest", 0);
    e.series("longer than its links by", "%", [chain](const World& world) { return 100 * chain.stretch(world); });
    e.number("longest", "%", [](const Run& run) {
      const auto& stretch = run.series.at("longer than its links by");
      return *std::max_element(stretch.begin(), stretch.end());
    });

    e.study([&e, tall, times_the_mass, boxes = gate.boxes, ratio = chain.load] {
      const std::string upright = "set yrange [*:*] noreverse; set size noratio";  // after the patterns
      const Real h = e.dt();
      for (const auto& [name, fill] : {std::pair{"A of a stack of six", +[](World& world) { stack(world, 6); }},
                                       std::pair{"A of a pyramid of five", +[](World& world) { pyramid(world, 5); }}}) {
        const Snapshot snapshot(fill, h);
        e.panel({.title = name,
                 .x_label = "row",
                 .y_label = "row",
                 .curves = {pattern(matrix_of(snapshot.normals))},
                 .extra = "set yrange [*:*] reverse; set size ratio -1; set pointsize 0.4"});
      }
      const Fill stacked = [boxes](World& world) { stack(world, boxes); };
      const Fill ten_wide = [](World& world) { pyramid(world, 10); };
      const Fill heavy_on_four = [ratio](World& world) {
        stack(world, 4);
        world.add(box(Vec3::Constant(Real(0.5)), 100 * ratio).at({0, Real(4.5), 0}));
      };
      Snapshot at_rest(stacked, h);
      const ContactProblem problem = problem_of(at_rest.world);
      e.panel(
          {.title = tall + ", from nothing",
           .x_label = "sweeps",
           .y_label = "relative residual",
           .log_x = true,
           .log_y = true,
           .curves = {convergence(problem, "pgs", "pyramid", 0), convergence(problem, "scaled-back", "scaled back", 1),
                      convergence(problem, "cone", "cone", 2), convergence(problem, "nscg", "cone, conjugate", 3)},
           .extra = upright});
      const Solution best = solve_best(problem);
      e.remark(fmt::format("{}, all at once: a relative residual below 1e-12 {} after {} sweeps and {} linear systems",
                           tall, best.residual < 1e-12 ? "is reached" : "is not reached", best.sweeps, best.systems));
      for (const auto& [name, fill] : std::vector<std::pair<std::string, Fill>>{
               {tall, stacked}, {"a pyramid of ten", ten_wide}, {times_the_mass + " heavier on four", heavy_on_four}}) {
        const Signs found = signs(Snapshot(fill, h), 30000);
        e.panel(
            {.title = name + ", no friction",
             .x_label = "sweeps",
             .y_label = "relative to its full size",
             .log_x = true,
             .log_y = true,
             .curves = {curve_of(found.correction, "corrective impulse", 0), curve_of(found.speed, "closing speed", 1),
                        curve_of(found.error, "true error of a body's speed", 3)},
             .extra = upright});
        for (const auto& [sign, values] :
             {std::pair{"corrective impulses", &found.correction}, std::pair{"closing speeds", &found.speed}}) {
          const int at = first_below(*values, 1e-2);
          if (at > 0)
            e.remark(fmt::format("{}: {} fall below 1 % after {} sweeps, when a body's speed is wrong by {:.3g} %",
                                 name, sign, at, 100 * found.error[static_cast<std::size_t>(at) - 1]));
        }
        e.remark(fmt::format("{}: after 10 sweeps a body's speed is wrong by {:.3g} %", name, 100 * found.error[9]));
      }
      std::vector<Curve> chains;
      for (const int count : {10, 20, 40, 80}) {
        const ChainSolved solved = solve_chain(count, h, 40000);
        chains.push_back(curve_of(solved.left, fmt::format("{} links", count), chains.size()));
        const int sweeps = first_below(solved.left, 1e-2);
        e.remark(fmt::format(
            "a chain of {} links: below 1 % after {} sweeps, {} row solves; at once, {} numbers in L, {:.0e}", count,
            sweeps, static_cast<std::size_t>(sweeps) * solved.rows, solved.numbers, solved.at_once));
      }
      e.panel({.title = "chains let go at 45°",
               .x_label = "sweeps",
               .y_label = "true error of a link's speed",
               .log_x = true,
               .log_y = true,
               .curves = chains,
               .extra = upright});
    });
  });
}
