/// The film at the top of the project's page: one stack, once forgetting its impulses after each step and once remembering them.
#include "pushback/chapters/07_warm_start/full_solver.h"
#include "pushback/chapters/11_substeps/substeps.h"
#include "pushback/common/experiment/experiment.h"

using namespace pushback;

int main(int argc, char** argv) {
  Experiment e("front_page", "What keeps a stack standing?");
  return e.run(argc, argv, [&] {
    e.scene({.name = "a stack of ten",
             .fill = [](World& world) { stack(world, 10); },
             .camera = {{Real(16), Real(6), Real(8)}, {0, Real(4.7), Real(2.6)}, Real(0.64)},
             .seconds = 8,
             .instants = {8},
             .caption = "The same boxes, the same three sweeps a step: only the right stack remembers its impulses.",
             .cell_height = 560});
    e.variant("impulses forgotten", Substeps(Solver<Clamping, Baumgarte, Slop, Restitution, Friction>{}, 2, 3));
    e.variant("impulses remembered", Substeps(FullSolver{}, 2, 3));
    e.series("height of the top", "m", [](const World& world) { return world.bodies.back().position.y(); });
    e.number("height of the top", "m", [](const Run& run) { return run.world.bodies.back().position.y(); });
    for (const Real t : {Real(2), Real(4), Real(6)})
      e.number(fmt::format("at {:g} s", t), "m", [t](const Run& run) {
        return run.series.at("height of the top").at(static_cast<std::size_t>(t / run.dt) - 1);
      });
  });
}
