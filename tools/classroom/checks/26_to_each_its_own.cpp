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
      {"what flies, what has half steps and what has substeps is told apart", 2,
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
         return {{"of random islands, so many fly:", called[0]},
                 {"so many have half steps:", called[1]},
                 {"so many have substeps:", called[2]}};
       },
       "an island's own contacts and joints say what it calls for, in the task's order: what is refused has substeps, "
       "joints have half steps, what touches nothing flies, and few contacts, up to and with the limit, have half "
       "steps."},
      {"an island whose contacts come and go near the limit stays what it is", 2,
       [](Random& random, const Answer& answer) -> std::vector<Reading> {
         std::vector<int> contacts{9, 13, 12, 8, 9, 12};
         for (int i = int(contacts.size()); i < 300; ++i) contacts.push_back(whole(random, i % 100 < 50 ? 6 : 9, 13));
         int by_half_steps = 0;
         bool before = false;
         for (const int count : contacts) {
           before = answer.call({.contacts = count, .had_half_steps = before}, bounds_of_checks) == Call::half_steps;
           by_half_steps += before;
         }
         return {{"of 300 steps your island has by half steps", by_half_steps}};
       },
       "an island that had half steps keeps them up to and with most_kept contacts, one that had substeps gets them "
       "with most or fewer. So what comes and goes between the two changes nothing."},
      {"a step whose energy is not kept is taken again in twice as many, one that has too many comes down", 2,
       [](Random& random, const Answer& answer) -> std::vector<Reading> {
         const int now = 4 << whole(random, 1, 4);
         const auto judge = [&answer](int substeps, Real off) { return answer.judge(substeps, off, bounds_of_checks); };
         const Verdict well = judge(now, random.between(Real(0.01), Real(0.12)));
         const Verdict just = judge(now, random.between(Real(0.13), Real(0.24)));
         const Verdict badly = judge(now, random.between(Real(1.1), 9));
         return {{"after a step that is far better than asked, the next one has so many substeps:", well.substeps},
                 {"after one that is just good enough, the next one has so many:", just.substeps},
                 {"after one that is too far off, stands (1) or not (0):", badly.stands},
                 {"it is tried again in so many:", badly.substeps},
                 {"the least are never fewer than", judge(4, Real(0.01)).substeps},
                 {"too far off in the most:", judge(128, 2).substeps}};
       },
       "a step with off at most 1 stands. Otherwise what it lost is not lost: it is taken again in twice as many, up "
       "to most_substeps. Below an eighth half as many follow, but no fewer than least_substeps."},
      {"a chain that whips has many substeps while it does, and few before and after", 2,
       [](Random& random, const Answer& answer) -> std::vector<Reading> {
         const Real calm = random.between(Real(0.1), 1), fierce = random.between(3000, 9000),
                    at = random.between(60, 90);
         const auto size = [&](int step) {
           const Real from = (static_cast<Real>(step) - at) / 12;
           return calm + fierce * std::exp(-from * from) + (step == 150 ? Real(1e6) : 0);
         };
         const Played played = chain_of(answer, size, 200);
         return {{"in 200 steps your chain is tried so many times:", played.tries},
                 {"it spends so many substeps:", played.spent},
                 {"so many steps are left to others:", played.given_up}};
       },
       "the error falls with the square of the substeps. Doubling gets there in a few tries, half as many are enough "
       "below an eighth, and what most_substeps do not reach is left to others."},
  };
}

Exercise exercise() {
  return rebuild_of(
      "which step an island calls for, and in how many substeps",
      {"Begin with call: four lines, one for each sentence of the task, in its order. The first that holds decides.",
       "The limit of contacts is one of two numbers: island.had_half_steps ? bounds.most_kept : bounds.most.",
       "judge has three ends: {true, half as many or as many}, {false, twice as many}, {false, 0}."},
      Answer{plain_26::call_of, plain_26::judge_step});
}

}  // namespace pushback::exercise_26
