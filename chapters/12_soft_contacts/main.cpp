#include "pushback/chapters/11_substeps/study.h"
#include "pushback/chapters/12_soft_contacts/mast.h"
#include "pushback/chapters/12_soft_contacts/scenes.h"
#include "pushback/chapters/12_soft_contacts/steady_solver.h"
#include "pushback/common/experiment/marks.h"

using namespace pushback;
using namespace pushback::soft_contacts_scenes;
using namespace pushback::substeps_scenes;

namespace {

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
  void after_move(World&, Real) override {}
};

/// Both edges of a mast that buckles, as far aside at its top as the column is.
void add_mast(Picture& picture, const World& world) {
  const Real height = static_cast<Real>(world.bodies.size() - 1);
  const Real scale = world.bodies.back().position.x() / mast_shape(1 - Real(0.5) / height).aside;
  for (const Real edge : {-Real(0.5), Real(0.5)}) {
    std::vector<Vec3> line;
    for (int i = 0; i <= 40; ++i) {
      const Real up = static_cast<Real>(i) / 40;
      const auto [aside, slope] = mast_shape(up);
      line.push_back(Vec3(scale * aside + edge, height * up - edge * scale * slope / height, Real(0.55)));
    }
    add_line(picture, line, near_black_colour(), Real(1.2));
  }
}

/// Whether a column that is bent by 10 mm is upright again within 10 s.
bool comes_back(int boxes, int substeps, Real dt) {
  Substeps<SoftSolver> solver({}, substeps);
  World world;
  BentColumn{boxes, solver.angular_frequency(dt / static_cast<Real>(substeps))}(world);
  const auto top = [&world] { return world.bodies.back().position.x(); };
  for (Real t = 0; t < 10 && top() > 0 && top() < Real(0.5); t += dt) world.step(solver, dt);
  return top() <= 0;
}

/// Columns lower and higher than Greenhill's height, for some numbers of substeps: which of them stand.
void study_heights(Experiment& e) {
  Panel panel{.title = "how high a column stands",
              .x_label = "substeps; springs of 7.5 Hz for each",
              .y_label = "boxes",
              .log_x = true,
              .log_y = true,
              .ticks_at_points = true};
  Curve law{"Greenhill's law", {}, {}, "#000000"};
  for (const int substeps : {4, 8, 16, 32}) {
    const Real x = substeps, height = tallest_column(SoftContacts{}.angular_frequency(e.dt() / x));
    law.x.push_back(x);
    law.y.push_back(height);
    const bool last = substeps == 32;  // one name for each colour
    Curve stand{last ? "stands" : "", {}, {}, line_colour(1), Curve::Style::line_and_points};
    Curve fall{last ? "falls" : "", {}, {}, line_colour(0), Curve::Style::line_and_points};
    for (const Real part : {Real(0.8), Real(0.95), Real(1.05), Real(1.25)}) {
      const Real boxes = std::round(part * height);
      Curve& curve = comes_back(static_cast<int>(boxes), substeps, e.dt()) ? stand : fall;
      curve.x.push_back(x);
      curve.y.push_back(boxes);
    }
    e.remark(
        fmt::format("{} substeps: Greenhill's law allows {:.1f} boxes. Of the columns that were bent, {:.0f} boxes "
                    "come back and {:.0f} fall.",
                    substeps, height, stand.y.empty() ? 0 : stand.y.back(), fall.y.empty() ? 0 : fall.y.front()));
    panel.curves.push_back(stand);
    panel.curves.push_back(fall);
  }
  panel.curves.push_back(law);
  e.panel(panel);
}

}  // namespace

