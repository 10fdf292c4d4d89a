#include "pushback/chapters/03_baumgarte/baumgarte.h"
#include "pushback/chapters/03_baumgarte/exercise/asked.h"
#include "pushback/common/exercise/shown.h"

namespace pushback::exercise_03 {

namespace {

constexpr Real beta = Real(0.2);

/// What another effect has asked for.
struct Asking : Effect {
  Real bias = 0;
  void build(StepContext& step) {
    for (Row& row : step.rows) row.bias = bias;
  }
};

using PushingOut = Solver<Clamping, AnyEffect>;
using PushingOutToo = Solver<Clamping, Asking, AnyEffect>;

/// A ball without weight, `depth` deep in the ground; above it where that is negative.
struct Ball {
  World world;
  Real h;

  Ball(Random& random, Real depth, Real speed = 0) : h(1 / random.between(50, 240)) {
    const Real radius = random.between(Real(0.2), Real(0.5));
    world.gravity.setZero();
    world.add(ground());
    world.add(sphere(radius, random.between(5, 20)).at({0, radius - depth, 0}).moving({0, speed, 0}));
    world.contacts = {{.point = {0, -depth / 2, 0}, .normal = {0, 1, 0}, .depth = depth, .id = {0, 1, 0}}};
  }
  /// Its speed after a step's solver, m/s; of all numbers of the check the one with this index.
  template <class ContactSolver>
  Real solved(ContactSolver solver, std::size_t quantity = 0) {
    solver.solve(world, h, 1);
    show(world, quantity);
    return world.bodies[1].velocity.y();
  }
};

std::vector<Check<Answer>> checks() {
  return {
      {"a ball that is too deep leaves at β d / h",
       1,
       {{"your ball, which is too deep, leaves with", "m/s", 1e-6}},
       [](Random& random, const Answer& answer) -> Numbers {
         Ball ball(random, random.between(Real(0.01), Real(0.05)));
         return {ball.solved(with_effect<PushingOut>(answer.push_out))};
       }},
      {"a ball that is still apart goes its way, and is not let in",
       1,
       {{"your ball, which is still above the ground and leaving, leaves with", "m/s", 1e-6},
        {"your ball, which is still above the ground and coming nearer, goes on with", "m/s", 1e-6}},
       [](Random& random, const Answer& answer) -> Numbers {
         const Real gap = random.between(Real(0.02), Real(0.05));
         Ball leaving(random, -gap, random.between(Real(0.01), Real(0.1)));
         Ball coming(random, -gap, -random.between(6, 8));
         const auto solver = with_effect<PushingOut>(answer.push_out);
         return {leaving.solved(solver, 0), coming.solved(solver, 1)};
       }},
      {"of two wishes the one for more speed stays",
       1,
       {{"your ball, of which another effect asks more speed, leaves with", "m/s", 1e-6},
        {"your ball, of which another effect asks less speed, leaves with", "m/s", 1e-6}},
       [](Random& random, const Answer& answer) -> Numbers {
         auto solver = with_effect<PushingOutToo>(answer.push_out);
         Ball more(random, Real(0.02)), less(random, Real(0.02));
         solver.bias = -2 * beta * Real(0.02) / more.h;
         const Real faster = more.solved(solver, 0);
         solver.bias = Real(-0.5) * beta * Real(0.02) / less.h;
         return {faster, less.solved(solver, 1)};
       }},
      {"under gravity a box comes up along d₀ (1−β)ᵏ",
       2,
       {{"after some steps your box is deep by", "mm", 1e-4}, {"and moves up with", "m/s", 1e-5}},
       [](Random& random, const Answer& answer) -> Numbers {
         World world;
         const Real half = random.between(Real(0.4), Real(0.6)), depth = random.between(Real(0.03), Real(0.06));
         world.add(ground());
         world.add(box(Vec3::Constant(half), 100).at({0, half - depth, 0}));
         auto solver = with_effect<PushingOut>(answer.push_out);
         const std::size_t steps = 3 + random.below(10);
         Numbers depths{1000 * depth};
         for (std::size_t step = 0; step < steps; ++step) {
           world.step(solver, Real(1) / 60, 100);
           show(world);
           depths.push_back(1000 * (half - world.bodies[1].position.y()));
         }
         return with_record({depths.back(), world.bodies[1].velocity.y()}, depths);
       }},
  };
}

/// A mistake is what it makes of b.
template <class Bias>
struct Mistaken : Effect {
  Bias bias;
  void build(StepContext& step) {
    for (std::size_t i = 0; i < step.contacts.size(); ++i)
      step.rows[i].bias = bias(step.rows[i].bias, step.rows[i].separation, step.dt);
  }
};
template <class Bias>
Answer mistaken(Bias bias) {
  return {Mistaken<Bias>{{}, bias}};
}

std::vector<Mistake<Answer>> mistakes() {
  const std::string per_step =
      "it looks as if 1/h were forgotten. β d is a distance; to cover it within one step, the speed is β d / h.";
  const std::string sign =
      "it looks as if b had the wrong sign. b is minus the wanted speed, and C is negative where bodies overlap: b = "
      "β/h C.";
  const std::string apart =
      "it looks as if points that are still apart were pushed, too. Where C > 0 there is no overlap to undo.";
  const std::string least =
      "it looks as if b were simply overwritten. Another effect may want more speed, and points that are "
      "still apart want none: keep the lesser b, by min.";
  return {
      {"1/h forgotten", per_step, mistaken([](Real b, Real c, Real) { return std::min(b, beta * c); })},
      {"1/h forgotten", per_step, mistaken([](Real, Real c, Real) { return beta * c; })},
      {"h for 1/h", "it looks as if β d were multiplied by h. A distance divided by a time is a speed: β d / h.",
       mistaken([](Real b, Real c, Real h) { return std::min(b, beta * h * c); })},
      {"β forgotten",
       "it looks as if β were forgotten. One step is to take away the part β of the overlap, not all of it.",
       mistaken([](Real b, Real c, Real h) { return std::min(b, c / h); })},
      {"sign", sign, mistaken([](Real b, Real c, Real h) { return std::min(b, -beta / h * c); })},
      {"sign", sign, mistaken([](Real, Real c, Real h) { return -beta / h * c; })},
      {"a push on points that are apart", apart,
       mistaken([](Real b, Real c, Real h) { return std::min(b, -beta / h * std::abs(c)); })},
      {"a push on points that are apart", apart,
       mistaken([](Real, Real c, Real h) { return -beta / h * std::abs(c); })},
      {"min forgotten", least, mistaken([](Real, Real c, Real h) { return beta / h * c; })},
      {"min forgotten", least, mistaken([](Real, Real c, Real h) { return beta / h * std::min(Real(0), c); })},
      {"max for min",
       "it looks as if the greater b were kept, by max. b is minus a speed: of two wishes the lesser b is the one for "
       "more speed.",
       mistaken([](Real b, Real c, Real h) { return std::max(b, beta / h * c); })},
      {"wishes added",
       "it looks as if the wishes were added up. Each is a speed that is enough for its effect: keep the lesser b, by "
       "min.",
       mistaken([](Real b, Real c, Real h) { return b + std::min(Real(0), beta / h * c); })},
  };
}

}  // namespace

Numbers play(std::size_t check, Random& random, const Answer& answer) {
  return checks()[check].play(random, answer);
}

Exercise exercise() {
  return exercise_of<Answer>(
      "the push-out",
      {"The row solves J V + b = 0: b is minus the separating speed that you want.",
       "After one step of h seconds the part β of the depth d = -C should be gone. Which speed covers β d in h?",
       "b = β/h C, with C = row.separation: negative, so it asks for a positive speed. Keep the lesser of "
       "this and the b that is there already: std::min."},
      checks(), {Baumgarte{{}, beta}}, mistakes(), {{3, {"depth of your box", "mm", "step"}}});
}

}  // namespace pushback::exercise_03
