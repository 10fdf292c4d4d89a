#include <cmath>

#include "pushback/chapters/24_half_step/exercise/asked.h"

namespace pushback::exercise_24 {

namespace {

/// A ball at rest on a random rod, well away from where it would stay.
Bob let_go(Random& random) {
  const Real angle = random.between(Real(0.6), Real(1.4)), length = random.between(Real(0.8), Real(1.5));
  return {{length * std::sin(angle), -length * std::cos(angle), 0}, Vec3::Zero(), length};
}
Vec3 gravity(Random& random) {
  return {0, -random.between(8, 11), 0};
}

Bob after(Bob bob, const Answer& answer, const Vec3& g, int steps, Real h) {
  for (int i = 0; i < steps; ++i) answer.step(bob, g, h);
  return bob;
}

/// The same by steps that are far shorter, of this chapter.
Vec3 truth(Bob bob, const Vec3& g, int steps, Real h) {
  for (int i = 0; i < 64 * steps; ++i) plain_24::half_step(bob, g, h / 64);
  return bob.x;
}

constexpr Real h = Real(1) / 60;

}  // namespace

std::vector<Check<Answer>> checks_of(const Answer& /*any*/) {
  return {
      {"after one step the rod is as long as it should be, and the ball does not move along it", 1,
       [](Random& random, const Answer& answer) -> std::vector<Reading> {
         Bob bob = let_go(random);
         const Vec3 g = gravity(random);
         bob.v = random.between(1, 2) * bob.rod().cross(Vec3::UnitZ());
         const Bob later = after(bob, answer, g, 1, h);
         return {{"after one step your ball is this much too far from the origin:", later.off(later.x), "m", 1e-9},
                 {"after one step your ball moves along the rod with", later.v.dot(later.rod()), "m/s", 1e-9},
                 {"after one step your ball is at the height", later.x.y(), "m", 1e-7}};
       },
       "after the step C is 0, for which Newton's method goes on until it is, and v has no part along the rod as it "
       "lies then, not even from the second half of the kick."},
      {"after a second the ball is where the step should have brought it", 2,
       [](Random& random, const Answer& answer) -> std::vector<Reading> {
         const Bob bob = let_go(random);
         const Bob later = after(bob, answer, gravity(random), 60, h);
         return {{"after a second your ball is at the height", later.x.y(), "m", 1e-7},
                 {"after a second your ball is to the right by", later.x.x(), "m", 1e-7},
                 {"after a second your ball has the speed", later.v.norm(), "m/s", 1e-7}};
       },
       "the kick comes in two halves, one before the drift and one after it, and the rod holds the ball in between."},
      {"with half of the step it is off by a quarter", 1,
       [](Random& random, const Answer& answer) -> std::vector<Reading> {
         const Bob bob = let_go(random);
         const Vec3 g = gravity(random), right = truth(bob, g, 30, h);
         const Vec3 whole = after(bob, answer, g, 30, h).x, half = after(bob, answer, g, 60, h / 2).x;
         return {{"with half of the step, your ball's error is smaller by the factor",
                  (whole - right).norm() / (half - right).norm(), "", 1e-3},
                 {"with half of the step, your ball is at the height", half.y(), "m", 1e-7}};
       },
       "a step of second order is off by a quarter with half of h. The drift needs the velocity of the middle of the "
       "step, after half of the kick and with what the rod does in it."},
      {"turned round, the ball finds where it began", 1,
       [](Random& random, const Answer& answer) -> std::vector<Reading> {
         const Bob bob = let_go(random);
         const Vec3 g = gravity(random);
         Bob there = after(bob, answer, g, 200, h);
         there.v = -there.v;
         return {{"after 200 steps there and 200 back, your ball is away from where it began by",
                  (after(there, answer, g, 200, h).x - bob.x).norm(), "m"},
                 {"after 200 steps your ball is at the height", there.x.y(), "m"}};
       },
       "backwards in time it has to be the same step. So the impulse acts along the rod as it lies before the drift "
       "and is in v, and the kick has two equal halves."},
  };
}

Exercise exercise() {
  return rebuild_of(
      "a step of second order",
      {"Two halves of the kick, one before the drift, one after it. Write this much first: without a rod the ball then "
       "falls as it should.",
       "Between the first half and the drift: v -= C(x + h v) / h J, over and over. J is the rod as it lies before the "
       "drift, in all rounds.",
       "At the end: v -= (v . J) J, with J as the rod lies now."},
      Answer{plain_24::half_step});
}

}  // namespace pushback::exercise_24
