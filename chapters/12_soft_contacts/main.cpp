#include "pushback/chapters/12_soft_contacts/scenes.h"
#include "pushback/chapters/12_soft_contacts/steady_solver.h"
#include "pushback/chapters/11_substeps/study.h"
#include "pushback/common/experiment/experiment.h"

using namespace pushback;

namespace {

constexpr Real g = Real(9.81);

/// m/s, of a body alone that is `depth` (m) too deep, after `seconds` in steps of h, where no pass relaxes it.
///
///   v += max(0, (b - v) / (1 + gamma / K)),   b = d k / (c + h k);   rigid, without gamma, where b is too fast
Real speed_out_of(const SoftContacts& spring, Real depth, Real h, Real seconds) {
  const Real w = spring.angular_frequency(h), damping = 2 * spring.damping_ratio + h * w;
  Real v = 0;
  for (Real t = 0; t < seconds && depth > 0; t += h) {
    const Real push_out = depth * w / damping;
    if (push_out > spring.fastest_push_out) v = std::max(v, spring.fastest_push_out);
    else v += std::max(Real(0), (push_out - v) / (1 + 1 / (h * w * damping)));
    depth -= h * v;
  }
  return v;
}

/// The spring without the relaxing pass.
struct Unrelaxed : SoftSolver {
  void after_move(World&, Real) {}
};

}  // namespace

