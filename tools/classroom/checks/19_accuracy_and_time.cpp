#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "pushback/chapters/19_accuracy_and_time/exercise/asked.h"

namespace pushback::exercise_19 {

namespace {

using study::Measured;
using study::Measurements;

/// Timed in four rounds, with this median.
Measured measured(double median, double error) {
  Measured one;
  one.error = error;
  for (const double part : {0.9, 0.97, 1.03, 1.2}) one.seconds.push_back(part * median);
  return one;
}

/// Settings of which none beats another, from the fastest on.
Measurements unbeaten(Random& random) {
  Measurements found;
  double seconds = random.between(Real(0.0002), Real(0.001)), error = random.between(Real(0.01), Real(0.05));
  for (std::size_t left = 4 + random.below(3); left > 0; --left) {
    found.push_back(measured(seconds, error));
    seconds *= random.between(Real(1.6), 3);
    error /= random.between(2, 4);
  }
  return found;
}

Measured lost(double median) {
  return measured(median, std::numeric_limits<double>::infinity());
}

/// Slower than this one, and worse.
Measured beaten(Random& random, const Measured& by) {
  const double times = random.between(Real(1.1), Real(1.5));
  return measured(times * by.median(), by.error * random.between(Real(1.1), Real(1.5)));
}

const std::vector<Quantity>& of_a_front() {
  static const std::vector<Quantity> quantities{{"the number of settings on your front is", "", 1e-9},
                                                {"the settings on your front take together", "ms", 1e-4},
                                                {"the errors on your front add up to", "mm", 1e-4}};
  return quantities;
}

/// Errors that are infinite are not added.
Numbers numbers_of(const Measurements& front) {
  double seconds = 0, error = 0;
  for (const Measured& one : front) {
    seconds += one.median();
    if (std::isfinite(one.error)) error += one.error;
  }
  return {static_cast<Real>(front.size()), static_cast<Real>(1000 * seconds), static_cast<Real>(1000 * error)};
}

std::vector<Check<Answer>> checks() {
  std::vector<Quantity> of_lost = of_a_front();
  of_lost.push_back({"where all motions were lost, the number of settings on your front is", "", 1e-9});
  return {
      {"a setting that another beats in both is not on the front", 1, of_a_front(),
       [](Random& random, const Answer& answer) -> Numbers {
         Measurements best = unbeaten(random);
         best[1].seconds.back() *= 10;  // unlucky, once
         Measurements all{best.back()};
         all.insert(all.end(), best.begin(), best.end() - 1);
         for (const Measured& by : best) all.push_back(beaten(random, by));
         Measured lucky = beaten(random, best.front());  // once
         lucky.seconds.front() *= 0.3;
         all.push_back(lucky);
         return numbers_of(answer.front(all));
       }},
      {"of settings that are equal in one, only the best in the other is on the front", 2, of_a_front(),
       [](Random& random, const Answer& answer) -> Numbers {
         const Measurements best = unbeaten(random);
         Measured as_fast = best[1], as_good = best[2];
         as_fast.error *= random.between(Real(1.2), Real(1.8));
         const double times = random.between(Real(1.2), Real(1.5));
         for (double& seconds : as_good.seconds) seconds *= times;
         Measurements all{as_fast, as_good, best.back()};
         all.insert(all.end(), best.begin(), best.end() - 1);
         return numbers_of(answer.front(all));
       }},
      {"a motion that was lost is not on the front, however fast", 1, of_lost,
       [](Random& random, const Answer& answer) -> Numbers {
         const Measurements best = unbeaten(random);
         const double fastest = best.front().median() * random.between(Real(0.3), Real(0.6));
         Measured given_up = lost(10 * best.back().median());
         given_up.late = true;
         Measurements all{best.back(), given_up, lost(fastest)};
         all.insert(all.end(), best.begin(), best.end() - 1);
         Numbers numbers = numbers_of(answer.front(all));
         numbers.push_back(static_cast<Real>(answer.front({given_up, lost(fastest)}).size()));
         return numbers;
       }},
      {"the front goes from the fastest to the most accurate",
       1,
       {{"your front begins with a setting that takes", "ms", 1e-4},
        {"your front ends with a setting that takes", "ms", 1e-4}},
       [](Random& random, const Answer& answer) -> Numbers {
         Measurements all = unbeaten(random);
         std::rotate(all.begin(), all.begin() + 1, all.end());
         const Measurements front = answer.front(all);
         if (front.empty()) return {0, 0};
         return {static_cast<Real>(1000 * front.front().median()), static_cast<Real>(1000 * front.back().median())};
       }},
  };
}

bool by_time(const Measured& one, const Measured& other) {
  return one.median() < other.median();
}

bool by_both(const Measured& one, const Measured& other) {
  return std::pair(one.median(), one.error) < std::pair(other.median(), other.error);
}

void leave_out_lost(Measurements& all) {
  std::erase_if(all, [](const Measured& one) { return !std::isfinite(one.error); });
}

/// In their order, those that are to be kept after what was kept before.
template <class Keep>
Measurements kept(const Measurements& all, const Keep& keep) {
  Measurements found;
  for (const Measured& one : all)
    if (found.empty() || keep(one, found)) found.push_back(one);
  return found;
}

bool better_than_last(const Measured& one, const Measurements& found) {
  return one.error < found.back().error;
}

/// In their order, those that none beats.
template <class Beats>
Measurements left_by(const Measurements& all, const Beats& beats) {
  Measurements found;
  for (const Measured& one : all)
    if (std::none_of(all.begin(), all.end(), [&](const Measured& other) { return beats(other, one); }))
      found.push_back(one);
  return found;
}

bool beats(const Measured& one, const Measured& other) {
  return one.median() <= other.median() && one.error <= other.error &&
         (one.median() < other.median() || one.error < other.error);
}

/// Right but for the time that counts.
template <class Seconds>
Measurements front_by(Measurements all, const Seconds& seconds) {
  leave_out_lost(all);
  Measurements found = left_by(all, [&](const Measured& one, const Measured& other) {
    return seconds(one) <= seconds(other) && one.error <= other.error &&
           (seconds(one) < seconds(other) || one.error < other.error);
  });
  std::sort(found.begin(), found.end(), by_time);
  return found;
}

std::vector<Mistake<Answer>> mistakes() {
  return {
      {"equal times kept",
       "it looks as if settings that take equally long were kept together. The one with the larger error costs as much "
       "and gives less. Of equal times, the least error has to come first.",
       {[](Measurements all) {
         leave_out_lost(all);
         std::stable_sort(all.begin(), all.end(), by_time);
         return kept(all, better_than_last);
       }}},
      {"equal errors kept",
       "it looks as if settings with the same error were kept together. The slower one gives no more than the faster "
       "one: it has to be better, not as good.",
       {[](Measurements all) {
         leave_out_lost(all);
         std::sort(all.begin(), all.end(), by_both);
         return kept(all, [](const Measured& one, const auto& found) { return one.error <= found.back().error; });
       }}},
      {"ties kept",
       "it looks as if a setting were beaten only by one that is better in both. One that is as fast and more "
       "accurate, or as accurate and faster, beats it, too.",
       {[](Measurements all) {
         leave_out_lost(all);
         std::sort(all.begin(), all.end(), by_both);
         return left_by(all, [](const Measured& one, const Measured& other) {
           return one.median() < other.median() && one.error < other.error;
         });
       }}},
      {"a lost motion kept",
       "it looks as if a motion that was lost were on the front. Its error is infinite: it is the fastest, and nothing "
       "that it says is true.",
       {[](Measurements all) {
         std::sort(all.begin(), all.end(), by_both);
         return kept(all, better_than_last);
       }}},
      {"nothing left out",
       "it looks as if nothing were left out. On the front are those that no other beats.",
       {[](Measurements all) {
         std::sort(all.begin(), all.end(), by_both);
         return all;
       }}},
      {"nothing left out",
       "it looks as if nothing but lost motions were left out. On the front are those that no other beats.",
       {[](Measurements all) {
         leave_out_lost(all);
         std::sort(all.begin(), all.end(), by_both);
         return all;
       }}},
      {"compared with the first",
       "it looks as if each setting were compared with the fastest one alone. Who is slower has to be more accurate "
       "than all that are faster: than the last one that was kept.",
       {[](Measurements all) {
         leave_out_lost(all);
         std::sort(all.begin(), all.end(), by_both);
         return kept(all, [](const Measured& one, const auto& found) { return one.error < found.front().error; });
       }}},
      {"the worst kept",
       "it looks as if the larger of two errors won. Who takes longer has to give a smaller one.",
       {[](Measurements all) {
         leave_out_lost(all);
         std::sort(all.begin(), all.end(), by_both);
         return kept(all, [](const Measured& one, const auto& found) { return one.error > found.back().error; });
       }}},
      {"beaten by itself",
       "it looks as if each setting were compared with itself too, and found to be beaten. Equal in both is not "
       "beaten.",
       {[](Measurements all) {
         leave_out_lost(all);
         return left_by(all, [](const Measured& one, const Measured& other) {
           return one.median() <= other.median() && one.error <= other.error;
         });
       }}},
      {"sort forgotten",
       "it looks as if each setting were compared with the last one kept, in the order in which they were given. "
       "Comparing with the last is enough only where they come by their times.",
       {[](Measurements all) {
         leave_out_lost(all);
         return kept(all, better_than_last);
       }}},
      {"the front not sorted",
       "it looks as if the front had the order in which the settings were given. A line that is drawn through it would "
       "go back and forth: sort it by time.",
       {[](Measurements all) {
         leave_out_lost(all);
         return left_by(all, beats);
       }}},
      {"the wrong way round",
       "it looks as if the front went from the most accurate to the fastest. It goes by time, ascending.",
       {[](Measurements all) {
         leave_out_lost(all);
         std::sort(all.begin(), all.end(), by_both);
         Measurements found = kept(all, better_than_last);
         std::reverse(found.begin(), found.end());
         return found;
       }}},
      {"a mean or a last round for the median",
       "it looks as if a round in which the machine was busy counted, by the mean of all rounds or as the last one. "
       "The median of all rounds does not mind one of them.",
       {[](Measurements all) {
         return front_by(std::move(all), [](const Measured& one) { return one.seconds.back(); });
       }}},
      {"a mean or a last round for the median",
       "it looks as if a round in which the machine was busy counted, by the mean of all rounds or as the last one. "
       "The median of all rounds does not mind one of them.",
       {[](Measurements all) {
         return front_by(std::move(all), [](const Measured& one) {
           return std::accumulate(one.seconds.begin(), one.seconds.end(), 0.0) /
                  static_cast<double>(one.seconds.size());
         });
       }}},
      {"the fastest round for the median",
       "it looks as if the fastest of a setting's rounds counted. That is luck, once: the time that counts is the "
       "median of all rounds.",
       {[](Measurements all) {
         leave_out_lost(all);
         std::sort(all.begin(), all.end(), [](const Measured& one, const Measured& other) {
           return std::pair(one.seconds.front(), one.error) < std::pair(other.seconds.front(), other.error);
         });
         return kept(all, better_than_last);
       }}},
  };
}

}  // namespace

Numbers play(std::size_t check, Random& random, const Answer& answer) {
  return checks()[check].play(random, answer);
}

Exercise exercise() {
  return rebuild_of<Answer>("the front of a diagram",
                            {"Leave out first what has an infinite error: std::isfinite.",
                             "Put the others in the order of their times; of equal times, the smaller error first. A "
                             "std::pair of both compares so.",
                             "Go through them in that order. Nobody who comes later is faster, so a setting belongs "
                             "to the front exactly if its error is smaller than that of the last one that you took."},
                            checks(), {study::front}, mistakes());
}

}  // namespace pushback::exercise_19
