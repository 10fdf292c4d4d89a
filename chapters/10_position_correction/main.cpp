#include "pushback/chapters/10_position_correction/scenes.h"
#include "pushback/chapters/10_position_correction/study.h"
#include "pushback/common/experiment/experiment.h"
#include "pushback/common/experiment/marks.h"

using namespace pushback;
using namespace pushback::baumgarte_scenes;
using namespace pushback::position_correction_scenes;

namespace {

Real height(const World& world) {
  return world.bodies.back().position.y();
}
/// J: by how much the energy has grown, over all steps in which it has.
std::function<Real(const Run&)> energy_fed_in(const std::function<void(World&)>& fill) {
  return [fill](const Run& run) {
    World world;
    fill(world);
    Real before = kinetic_energy(world) + potential_energy(world), fed_in = 0;
    for (const Sample& sample : run.samples) {
      const Real after = sample.kinetic_energy + sample.potential_energy;
      fed_in += std::max(Real(0), after - before);
      before = after;
    }
    return fed_in;
  };
}
Real most_kinetic_energy(const Run& run) {
  Real most = 0;
  for (const Sample& sample : run.samples) most = std::max(most, sample.kinetic_energy);
  return most;
}
/// Root mean square of the speed in the last second, mm/s.   `mass`: kg, of all bodies
std::function<Real(const Run&)> jitter(Real mass) {
  return [mass](const Run& run) {
    Real sum = 0;
    const std::vector<Sample> last = run.last(1);
    for (const Sample& sample : last) sum += 2 * sample.kinetic_energy / mass;
    return 1000 * std::sqrt(sum / static_cast<Real>(last.size()));
  };
}
/// Highest point after the first bounce, mm above where it lies on the ground; 0 if it does not rise that high.
Real first_apex(const Run& run) {
  const auto& heights = run.series.at("height over the ground");
  std::size_t i = 1;
  while (i < heights.size() && heights[i] <= heights[i - 1]) ++i;
  return std::max(Real(0), *std::max_element(heights.begin() + static_cast<std::ptrdiff_t>(i) - 1, heights.end()));
}

/// The three ways to correct positions, as they were asked for.
struct Ways {
  With<Baumgarte> baumgarte;
  With<SplitImpulse> split;
  With<NonlinearGaussSeidel> ngs;
};

template <class ContactSolver>
ContactSolver at_once(ContactSolver solver, Real at_most) {
  solver.beta = 1;
  if constexpr (requires { solver.most; }) solver.most = at_most;
  return solver;
}
template <class ContactSolver>
ContactSolver no_slop(ContactSolver solver) {
  solver.slop = 0;
  return solver;
}

void all_three(Experiment& e, const Ways& by) {
  e.variant("Baumgarte", by.baumgarte).coloured(0);
  e.variant("split impulse", by.split).coloured(1);
  e.variant("non-linear Gauss-Seidel", by.ngs).coloured(2);
}
void all_three_at_once(Experiment& e, const Ways& by) {
  e.variant("Baumgarte", at_once(by.baumgarte, 0)).coloured(0);
  e.variant("split impulse", at_once(by.split, 1)).coloured(1);
  e.variant("non-linear Gauss-Seidel", at_once(by.ngs, 1)).coloured(2);
}

void twelve_boxes_come_apart(Experiment& e, const Ways& by) {
  const auto heap = [&] {
    e.series(
        "kinetic energy", "J", [](const World& world) { return std::max(kinetic_energy(world), Real(1e-6)); }, true);
    e.number("kinetic energy, at most", "J", most_kinetic_energy);
    e.number("energy fed in", "J", energy_fed_in(boxes_in_each_other));
    e.number("farthest from the middle", "m", [](const Run& run) {
      Real farthest = 0;
      for (const Body& body : run.world.bodies)
        farthest = std::max(farthest, std::hypot(body.position.x(), body.position.z()));
      return farthest;
    });
  };
  e.scene({.name = "twelve boxes born inside each other",
           .fill = boxes_in_each_other,
           .camera = {{Real(4.2), Real(4), Real(10)}, {0, Real(2.35), 0}, Real(0.54)},
           .seconds = 3,
           .instants = {Real(0.5)},
           .contacts = Drawn::nothing,
           .key = "boxes",
           .caption = "The boxes have to come apart. The thin lines are the block in which they then stand; a box "
                      "that flies on has kept its velocity.",
           .marks =
               [](Picture& picture, const World&, Real) {
                 for (const Body& stands : twelve_boxes(1))
                   add_outline(picture, stands, near_black_colour(), Real(1.5));
               },
           .cell_height = 440,
           .guess = Guess{{0, 1}, true}});
  all_three(e, by);
  heap();
  e.scene({.name = "the same twelve, β = 1", .fill = boxes_in_each_other, .seconds = 3, .pictures = false});
  all_three_at_once(e, by);
  e.variant("split impulse, 50 mm a step", at_once(by.split, Real(0.05))).coloured(4);
  e.variant("non-linear Gauss-Seidel, 50 mm a step", at_once(by.ngs, Real(0.05))).coloured(3);
  heap();
}

void box_in_the_ground(Experiment& e, const Ways& by, Real depth) {
  const Real first_at = Real(-3.45);  // m, of the box in the strobe picture, whose seven instants fill the slab
  const auto deep_box = [depth, first_at](World& world) {
    very_deep_box(world, depth);
    world.bodies.back().position.x() = first_at;
  };
  const auto jump = [&] {
    e.series_without_curves("height over the ground",
                            [](const World& world) { return 1000 * (height(world) - Real(0.5)); });
    e.number("highest jump", "mm", [](const Run& run) {
      const auto& heights = run.series.at("height over the ground");
      return std::max(Real(0), *std::max_element(heights.begin(), heights.end()));
    });
    e.number("kinetic energy, at most", "J", most_kinetic_energy);
    e.number("energy fed in", "J", energy_fed_in(deep_box));
  };
  e.scene({.name = fmt::format("a box {:.3g} mm in the ground", 1000 * depth),
           .fill = deep_box,
           .camera = {{0, Real(1.7), 16}, {0, Real(0.5), 0}, Real(0.119)},
           .seconds = Real(0.6),
           .key = "box",
           .caption = "The box is drawn every 0.1 s, each time farther to the right. The line marks the height of its "
                      "top at rest.",
           .marks = [](Picture& picture, const World&,
                       Real) { add_line(picture, {{-4, 1, Real(0.5)}, {4, 1, Real(0.5)}}); },
           .strobe = Strobe{.every = Real(0.1), .shift_per_second = {Real(11.5), 0, 0}, .height = 340}});
  all_three(e, by);
  jump();
  e.scene({.name = "the same box, β = 1", .fill = deep_box, .seconds = 1, .pictures = false});
  all_three_at_once(e, by);
  jump();
}

void stack_leans(Experiment& e, const Ways& by, int boxes) {
  const Real tall = static_cast<Real>(boxes);
  const std::string a_stack = "a stack of " + spelled(boxes);
  const auto leaning = [boxes](World& world) { stack(world, boxes); };
  e.scene({.name = a_stack, .fill = leaning, .seconds = 10, .pictures = false});
  all_three(e, by);
  const auto drift_of_top = [](const World& world) {
    const Vec3& top = world.bodies.back().position;
    return 1000 * std::hypot(top.x(), top.z());
  };
  e.series("drift of the top", "mm", drift_of_top);
  e.number("jitter", "mm/s", jitter(tall * 100));
  e.number("drift of the top", "mm", [drift_of_top](const Run& run) { return drift_of_top(run.world); });
  e.number("energy fed in", "J", energy_fed_in(leaning));
  e.number("overlap at the end", "mm", [](const Run& run) { return 1000 * run.samples.back().overlap; });
  e.number("contact points lost", "", [](const Run& run) {
    int lost = 0;
    for (const Sample& sample : run.samples) lost += sample.lost;
    return static_cast<Real>(lost);
  });
}

/// One contact, no slop.
void ball_follows_closed_forms(Experiment& e, const Ways& by, const WeightlessBall& ball, Real h) {
  const Real beta = by.split.beta, most = by.split.most;
  const int rounds = by.ngs.rounds;
  const auto left_by_split = [=](Real steps) { return 1000 * ball.left(beta, most, std::lround(steps)); };
  const auto left_by_ngs = [=](Real steps) {
    return 1000 * ball.left(beta, most / static_cast<Real>(rounds), rounds * std::lround(steps));
  };
  const Real exit_speed = beta * ball.depth / h;
  e.scene({.name = fmt::format("a ball {:.3g} mm deep, without gravity and slop", 1000 * ball.depth),
           .fill = ball,
           .seconds = 10 * h,
           .pictures = false});
  e.variant("Baumgarte", no_slop(by.baumgarte))
      .coloured(0)
      .expect("exit speed", exit_speed)
      .expect("energy fed in", 100 * std::pow(exit_speed, Real(2)) / 2);
  e.variant("split impulse", no_slop(by.split))
      .coloured(1)
      .expect("exit speed", 0)
      .expect("energy fed in", 0)
      .expect("overlap after ten steps", left_by_split(10))
      .reference("d₀ (1−β)ᵏ", [=](Real t) { return left_by_split(t / h); });
  e.variant("non-linear Gauss-Seidel", no_slop(by.ngs))
      .coloured(2)
      .expect("exit speed", 0)
      .expect("energy fed in", 0)
      .expect("overlap after ten steps", left_by_ngs(10))
      .reference("", [=](Real t) { return left_by_ngs(t / h); });
  e.series("overlap", "mm", [](const World& world) { return 1000 * (Real(0.5) - height(world)); });
  e.number("exit speed", "m/s", [](const Run& run) { return run.world.bodies[1].velocity.y(); });
  e.number("energy fed in", "J", energy_fed_in(ball));
  e.number("overlap after ten steps", "mm",
           [](const Run& run) { return std::max(Real(0), run.series.at("overlap").back()); });
}

void balls_bounce(Experiment& e, const Ways& by) {
  const auto bounce = [&] {
    e.series_without_curves("height over the ground",
                            [](const World& world) { return 1000 * (height(world) - Real(0.3)); });
    e.number("first apex", "mm", first_apex);
  };
  e.scene(
      {.name = "a ball with e = 1, dropped by 1 m", .fill = dropped_ball(1), .seconds = Real(1.8), .pictures = false});
  all_three(e, by);
  bounce();
  e.scene({.name = "a ball with e = 0, β = 1", .fill = dropped_ball(0), .seconds = Real(1.2), .pictures = false});
  all_three_at_once(e, by);
  bounce();
}

void study_of_jitter(Experiment& e, const Ways& by, int boxes, Real h) {
  e.study([&e, by, boxes, h] {
    for (const bool with_slop : {true, false}) {
      const auto slop = [&](auto solver) { return with_slop ? solver : no_slop(solver); };
      e.panel({.title = with_slop ? "a stack of " + spelled(boxes) + ", slop 5 mm" : "the same without slop",
               .x_label = "β",
               .y_label = "jitter, mm/s",
               .log_y = true,
               .curves = {jitter_curve<Baumgarte>("Baumgarte", 0, boxes, h, slop(by.baumgarte)),
                          jitter_curve<SplitImpulse>("split impulse", 1, boxes, h, slop(by.split)),
                          jitter_curve<NonlinearGaussSeidel>("non-linear Gauss-Seidel", 2, boxes, h, slop(by.ngs))}});
    }
  });
}

}  // namespace

