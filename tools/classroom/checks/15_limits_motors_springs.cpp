#include "pushback/chapters/15_limits_motors_springs/exercise/asked.h"
#include "pushback/chapters/15_limits_motors_springs/limits.h"

namespace pushback::exercise_15 {

namespace {

/// A load on a rope from a hand at the origin, whose row is solved as if a step began.
struct Roped {
  Real mass, h, strength, beta;

  /// In short steps C h, C h² and 0 are almost the same b, and C/h² is more than any load needs; in these each is another.
  explicit Roped(Random& random)
      : mass(random.between(2, 10)),
        h(random.between(Real(0.5), Real(0.7))),
        strength(1e6),
        beta(random.between(Real(0.1), Real(0.4))) {}
  /// Its speed away from the hand, m/s, before and after. `slack`: m.
  Real solved(Real slack, Real speed, Random& random, const Answer& answer) const {
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
    return load.velocity.dot(away);
  }
};

/// The chapter's limit, which asks in forces, as a row has it.
void right(JointRow& rope, Real strength, Real beta, Real h) {
  const Equation asked = at_least_zero({.jacobian = rope, .hi = strength}, rope.separation, h);
  rope.bias = asked.bias + beta / h * asked.error;
  rope.lo = h * asked.lo;
  rope.hi = h * asked.hi;
}

}  // namespace

std::vector<Check<Answer>> checks_of(const Answer& /*any*/) {
  return {
      {"a taut rope stops a load that moves away, but not one that approaches", 1,
       [](Random& random, const Answer& answer) -> std::vector<Reading> {
         const Roped roped(random);
         const Real leaves = random.between(2, 5), comes = random.between(2, 5);
         return {{"your load, which was moving away on a taut rope, continues at",
                  roped.solved(0, leaves, random, answer), "m/s"},
                 {"your load, which was already approaching, continues at", -roped.solved(0, -comes, random, answer),
                  "m/s"}};
       },
       "a rope pulls and never pushes, so its accumulated impulse is 0 or more. A taut rope stops a load that moves "
       "away, and gives no impulse to one that approaches."},
      {"a load on a slack rope gets no farther than the length of the rope", 2,
       [](Random& random, const Answer& answer) -> std::vector<Reading> {
         const Roped roped(random);
         const Real slack = random.between(1, 2), fastest = slack / roped.h;
         const Real slow = random.between(Real(0.6), Real(0.9)), fast = random.between(Real(1.5), 3);
         return {{"your load, which cannot reach the end of its rope in this step, continues at",
                  roped.solved(slack, slow * fastest, random, answer), "m/s"},
                 {"your load, which would pass the end of its rope in this step, continues at",
                  roped.solved(slack, fast * fastest, random, answer), "m/s"}};
       },
       "a slack rope lets its load move away at up to C/h, so the rope is just taut at the end of this step."},
      {"a load that is too far comes back by the fraction β, or faster if it already approaches faster", 1,
       [](Random& random, const Answer& answer) -> std::vector<Reading> {
         const Roped roped(random);
         const Real too_long = random.between(1, 2), comes = random.between(1, 2) * too_long / roped.h;
         return {{"your load, which is too far, comes back at", -roped.solved(-too_long, 0, random, answer), "m/s"},
                 {"your load, which is too far and already approaching fast, continues at",
                  -roped.solved(-too_long, -comes, random, answer), "m/s"}};
       },
       "an overlong rope is an error, and each step removes the fraction β of it with b = β/h C. The rope does not "
       "slow a load that approaches faster."},
      {"a hand that holds with F slows the load by the impulse h F per step", 2,
       [](Random& random, const Answer& answer) -> std::vector<Reading> {
         Roped roped(random);
         roped.strength = random.between(50, 200);
         const Real fast = random.between(2, 3) * roped.h * roped.strength / roped.mass;
         const Real slack = random.between(Real(0.2), Real(0.5));
         return {{"your load, which pulls harder than the hand holds, continues at",
                  roped.solved(0, fast, random, answer), "m/s"},
                 {"your load, whose rope is slack and which pulls harder than the hand holds, continues at",
                  roped.solved(slack, fast + slack / roped.h, random, answer), "m/s"}};
       },
       "a hand that holds with F gives at most the impulse h F per step, whether the rope is slack, taut or too long."},
  };
}

Exercise exercise() {
  return rebuild_of("a rope that can only pull",
                    {"A row pulls if its impulse is positive. Which range of the accumulated impulse describes a rope "
                     "that never pushes, and that a hand holds with F for h seconds?",
                     "If the rope is slack, C may fall to 0 within this step, and the row makes J V + b = 0 only if "
                     "the load would go farther. At which speed does C fall to 0 in h?",
                     "rope.lo = 0; rope.hi = h * strength. b = C/h if C > 0, and b = β/h C otherwise."},
                    Answer{right});
}

}  // namespace pushback::exercise_15
