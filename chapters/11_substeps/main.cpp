#include "pushback/chapters/07_warm_start/full_solver.h"
#include "pushback/chapters/11_substeps/study.h"
#include "pushback/common/experiment/marks.h"

using namespace pushback;
using namespace pushback::substeps_scenes;

int main(int argc, char** argv) {
  Experiment e("11_substeps", "Many sweeps, or many substeps?");
  int count = 32;
  e.parameter({"--substeps", "", "", "Substeps, or sweeps of an undivided step", 1, 128}, &count);
  int tall = 20;
  e.parameter({"--boxes", "n", "", "Boxes in the stack", 2, 25}, &tall);
  HeavyOnLight heavy;
  e.parameter({"--mass-ratio", "", "", "Mass ratio of the upper and lower box", 1, 2000}, &heavy.mass_ratio);
  return e.run(argc, argv, [&] {
    const auto sweeping = [&](int sweeps) -> Variant& {
      return e.variant(fmt::format("one step, {} sweeps", sweeps), FullSolver{}).with_exactly(sweeps);
    };
    const auto stepping = [&] {
      e.variant(fmt::format("{} substeps", count), Substeps(FullSolver{}, count)).with_exactly(1).coloured(2);
    };
    const Real top = tall;
    const Body where_it_stood = box({Real(0.5), top / 2, Real(0.5)}, 1).at({0, top / 2, 0});
    e.scene({.name = "a stack of " + spelled(tall),
             .fill = [tall](World& world) { stack(world, tall); },
             .camera = {{12, top / 2 + 6, 60}, {Real(0.8), top / 2 + Real(0.35), 0}, Real(0.363)},
             .seconds = 10,
             .instants = {5},
             .contacts = Drawn::nothing,
             .caption =
                 "All three stacks started between the thin lines. The pictures show them after 5 s, the numbers are "
                 "those after 10 s.",
             .start_shown = false,
             .marks = [where_it_stood](Picture& picture, const World&,
                                       Real) { add_outline(picture, where_it_stood, near_black_colour(), Real(0.8)); },
             .cell_height = 960,
             .guess = Guess{{0, 1, 2}}});
    watch_stack(e);
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
      std::vector<std::string> drifts;
      for (const Real drift : same.drift.y) drifts.push_back(fmt::format("{:.3g}", drift));
      e.remark(fmt::format("a stack of {}, 32 sweeps in 1/60 s, in {} substeps: the top drifts by {} mm", spelled(tall),
                           fmt::join(same.drift.x, ", "), fmt::join(drifts, ", ")));
      const auto worth = [&](const std::string& y, const std::vector<Curve>& curves) {
        Panel panel = study_panel("what a sweep is worth", "sweeps in 1/60 s", y, curves);
        panel.ticks_at_points = true;
        e.panel(panel);
      };
      worth("drift of the top, mm", {sweeps.drift, steps.drift});
      worth("speed in the last second, mm/s", {sweeps.speed, steps.speed});
    });
  });
}
