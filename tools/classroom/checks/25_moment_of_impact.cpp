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

std::vector<Check<Answer>> checks() {
  return {
      {"a ball that meets the ground within a step bounces there, and rises for what is left",
       2,
       {{"after the step your ball is at the height", "m", 1e-9}, {"after the step your ball rises with", "m/s", 1e-9}},
       [](Random& random, const Answer& answer) -> Numbers {
         const Real g = gravity(random), e = random.between(Real(0.4), Real(0.8));
         const Ball begin{random.between(Real(0.01), Real(0.03)), -random.between(4, 6), e};
         const Ball ball = after(begin, answer, g, 1, h);
         return {ball.y, ball.v};
       }},
      {"a ball may meet the ground several times in a step",
       1,
       {{"after a step of 0.1 s your ball is at the height", "m", 1e-9},
        {"after a step of 0.1 s your ball rises with", "m/s", 1e-9}},
       [](Random& random, const Answer& answer) -> Numbers {
         const Real g = gravity(random), e = random.between(Real(0.85), Real(0.9));
         const Ball begin{0, random.between(Real(0.18), Real(0.22)), e};
         const Ball ball = after(begin, answer, g, 1, Real(0.1));
         return {ball.y, ball.v};
       }},
      {"after a second and a half the ball is where it should be, however long the steps are",
       1,
       {{"in steps of 1/60 s, your ball gets to the height", "m", 1e-9},
        {"in steps of 1/240 s, your ball gets to the height", "m", 1e-9}},
       [](Random& random, const Answer& answer) -> Numbers {
         const Real g = gravity(random), e = random.between(Real(0.7), Real(0.9));
         const Ball begin{random.between(Real(0.8), Real(1.2)), random.between(-1, 1), e};
         return {after(begin, answer, g, 90, h).y, after(begin, answer, g, 360, h / 4).y};
       }},
      {"what would bounce for ever comes to rest, and not before",
       1,
       {{"after ten seconds your ball is at the height", "m", 1e-9},
        {"after ten seconds your ball moves with", "m/s", 1e-9},
        {"where all bounces to come take 0.8 steps, your ball moves with", "m/s", 1e-9},
        {"where they take four steps, your ball moves with", "m/s", 1e-9}},
       [](Random& random, const Answer& answer) -> Numbers {
         const Real g = gravity(random), e = random.between(Real(0.6), Real(0.8));
         const Ball rests = after({1, 0, e}, answer, g, 600, h);
         const auto speed_after = [&](Real steps) {  // T is so many, once it has bounced
           return std::abs(after({0, -steps * h * g * (1 - e) / (2 * e), e}, answer, g, 1, h).v);
         };
         return {rests.y, std::abs(rests.v), speed_after(Real(0.8)), speed_after(4)};
       }},
  };
}

/// Right but for the time to the ground and the bounce. It ends after 100 bounces, whatever these are.
template <class Time, class Bounce>
void with(Ball& ball, Real g, Real dt, const Time& time, const Bounce& bounce) {
  Real left = dt;
  for (int i = 0; i < 100; ++i) {
    const Real t = time(ball, g);
    if (!(t <= left)) return fly(ball, g, left);
    fly(ball, g, t);
    left -= t;
    bounce(ball);
    if (2 * ball.v <= dt * g * (1 - ball.e)) {
      ball.v = 0;
      return;
    }
  }
}
void bounce(Ball& ball) {
  ball.y = 0;
  ball.v *= -ball.e;
}

constexpr auto late =
    "it looks as if the ball bounced when the step is over. It then does so up to a step too late, and with the speed "
    "of "
    "that time.";

std::vector<Mistake<Answer>> mistakes() {
  return {
      {"the bounce at the end", late, {plain_25::late_step}},
      {"the bounce at the end", late, {[](Ball& ball, Real g, Real dt) {
         fly(ball, g, dt);
         if (ball.y < 0) ball.y *= -1, ball.v *= -ball.e;
       }}},
      {"the rest of the step lost",
       "it looks as if the step ended with the bounce. What is left of it is flown, too.",
       {[](Ball& ball, Real g, Real dt) {
         const Real t = plain_25::time_to_ground(ball, g);
         fly(ball, g, std::min(t, dt));
         if (t > dt) return;
         bounce(ball);
         if (2 * ball.v <= dt * g * (1 - ball.e)) ball.v = 0;
       }}},
      {"one bounce in a step",
       "it looks as if a step had one bounce at most. A low ball is at the ground again before the step is over.",
       {[](Ball& ball, Real g, Real dt) {
         const Real t = plain_25::time_to_ground(ball, g);
         if (t > dt) return fly(ball, g, dt);
         fly(ball, g, t);
         bounce(ball);
         if (2 * ball.v <= dt * g * (1 - ball.e)) ball.v = 0;
         else fly(ball, g, dt - t);
         ball.y = std::max(ball.y, Real(0));
       }}},
      {"a straight way down",
       "it looks as if the time were y / -v. Gravity makes the ball faster on its way: the time is the root of a "
       "parabola.",
       {[](Ball& ball, Real g, Real dt) {
         with(ball, g, dt, [](const Ball& b, Real) { return b.v < 0 ? b.y / -b.v : Real(1e9); }, bounce);
       }}},
      {"the other root",
       "it looks as if the other root were taken: the time at which the ball would have left the ground.",
       {[](Ball& ball, Real g, Real dt) {
         with(
             ball, g, dt,
             [](const Ball& b, Real acceleration) {
               return (b.v - std::sqrt(b.v * b.v + 2 * acceleration * b.y)) / acceleration;
             },
             bounce);
       }}},
      {"e squared",
       "it looks as if the bounce kept e squared of the speed. That is what it keeps of the energy.",
       {[](Ball& ball, Real g, Real dt) {
         with(ball, g, dt, plain_25::time_to_ground, [](Ball& b) {
           b.y = 0;
           b.v *= -b.e * b.e;
         });
       }}},
      {"e forgotten", "it looks as if the ball left as fast as it came.", {[](Ball& ball, Real g, Real dt) {
         with(ball, g, dt, plain_25::time_to_ground, [](Ball& b) {
           b.y = 0;
           b.v *= -1;
         });
       }}},
      {"it never rests",
       "it looks as if nothing ended the bounces. Those that would all fit into a step are not worth a flight each.",
       {[](Ball& ball, Real g, Real dt) {
         Real left = dt;
         for (int i = 0; i < 10000; ++i) {
           const Real t = plain_25::time_to_ground(ball, g);
           if (!(t <= left)) return fly(ball, g, left);
           fly(ball, g, t);
           left -= t;
           bounce(ball);
           if (ball.v < Real(1e-7)) return;
         }
       }}},
  };
}

}  // namespace

Numbers play(std::size_t check, Random& random, const Answer& answer) {
  return checks()[check].play(random, answer);
}

Exercise exercise() {
  return rebuild_of<Answer>("a step that is cut where a ball meets the ground",
                            {"Begin with a ball that does not meet the ground: t is more than h, and it flies for h.",
                             "The time to the ground is (v + sqrt(v^2 + 2 g y)) / g, whether it rises or falls. Right "
                             "after a bounce, y is 0, and this "
                             "is 2 v / g.",
                             "A loop: what is left of the step becomes less by t each time. It ends where t is more "
                             "than what is left, or where "
                             "the ball rests."},
                            checks(), {plain_25::cut_step}, mistakes());
}

}  // namespace pushback::exercise_25
