#include <algorithm>

#include "asked.h"

namespace pushback::exercise_brake {

namespace {

constexpr std::size_t steps = 20;

/// A wagon whose brake would take `needed` steps to stop it: its speed at the end and after the first step.
Numbers rolled(Random& random, Real speed, Real needed, const Answer& answer) {
  const Real mass = random.between(50, 200), h = Real(1) / 60, strength = mass * std::abs(speed) / (needed * h);
  Numbers speeds{speed};
  for (std::size_t step = 0; step < steps; ++step)
    speeds.push_back(speeds.back() + answer.brake(mass, speeds.back(), strength, h) / mass);
  return {speeds.back(), speeds[1]};
}

Check<Answer> check(std::string says, const std::string& wagon, std::string hint,
                    const std::function<Numbers(Random&, const Answer&)>& play) {
  return {std::move(says),
          1,
          {{"your wagon, which " + wagon + ", ends with", "m/s", 1e-9},
           {"your wagon, which " + wagon + ", has after its first step", "m/s", 1e-9}},
          play,
          std::move(hint)};
}

Real right(Real mass, Real speed, Real strength, Real h) {
  return std::clamp(-mass * speed, -strength * h, strength * h);
}

}  // namespace

std::vector<Check<Answer>> checks_of(const Answer& /*any*/) {
  return {
      check("a wagon that can be stopped stands, and stays", "is slow",
            "the brake gives -m v where that is less than F h, and F h otherwise. The wagon stops after some steps, "
            "and then stands.",
            [](Random& random, const Answer& answer) {
              return rolled(random, random.between(1, 3), random.between(Real(5.2), Real(5.8)), answer);
            }),
      check("a wagon that is too fast for its brake goes on more slowly", "is fast",
            "a force of F gives the impulse F h in a step of h, and not more.",
            [](Random& random, const Answer& answer) {
              return rolled(random, random.between(5, 9), random.between(80, 100), answer);
            }),
      check("a wagon that rolls backwards is held back, too", "rolls backwards",
            "the brake acts against the motion, whichever way the wagon rolls: from -F h to F h.",
            [](Random& random, const Answer& answer) {
              return rolled(random, -random.between(5, 9), random.between(80, 100), answer);
            }),
  };
}

Exercise exercise() {
  return exercise_of("a brake of bounded strength",
                             {"To stand after this step, the wagon needs the impulse -m v.",
                              "In h seconds, a force of at most F gives an impulse between -F h and F h."},
                             Answer{right});
}

}  // namespace pushback::exercise_brake
