#include <array>
#include <cmath>

#include "pushback/chapters/27_which_error/exercise/asked.h"
#include "pushback/tools/classroom/checks/scenes.h"

namespace pushback::exercise_27 {

namespace {

constexpr Real h = Real(1) / 60;                             // s
constexpr int two_seconds = 120;                             // steps
constexpr Real highest = 2, fastest = 5, fastest_spin = 10;  // m, m/s, rad/s
constexpr Real fooled_by = 10;                               // times what the sum of halves says

Bar random_bar(Random& random) {
  const Real y = random.between(Real(0.7), 2);
  const Real angle = random.between(Real(0.1), Real(1.4));
  return {y, 0, angle, 0};
}

Played played(const Answer& answer, const Bar& bar, int steps) {
  Played played{bar, bar};
  for (int i = 0; i < steps; ++i) answer.play_step(played, h);
  return played;
}

std::vector<Reading> estimates(const std::string& whose, const Played& played) {
  return {{"the height of " + whose + " is", played.bar.y, "m", 1e-9},
          {"the sum of halves is", 1000 * played.halves, "mm", 1e-6},
          {"the twin of " + whose + " is at", played.twin.y, "m", 1e-9}};
}

bool allowed(const Bar& bar) {
  return gap(bar) > 0 && bar.y <= highest && std::abs(bar.v) < fastest && std::abs(bar.spin) < fastest_spin;
}

/// Whether the bar is wrong by so much, at a time at which its truth is known.
bool fools(const Bar& bar) {
  if (!allowed(bar)) return false;
  Played played{bar, bar};
  Bar truth = bar, coarser = bar;
  for (int i = 0; i < two_seconds; ++i) {
    plain_27::play_step(played, h);
    truth = plain_27::step(truth, h, 4096);
    coarser = plain_27::step(coarser, h, 2048);
    const Real error = std::abs(played.bar.y - truth.y);
    if (error > fooled_by * played.halves && std::abs(truth.y - coarser.y) < error / 10) return true;
  }
  return false;
}

constexpr std::array others{Bar{Real(0.8), 0, Real(0.85), 0}, Bar{Real(1.1), 0, Real(0.55), 0},
                            Bar{Real(1.2), 0, Real(0.65), 0}, Bar{Real(1.3), 0, Real(0.65), 0},
                            Bar{Real(1.6), 0, Real(0.6), 0},  Bar{Real(1.9), 0, Real(0.55), 0}};

Bar fooling_bar() {
  return {1, 0, Real(0.95), 0};
}

}  // namespace

std::vector<Check<Answer>> checks_of(const Answer& /*any*/) {
  return {
      {"while a bar falls, the sum of halves and its twin say what is wrong with its height", 2,
       [](Random& random, const Answer& answer) {
         Bar bar = random_bar(random);
         bar.y += 10;
         return estimates("a bar that falls", played(answer, bar, 30));
       },
       "a step in 32 substeps is wrong by twice as much as in 64. The sum adds the differences of all steps, and half "
       "a second "
       "times those of the velocities."},
      {"a bar that bounces has a sum that only grows, and a twin that is never made equal to it", 3,
       [](Random& random, const Answer& answer) {
         return estimates("a bar that bounces", played(answer, random_bar(random), 60));
       },
       "both steps of the sum begin at the bar. The twin begins where the bar began, and goes on from where it is "
       "itself."},
      {"your bar fools the sum of halves, and so does another one", 5,
       [](Random& random, const Answer& answer) -> std::vector<Reading> {
         const Bar bar = answer.fooling_bar();
         const Played other = played(answer, others[random.below(others.size())], two_seconds);
         return {{"whether it begins as the task allows (1 or 0) is", allowed(bar)},
                 {"whether its error exceeds ten times the sum of halves (1 or 0) is", fools(bar)},
                 {"the sum of halves of another bar is", 1000 * other.halves, "mm", 1e-6},
                 {"its twin says", 1000 * other.said_by_twin(), "mm", 1e-6}};
       },
       "a small difference in the angle at which an end hits the floor changes the spin after it, so each impact makes "
       "an error "
       "larger. Look for bars that hit the floor often, and play many of them."},
  };
}

Exercise exercise() {
  return rebuild_of(
      "two estimates of an error, and a scene that fools one of them",
      {"play_step has three results of step(): the bar's in fine / 2 substeps, the bar's in fine, and the twin's in "
       "coarse.",
       "Keep the result in fine / 2 substeps in a variable, before you change played.bar.",
       "Play a hundred bars in a loop, with angles from 0 to 1.5 rad. About one in twelve fools the sum."},
      Answer{plain_27::play_step, fooling_bar});
}

}  // namespace pushback::exercise_27