int main(int argc, char** argv) {
  Experiment e("10_position_correction", "Can an overlap be undone without a velocity?");
  Ways by;
  Real beta = by.baumgarte.beta, most = by.split.most;
  e.parameter({"--beta", "β", "", "Overlap fraction removed per step, or per round", 0, 1}, &beta);
  e.parameter({"--most", "", "m", "Largest correction of a contact per step", 0, 1}, &most);
  e.parameter({"--rounds", "", "", "Rounds of non-linear Gauss-Seidel", 0, 100}, &by.ngs.rounds);
  Real depth = very_deep;
  e.parameter({"--depth", "", "m", "Initial depth of the box", 0.01, 0.4}, &depth);
  int boxes = 10;
  e.parameter({"--boxes", "n", "", "Boxes in the stack", 1, 20}, &boxes);
  WeightlessBall ball;
  e.parameter({"--ball-depth", "d₀", "m", "Initial depth of the ball", 0.001, 0.2}, &ball.depth);
  return e.run(argc, argv, [&] {
    by.baumgarte.beta = by.split.beta = by.ngs.beta = beta;
    by.split.most = by.ngs.most = most;
    twelve_boxes_come_apart(e, by);
    box_in_the_ground(e, by, depth);
    stack_leans(e, by, boxes);
    ball_follows_closed_forms(e, by, ball, e.dt());
    balls_bounce(e, by);
    study_of_jitter(e, by, boxes, e.dt());
  });
}
