#include <algorithm>
#include <cmath>

#include "pushback/chapters/27_which_error/exercise/asked.h"
#include "pushback/tools/classroom/checks/scenes.h"

namespace pushback::exercise_27 {

namespace {

constexpr Bounds bounds_of_checks{};
constexpr Real none = std::numeric_limits<Real>::infinity();

/// A motion whose steps of this order are off by `size(step) / n^p`, and by `stuck(step)`, which no substeps lessen, in parts of what is
/// allowed.
struct Played {
  int tries = 0, spent = 0, not_kept = 0;
};
template <class Size, class Stuck>
Played motion_of(const Answer& answer, int order, const Size& size, const Stuck& stuck, int steps) {
  constexpr int most_tries = 2000;
  Played played;
  int next = bounds_of_checks.least;
  for (int step = 0; step < steps; ++step) {
    for (Real before = none;;) {
      if (++played.tries > most_tries) return played;
      const Real off = size(step) / std::pow(static_cast<Real>(next), static_cast<Real>(order)) + stuck(step);
      const Verdict verdict = answer.judge({next, off, before, order}, bounds_of_checks);
      before = off;
      played.spent += next;
      next = std::clamp(verdict.substeps, 1, 1 << 20);
      if (!verdict.stands) continue;
      played.not_kept += !verdict.kept;
      break;
    }
  }
  return played;
}

}  // namespace

std::vector<Check<Answer>> checks_of(const Answer& /*any*/) {
  return {
      {"the error of the finer result is told from the difference of two, whatever the order", 2,
       [](Random& random, const Answer& answer) -> std::vector<Reading> {
         const auto off = [&](int order, Real side) {
           const Real place = random.between(1, 3), error = side * random.between(Real(0.5), 2);
           return answer.off_by(place + error * std::exp2(static_cast<Real>(order)), place + error, order);
         };
         return {{"steps of order 1 are off by", off(1, 1), "m", 1e-3},
                 {"steps of order 4 are off by", off(4, 1), "m", 1e-3},
                 {"steps of order 2, on the other side of where they belong, by", off(2, -1), "m", 1e-3}};
       },
       "the coarse result is off by 2^p times as much as the fine one, so their difference is 2^p - 1 times the error "
       "of the fine one. That is a length, and not below 0."},
      {"a step that is off too far is taken again in twice as many, if that helps, and never in more than the most", 2,
       [](Random& random, const Answer& answer) -> std::vector<Reading> {
         const int now = 1 << whole(random, 1, 3);
         const Real far = random.between(2, 9);
         const auto judge = [&answer](int substeps, Real off, Real before) {
           return answer.judge({substeps, off, before, 2}, bounds_of_checks);
         };
         const Verdict badly = judge(now, far, 4 * far), stuck = judge(now, far, random.between(1, Real(1.9)) * far);
         const Verdict most = judge(16, far, 4 * far), just = judge(now, random.between(Real(0.6), Real(0.99)), none);
         return {{"after a try that is too far off, stands (1) or not (0):", badly.stands},
                 {"it is tried again in so many:", badly.substeps},
                 {"after one that is no better than the one before, stands (1) or not (0):", stuck.stands},
                 {"that one is kept (1) or not (0):", stuck.kept},
                 {"too far off in the most, stands (1) or not (0):", most.stands},
                 {"one that is just good enough is kept (1) or not (0):", just.kept}};
       },
       "what is off too far is taken again in twice as many, as long as the last doubling halved the error and no more "
       "than the most are needed. Otherwise it stands, and is not kept."},
      {"a step that is far better than asked makes the next one coarser, if the order allows it", 2,
       [](Random& random, const Answer& answer) -> std::vector<Reading> {
         const Real some = 1 / random.between(9, 12), little = 1 / random.between(35, 60);
         const auto next = [&answer](int substeps, Real off, int order) {
           return static_cast<Real>(answer.judge({substeps, off, none, order}, bounds_of_checks).substeps);
         };
         const int now = 2 * whole(random, 2, 8);
         return {{"order 1, off by 1/5, the next has", next(now, Real(0.2), 1)},
                 {"order 2, off by 1/9 to 1/12, the next has", next(now, some, 2)},
                 {"order 4, off by as much, the next has", next(now, some, 4)},
                 {"order 4, off by less than 1/32, the next has", next(now, little, 4)},
                 {"from the least the next has", next(2, little, 2)}};
       },
       "half as many substeps are off by 2^p times as much. The next step has half as many if that is below 1/2, but "
       "no fewer than the least."},
      {"a motion has many substeps where it needs them, few before and after, and none are wasted where they do not "
       "help",
       2,
       [](Random& random, const Answer& answer) -> std::vector<Reading> {
         const Real calm = random.between(1, 3), fierce = random.between(80, 200), at = random.between(60, 90);
         const auto size = [&](int step) {
           const Real from = (static_cast<Real>(step) - at) / 12;
           return calm + fierce * std::exp(-from * from) + (step == 180 ? Real(1e4) : 0);
         };
         const auto stuck = [](int step) { return step >= 140 && step < 150 ? Real(5) : 0; };
         const Played played = motion_of(answer, 2, size, stuck, 200);
         return {{"in 200 steps your motion is tried so many times:", played.tries},
                 {"it spends so many substeps:", played.spent},
                 {"so many steps are said not to be kept:", played.not_kept}};
       },
       "each step has as many substeps as its own error calls for: more while the motion jerks, fewer afterwards, and "
       "none more where they do not help."},
  };
}

Exercise exercise() {
  return rebuild_of("an error that is known while it runs, and as many substeps as it calls for",
                    {"off_by is one line: the difference without its sign, divided by 2^p - 1. std::exp2 computes 2^p.",
                     "Begin judge with what is kept, then what is tried again. What is left stands, and is not kept.",
                     "Fewer for the next step: off times 2^p is below 1/2, and substeps is above bounds.least."},
                    Answer{plain_27::off_by, plain_27::judge_try});
}

}  // namespace pushback::exercise_27
