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
      {"the difference of two results gives the error of the finer one, for any order", 2,
       [](Random& random, const Answer& answer) -> std::vector<Reading> {
         const auto off = [&](int order, Real side) {
           const Real place = random.between(1, 3), error = side * random.between(Real(0.5), 2);
           return answer.off_by(place + error * std::exp2(static_cast<Real>(order)), place + error, order);
         };
         return {{"the error of steps of order 1 is", off(1, 1), "m", 1e-3},
                 {"the error of steps of order 4 is", off(4, 1), "m", 1e-3},
                 {"for steps of order 2 with the opposite sign, the error is", off(2, -1), "m", 1e-3}};
       },
       "the error of the coarse result is 2^p times the error of the fine one, so their difference is 2^p - 1 times "
       "the error of the fine one. The error is a length, so it is never negative."},
      {"a step with too large an error is repeated with twice as many substeps if this helps, and never with more than "
       "the most",
       2,
       [](Random& random, const Answer& answer) -> std::vector<Reading> {
         const int now = 1 << whole(random, 1, 3);
         const Real far = random.between(2, 9);
         const auto judge = [&answer](int substeps, Real off, Real before) {
           return answer.judge({substeps, off, before, 2}, bounds_of_checks);
         };
         const Verdict badly = judge(now, far, 4 * far), stuck = judge(now, far, random.between(1, Real(1.9)) * far);
         const Verdict most = judge(16, far, 4 * far), just = judge(now, random.between(Real(0.6), Real(0.99)), none);
         return {{"after a try with too large an error, `stands` (1 or 0) is", badly.stands},
                 {"the number of substeps in its repetition is", badly.substeps},
                 {"after a try that is no better than the previous one, `stands` (1 or 0) is", stuck.stands},
                 {"after a try that is no better than the previous one, `kept` (1 or 0) is", stuck.kept},
                 {"for too large an error with the most substeps, `stands` (1 or 0) is", most.stands},
                 {"for an error that is just small enough, `kept` (1 or 0) is", just.kept}};
       },
       "a step with too large an error is repeated with twice as many substeps, if the last doubling halved the error "
       "and the most allow it. Otherwise it stands, but is not kept."},
      {"after a step that is far better than required, the next one is coarser if the order allows it", 2,
       [](Random& random, const Answer& answer) -> std::vector<Reading> {
         const Real some = 1 / random.between(9, 12), little = 1 / random.between(35, 60);
         const auto next = [&answer](int substeps, Real off, int order) {
           return static_cast<Real>(answer.judge({substeps, off, none, order}, bounds_of_checks).substeps);
         };
         const int now = 2 * whole(random, 2, 8);
         return {
             {"for order 1 and an error of 1/5, the number of substeps of the next step is", next(now, Real(0.2), 1)},
             {"for order 2 and an error of 1/9 to 1/12, the number of substeps of the next step is",
              next(now, some, 2)},
             {"for order 4 and the same error, the number of substeps of the next step is", next(now, some, 4)},
             {"for order 4 and an error below 1/32, the number of substeps of the next step is", next(now, little, 4)},
             {"with the least substeps, the number of substeps of the next step is", next(2, little, 2)}};
       },
       "with half as many substeps the error is 2^p times as large. If this is below 1/2, the next step has half as "
       "many, but no fewer than the least."},
      {"a motion gets many substeps while it needs them, few before and after, and no useless ones", 2,
       [](Random& random, const Answer& answer) -> std::vector<Reading> {
         const Real calm = random.between(1, 3), fierce = random.between(80, 200), at = random.between(60, 90);
         const auto size = [&](int step) {
           const Real from = (static_cast<Real>(step) - at) / 12;
           return calm + fierce * std::exp(-from * from) + (step == 180 ? Real(1e4) : 0);
         };
         const auto stuck = [](int step) { return step >= 140 && step < 150 ? Real(5) : 0; };
         const Played played = motion_of(answer, 2, size, stuck, 200);
         return {{"in 200 steps, the number of tries of your motion is", played.tries},
                 {"the total number of its substeps is", played.spent},
                 {"the number of steps that are reported as not kept is", played.not_kept}};
       },
       "each step has as many substeps as its own error requires: more while the motion jerks, fewer afterwards, and "
       "no more if they do not help."},
  };
}

Exercise exercise() {
  return rebuild_of("an error that is known at run time, and as many substeps as it requires",
                    {"off_by is one line: the difference without its sign, divided by 2^p - 1. std::exp2 computes 2^p.",
                     "Begin judge with the result that is kept, then the one that is repeated. The remaining case "
                     "stands, but is not kept.",
                     "The next step has fewer if off times 2^p is below 1/2 and substeps is above bounds.least."},
                    Answer{plain_27::off_by, plain_27::judge_try});
}

}  // namespace pushback::exercise_27
