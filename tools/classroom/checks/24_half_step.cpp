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
      {"after one step the rod has its right length, and the ball does not move along it", 1,
       [](Random& random, const Answer& answer) -> std::vector<Reading> {
         Bob bob = let_go(random);
         const Vec3 g = gravity(random);
         bob.v = random.between(1, 2) * bob.rod().cross(Vec3::UnitZ());
         const Bob later = after(bob, answer, g, 1, h);
         return {{"after one step your ball is too far from the origin by", later.off(later.x), "m", 1e-9},
                 {"after one step the speed of your ball along the rod is", later.v.dot(later.rod()), "m/s", 1e-9},
                 {"after one step the height of your ball is", later.x.y(), "m", 1e-7}};
       },
       "after the step C is 0, because Newton's method continues until it is. v has no component along the new "
       "direction of the rod, not even from the second half of the kick."},
      {"after a second the ball is where exact steps of this kind take it", 2,
       [](Random& random, const Answer& answer) -> std::vector<Reading> {
         const Bob bob = let_go(random);
         const Bob later = after(bob, answer, gravity(random), 60, h);
         return {{"after a second the height of your ball is", later.x.y(), "m", 1e-7},
                 {"after a second the distance of your ball to the right is", later.x.x(), "m", 1e-7},
                 {"after a second the speed of your ball is", later.v.norm(), "m/s", 1e-7}};
       },
       "the kick comes in two halves, one before the drift and one after it. The rod holds the ball in between."},
      {"halving the step divides the error by four", 1,
       [](Random& random, const Answer& answer) -> std::vector<Reading> {
         const Bob bob = let_go(random);
         const Vec3 g = gravity(random), right = truth(bob, g, 30, h);
         const Vec3 whole = after(bob, answer, g, 30, h).x, half = after(bob, answer, g, 60, h / 2).x;
         return {{"halving the step divides the error of your ball by", (whole - right).norm() / (half - right).norm(),
                  "", 1e-3},
                 {"with half the step, the height of your ball is", half.y(), "m", 1e-7}};
       },
       "for a step of second order, halving h divides the error by four. The drift needs the velocity in the middle of "
       "the step, after half of the kick and the rod's impulse."},
      {"run backwards, the ball returns to its start", 1,
       [](Random& random, const Answer& answer) -> std::vector<Reading> {
         const Bob bob = let_go(random);
         const Vec3 g = gravity(random);
         Bob there = after(bob, answer, g, 200, h);
         there.v = -there.v;
         return {{"after 200 steps forwards and 200 backwards, the distance of your ball from its start is",
                  (after(there, answer, g, 200, h).x - bob.x).norm(), "m"},
                 {"after 200 steps the height of your ball is", there.x.y(), "m"}};
       },
       "the step must be the same backwards in time. So the impulse acts along the rod's direction before the drift "
       "and is part of v, and the kick has two equal halves."},
  };
}

Exercise exercise() {
  return rebuild_of("a step of second order",
                    {"Split the kick into two halves, one before the drift and one after it. Write only this at first. "
                     "Without a rod the ball then falls as it should.",
                     "Between the first half and the drift, repeat v -= C(x + h v) / h J. In all rounds, J is the "
                     "direction of the rod before the drift.",
                     "At the end, v -= (v . J) J with the new direction J of the rod."},
                    Answer{plain_24::half_step});
}

}  // namespace pushback::exercise_24
