#include "chapters/07_warm_start/study.h"
#include "common/experiment.h"

using namespace pushback;

namespace {

using Cold = Solver<Clamping, Baumgarte, Slop, Restitution, Friction>;

/// Every contact gets what its neighbour in the list had.
struct WarmStartWithWrongIds : WarmStart {
  void build(const Contacts& contacts, Rows& rows, Real dt) {
    WarmStart::build(contacts, rows, dt);
    if (!first_guess_.empty()) std::rotate(first_guess_.begin(), first_guess_.begin() + 1, first_guess_.end());
  }
};
using WrongIds = Solver<Clamping, Baumgarte, Slop, Restitution, Friction, WarmStartWithWrongIds>;

/// Mean from 1 s to 2 s: all of them still stand then.
Real mean(const Run& run, Real Sample::* what) {
  Real sum = 0;
  int count = 0;
  for (const Sample& sample : run.samples) {
    if (sample.time < 1 || sample.time > 2) continue;
    sum += sample.*what;
    ++count;
  }
  return sum / static_cast<Real>(count);
}

Real top_of(const Run& run) {
  Real highest = 0;
  for (const Body& body : run.world.bodies) highest = std::max(highest, body.position.y());
  return highest;
}

}  // namespace

int main(int argc, char** argv) {
  Experiment e("07_warm_start", "What is last step's answer worth?");
  std::vector<int> sweep_counts{1, 2, 3, 5, 8, 10, 15, 20, 30, 50, 80, 120, 200, 400, 800};
  e.option("--sweep-counts", sweep_counts, "Numbers of sweeps for the diagrams", positive());
  return e.run(argc, argv, [&] {
    const auto three_ways = [&](int sweeps) {
      e.variant("cold", Cold{}).with_sweeps(sweeps);
      e.variant("warm", FullSolver{}).with_sweeps(sweeps);
      e.variant("warm, wrong ids", WrongIds{}).with_sweeps(sweeps);
    };
    const auto measured = [&] {
      e.series("deepest overlap", "mm", [](const World& world) { return 1000 * deepest_overlap(world); });
      e.number("overlap, 1 to 2 s", "mm", [](const Run& run) { return 1000 * mean(run, &Sample::overlap); });
      e.number("residual, 1 to 2 s", "m/s", [](const Run& run) { return mean(run, &Sample::residual); });
      e.number("height of the top after 8 s", "m", top_of);
    };
    e.scene({.name = "a stack of ten",
             .fill = [](World& world) { stack(world, 10); },
             .camera = {{10, 6, 15}, {0, Real(4.9), 0}},
             .seconds = 8});
    three_ways(10);
    measured();
    e.scene({.name = "a pyramid, ten wide",
             .fill = [](World& world) { pyramid(world, 10); },
             .camera = {{5, 7, 18}, {0, Real(4.7), 0}},
             .seconds = 8});
    three_ways(4);
    measured();

    e.study([&e, &sweep_counts] {
      std::vector<Study> studies{study<Cold>("cold", sweep_counts, e.dt(), 0),
                                 study<FullSolver>("warm", sweep_counts, e.dt(), 1),
                                 study<WrongIds>("warm, wrong ids", sweep_counts, e.dt(), 2)};
      Panel residual{.title = "a stack of ten, at rest",
                     .x_label = "sweeps",
                     .y_label = "residual, m/s",
                     .log_x = true,
                     .log_y = true,
                     .extra = "set arrow from graph 0, first 1e-3 to graph 1, first 1e-3 nohead dt 2 lc rgb '#888888'"};
      Panel depth{.title = "a stack of ten, at rest",
                  .x_label = "sweeps",
                  .y_label = "deepest overlap, mm",
                  .log_x = true,
                  .log_y = true};
      for (Study& s : studies) {
        residual.curves.push_back(std::move(s.residual));
        depth.curves.push_back(std::move(s.depth));
        e.remark(s.verdict);
      }
      e.panel(residual);
      e.panel(depth);
    });
  });
}
