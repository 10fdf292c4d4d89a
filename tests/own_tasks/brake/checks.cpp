#include <algorithm>

#include "asked.h"

namespace pushback::exercise_brake {

namespace {

constexpr std::size_t steps = 20;
const Recorded rolling{"speed of your wagon", "m/s", "step"};

/// A wagon whose brake would take `needed` steps to stop it: its speed at the end and after the first step, then after each.
Numbers rolled(Random& random, Real speed, Real needed, const Answer& answer) {
  const Real mass = random.between(50, 200), h = Real(1) / 60, strength = mass * std::abs(speed) / (needed * h);
  Numbers speeds{speed};
  for (std::size_t step = 0; step < steps; ++step)
    speeds.push_back(speeds.back() + answer.brake(mass, speeds.back(), strength, h) / mass);
  return with_record({speeds.back(), speeds[1]}, speeds);
}

Check<Answer> check(std::string says, const std::string& wagon,
                    const std::function<Numbers(Random&, const Answer&)>& play) {
  return {std::move(says),
          1,
          {{"your wagon, which " + wagon + ", ends with", "m/s", 1e-9},
           {"your wagon, which " + wagon + ", has after its first step", "m/s", 1e-9}},
          play};
}

std::vector<Check<Answer>> checks() {
  return {
      check("a wagon that can be stopped stands, and stays", "is slow",
            [](Random& random, const Answer& answer) {
              return rolled(random, random.between(1, 3), random.between(Real(5.2), Real(5.8)), answer);
            }),
      check("a wagon that is too fast for its brake goes on more slowly", "is fast",
            [](Random& random, const Answer& answer) {
              return rolled(random, random.between(5, 9), random.between(80, 100), answer);
            }),
      check("a wagon that rolls backwards is held back, too", "rolls backwards",
            [](Random& random, const Answer& answer) {
              return rolled(random, -random.between(5, 9), random.between(80, 100), answer);
            }),
  };
}

Real right(Real mass, Real speed, Real strength, Real h) {
  return std::clamp(-mass * speed, -strength * h, strength * h);
}

std::vector<Mistake<Answer>> mistakes() {
  return {
      {"no bound",
       "it looks as if the brake had no bound. In h it gives at most F h.",
       {[](Real mass, Real speed, Real, Real) { return -mass * speed; }}},
      {"h forgotten",
       "it looks as if F were taken for an impulse. An impulse is a force times a time: F h.",
       {[](Real mass, Real speed, Real strength, Real) { return std::clamp(-mass * speed, -strength, strength); }}},
      {"pushes back",
       "it looks as if the brake always gave all of F h. Where less is enough to stop, it gives less.",
       {[](Real, Real speed, Real strength, Real h) { return std::copysign(strength * h, -speed); }}},
      {"forwards only",
       "it looks as if the brake held back only what rolls forwards.",
       {[](Real mass, Real speed, Real strength, Real h) {
         return std::clamp(-mass * speed, -strength * h, Real(0));
       }}},
  };
}

}  // namespace

Numbers play(std::size_t check, Random& random, const Answer& answer) {
  return checks()[check].play(random, answer);
}

Exercise exercise() {
  return exercise_of<Answer>("a brake of bounded strength",
                             {"To stand after this step, the wagon needs the impulse -m v.",
                              "In h seconds, a force of at most F gives an impulse between -F h and F h."},
                             checks(), {right}, mistakes(), {{0, rolling}, {1, rolling}, {2, rolling}});
}

}  // namespace pushback::exercise_brake
