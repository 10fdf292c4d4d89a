#include "pushback/chapters/04_slop/slop.h"
#include "pushback/chapters/08_friction_cone/friction_cone.h"
#include "pushback/chapters/16_whole_problem/iterated.h"
#include "pushback/chapters/16_whole_problem/scenes.h"
#include "pushback/chapters/16_whole_problem/study.h"
#include "pushback/common/experiment/experiment.h"

using namespace pushback;
using namespace pushback::whole_problem_scenes;

namespace {

using Cold = Solver<Clamping, Baumgarte, Slop, FrictionCone>;
using Fill = std::function<void(World&)>;

constexpr double small = 1e-2;  // a rule stops when its criterion falls below this

}  // namespace

int main(int argc, char** argv) {
  Experiment e("16_whole_problem", "Which problem do the iterations solve, and how much of it do they leave unsolved?");
  StackInGate gate;
  e.parameter({"--boxes", "n", "", "Boxes in the stack", 1, 30}, &gate.boxes);
  Real ratio = 1000;
  e.parameter({"--mass-ratio", "", "", "Mass ratio of the upper and lower boxes", 1, 10000}, &ratio);
  return e.run(argc, argv, [&] {
    const std::string tall = "a stack of " + spelled(gate.boxes);
    const Fill stacked = [boxes = gate.boxes](World& world) { stack(world, boxes); };
    const Real top = static_cast<Real>(gate.boxes);
    const Signs of_stack = signs(Snapshot(stacked, e.dt()), 3000);  // each rule takes its number of sweeps from here
    const auto until = [&](const std::vector<double>& sign) { return first_below(sign, small); };
    e.scene(
        {.name = tall + ", every step from nothing",
         .fill = gate,
         .camera = {{0, top - Real(1.2), Real(7.8)}, {0, top - Real(1.8), 0}},
         .seconds = 2,
         .instants = {Real(0.5)},
         .contacts = Drawn::nothing,
         .caption = fmt::format(
             "The top of the stack; outlines: where its boxes should be. Corrections are small after {} sweeps, and "
             "the stack sinks as after 10. Closing speeds are small after {}.",
             until(of_stack.correction), until(of_stack.speed)),
         .start_shown = false,
         .marks = [gate](Picture& picture, const World&, Real) { gate.mark(picture); },
         .cell_height = 500});
    const auto sweeping = [&](const std::string& rule, int sweeps) {
      e.variant(rule, Cold{}).with_exactly(sweeps).expect("sunk after 0.5 s", 0).expect("sunk after 2 s", 0);
    };
    sweeping("10 sweeps", 10);
    sweeping("until corrections are small", until(of_stack.correction));
    sweeping("until closing speeds are small", until(of_stack.speed));
    e.series("the top has sunk by", "m", [gate](const World& world) { return gate.height_lost_by_top(world); });
    e.number("sunk after 0.5 s", "m", [](const Run& run) {
      const auto& sunk = run.series.at("the top has sunk by");
      return sunk[std::min(sunk.size(), static_cast<std::size_t>(std::lround(0.5 / run.dt))) - 1];
    });
    e.number("sunk after 2 s", "m", [gate](const Run& run) { return gate.height_lost_by_top(run.world); });
    e.iterations(tall, [&e, gate] { return swept_in_all_ways(first_step(gate, e.dt())); });
    e.iterations("a pyramid of five",
                 [&e] { return swept_in_all_ways(first_step([](World& world) { pyramid(world, 5); }, e.dt())); });

    e.study([&e, tall, stacked, ratio] {
      const Real h = e.dt();
      for (const auto& [name, fill] : {std::pair{"A of a stack of six", +[](World& world) { stack(world, 6); }},
                                       std::pair{"A of a pyramid of five", +[](World& world) { pyramid(world, 5); }}}) {
        const SparseMatrix matrix = matrix_of(Snapshot(fill, h).normals);
        const auto last = static_cast<Real>(matrix.rows() - 1);
        e.panel({.title = name,
                 .x_label = "row",
                 .y_label = "row",
                 .curves = {pattern(matrix)},
                 .x_range = {0, last},
                 .y_range = {last, 0},  // downwards, as a matrix is written
                 .equal_units = true});
      }
      Snapshot at_rest(stacked, h);
      const ContactProblem problem = problem_of(at_rest.world);
      e.panel({.title = tall + ", from nothing",
               .x_label = "sweeps",
               .y_label = "relative residual",
               .log_x = true,
               .log_y = true,
               .curves = merged(
                   {convergence(problem, "pgs", "pyramid", 0), convergence(problem, "scaled-back", "scaled back", 1),
                    convergence(problem, "cone", "cone", 2), convergence(problem, "nscg", "cone, conjugate", 3)})});
      const Fill ten_wide = [](World& world) { pyramid(world, 10); };
      const Fill heavy_on_four = [ratio](World& world) {
        stack(world, 4);
        world.add(box(Vec3::Constant(Real(0.5)), 100 * ratio).at({0, Real(4.5), 0}));
      };
      for (const auto& [name, fill] :
           std::vector<std::pair<std::string, Fill>>{{tall, stacked},
                                                     {"a pyramid of ten", ten_wide},
                                                     {spelled(ratio) + " times heavier on four", heavy_on_four}}) {
        const Signs found = signs(Snapshot(fill, h), 30000);
        e.panel(
            {.title = name + ", no friction",
             .x_label = "sweeps",
             .y_label = "relative to its full size",
             .log_x = true,
             .log_y = true,
             .curves = {curve_of(found.correction, "corrective impulse", 0), curve_of(found.speed, "closing speed", 1),
                        curve_of(found.error, "true error of a body's speed", 3)}});
        for (const auto& [sign, values] :
             {std::pair{"corrective impulses", &found.correction}, std::pair{"closing speeds", &found.speed}}) {
          const int at = first_below(*values, small);
          if (at > 0)
            e.remark(fmt::format("{}: {} fall below 1 % after {} sweeps, when a body's speed is wrong by {:.3g} %",
                                 name, sign, at, 100 * found.error[static_cast<std::size_t>(at) - 1]));
        }
        e.remark(fmt::format("{}: after 10 sweeps a body's speed is wrong by {:.3g} %", name, 100 * found.error[9]));
      }
    });
  });
}
