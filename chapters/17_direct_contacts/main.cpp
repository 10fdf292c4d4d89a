#include "pushback/chapters/04_slop/slop.h"
#include "pushback/chapters/16_whole_problem/scenes.h"
#include "pushback/chapters/17_direct_contacts/direct_contacts.h"
#include "pushback/common/experiment/experiment.h"

using namespace pushback;
using namespace pushback::whole_problem_scenes;

namespace {

using Cold = Solver<Clamping, Baumgarte, Slop, FrictionCone>;
using Direct = Solver<Clamping, Baumgarte, Slop, FrictionCone, DirectContacts>;  // this chapter

}  // namespace

int main(int argc, char** argv) {
  Experiment e("17_direct_contacts", "Can all contacts of a step be solved at once, to rounding?");
  StackInGate gate;
  e.parameter({"--boxes", "n", "", "Boxes of the stack", 1, 30}, &gate.boxes);
  return e.run(argc, argv, [&] {
    const std::string tall = "a stack of " + spelled(gate.boxes);
    const Real top = static_cast<Real>(gate.boxes);
    e.scene({.name = tall + ", every step from nothing",
             .fill = gate,
             .camera = {{0, top - Real(1.2), Real(7.8)}, {0, top - Real(1.8), 0}},
             .seconds = 2,
             .instants = {2},
             .caption = "Thin lines: where the boxes should be. Which solver holds them there?",
             .start_shown = false,
             .marks = [gate](Picture& picture, const World&, Real) { gate.mark(picture); },
             .cell_height = 500,
             .side_by_side = true});
    e.variant("10 sweeps", Cold{}).with_exactly(10).expect("the top has sunk by", 0);
    e.variant("100 sweeps", Cold{}).with_exactly(100).expect("the top has sunk by", 0);
    e.variant("direct contact solve", Direct{}).with_exactly(1).expect("the top has sunk by", 0);
    e.series("the top has sunk by", "m", [gate](const World& world) { return gate.height_lost_by_top(world); });
    e.number("the top has sunk by", "m", [gate](const Run& run) { return gate.height_lost_by_top(run.world); });

    e.study([&e, tall, boxes = gate.boxes] {
      World at_rest;
      stack(at_rest, boxes);
      at_rest.begin_step(e.dt());
      const Solution best = solve_best(problem_of(at_rest));
      e.remark(fmt::format(
          "{}, direct contact solve: a relative residual below 1e-12 {} after {} sweeps and {} linear systems", tall,
          best.residual < 1e-12 ? "is reached" : "is not reached", best.sweeps, best.systems));
    });
  });
}
