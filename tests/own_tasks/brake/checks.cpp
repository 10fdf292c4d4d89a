#include <algorithm>

#include "asked.h"

namespace pushback::exercise_brake {

namespace {

/// A wagon, "which is slow", whose brake would take `needed` steps to stop it.
std::vector<Reading> rolled(Random& random, const std::string& wagon, Real speed, Real needed, const Answer& answer) {
  const Real mass = random.between(50, 200), h = Real(1) / 60, strength = mass * std::abs(speed) / (needed * h);
  const auto braked = [&](Real now) { return now + answer.brake(mass, now, strength, h) / mass; };
  const Real first = braked(speed);
  Real last = first;
  for (int step = 1; step < 20; ++step) last = braked(last);
  return {{"your wagon, which " + wagon + ", ends with", last, "m/s", 1e-9},
          {"your wagon, which " + wagon + ", has after its first step", first, "m/s", 1e-9}};
}

Real right(Real mass, Real speed, Real strength, Real h) {
  return std::clamp(-mass * speed, -strength * h, strength * h);
}

}  // namespace

std::vector<Check<Answer>> checks_of(const Answer& /*any*/) {
  return {
      {"a wagon that can be stopped stands, and stays", 1,
       [](Random& random, const Answer& answer) {
         const Real needed = random.between(Real(5.2), Real(5.8)), speed = random.between(1, 3);
         return rolled(random, "is slow", speed, needed, answer);
       },
       "the brake gives -m v where that is less than F h, and F h otherwise. The wagon stops after some steps, and "
       "then stands."},
      {"a wagon that is too fast for its brake goes on more slowly", 1,
       [](Random& random, const Answer& answer) {
         const Real needed = random.between(80, 100), speed = random.between(5, 9);
         return rolled(random, "is fast", speed, needed, answer);
       },
       "a force of F gives the impulse F h in a step of h, and not more."},
      {"a wagon that rolls backwards is held back, too", 1,
       [](Random& random, const Answer& answer) {
         const Real needed = random.between(80, 100), speed = -random.between(5, 9);
         return rolled(random, "rolls backwards", speed, needed, answer);
       },
       "the brake acts against the motion, whichever way the wagon rolls: from -F h to F h."},
  };
}

Exercise exercise() {
  return exercise_of("a brake of bounded strength",
                     {"To stand after this step, the wagon needs the impulse -m v.",
                      "In h seconds, a force of at most F gives an impulse between -F h and F h."},
                     Answer{right});
}

}  // namespace pushback::exercise_brake