int main(int argc, char** argv) {
  Experiment e("12_soft_contacts", "What if a contact is a spring with a damper?");
  int count = 32;
  SoftContacts spring;
  e.parameter({"--substeps", "", "", "Substeps per step", 1, 128}, &count);
  e.parameter({"--hertz", "", "Hz", "Frequency of the contact springs", 30, 2000}, &spring.hertz);
  e.parameter({"--damping-ratio", "ζ", "", "Damping ratio of the soft contacts", 0, 20}, &spring.damping_ratio);
  int tall = 20;
  e.parameter({"--boxes", "n", "", "Boxes in the smaller stack", 2, 25}, &tall);
  HeavyOnLight heavy;
  e.parameter({"--mass-ratio", "", "", "Mass ratio of the upper and lower box", 1, 2000}, &heavy.mass_ratio);
  SunkenBall sunken;
  e.parameter({"--depth", "", "m", "Initial depth of the ball", 0.005, 0.2}, &sunken.depth);
  return e.run(argc, argv, [&] {
    const Real h = e.dt() / static_cast<Real>(count), w = spring.angular_frequency(h);
    const auto hard = [&]() -> Variant& {
      return e.variant(fmt::format("{} substeps, hard", count), Substeps(FullSolver{}, count))
          .with_exactly(1)
          .coloured(0);
    };
    const auto springy = [&](const std::string& what, int colour, auto solver) -> Variant& {
      solver.hertz = spring.hertz;
      solver.damping_ratio = spring.damping_ratio;
      return e.variant(fmt::format("{} substeps, {}", count, what), Substeps(solver, count))
          .with_exactly(1)
          .coloured(colour);
    };
    const auto soft = [&]() -> Variant& { return springy("soft", 1, SoftSolver{}); };
    const auto not_relaxed = [&]() -> Variant& { return springy("soft, not relaxed", 2, Unrelaxed{}); };

    const auto overlap_of_stack = [w](int boxes) {
      return 1000 * 2 * static_cast<Real>(boxes - 1) * World::g / (w * w);
    };
    const Real top = tall, times = 300, yield = World::g / (w * w);
    // Of a stack on soft contacts at rest, from the ground to its top.
    const Real height = top - times * yield * top * top;
    const std::vector<Vec3> rests{{-Real(0.5), 0, Real(0.55)},
                                  {-Real(0.5), height, Real(0.55)},
                                  {Real(0.5), height, Real(0.55)},
                                  {Real(0.5), 0, Real(0.55)}};
    const Real pace = Real(1.4) * top, middle = Real(1.125) * pace;  // m/s, so that they lean beside each other; m
    e.scene(
        {.name = "a stack of " + spelled(tall),
         .fill = [tall](World& world) { stack(world, tall); },
         .camera = {{middle - 16, Real(0.08) * top, 20 * top}, {middle, Real(0.51) * top, 0}, Real(0.0555)},
         .seconds = 10,
         .contacts = Drawn::nothing,
         .caption =
             "The stack every 0.25 s from left to right, its displacements drawn 300 times as large. Thin lines: "
             "where soft contacts should come to rest.",
         .start_shown = false,
         .magnified = times,
         .strobe = Strobe{.every = Real(0.25),
                          .shift_per_second = {pace, 0, 0},
                          .from = 5,
                          .height = 440,
                          .until = Real(7.25),
                          .marks = [rests](Picture& picture,
                                           const World&) { add_line(picture, rests, near_black_colour(), Real(1.2)); }},
         .in_brief = {{0, 0}},
         .guess = Guess{{0, 1}}});
    watch_stack(e);
    hard();
    soft().expect("overlap at the end", overlap_of_stack(tall));

    scene_of_heavy(e, heavy);
    hard();
    not_relaxed().without_curves();
    soft().expect("overlap at the end", 1000 * (1 + heavy.mass_ratio) * World::g / (w * w));

    e.scene({.name = "a stack of " + spelled(2 * tall),
             .fill = [tall](World& world) { stack(world, 2 * tall); },
             .seconds = 10,
             .pictures = false});
    soft();
    springy("all together", 3, SteadySolver{}).expect("overlap at the end", overlap_of_stack(2 * tall));
    number_drift(e);
    number_overlap(e);

    const Real every = Real(0.75), apart = Real(0.45) * top;  // s; m, of one instant from the next
    const Real half = Real(3.6) * apart;
    e.scene({.name = "a column of " + spelled(tall) + ", bent by 10 mm",
             .fill = [tall](World& world) { stack(world, tall); },
             .camera = {{half, Real(0.08) * top, 20 * top}, {half, Real(0.51) * top, 0}, Real(0.0555)},
             .seconds = 10,
             .contacts = Drawn::nothing,
             .key = "column",
             .caption =
                 "The column is drawn every 0.75 s from left to right. Thin lines: a mast that buckles under its "
                 "own weight, as far aside at its top.",
             .strobe = Strobe{.every = every,
                              .shift_per_second = {apart / every, 0, 0},
                              .from = 10 - 7 * every,
                              .height = 440,
                              .marks = add_mast}});
    const Real stiffest = std::min(Real(60), 1 / (8 * h));
    std::vector<Real> springs{std::min(Real(30), stiffest)};  // Hz
    if (stiffest > springs[0]) springs.push_back(stiffest);
    for (std::size_t i = 0; i < springs.size(); ++i) {
      SoftSolver solver;
      solver.hertz = springs[i];
      const BentColumn bent{tall, 2 * pi * springs[i]};
      e.variant(fmt::format("{} substeps, {:.3g} Hz", count, springs[i]), Substeps(solver, count))
          .with_exactly(1)
          .changing([bent](World& world) { bent.bend(world); })
          .coloured(static_cast<int>(i));
    }
    e.series("drift of the top", "mm", drift_in_mm, true);
    e.number("drift of the top", "mm", [](const Run& run) { return drift_in_mm(run.world); });

    const FullSolver baumgarte;
    e.scene({.name = fmt::format("{:.3g} mm too deep, without gravity", 1000 * sunken.depth),
             .fill = sunken,
             .camera = {{Real(3.5), Real(2.6), 30}, {Real(3.5), Real(1.33), 0}, Real(0.097)},
             .seconds = Real(0.6),
             .contacts = Drawn::nothing,
             .key = "ball",
             .caption = "The ball is drawn every 0.1 s, each time farther to the right. It has to come out of the "
                        "ground, up to the line, and stay there.",
             .marks = [](Picture& picture, const World&,
                         Real) { add_line(picture, {{Real(-0.6), 1, 0}, {Real(7.6), 1, 0}}); },
             .strobe = Strobe{.every = Real(0.1), .shift_per_second = {Real(11.6), 0, 0}, .height = 420}});
    hard().expect("exit speed", baumgarte.beta * std::max(Real(0), sunken.depth - baumgarte.slop) / h);
    not_relaxed().expect("exit speed", speed_out_of(spring, sunken.depth, h, Real(0.6)));
    soft().expect("exit speed", 0);
    e.series_without_curves("speed", [](const World& world) { return world.bodies[1].velocity.y(); });
    e.number("exit speed", "m/s", [](const Run& run) { return run.series.at("speed").back(); });

    e.study([&e, tall] {
      study_heights(e);
      const auto steps = [](const Budget& budget) { return budget.substeps; };
      const auto all_sweeps = [](const Budget& budget) { return budget.substeps * budget.sweeps; };
      const auto and_relaxing = [](const Budget& budget) { return budget.substeps * (budget.sweeps + 1); };
      const std::vector<Budget> same{{1, 32}, {2, 16}, {4, 8}, {8, 4}, {16, 2}, {32, 1}};
      const StackCurves hard_same = study<FullSolver>("hard", 0, tall, e.dt(), same, steps),
                        soft_same = study<SoftSolver>("soft", 1, tall, e.dt(), same, steps);
      const StackCurves hard_steps = study<FullSolver>("substeps, hard", 0, tall, e.dt(), {{16, 1}, {32, 1}, {64, 1}},
                                                       all_sweeps),
                        soft_steps = study<SoftSolver>("substeps, soft", 1, tall, e.dt(),
                                                       {{8, 1}, {16, 1}, {32, 1}, {64, 1}}, and_relaxing);
      const std::string at_same_cost = "a stack of " + spelled(tall) + ", 32 sweeps in 1/60 s";
      e.panel(study_panel(at_same_cost, "substeps", "drift of the top, mm", {hard_same.drift, soft_same.drift}));
      e.panel(study_panel(at_same_cost, "substeps", "deepest overlap, mm", {hard_same.overlap, soft_same.overlap}));
      const std::string cost = "what a sweep is worth", x = "sweeps in 1/60 s, relaxing counted";
      e.panel(study_panel(cost, x, "drift of the top, mm", {hard_steps.drift, soft_steps.drift}));
      e.panel(study_panel(cost, x, "speed in the last second, mm/s", {hard_steps.speed, soft_steps.speed}));
    });
  });
}
