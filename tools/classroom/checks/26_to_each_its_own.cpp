#include <algorithm>
#include <cmath>

#include "pushback/chapters/26_to_each_its_own/exercise/asked.h"

namespace pushback::exercise_26 {

namespace {

constexpr Bounds bounds_of_checks{};

int whole(Random& random, int least, int most) {
  return least + static_cast<int>(random.below(std::size_t(most - least + 1)));
}
/// How an island of so many contacts fares, step after step, as `call` has it: by half steps in so many of them, with so many changes.
struct Course {
  int by_half_steps = 0, changes = 0;
};
Course course_of(const Answer& answer, const std::vector<int>& contacts) {
  Course course;
  Call before = Call::substeps;
  for (const int count : contacts) {
    const Call now = answer.call({.contacts = count, .had_half_steps = before == Call::half_steps}, bounds_of_checks);
    course.by_half_steps += now == Call::half_steps;
    course.changes += now != before;
    before = now;
  }
  return course;
}

/// A chain whose error in n substeps is `size(step) / n^2`, in parts of what is allowed.
struct Played {
  int tries = 0, spent = 0, most = 0, given_up = 0;
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
      played.most = std::max(played.most, next);
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

std::vector<Check<Answer>> checks() {
  return {
      {"what flies, what has half steps and what has substeps is told apart",
       2,
       {{"of random islands, so many fly:", "", 0},
        {"so many have half steps:", "", 0},
        {"so many have substeps:", "", 0}},
       [](Random& random, const Answer& answer) -> Numbers {
         Numbers called(3, 0);
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
         return called;
       }},
      {"an island whose contacts come and go near the limit stays what it is",
       2,
       {{"of 300 steps your island has by half steps", "", 0}, {"it changes so many times:", "", 0}},
       [](Random& random, const Answer& answer) -> Numbers {
         std::vector<int> contacts{9, 13, 12, 8, 9, 12};
         for (int i = int(contacts.size()); i < 300; ++i) contacts.push_back(whole(random, i % 100 < 50 ? 6 : 9, 13));
         const Course course = course_of(answer, contacts);
         return {static_cast<Real>(course.by_half_steps), static_cast<Real>(course.changes)};
       }},
      {"a step whose energy is not kept is taken again in twice as many, one that has too many comes down",
       2,
       {{"after a step that is far better than asked, stands (1) or not (0):", "", 0},
        {"the next one has so many substeps:", "", 0},
        {"after one that is just good enough, the next one has so many:", "", 0},
        {"after one that is too far off, stands (1) or not (0):", "", 0},
        {"it is tried again in so many:", "", 0},
        {"the least are never fewer than", "", 0},
        {"too far off in the most:", "", 0}},
       [](Random& random, const Answer& answer) -> Numbers {
         const int now = 4 << whole(random, 1, 4);
         const auto judge = [&answer](int substeps, Real off) { return answer.judge(substeps, off, bounds_of_checks); };
         const Verdict well = judge(now, random.between(Real(0.01), Real(0.12)));
         const Verdict just = judge(now, random.between(Real(0.13), Real(0.24)));
         const Verdict badly = judge(now, random.between(Real(1.1), 9));
         return {static_cast<Real>(well.stands),           static_cast<Real>(well.substeps),
                 static_cast<Real>(just.substeps),         static_cast<Real>(badly.stands),
                 static_cast<Real>(badly.substeps),        static_cast<Real>(judge(4, Real(0.01)).substeps),
                 static_cast<Real>(judge(128, 2).substeps)};
       }},
      {"a chain that whips has many substeps while it does, and few before and after",
       2,
       {{"in 200 steps your chain is tried so many times:", "", 0},
        {"it spends so many substeps:", "", 0},
        {"in one step so many at most:", "", 0},
        {"so many steps are left to others:", "", 0}},
       [](Random& random, const Answer& answer) -> Numbers {
         const Real calm = random.between(Real(0.1), 1), fierce = random.between(3000, 9000),
                    at = random.between(60, 90);
         const auto size = [&](int step) {
           const Real from = (static_cast<Real>(step) - at) / 12;
           return calm + fierce * std::exp(-from * from) + (step == 150 ? Real(1e6) : 0);
         };
         const Played played = chain_of(answer, size, 200);
         return {static_cast<Real>(played.tries), static_cast<Real>(played.spent), static_cast<Real>(played.most),
                 static_cast<Real>(played.given_up)};
       }},
  };
}

Answer with_call(Call (*call)(const Seen&, const Bounds&)) {
  return {call, plain_26::judge_step};
}
Answer with_judge(Verdict (*judge)(int, Real, const Bounds&)) {
  return {plain_26::call_of, judge};
}

std::vector<Mistake<Answer>> mistakes() {
  return {
      {"no memory",
       "it looks as if an island were judged by its contacts alone. One that had half steps may keep them up to "
       "most_kept, or it "
       "changes with every contact that comes or goes.",
       with_call([](const Seen& island, const Bounds& bounds) {
         Seen forgotten = island;
         forgotten.had_half_steps = false;
         return plain_26::call_of(forgotten, bounds);
       })},
      {"most_kept for all",
       "it looks as if most_kept were the limit of every island. Of one that had substeps it is most.",
       with_call([](const Seen& island, const Bounds& bounds) {
         Seen kept = island;
         kept.had_half_steps = true;
         return plain_26::call_of(kept, bounds);
       })},
      {"limits taken the other way round",
       "it looks as if most_kept were the limit of an island that had substeps, and most that of one that had half "
       "steps. It is the "
       "other way round.",
       with_call([](const Seen& island, const Bounds& bounds) {
         Seen turned = island;
         turned.had_half_steps = !island.had_half_steps;
         return plain_26::call_of(turned, bounds);
       })},
      {"below, not up to",
       "it looks as if an island with just as many contacts as the limit were one of many. Up to the limit it is one "
       "of few.",
       with_call([](const Seen& island, const Bounds& bounds) {
         return plain_26::call_of(island, {.most = bounds.most - 1, .most_kept = bounds.most_kept - 1});
       })},
      {"refused too late",
       "it looks as if joints were asked before what is refused. A limit is a joint, too, and half steps do not hold "
       "it.",
       with_call([](const Seen& island, const Bounds& bounds) {
         return island.joints > 0 ? Call::half_steps : plain_26::call_of(island, bounds);
       })},
      {"refusal forgotten", "it looks as if nothing were refused. Half steps do not do limits, loops and Forces.",
       with_call([](const Seen& island, const Bounds& bounds) {
         Seen free = island;
         free.refused = false;
         return plain_26::call_of(free, bounds);
       })},
      {"joints fly", "it looks as if an island of joints without a contact flew. Its bodies hold each other.",
       with_call([](const Seen& island, const Bounds& bounds) {
         if (!island.refused && island.contacts == 0) return Call::flight;
         return plain_26::call_of(island, bounds);
       })},
      {"the step stands anyway",
       "it looks as if the step that was too far off were kept, and the next one were taken in twice as many. What it "
       "lost is lost "
       "then: it is taken again.",
       with_judge([](int substeps, Real off, const Bounds& bounds) {
         Verdict verdict = plain_26::judge_step(substeps, off, bounds);
         verdict.stands = true;
         return verdict;
       })},
      {"never fewer", "it looks as if the substeps never became fewer. One whip, and all that follows costs as much.",
       with_judge([](int substeps, Real off, const Bounds& bounds) {
         return off <= 1 ? Verdict{true, substeps} : plain_26::judge_step(substeps, off, bounds);
       })},
      {"fewer at once",
       "it looks as if each step that stands made the next one coarser. Where off is 1/4 or more, half as many are too "
       "few, and each "
       "second step is taken twice.",
       with_judge([](int substeps, Real off, const Bounds& bounds) {
         return plain_26::judge_step(substeps, off <= 1 ? 0 : off, bounds);
       })},
      {"a quarter",
       "it looks as if fewer substeps followed below a quarter. In half as many the error is four times as large: just "
       "what is "
       "allowed, and often more.",
       with_judge([](int substeps, Real off, const Bounds& bounds) {
         return plain_26::judge_step(substeps, off < Real(0.25) ? 0 : off, bounds);
       })},
      {"fewer than the least", "it looks as if the substeps became fewer than least_substeps.",
       with_judge([](int substeps, Real off, const Bounds& bounds) {
         return off < Real(0.125) ? Verdict{true, substeps / 2} : plain_26::judge_step(substeps, off, bounds);
       })},
      {"no end",
       "it looks as if a step were tried in more than most_substeps. What half steps do not get to in that many goes "
       "to others.",
       with_judge([](int substeps, Real off, const Bounds& bounds) {
         Bounds wide = bounds;
         wide.most_substeps = 1 << 20;
         return plain_26::judge_step(substeps, off, wide);
       })},
      {"one more instead of twice",
       "it looks as if the next try had one substep more. The error falls with their square: doubling gets there in a "
       "few tries.",
       with_judge([](int substeps, Real off, const Bounds& bounds) {
         Verdict verdict = plain_26::judge_step(substeps, off, bounds);
         if (!verdict.stands) verdict.substeps = substeps < bounds.most_substeps ? substeps + 1 : 0;
         return verdict;
       })},
  };
}

}  // namespace

Numbers play(std::size_t check, Random& random, const Answer& answer) {
  return checks()[check].play(random, answer);
}

Exercise exercise() {
  return rebuild_of<Answer>(
      "which step an island calls for, and in how many substeps",
      {"Begin with call: four lines, one for each sentence of the task, in its order. The first that holds decides.",
       "The limit of contacts is one of two numbers: island.had_half_steps ? bounds.most_kept : bounds.most.",
       "judge has three ends: {true, half as many or as many}, {false, twice as many}, {false, 0}."},
      checks(), {plain_26::call_of, plain_26::judge_step}, mistakes());
}

}  // namespace pushback::exercise_26
