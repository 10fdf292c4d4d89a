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
      {"a ball that meets the ground within a step bounces there, and rises for what is left", 2,
       [](Random& random, const Answer& answer) -> std::vector<Reading> {
         const Real g = gravity(random), e = random.between(Real(0.4), Real(0.8));
         const Ball begin{random.between(Real(0.01), Real(0.03)), -random.between(4, 6), e};
         const Ball ball = after(begin, answer, g, 1, h);
         return {{"after the step your ball is at the height", ball.y, "m", 1e-9},
                 {"after the step your ball rises with", ball.v, "m/s", 1e-9}};
       },
       "the ball falls along a parabola and meets the ground after t. There it leaves with e times its speed, and "
       "flies for what is left of the step."},
      {"a ball may meet the ground several times in a step", 1,
       [](Random& random, const Answer& answer) -> std::vector<Reading> {
         const Real g = gravity(random), e = random.between(Real(0.85), Real(0.9));
         const Ball begin{0, random.between(Real(0.18), Real(0.22)), e};
         const Ball ball = after(begin, answer, g, 1, Real(0.1));
         return {{"after a step of 0.1 s your ball is at the height", ball.y, "m", 1e-9},
                 {"after a step of 0.1 s your ball rises with", ball.v, "m/s", 1e-9}};
       },
       "a low ball is at the ground again before the step is over. After each bounce, what is left of the step is "
       "flown in the same way."},
      {"after a second and a half the ball is where it should be, however long the steps are", 1,
       [](Random& random, const Answer& answer) -> std::vector<Reading> {
         const Real g = gravity(random), e = random.between(Real(0.7), Real(0.9));
         const Ball begin{random.between(Real(0.8), Real(1.2)), random.between(-1, 1), e};
         return {
             {"in steps of 1/60 s, your ball gets to the height", after(begin, answer, g, 90, h).y, "m", 1e-9},
             {"in steps of 1/240 s, your ball gets to the height", after(begin, answer, g, 360, h / 4).y, "m", 1e-9}};
       },
       "flights are exact, and so is the moment of each bounce. Where no time is lost or gained at a bounce, the "
       "length of the steps makes no difference."},
      {"what would bounce for ever comes to rest, and not before", 1,
       [](Random& random, const Answer& answer) -> std::vector<Reading> {
         const Real g = gravity(random), e = random.between(Real(0.6), Real(0.8));
         const Ball rests = after({1, 0, e}, answer, g, 600, h);
         const auto speed_after = [&](Real steps) {  // T is so many, once it has bounced
           return std::abs(after({0, -steps * h * g * (1 - e) / (2 * e), e}, answer, g, 1, h).v);
         };
         return {
             {"after ten seconds your ball moves with", std::abs(rests.v), "m/s", 1e-9},
             {"where all bounces to come take 0.8 steps, your ball moves with", speed_after(Real(0.8)), "m/s", 1e-9},
             {"where they take four steps, your ball moves with", speed_after(4), "m/s", 1e-9}};
       },
       "all bounces to come take T = 2 v / (g (1 - e)). Once T is no longer than a step, the ball rests, and not "
       "before."},
  };
}

Exercise exercise() {
  return rebuild_of("a step that is cut where a ball meets the ground",
                    {"Begin with a ball that does not meet the ground: t is more than h, and it flies for h.",
                     "The time to the ground is (v + sqrt(v^2 + 2 g y)) / g, whether it rises or falls. Right after a "
                     "bounce, y is 0, and this is 2 v / g.",
                     "A loop: what is left of the step becomes less by t each time. It ends where t is more than what "
                     "is left, or where the ball rests."},
                    Answer{plain_25::cut_step});
}

}  // namespace pushback::exercise_25
