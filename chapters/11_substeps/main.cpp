#include "pushback/chapters/07_warm_start/full_solver.h"
#include "pushback/chapters/11_substeps/study.h"

using namespace pushback;
using namespace pushback::substeps_scenes;

int main(int argc, char** argv) {
  Experiment e("11_substeps", "Many iterations, or many substeps?");
  int count = 32;
  e.parameter({"--substeps", "", "", "Substeps in each step, and sweeps where a step is not cut", 1, 128}, &count);
  int tall = 20;
  e.parameter({"--boxes", "n", "", "Boxes of the stack", 2, 25}, &tall);
  HeavyOnLight heavy;
  e.parameter({"--mass-ratio", "", "", "Mass of the upper box, in masses of the one below", 1, 2000},
              &heavy.mass_ratio);
  return e.run(argc, argv, [&] {
    const auto sweeping = [&](int sweeps) -> Variant& {
      return e.variant(fmt::format("one step, {} sweeps", sweeps), FullSolver{}).with_exactly(sweeps);
    };
    const auto stepping = [&] {
      e.variant(fmt::format("{} substeps", count), FullSolver{}).in_substeps(count).with_exactly(1).coloured(2);
    };
    scene_of_stack(e, tall);
    sweeping(10).coloured(0);
    if (count != 10) sweeping(count).coloured(1);
    stepping();
    scene_of_heavy(e, heavy);
    sweeping(count).coloured(1);
    stepping();

    e.study([&e, tall] {
      const auto in = [&](const std::string& name, std::size_t colour, const std::vector<Budget>& budgets,
                          const std::function<int(const Budget&)>& along) {
        return study<FullSolver>(name, colour, tall, e.dt(), budgets, along);
      };
      const StackCurves same = in("", 2, {{1, 32}, {2, 16}, {4, 8}, {8, 4}, {16, 2}, {32, 1}},
                                  [](const Budget& budget) { return budget.substeps; });
      const auto all_sweeps = [](const Budget& budget) { return budget.substeps * budget.sweeps; };
      const StackCurves sweeps = in("sweeps in one step", 1, {{1, 16}, {1, 32}, {1, 64}}, all_sweeps),
                        steps = in("substeps", 2, {{16, 1}, {32, 1}, {64, 1}}, all_sweeps);
      const std::string at_same_cost = "a stack of " + spelled(tall) + ", 32 sweeps in 1/60 s";
      e.panel(study_panel(at_same_cost, "substeps", "drift of the top, mm", {same.drift}));
      e.panel(study_panel(at_same_cost, "substeps", "deepest overlap, mm", {same.overlap}));
      const std::string cost = "what a sweep is worth", x = "sweeps in 1/60 s";
      e.panel(study_panel(cost, x, "drift of the top, mm", {sweeps.drift, steps.drift}));
      e.panel(study_panel(cost, x, "speed in the last second, mm/s", {sweeps.speed, steps.speed}));
    });
  });
}