int main(int argc, char** argv) {
  Experiment e("12_soft_contacts", "Many sweeps, or many small steps?");
  int count = 32;
  SoftContacts spring;
  e.parameter({"--substeps", "", "", "Small steps in each step", 1, 128}, &count);
  e.parameter({"--hertz", "", "Hz",
               "Frequency of the soft contacts' springs; an eighth of the small steps' frequency at most", 30, 2000},
              &spring.hertz);
  e.parameter({"--damping-ratio", "ζ", "", "Damping ratio of the soft contacts; 1: critical", 0, 20},
              &spring.damping_ratio);
  int tall = 20;
  e.parameter({"--boxes", "n", "", "Boxes of the first stack; the second has twice as many", 2, 25}, &tall);
  HeavyOnLight heavy;
  e.parameter({"--mass-ratio", "", "", "Mass of the upper box, in masses of the one below", 1, 2000},
              &heavy.mass_ratio);
  SunkenBall sunken;
  e.parameter({"--depth", "", "m", "How deep the ball is in the ground", 0.005, 0.2}, &sunken.depth);
  return e.run(argc, argv, [&] {
    const Real h = e.dt() / static_cast<Real>(count), w = spring.angular_frequency(h);
    const auto with_spring = [&](auto solver) {
      solver.hertz = spring.hertz;
      solver.damping_ratio = spring.damping_ratio;
      return solver;
    };
    const auto sweeping = [&](int sweeps) -> Variant& {
      return e.variant(fmt::format("one step, {} sweeps", sweeps), FullSolver{}).with_exactly(sweeps);
    };
    const auto small = [&](const std::string& what, auto solver) -> Variant& {
      return e.variant(fmt::format("{} small steps{}", count, what), solver).in_substeps(count).with_exactly(1);
    };

    const Real top = static_cast<Real>(tall);
    const auto overlap_of_stack = [w](Real boxes) { return 1000 * 2 * (boxes - 1) * g / (w * w); };
    e.scene({.name = "a stack of " + spelled(tall),
             .fill = [tall](World& world) { stack_before_posts(world, tall); },
             .camera = {{0, top - Real(3.5), 12}, {0, top - Real(2.8), 0}},
             .seconds = 10,
             .instants = {0, 2, Real(3.5), 6}});
    sweeping(10);
    if (count != 10) sweeping(count);
    small("", FullSolver{});
    small(", soft", with_spring(SoftSolver{})).expect("overlap at the end", overlap_of_stack(top));
    e.series("drift of the top", "mm", [](const World& world) { return 1000 * drift_of_top(world); }, true);
    e.series("largest speed", "mm/s", [](const World& world) { return 1000 * largest_speed(world); }, true);
    e.number("drift of the top", "mm", [](const Run& run) { return 1000 * drift_of_top(run.world); });
    e.number("speed in the last second", "mm/s", [](const Run& run) {
      const auto& speeds = run.series.at("largest speed");
      const auto second = std::min<std::ptrdiff_t>(std::ssize(speeds), std::lround(1 / run.dt));
      return *std::max_element(speeds.end() - second, speeds.end());
    });
    const auto overlap = [](const Run& run) { return 1000 * run.samples.back().overlap; };
    e.number("overlap at the end", "mm", overlap);

    e.scene({.name = spelled(heavy.mass_ratio) + " times heavier than what it lies on",
             .fill = heavy,
             .camera = {{2, Real(1.8), 5}, {0, Real(0.95), 0}},
             .seconds = 5,
             .instants = {0, Real(0.25), Real(0.5), 5}});
    small("", FullSolver{});
    small(", soft, not relaxed", with_spring(Unrelaxed{}));
    small(", soft", with_spring(SoftSolver{}))
        .expect("overlap at the end", 1000 * (1 + heavy.mass_ratio) * g / (w * w));
    e.series("deepest overlap", "mm", [](const World& world) { return 1000 * deepest_overlap(world); }, true);
    e.number("height of the heavy one", "m", [](const Run& run) { return run.world.bodies[2].position.y(); });
    e.number("deepest of all", "mm", [](const Run& run) {
      Real deepest = 0;
      for (const Sample& sample : run.samples) deepest = std::max(deepest, sample.overlap);
      return 1000 * deepest;
    });
    e.number("overlap at the end", "mm", overlap);

    e.scene({.name = "a stack of " + spelled(2 * tall),
             .fill = [tall](World& world) { stack(world, 2 * tall); },
             .camera = {},
             .seconds = 10,
             .pictures = false});
    small(", soft", with_spring(SoftSolver{}));
    small(", all together", with_spring(SteadySolver{})).expect("overlap at the end", overlap_of_stack(2 * top));
    e.series("drift of the top", "mm", [](const World& world) { return 1000 * drift_of_top(world); }, true);
    e.number("drift of the top", "mm", [](const Run& run) { return 1000 * drift_of_top(run.world); });
    e.number("overlap at the end", "mm", overlap);

    const FullSolver hard;
    e.scene({.name = fmt::format("{:.3g} mm too deep, without gravity", 1000 * sunken.depth),
             .fill = sunken,
             .camera = {{Real(0.7), Real(1.4), Real(5.5)}, {0, Real(1.1), 0}},
             .seconds = Real(0.6),
             .instants = {0, Real(0.05), Real(0.2), Real(0.6)}});
    small("", FullSolver{}).expect("exit speed", hard.beta * std::max(Real(0), sunken.depth - hard.slop) / h);
    small(", soft, not relaxed", with_spring(Unrelaxed{}))
        .expect("exit speed", speed_out_of(spring, sunken.depth, h, Real(0.6)));
    small(", soft", with_spring(SoftSolver{})).expect("exit speed", 0);
    e.series("height over the ground", "mm",
             [](const World& world) { return 1000 * (world.bodies[1].position.y() - Real(0.5)); });
    e.number("exit speed", "m/s", [](const Run& run) { return run.world.bodies[1].velocity.y(); });

    e.study([&e, tall] {
      const auto steps = [](const Budget& budget) { return budget.substeps; };
      const auto all_sweeps = [](const Budget& budget) { return budget.substeps * budget.sweeps; };
      const auto and_relaxing = [](const Budget& budget) { return budget.substeps * (budget.sweeps + 1); };
      const std::vector<Budget> same{{1, 32}, {2, 16}, {4, 8}, {8, 4}, {16, 2}, {32, 1}};
      const StackCurves hard_same = study<FullSolver>("hard", 0, tall, e.dt(), same, steps),
                        soft_same = study<SoftSolver>("soft", 1, tall, e.dt(), same, steps);
      const StackCurves sweeps = study<FullSolver>("sweeps in one step", 2, tall, e.dt(), {{1, 16}, {1, 32}, {1, 64}},
                                                   all_sweeps),
                        hard_steps =
                            study<FullSolver>("small steps", 0, tall, e.dt(), {{16, 1}, {32, 1}, {64, 1}}, all_sweeps),
                        soft_steps = study<SoftSolver>("small steps, soft", 1, tall, e.dt(),
                                                       {{8, 1}, {16, 1}, {32, 1}, {64, 1}}, and_relaxing);
      const auto panel = [&](const std::string& title, const std::string& x, const std::string& y,
                             const std::vector<Curve>& curves) {
        e.panel({.title = title, .x_label = x, .y_label = y, .log_x = true, .log_y = true, .curves = curves});
      };
      const std::string at_same_cost = "a stack of " + spelled(tall) + ", 32 sweeps in 1/60 s";
      panel(at_same_cost, "small steps", "drift of the top, mm", {hard_same.drift, soft_same.drift});
      panel(at_same_cost, "small steps", "deepest overlap, mm", {hard_same.overlap, soft_same.overlap});
      const std::string cost = "what a sweep is worth";
      panel(cost, "sweeps in 1/60 s, relaxing counted", "drift of the top, mm",
            {sweeps.drift, hard_steps.drift, soft_steps.drift});
      panel(cost, "sweeps in 1/60 s, relaxing counted", "speed in the last second, mm/s",
            {sweeps.speed, hard_steps.speed, soft_steps.speed});
    });
  });
}
