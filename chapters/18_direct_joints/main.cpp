#include "pushback/chapters/14_joints_under_load/split_joints.h"
#include "pushback/chapters/16_whole_problem/study.h"
#include "pushback/chapters/18_direct_joints/chain_study.h"
#include "pushback/chapters/18_direct_joints/iterated.h"
#include "pushback/chapters/18_direct_joints/scenes.h"
#include "pushback/common/experiment/experiment.h"
#include "pushback/common/experiment/marks.h"

using namespace pushback;
using namespace pushback::direct_joints_scenes;
using namespace pushback::whole_problem_scenes;

namespace {

using Swept = Solver<SplitJoints>;    // chapter 14, with warm start
using Direct = Solver<DirectJoints>;  // this chapter

}  // namespace

int main(int argc, char** argv) {
  Experiment e("18_direct_joints", "What does a heavy chain cost, iterated or solved directly?");
  LoadedChain chain;
  e.parameter({"--links", "", "", "Links of the loaded chain", 1, 40}, &chain.links);
  e.parameter({"--mass-ratio", "", "", "Mass of the load, in link masses", 1, 10000}, &chain.load);
  return e.run(argc, argv, [&] {
    e.scene({.name = fmt::format("{} link{}, and {} times the mass of one", spelled(chain.links),
                                 chain.links == 1 ? "" : "s", spelled(chain.load)),
             .fill = chain,
             .camera = {{Real(0.6), -Real(2.3), Real(9.6)}, {0, -Real(2.6), 0}},
             .seconds = 2,
             .instants = {Real(0.5)},
             .caption = "The load should hang where the outline is, and never move. Blue bars: where the chain begins, "
                        "and where the "
                        "load should end.",
             .start_shown = false,
             .marks =
                 [](Picture& picture, const World&, Real) {
                   constexpr Real half = LoadedChain::load_half;
                   add_outline(picture, box(Vec3::Constant(half), 1).at({0, -LoadedChain::length - half, 0}));
                 },
             .cell_height = 560});
    e.variant("joints, 10 sweeps", Swept{}).with_exactly(10).expect("longest", 0);
    e.variant("joints, 100 sweeps", Swept{}).with_exactly(100).expect("longest", 0);
    e.variant("direct joint solve", Direct{}).with_exactly(1).expect("longest", 0);
    e.series("longer than its links by", "%", [chain](const World& world) { return 100 * chain.stretch(world); });
    e.number("longest", "%", [](const Run& run) { return run.largest("longer than its links by"); });
    e.iterations("the chain with its load", [&e, chain] { return iterated(chain, e.dt()); });
    e.iterations("a chain let go at 45°", [&e, links = chain.links] {
      return iterated([links](World& world) { slanting_chain(world, links); }, e.dt());
    });

    e.study([&e] {
      std::vector<Curve> chains;
      for (const int count : {10, 20, 40, 80}) {
        const ChainSolved solved = solve_chain(count, e.dt(), 40000);
        chains.push_back(curve_of(solved.left, fmt::format("{} links", count), chains.size()));
        const int sweeps = first_below(solved.left, 1e-2);
        e.remark(fmt::format(
            "a chain of {} links: below 1 % after {} sweeps, {} row solves; directly, {} numbers in L, {:.0e}", count,
            sweeps, static_cast<std::size_t>(sweeps) * solved.rows, solved.numbers, solved.at_once));
      }
      e.panel({.title = "chains let go at 45°",
               .x_label = "sweeps",
               .y_label = "true error of a link's speed",
               .log_x = true,
               .log_y = true,
               .curves = chains});
    });
  });
}
