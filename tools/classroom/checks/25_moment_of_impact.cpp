#include <cmath>

#include "pushback/chapters/25_moment_of_impact/exercise/asked.h"

namespace pushback::exercise_25 {

namespace {

constexpr Real h = Real(1) / 60;

Real gravity(Random& random) {
  return random.between(8, 11);
}
Ball after(Ball ball, const Answer& answer, Real g, int steps, Real dt) {
  for (int i = 0; i < steps; ++i) answer.step(ball, g, dt);
  return ball;
}

}  // namespace

std::vector<Check<Answer>> checks_of(const Answer& /*any*/) {
  return {
      {"a ball that hits the ground within a step bounces there, and rises for the rest of the step", 2,
       [](Random& random, const Answer& answer) -> std::vector<Reading> {
         const Real g = gravity(random), e = random.between(Real(0.4), Real(0.8));
         const Ball begin{random.between(Real(0.01), Real(0.03)), -random.between(4, 6), e};
         const Ball ball = after(begin, answer, g, 1, h);
         return {{"after the step the height of your ball is", ball.y, "m", 1e-9},
                 {"after the step your ball rises at", ball.v, "m/s", 1e-9}};
       },
       "the ball falls along a parabola and hits the ground after the time t. It leaves the ground at e times its "
       "speed, and flies for the rest of the step."},
      {"a ball may hit the ground several times in a step", 1,
       [](Random& random, const Answer& answer) -> std::vector<Reading> {
         const Real g = gravity(random), e = random.between(Real(0.85), Real(0.9));
         const Ball begin{0, random.between(Real(0.18), Real(0.22)), e};
         const Ball ball = after(begin, answer, g, 1, Real(0.1));
         return {{"after a step of 0.1 s the height of your ball is", ball.y, "m", 1e-9},
                 {"after a step of 0.1 s your ball rises at", ball.v, "m/s", 1e-9}};
       },
       "a low ball hits the ground again before the step is over. After each bounce, treat the rest of the step in the "
       "same way."},
      {"after a second and a half the ball is in the right place, however long the steps are", 1,
       [](Random& random, const Answer& answer) -> std::vector<Reading> {
         const Real g = gravity(random), e = random.between(Real(0.7), Real(0.9));
         const Ball begin{random.between(Real(0.8), Real(1.2)), random.between(-1, 1), e};
         return {
             {"in steps of 1/60 s, your ball reaches the height", after(begin, answer, g, 90, h).y, "m", 1e-9},
             {"in steps of 1/240 s, your ball reaches the height", after(begin, answer, g, 360, h / 4).y, "m", 1e-9}};
       },
       "flights are exact, and so is the moment of each bounce. If no time is lost or gained at a bounce, the length "
       "of the steps does not matter."},
      {"a ball that would bounce for ever comes to rest, but not too early", 1,
       [](Random& random, const Answer& answer) -> std::vector<Reading> {
         const Real g = gravity(random), e = random.between(Real(0.6), Real(0.8));
         const Ball rests = after({1, 0, e}, answer, g, 600, h);
         const auto speed_after = [&](Real steps) {  // T is so many, once it has bounced
           return std::abs(after({0, -steps * h * g * (1 - e) / (2 * e), e}, answer, g, 1, h).v);
         };
         return {
             {"after ten seconds your ball moves at", std::abs(rests.v), "m/s", 1e-9},
             {"if all later bounces take 0.8 steps together, your ball moves at", speed_after(Real(0.8)), "m/s", 1e-9},
             {"if all later bounces take four steps together, your ball moves at", speed_after(4), "m/s", 1e-9}};
       },
       "all later bounces together take T = 2 v / (g (1 - e)). The ball rests as soon as T is no longer than a step, "
       "and not earlier."},
  };
}

Exercise exercise() {
  return rebuild_of(
      "a step that is cut where a ball meets the ground",
      {"Begin with a ball that does not reach the ground. Then t is longer than h, and the ball flies for h.",
       "The time to the ground is (v + sqrt(v^2 + 2 g y)) / g, whether the ball rises or falls. Right after a bounce, "
       "y is 0, and the time is 2 v / g.",
       "Write a loop that subtracts t from the rest of the step each time. It ends if t is longer than the rest, or if "
       "the ball rests."},
      Answer{plain_25::cut_step});
}

}  // namespace pushback::exercise_25
