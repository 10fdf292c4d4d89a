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
          {"the settings on your front take together", 1000 * seconds, "ms", 1e-4},
          {"the errors on your front add up to", 1000 * error, "mm", 1e-4}};
}

}  // namespace

std::vector<Check<Answer>> checks_of(const Answer& /*any*/) {
  return {
      {"a setting that another beats in both is not on the front", 1,
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
       "on the front are exactly those settings that no other beats. The time that counts is the median of all rounds, "
       "which does not mind one of them."},
      {"of settings that are equal in one, only the best in the other is on the front", 2,
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
       "a setting that is as fast as another and more accurate beats it, and so does one that is as accurate and "
       "faster."},
      {"a motion that was lost is not on the front, however fast", 1,
       [](Random& random, const Answer& answer) -> std::vector<Reading> {
         const Measurements best = unbeaten(random);
         const double fastest = best.front().median() * random.between(Real(0.3), Real(0.6));
         Measurements all{best.back(), lost(10 * best.back().median()), lost(fastest)};
         all.insert(all.end(), best.begin(), best.end() - 1);
         return readings_of(answer.front(all));
       },
       "a motion that was lost has an infinite error. However fast it is, nothing that it says is true."},
      {"the front goes from the fastest to the most accurate", 1,
       [](Random& random, const Answer& answer) -> std::vector<Reading> {
         Measurements all = unbeaten(random);
         std::rotate(all.begin(), all.begin() + 1, all.end());
         Measurements front = answer.front(all);
         if (front.empty()) front.push_back(measured(0, 0));
         return {{"your front begins with a setting that takes", 1000 * front.front().median(), "ms", 1e-4},
                 {"your front ends with a setting that takes", 1000 * front.back().median(), "ms", 1e-4}};
       },
       "the front goes by time, from the fastest to the most accurate."},
  };
}

Exercise exercise() {
  return rebuild_of("the front of a diagram",
                    {"Leave out first what has an infinite error: std::isfinite.",
                     "Put the others in the order of their times; of equal times, the smaller error first. A "
                     "std::pair of both compares so.",
                     "Go through them in that order. Nobody who comes later is faster, so a setting belongs "
                     "to the front exactly if its error is smaller than that of the last one that you took."},
                    Answer{study::front});
}

}  // namespace pushback::exercise_19
