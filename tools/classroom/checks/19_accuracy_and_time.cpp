#include <algorithm>
#include <cmath>
#include <limits>

#include "pushback/chapters/19_accuracy_and_time/exercise/asked.h"
#include "pushback/tools/classroom/checks/scenes.h"

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

/// Errors that are infinite are not added.
std::vector<Reading> readings_of(const Measurements& front) {
  double seconds = 0, error = 0;
  for (const Measured& one : front) {
    seconds += one.median();
    if (std::isfinite(one.error)) error += one.error;
  }
  return {{"the number of settings on your front is", front.size()},
          {"the times of the settings on your front add up to", 1000 * seconds, "ms", 1e-4},
          {"the errors on your front add up to", 1000 * error, "mm", 1e-4}};
}

}  // namespace

std::vector<Check<Answer>> checks_of(const Answer& /*any*/) {
  return {
      {"a setting is not on the front if another one is better in both", 1,
       [](Random& random, const Answer& answer) -> std::vector<Reading> {
         Measurements best = unbeaten(random);
         best[1].seconds.back() *= 10;  // unlucky, once
         Measurements all{best.back()};
         all.insert(all.end(), best.begin(), best.end() - 1);
         for (const Measured& by : best) all.push_back(beaten(random, by));
         Measured lucky = beaten(random, best.front());  // once
         lucky.seconds.front() *= 0.3;
         all.push_back(lucky);
         return readings_of(answer.front(all));
       },
       "the front contains exactly the settings that no other setting beats. Compare median times over all rounds, "
       "because one slow round does not change a median."},
      {"of settings with the same time or error, only the best in the other one is on the front", 2,
       [](Random& random, const Answer& answer) -> std::vector<Reading> {
         const Measurements best = unbeaten(random);
         Measured as_fast = best[1], as_good = best[2];
         as_fast.error *= random.between(Real(1.2), Real(1.8));
         const double times = random.between(Real(1.2), Real(1.5));
         for (double& seconds : as_good.seconds) seconds *= times;
         Measurements all{as_fast, as_good, best.back()};
         all.insert(all.end(), best.begin(), best.end() - 1);
         return readings_of(answer.front(all));
       },
       "a setting beats another one if it is as fast and more accurate, or as accurate and faster."},
      {"a motion that was lost is not on the front, however fast it was", 1,
       [](Random& random, const Answer& answer) -> std::vector<Reading> {
         const Measurements best = unbeaten(random);
         const double fastest = best.front().median() * random.between(Real(0.3), Real(0.6));
         Measurements all{best.back(), lost(10 * best.back().median()), lost(fastest)};
         all.insert(all.end(), best.begin(), best.end() - 1);
         return readings_of(answer.front(all));
       },
       "a motion that was lost has an infinite error. Its time does not count, because its result is wrong."},
      {"the front goes from the fastest to the most accurate", 1,
       [](Random& random, const Answer& answer) -> std::vector<Reading> {
         Measurements all = unbeaten(random);
         std::rotate(all.begin(), all.begin() + 1, all.end());
         Measurements front = answer.front(all);
         if (front.empty()) front.push_back(measured(0, 0));
         return {{"the time of the first setting on your front is", 1000 * front.front().median(), "ms", 1e-4},
                 {"the time of the last setting on your front is", 1000 * front.back().median(), "ms", 1e-4}};
       },
       "the front is sorted by time, from the fastest to the most accurate."},
  };
}

Exercise exercise() {
  return rebuild_of("the front of a diagram",
                    {"First leave out settings with an infinite error, by std::isfinite.",
                     "Sort the others by their times, and settings with equal times by their errors. A std::pair of "
                     "both compares in this way.",
                     "Go through them in this order. No later setting is faster, so a setting belongs to the front "
                     "exactly if its error is smaller than the error of the last one you took."},
                    Answer{study::front});
}

}  // namespace pushback::exercise_19
