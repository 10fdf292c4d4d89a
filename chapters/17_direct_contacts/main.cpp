#include "pushback/chapters/04_slop/slop.h"
#include "pushback/chapters/17_direct_contacts/direct_contacts.h"
#include "pushback/chapters/17_direct_contacts/iterated.h"
#include "pushback/chapters/17_direct_contacts/scenes.h"
#include "pushback/common/experiment/experiment.h"

using namespace pushback;
using namespace pushback::direct_contacts_scenes;

namespace {

using Cold = Solver<Clamping, Baumgarte, Slop, FrictionCone>;
using Direct = Solver<Clamping, Baumgarte, Slop, FrictionCone, DirectContacts>;  // this chapter

}  // namespace

int main(int argc, char** argv) {
  Experiment e("17_direct_contacts", "Can all contacts of a step be solved at once, to rounding?");
  HeavyOnFour pile;
  e.parameter({"--mass-ratio", "", "", "Mass ratio of the upper and lower boxes", 1, 10000}, &pile.ratio);
  return e.run(argc, argv, [&] {
    const std::string heavy = spelled(pile.ratio) + " times heavier on four";
    e.scene({.name = heavy + ", every step from nothing",
             .fill = pile,
             .camera = {{Real(1.6), Real(3.2), Real(10)}, {0, Real(2.3), 0}},
             .seconds = 1,
             .instants = {1},
             .caption = "Thin lines: where the boxes should be. Which solver keeps the heavy box on top from sinking?",
             .start_shown = false,
             .marks = [](Picture& picture, const World&, Real) { HeavyOnFour::mark(picture); },
             .cell_height = 500});
    e.variant("10 sweeps", Cold{}).with_exactly(10).expect("sunk by", 0);
    e.variant("1000 sweeps", Cold{}).with_exactly(1000).expect("sunk by", 0);
    e.variant("direct contact solve", Direct{}).with_exactly(1).expect("sunk by", 0);
    e.series("sunk by", "m", [pile](const World& world) { return pile.height_lost(world); });
    e.number("sunk by", "m", [pile](const Run& run) { return pile.height_lost(run.world); });
    e.iterations(heavy, [&e, pile] { return swept_and_solved(first_step(pile, e.dt())); });

    e.study([&e, heavy, pile] {
      World at_rest;
      pile(at_rest);
      at_rest.begin_step(e.dt());
      const Solution best = solve_best(problem_of(at_rest));
      e.remark(fmt::format(
          "{}, direct contact solve: a relative residual below 1e-12 {} after {} sweeps and {} linear systems", heavy,
          best.residual < 1e-12 ? "is reached" : "is not reached", best.sweeps, best.systems));
    });
  });
}
