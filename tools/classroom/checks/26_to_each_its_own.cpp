#include <algorithm>
#include <array>
#include <cmath>

#include "pushback/chapters/26_to_each_its_own/exercise/asked.h"
#include "pushback/tools/classroom/checks/scenes.h"

namespace pushback::exercise_26 {

namespace {

constexpr Bounds bounds_of_checks{};

/// A chain whose error in n substeps is `size(step) / n^2`, in parts of what is allowed.
struct Played {
  int tries = 0, spent = 0, given_up = 0;
};
template <class Size>
Played chain_of(const Answer& answer, const Size& size, int steps) {
  constexpr int most_tries = 2000;
  Played played;
  int next = bounds_of_checks.least_substeps;
  for (int step = 0; step < steps; ++step) {
    for (;;) {
      if (++played.tries > most_tries) return played;
      const Real off = size(step) / static_cast<Real>(next) / static_cast<Real>(next);
      const Verdict verdict = answer.judge(next, off, bounds_of_checks);
      played.spent += next;
      const bool never = verdict.substeps < 1;
      next = never ? bounds_of_checks.least_substeps : std::min(verdict.substeps, 1 << 20);
      if (verdict.stands) break;
      if (never) {
        ++played.given_up;
        break;
      }
    }
  }
  return played;
}

}  // namespace

std::vector<Check<Answer>> checks_of(const Answer& /*any*/) {
  return {
      {"islands in free flight, with half steps and with substeps are told apart", 2,
       [](Random& random, const Answer& answer) -> std::vector<Reading> {
         std::array<int, 3> called{};
         const auto ask = [&](const auto& island) {
           for (int count = whole(random, 3, 40); count > 0; --count)
             ++called[std::size_t(answer.call(island(), bounds_of_checks)) % 3];
         };
         const auto few = [&random] { return whole(random, 1, 7); };
         const auto joints = [&random] { return whole(random, 1, 30); };
         ask([] { return Seen{}; });
         ask([&] { return Seen{.contacts = few()}; });
         ask([&] { return Seen{.contacts = whole(random, 20, 99), .had_half_steps = random.below(2) == 0}; });
         ask([&] { return Seen{.joints = joints()}; });
         ask([&] { return Seen{.contacts = few(), .refused = true}; });
         ask([&] { return Seen{.joints = joints(), .refused = true}; });
         return {{"the number of random islands in free flight is", called[0]},
                 {"the number of random islands with half steps is", called[1]},
                 {"the number of random islands with substeps is", called[2]}};
       },
       "an island's own contacts and joints decide, in the order of the task. Refused islands get substeps, joints get "
       "half steps, islands that touch nothing fly freely, and islands with at most `most` contacts get half steps."},
      {"an island whose number of contacts varies near the limit keeps its kind of step", 2,
       [](Random& random, const Answer& answer) -> std::vector<Reading> {
         std::vector<int> contacts{9, 13, 12, 8, 9, 12};
         for (int i = int(contacts.size()); i < 300; ++i) contacts.push_back(whole(random, i % 100 < 50 ? 6 : 9, 13));
         int by_half_steps = 0;
         bool before = false;
         for (const int count : contacts) {
           before = answer.call({.contacts = count, .had_half_steps = before}, bounds_of_checks) == Call::half_steps;
           by_half_steps += before;
         }
         return {{"of 300 steps, the number of half steps of your island is", by_half_steps}};
       },
       "an island that had half steps keeps them with at most most_kept contacts. An island that had substeps changes "
       "to half steps with at most `most` contacts. So a number that varies between the two limits changes nothing."},
      {"a step with too large an energy error is repeated with twice as many substeps, and later steps reduce the "
       "number again",
       2,
       [](Random& random, const Answer& answer) -> std::vector<Reading> {
         const int now = 4 << whole(random, 1, 4);
         const auto judge = [&answer](int substeps, Real off) { return answer.judge(substeps, off, bounds_of_checks); };
         const Verdict well = judge(now, random.between(Real(0.01), Real(0.12)));
         const Verdict just = judge(now, random.between(Real(0.13), Real(0.24)));
         const Verdict badly = judge(now, random.between(Real(1.1), 9));
         return {
             {"after a step that is far better than required, the number of substeps of the next step is",
              well.substeps},
             {"after a step that is just good enough, the number of substeps of the next step is", just.substeps},
             {"for a step with too large an error, `stands` (1 or 0) is", badly.stands},
             {"the number of substeps in its repetition is", badly.substeps},
             {"with the smallest number of substeps, the number for the next step is", judge(4, Real(0.01)).substeps},
             {"for too large an error with most_substeps, the number of substeps in the repetition is",
              judge(128, 2).substeps}};
       },
       "a step stands if off is at most 1. Otherwise it is repeated with twice as many substeps, up to most_substeps. "
       "If off is below an eighth, the next step has half as many, but no fewer than least_substeps."},
      {"a chain that whips gets many substeps while it whips, and few before and after", 2,
       [](Random& random, const Answer& answer) -> std::vector<Reading> {
         const Real calm = random.between(Real(0.1), 1), fierce = random.between(3000, 9000),
                    at = random.between(60, 90);
         const auto size = [&](int step) {
           const Real from = (static_cast<Real>(step) - at) / 12;
           return calm + fierce * std::exp(-from * from) + (step == 150 ? Real(1e6) : 0);
         };
         const Played played = chain_of(answer, size, 200);
         return {{"in 200 steps, the number of tries of your chain is", played.tries},
                 {"the total number of its substeps is", played.spent},
                 {"the number of steps left to other solvers is", played.given_up}};
       },
       "the error falls with the square of the number of substeps. Doubling it is enough after a few tries. Half as "
       "many are enough if off is below an eighth. Other solvers take over a step that fails with most_substeps."},
  };
}

Exercise exercise() {
  return rebuild_of(
      "the kind of step for an island, and its number of substeps",
      {"Begin with call. It has four lines, one for each sentence of the task, in this order. The first condition that "
       "holds decides.",
       "The limit of contacts is one of two numbers: island.had_half_steps ? bounds.most_kept : bounds.most.",
       "judge has three results: {true, half as many or as many}, {false, twice as many}, {false, 0}."},
      Answer{plain_26::call_of, plain_26::judge_step});
}

}  // namespace pushback::exercise_26
