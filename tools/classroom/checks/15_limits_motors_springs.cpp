#include "pushback/chapters/13_joints/distance.h"
#include "pushback/chapters/15_limits_motors_springs/exercise/asked.h"
#include "pushback/chapters/15_limits_motors_springs/limits.h"
#include "pushback/common/exercise/shown.h"

namespace pushback::exercise_15 {

namespace {

/// A load on a rope from a hand at the origin, whose row is solved as if a step began.
struct Roped {
  Real mass, h, strength, beta;

  explicit Roped(Random& random)
      : mass(random.between(2, 10)),
        h(1 / random.between(40, 100)),
        strength(1e6),
        beta(random.between(Real(0.1), Real(0.4))) {}
  /// Its speed away from the hand, m/s, before and after. `slack`: m.
  Real solved(Real slack, Real speed, Random& random, const Answer& answer, std::size_t quantity) const {
    World world;
    const Vec3 away = random.direction();
    world.add(sphere(Real(0.1), mass).at(away));
    Body& load = world.bodies[0];
    load.velocity = speed * away;
    JointRow rope(world.body(the_world), load, Jacobian::along(-away, world.body(the_world), load, load.position), 0,
                  0);
    rope.separation = slack;
    answer.pull(rope, strength, beta, h);
    for (int sweep = 0; sweep < 4; ++sweep) rope.solve();
    world.joints.push_back(distance(world, the_world, Vec3::Zero(), 0, load.position));  // only to be seen
    show(world, {quantity});
    return load.velocity.dot(away);
  }
};

/// In short steps C h, C h² and 0 are almost the same b, and C/h² is more than any load needs; here each is another.
Roped in_long_steps(Random& random) {
  Roped roped(random);
  roped.h = random.between(Real(0.5), Real(0.7));
  return roped;
}

std::vector<Check<Answer>> checks() {
  return {
      {"a taut rope stops a load that leaves, and lets go one that comes",
       1,
       {{"your load, which was leaving on a taut rope, goes on with", "m/s", 1e-6},
        {"your load, which was coming back by itself, comes with", "m/s", 1e-6}},
       [](Random& random, const Answer& answer) -> Numbers {
         const Roped roped(random);
         const Real leaves = random.between(2, 5), comes = random.between(2, 5);
         return {roped.solved(0, leaves, random, answer, 0), -roped.solved(0, -comes, random, answer, 1)};
       }},
      {"a load on a slack rope goes as far as the rope is long",
       2,
       {{"your load, which cannot reach the end of its rope in this step, goes on with", "m/s", 1e-6},
        {"your load, which would get farther than its rope in this step, goes on with", "m/s", 1e-6},
        {"your load, which would get farther than its nearly taut rope, goes on with", "m/s", 1e-6},
        {"your load, which would get farther than its rope in a step of half a second or more, goes on with", "m/s",
         1e-6}},
       [](Random& random, const Answer& answer) -> Numbers {
         const Roped roped(random);
         const Real slack = random.between(Real(0.02), Real(0.05)), fastest = slack / roped.h;
         const Real slow = fastest * random.between(Real(0.6), Real(0.9)),
                    fast = fastest * random.between(Real(1.5), 3);
         const Real little = random.between(Real(0.001), Real(0.003));
         const Roped slowly = in_long_steps(random);
         const Real far = slack / slowly.h * random.between(4, 6);
         return {roped.solved(slack, slow, random, answer, 0), roped.solved(slack, fast, random, answer, 1),
                 roped.solved(little, fast, random, answer, 2), slowly.solved(slack, far, random, answer, 3)};
       }},
      {"a rope that is too long comes back by the part β, and does not hold up a load that comes faster",
       1,
       {{"your load, which is too far, comes back with", "m/s", 1e-6},
        {"your load, which is too far and was coming fast by itself, comes with", "m/s", 1e-6},
        {"your load, which is too far, comes back in a step of half a second or more with", "m/s", 1e-6}},
       [](Random& random, const Answer& answer) -> Numbers {
         const Roped roped(random);
         const Real slack = -random.between(Real(0.02), Real(0.05)), comes = random.between(1, 2) * -slack / roped.h;
         return {-roped.solved(slack, 0, random, answer, 0), -roped.solved(slack, -comes, random, answer, 1),
                 -in_long_steps(random).solved(slack, 0, random, answer, 2)};
       }},
      {"a hand that holds with F takes h F off the load in a step",
       2,
       {{"your load, which pulls harder than the hand holds, goes on with", "m/s", 1e-6},
        {"your load, which is far too fast for the hand, goes on with", "m/s", 1e-6},
        {"your load, whose rope is slack and which pulls harder than the hand holds, goes on with", "m/s", 1e-6},
        {"your load, whose rope is too long and which pulls harder than the hand holds, goes on with", "m/s", 1e-6}},
       [](Random& random, const Answer& answer) -> Numbers {
         Roped roped(random);
         roped.strength = random.between(50, 200);
         const Real in_a_step = roped.h * roped.strength / roped.mass, in_a_second = roped.strength / roped.mass;
         const Real fast = random.between(2, 3) * in_a_step, faster = random.between(Real(1.5), 2) * in_a_second;
         const Real slack = random.between(Real(0.02), Real(0.05));
         return {roped.solved(0, fast, random, answer, 0), roped.solved(0, faster, random, answer, 1),
                 roped.solved(slack, fast + slack / roped.h, random, answer, 2),
                 roped.solved(-slack, fast + slack / roped.h, random, answer, 3)};
       }},
  };
}

/// The chapter's limit, which asks in forces, as a row has it.
void right(JointRow& rope, Real strength, Real beta, Real h) {
  const Equation asked = at_least_zero({.jacobian = rope, .hi = strength}, rope.separation, h);
  rope.bias = asked.bias + beta / h * asked.error;
  rope.lo = h * asked.lo;
  rope.hi = h * asked.hi;
}

std::vector<Mistake<Answer>> mistakes() {
  const std::string impulse =
      "it looks as if a force stood where the row has an impulse. A force of F does h F in a step of h seconds: as an "
      "impulse, F is what the hand does in a whole second.";
  const std::string late =
      "it looks as if the rope acted only once it is too long. The load then gets past the end and is stopped a step "
      "late: look ahead, and ask for C ≥ 0 at the end of this step.";
  const std::string pushes =
      "it looks as if the rope could push. A rope has no stiffness: its impulse is never below 0.";
  const std::string turned =
      "it looks as if the limits were turned round. In this row an impulse above 0 pulls: from 0 up to h F.";
  const std::string a_speed =
      "it looks as if h did not turn a length into a speed. In b stand speeds: C/h where the rope is slack, and β/h C "
      "where it is too long.";
  const std::string only_one =
      "it looks as if the hand's limit held in one of the two cases alone. The hand slips above F, slack rope or not.";
  return {
      {"h in the wrong place", a_speed, {[](JointRow& rope, Real strength, Real beta, Real h) {
         right(rope, strength, beta, h);
         if (rope.separation <= 0) rope.bias /= h;
       }}},
      {"h in the wrong place", a_speed, {[](JointRow& rope, Real strength, Real beta, Real h) {
         right(rope, strength, beta, h);
         if (rope.separation <= 0) rope.bias *= h * h;
       }}},
      {"h in the wrong place", a_speed, {[](JointRow& rope, Real strength, Real beta, Real h) {
         right(rope, strength, beta, h);
         if (rope.separation > 0) rope.bias /= h;
       }}},
      {"h in the wrong place", a_speed, {[](JointRow& rope, Real strength, Real beta, Real h) {
         right(rope, strength, beta, h);
         if (rope.separation > 0) rope.bias *= h * h;
       }}},
      {"hi for lo",
       "it looks as if lo and hi were exchanged. In this row an impulse above 0 pulls: the least sum is 0, the largest "
       "h F.",
       {[](JointRow& rope, Real strength, Real beta, Real h) {
         right(rope, strength, beta, h);
         std::swap(rope.lo, rope.hi);
       }}},
      {"the hand's limit in one case", only_one, {[](JointRow& rope, Real strength, Real beta, Real h) {
         right(rope, strength, beta, h);
         if (rope.separation <= 0) rope.hi = std::numeric_limits<Real>::infinity();
       }}},
      {"the hand's limit in one case", only_one, {[](JointRow& rope, Real strength, Real beta, Real h) {
         right(rope, strength, beta, h);
         if (rope.separation > 0) rope.hi = std::numeric_limits<Real>::infinity();
       }}},
      {"a force for an impulse", impulse, {[](JointRow& rope, Real strength, Real beta, Real h) {
         right(rope, strength, beta, h);
         rope.hi = strength;
       }}},
      {"no limit of the hand",
       "it looks as if the hand could hold any load. It slips above F: rope.hi is the impulse of that force in this "
       "step, h F.",
       {[](JointRow& rope, Real strength, Real beta, Real h) {
         right(rope, strength, beta, h);
         rope.hi = std::numeric_limits<Real>::infinity();
       }}},
      {"active only when violated", late, {[](JointRow& rope, Real strength, Real beta, Real h) {
         right(rope, strength, beta, h);
         if (rope.separation > 0) rope.hi = 0;
       }}},
      {"active only when violated", late, {[](JointRow& rope, Real strength, Real beta, Real h) {
         right(rope, strength, beta, h);
         if (rope.separation >= 0) rope.hi = 0;
       }}},
      {"C/h forgotten",
       "it looks as if b were 0 while the rope is slack. The row then asks that the load get no farther from now on: "
       "it is caught in the air, by a rope that hangs loose.",
       {[](JointRow& rope, Real strength, Real beta, Real h) {
         right(rope, strength, beta, h);
         if (rope.separation > 0) rope.bias = 0;
       }}},
      {"β for the slack",
       "it looks as if the slack were fed back as an error is, by the part β. Slack is no error: all of it may be used "
       "in this step, C/h.",
       {[](JointRow& rope, Real strength, Real beta, Real h) {
         right(rope, strength, beta, h);
         rope.bias = beta / h * rope.separation;
       }}},
      {"β forgotten",
       "it looks as if β were forgotten where the rope is too long. A rope that is too long is an error, and a step "
       "takes away the part β of it.",
       {[](JointRow& rope, Real strength, Real beta, Real h) {
         right(rope, strength, beta, h);
         rope.bias = rope.separation / h;
       }}},
      {"the rope pushes", pushes, {[](JointRow& rope, Real strength, Real beta, Real h) {
         right(rope, strength, beta, h);
         rope.lo = -std::numeric_limits<Real>::infinity();
       }}},
      {"the rope pushes", pushes, {[](JointRow& rope, Real strength, Real beta, Real h) {
         right(rope, strength, beta, h);
         rope.lo = -rope.hi;
       }}},
      {"limits turned round", turned, {[](JointRow& rope, Real strength, Real beta, Real h) {
         right(rope, strength, beta, h);
         rope.lo = -rope.hi;
         rope.hi = 0;
       }}},
      {"1/h forgotten",
       "it looks as if 1/h were forgotten. C is a length: a load that is to cover it in this step needs the speed C/h.",
       {[](JointRow& rope, Real strength, Real beta, Real h) {
         right(rope, strength, beta, h);
         rope.bias *= h;
       }}},
      {"sign of b",
       "it looks as if b had the wrong sign. The row solves J V + b = 0, and J V is how fast C grows: C may fall by "
       "C/h a second, so b = C/h.",
       {[](JointRow& rope, Real strength, Real beta, Real h) {
         right(rope, strength, beta, h);
         rope.bias *= -1;
       }}},
      {"no feedback",
       "it looks as if nothing were fed back where the rope is too long. The rope then keeps the load from going on, "
       "but stays too long.",
       {[](JointRow& rope, Real strength, Real beta, Real h) {
         right(rope, strength, beta, h);
         rope.bias = std::max(Real(0), rope.bias);
       }}},
  };
}

}  // namespace

Numbers play(std::size_t check, Random& random, const Answer& answer) {
  return checks()[check].play(random, answer);
}

Exercise exercise() {
  return rebuild_of<Answer>(
      "a rope that can only pull",
      {"A row pulls where its impulse is above 0. Which sums does a rope allow that never pushes, and that a hand "
       "holds with F for h seconds?",
       "Where the rope is slack, C may fall to 0 within this step, and the row wants J V + b = 0 only if the load "
       "would go farther: at which speed does C fall to 0 in h?",
       "rope.lo = 0; rope.hi = h * strength. b = C/h where C > 0, and b = β/h C where it is not."},
      checks(), {right}, mistakes());
}

}  // namespace pushback::exercise_15
