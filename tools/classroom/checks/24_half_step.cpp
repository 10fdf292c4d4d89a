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

std::vector<Check<Answer>> checks() {
  return {
      {"after one step the rod is as long as it should be, and the ball does not move along it",
       1,
       {{"after one step your ball is this much too far from the origin:", "m", 1e-9},
        {"after one step your ball moves along the rod with", "m/s", 1e-9},
        {"after one step your ball is at the height", "m", 1e-7}},
       [](Random& random, const Answer& answer) -> Numbers {
         Bob bob = let_go(random);
         const Vec3 g = gravity(random);
         bob.v = random.between(1, 2) * bob.rod().cross(Vec3::UnitZ());
         const Bob later = after(bob, answer, g, 1, h);
         return {later.off(later.x), later.v.dot(later.rod()), later.x.y()};
       }},
      {"after a second the ball is where the step should have brought it",
       2,
       {{"after a second your ball is at the height", "m", 1e-7},
        {"after a second your ball is to the right by", "m", 1e-7},
        {"after a second your ball has the speed", "m/s", 1e-7}},
       [](Random& random, const Answer& answer) -> Numbers {
         const Bob bob = let_go(random);
         const Bob later = after(bob, answer, gravity(random), 60, h);
         return {later.x.y(), later.x.x(), later.v.norm()};
       }},
      {"with half of the step it is off by a quarter",
       1,
       {{"with half of the step, your ball's error is smaller by the factor", "", 1e-3},
        {"with half of the step, your ball is at the height", "m", 1e-7}},
       [](Random& random, const Answer& answer) -> Numbers {
         const Bob bob = let_go(random);
         const Vec3 g = gravity(random), right = truth(bob, g, 30, h);
         const Vec3 whole = after(bob, answer, g, 30, h).x, half = after(bob, answer, g, 60, h / 2).x;
         return {(whole - right).norm() / (half - right).norm(), half.y()};
       }},
      {"turned round, the ball finds where it began",
       1,
       {{"after 200 steps there and 200 back, your ball is away from where it began by", "m", 1e-6},
        {"after 200 steps your ball is at the height", "m", 1e-6}},
       [](Random& random, const Answer& answer) -> Numbers {
         const Bob bob = let_go(random);
         const Vec3 g = gravity(random);
         Bob there = after(bob, answer, g, 200, h);
         there.v = -there.v;
         return {(after(there, answer, g, 200, h).x - bob.x).norm(), there.x.y()};
       }},
  };
}

void drift_and_kick(Bob& bob, const Vec3& g, Real step) {
  bob.x += step * bob.v;
  bob.v += step / 2 * g;
}

constexpr auto whole_kick =
    "it looks as if the whole kick came first. Then the drift takes a velocity from the end of the step, and is off by "
    "g h²/2 in each.";
constexpr auto new_rod =
    "it looks as if the rod put the ball back along the line on which it lies after the drift, or moved the ball and "
    "not its velocity: both come to the same. Backwards in time that would be another step: the impulse has to act "
    "along the rod as it lies before, and to be in v.";
constexpr auto only_speed =
    "it looks as if only the speed along the rod were held, and not its length. Each step follows the tangent, and the "
    "rod gets longer.";

std::vector<Mistake<Answer>> mistakes() {
  return {
      {"the whole kick first", whole_kick, {[](Bob& bob, const Vec3& g, Real step) {
         bob.v += step * g;
         plain_24::hold(bob, bob.rod(), step);
         bob.x += step * bob.v;
         bob.project();
       }}},
      {"the whole kick first", whole_kick, {plain_24::whole_step}},
      {"the average of velocities",
       "it looks as if the ball moved by the average of its velocities before and after. What holds it is then solved "
       "for one of the two, and the step is of first order.",
       {plain_24::average_step}},
      {"along the new rod", new_rod, {plain_24::new_rod_step}},
      {"along the new rod", new_rod, {[](Bob& bob, const Vec3& g, Real step) {
         bob.v += step / 2 * g;
         bob.x += step * bob.v;
         bob.x *= bob.length / bob.x.norm();
         bob.v += step / 2 * g;
         bob.project();
       }}},
      {"the second half forgotten",
       "it looks as if the second half of the kick were missing. The ball then falls with half of g.",
       {[](Bob& bob, const Vec3& g, Real step) {
         bob.v += step / 2 * g;
         plain_24::hold(bob, bob.rod(), step);
         bob.x += step * bob.v;
         bob.project();
       }}},
      {"the velocity not projected",
       "it looks as if the last line were missing. The rod turns in a step, and what the ball had across it "
       "is no longer across it.",
       {[](Bob& bob, const Vec3& g, Real step) {
         bob.v += step / 2 * g;
         plain_24::hold(bob, bob.rod(), step);
         drift_and_kick(bob, g, step);
       }}},
      {"projected before the second half",
       "it looks as if the speed along the rod were taken away before the second half of the kick. That half "
       "has a part along the rod, too.",
       {[](Bob& bob, const Vec3& g, Real step) {
         bob.v += step / 2 * g;
         plain_24::hold(bob, bob.rod(), step);
         bob.x += step * bob.v;
         bob.project();
         bob.v += step / 2 * g;
       }}},
      {"the length not held", only_speed, {[](Bob& bob, const Vec3& g, Real step) {
         bob.v += step / 2 * g;
         bob.project();
         drift_and_kick(bob, g, step);
         bob.project();
       }}},
      {"the length not held", only_speed, {[](Bob& bob, const Vec3& g, Real step) {
         bob.v += step / 2 * g;
         drift_and_kick(bob, g, step);
         bob.project();
       }}},
      {"one round of Newton's method",
       "it looks as if Newton's method had one round. What it leaves is small, and it is not 0: go on until C is.",
       {[](Bob& bob, const Vec3& g, Real step) {
         bob.v += step / 2 * g;
         bob.v -= bob.off(bob.x + step * bob.v) / step * bob.rod();
         drift_and_kick(bob, g, step);
         bob.project();
       }}},
  };
}

}  // namespace

Numbers play(std::size_t check, Random& random, const Answer& answer) {
  return checks()[check].play(random, answer);
}

Exercise exercise() {
  return rebuild_of<Answer>(
      "a step of second order",
      {"Two halves of the kick, one before the drift, one after it. Write this much first: without a rod the ball then "
       "falls as it should.",
       "Between the first half and the drift: v -= C(x + h v) / h J, over and over. J is the rod as it lies before the "
       "drift, in all rounds.",
       "At the end: v -= (v . J) J, with J as the rod lies now."},
      checks(), {plain_24::half_step}, mistakes());
}

}  // namespace pushback::exercise_24
