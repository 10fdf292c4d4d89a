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
    show(world, {quantity});
    return world.bodies[1].velocity.y();
  }
};

/// Five balls beside each other: the speeds of the first and of the last, m/s.
std::pair<Real, Real> five_balls(Random& random, const Answer& answer) {
  World world;
  world.gravity.setZero();
  world.add(ground());
  for (std::uint32_t i = 1; i <= 5; ++i) {
    const Real depth = random.between(Real(0.01), Real(0.1)), x = 2 * static_cast<Real>(i);
    world.add(sphere(Real(0.5), random.between(5, 20)).at({x, Real(0.5) - depth, 0}));
    world.contacts.push_back({.point = {x, -depth / 2, 0}, .normal = {0, 1, 0}, .depth = depth, .id = {0, i, 0}});
  }
  auto solver = with_effect<PushingOut>(answer.push_out);
  solver.solve(world, 1 / random.between(50, 240), 1);
  show(world, {2, 3});
  return {world.bodies[1].velocity.y(), world.bodies[5].velocity.y()};
}

std::vector<Check<Answer>> checks() {
  return {
      {"a ball that is too deep leaves at β d / h",
       1,
       {{"your ball, which is too deep, leaves with", "m/s", 1e-6},
        {"your ball, which is very deep, leaves with", "m/s", 1e-6},
        {"of five balls, each of another depth, the first leaves with", "m/s", 1e-6},
        {"of five balls, each of another depth, the last leaves with", "m/s", 1e-6}},
       [](Random& random, const Answer& answer) -> Numbers {
         Ball ball(random, random.between(Real(0.01), Real(0.05)));
         Ball deep(random, random.between(Real(0.5), Real(0.8)));
         auto solver = with_effect<PushingOut>(answer.push_out);  // one, for steps of another length
         solver.solve(ball.world, ball.h, 1);
         show(ball.world, {0});
         solver.solve(deep.world, deep.h, 1);
         show(deep.world, {1});
         const Real alone = ball.world.bodies[1].velocity.y(), fast = deep.world.bodies[1].velocity.y();
         const auto [first, last] = five_balls(random, answer);
         return {alone, fast, first, last};
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
        {"your ball, of which another effect asks less speed, leaves with", "m/s", 1e-6},
        {"your ball above the ground, of which another effect asks a speed, leaves with", "m/s", 1e-6}},
       [](Random& random, const Answer& answer) -> Numbers {
         auto solver = with_effect<PushingOutToo>(answer.push_out);
         Ball more(random, Real(0.02)), less(random, Real(0.02));
         solver.bias = -2 * beta * Real(0.02) / more.h;
         const Real faster = more.solved(solver, 0);
         solver.bias = Real(-0.5) * beta * Real(0.02) / less.h;
         const Real slower = less.solved(solver, 1);
         Ball above(random, Real(-0.02));
         solver.bias = -random.between(1, 2);
         return {faster, slower, above.solved(solver, 2)};
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
         const Real h = 1 / random.between(50, 240);
         Numbers depths{1000 * depth};
         for (std::size_t step = 0; step < steps; ++step) {
           world.step(solver, h, 100);
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

/// It keeps a number of its first step, h or each depth, for all others.
struct KeepsH : Effect {
  Real h = 0;
  void build(StepContext& step) {
    if (h == 0) h = step.dt;
    for (Row& row : step.rows) row.bias = std::min(row.bias, beta / h * row.separation);
  }
};
struct KeepsDepth : Effect {
  std::vector<Real> first = {};
  void build(StepContext& step) {
    for (std::size_t i = first.size(); i < step.rows.size(); ++i) first.push_back(step.rows[i].separation);
    for (std::size_t i = 0; i < step.rows.size(); ++i)
      step.rows[i].bias = std::min(step.rows[i].bias, beta / step.dt * first[i]);
  }
};

/// b of all rows by what it makes of all separations.
struct FirstDepthForAll : Effect {
  void build(StepContext& step) {
    for (Row& row : step.rows) row.bias = std::min(row.bias, beta / step.dt * step.rows[0].separation);
  }
};
struct DeepestForAll : Effect {
  void build(StepContext& step) {
    Real deepest = 0;
    for (const Row& row : step.rows) deepest = std::min(deepest, row.separation);
    for (Row& row : step.rows) row.bias = std::min(row.bias, beta / step.dt * deepest);
  }
};
struct Some : Effect {
  std::size_t first = 0, left_out = 0;  // how many rows count from the first on, or are left out at the end
  void build(StepContext& step) {
    const std::size_t all = step.rows.size(),
                      count = first > 0 ? std::min(first, all) : std::max(all, left_out + 1) - left_out;
    for (std::size_t i = 0; i < std::min(count, all); ++i)
      step.rows[i].bias = std::min(step.rows[i].bias, beta / step.dt * step.rows[i].separation);
  }
};

std::vector<Mistake<Answer>> mistakes() {
  const std::string per_step =
      "it looks as if 1/h were forgotten. β d is a distance; to cover it within one step, the speed is β d / h.";
  const std::string sign =
      "it looks as if b had the wrong sign. b is minus the wanted speed, and C is negative where bodies overlap: b = "
      "β/h C.";
  const std::string apart =
      "it looks as if points that are still apart were pushed, too. Where C > 0 there is no overlap to undo.";
  const std::string least =
      "it looks as if b were simply overwritten. Another effect may want more speed, and points that are still apart "
      "want none: keep the lesser b, by min.";
  const std::string some =
      "it looks as if some contacts were left out. Every row has a b of its own, up to step.contacts.size().";
  const std::string another =
      "it looks as if all rows had the separation of one of them. Each point is as deep as it is: C of its own row.";
  return {
      {"β/h²",
       "it looks as if β d were divided by h twice. A distance divided by a time is a speed: β d / h; divided once "
       "more it would be an acceleration.",
       mistaken([](Real b, Real c, Real h) { return std::min(b, beta / (h * h) * c); })},
      {"the h of the first step",
       "it looks as if h were that of the first step. Steps may be of different lengths: step.dt is the length of this "
       "one.",
       {KeepsH{}}},
      {"the depth of the first step",
       "it looks as if the depth were that of the first step. Each step begins with the depth that is left: β of that "
       "is to go, less each time.",
       {KeepsDepth{}}},
      {"another row's depth", another, {FirstDepthForAll{}}},
      {"another row's depth", another, {DeepestForAll{}}},
      {"contacts left out", some, {Some{{}, 1, 0}}},
      {"contacts left out", some, {Some{{}, 2, 0}}},
      {"contacts left out", some, {Some{{}, 3, 0}}},
      {"contacts left out", some, {Some{{}, 0, 1}}},
      {"no b for points that are apart",
       "it looks as if b became 0 where the points are apart. Another effect may have asked for a speed there: leave "
       "its b as it is.",
       mistaken([](Real b, Real c, Real h) { return c < 0 ? std::min(b, beta / h * c) : 0; })},
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
       "b = β/h C, with C = row.separation: negative, so it asks for a positive speed. Keep the lesser of this and the "
       "b that is there already: std::min."},
      checks(), {Baumgarte{{}, beta}}, mistakes(), {{3, {"depth of your box", "mm", "step"}}});
}

}  // namespace pushback::exercise_03
