#include <array>
#include <cmath>

#include "pushback/chapters/24_half_step/exercise/transfer/asked.h"
#include "pushback/chapters/24_half_step/study.h"
#include "pushback/tools/classroom/checks/scenes.h"

namespace pushback::exercise_24_transfer {

namespace {

using half_step_scenes::composed_step;

/// The answer for truth + c h^p, with h = 1.
Judged said_of(const Answer& answer, double truth, double c, double p) {
  return answer.judge(truth + c, truth + c * std::pow(2, -p), truth + c * std::pow(4, -p));
}

/// How far a ball on a rod has got to the right after half a second.
template <class Step>
double way(const Step& step, const plain_24::Bob& begin, int steps) {
  plain_24::Bob bob = begin;
  for (int i = 0; i < steps; ++i) step(bob, Vec3(0, -World::g, 0), Real(0.5) / static_cast<Real>(steps));
  return static_cast<double>(bob.x.x());
}

Judged right(double whole, double half, double quarter) {
  const double p = std::log2(std::abs((whole - half) / (half - quarter)));
  const double left = (quarter - half) / (std::exp2(p) - 1);
  return {p, std::abs(left), quarter + left};
}

}  // namespace

std::vector<Check<Answer>> checks_of(const Answer& /*any*/) {
  return {
      {"the order of an invented method", 1,
       [](Random& random, const Answer& answer) -> std::vector<Reading> {
         const double truth = between(random, 1, 3), c = between(random, 0.2, 0.8);
         const double one = between(random, 1, 2), other = between(random, 2.5, 4);
         return {{"your order of a method is", said_of(answer, truth, c, one).order, "", 1e-5},
                 {"your order of another method is", said_of(answer, truth, -c, other).order, "", 1e-5}};
       },
       "halving the step divides an error of order p by 2^p. The first difference is 2^p times the second, so p is the "
       "base-2 logarithm of their ratio."},
      {"the error of the best of three results", 2,
       [](Random& random, const Answer& answer) -> std::vector<Reading> {
         const double truth = between(random, 1, 3), c = between(random, 0.2, 0.8);
         const double p = between(random, 1.2, 2);
         return {{"your error of the best of three results is", 1000 * said_of(answer, truth, c, p).error, "mm", 1e-4},
                 {"for results that rise, your error of the best one is", 1000 * said_of(answer, truth, -c, p).error,
                  "mm", 1e-4}};
       },
       "the error of half is 2^p times the error of quarter, so their difference is 2^p - 1 times the error of "
       "quarter. The error is 0 or more."},
      {"an improved result", 2,
       [](Random& random, const Answer& answer) -> std::vector<Reading> {
         const double truth = between(random, 1, 3), c = between(random, 0.2, 0.8), p = between(random, 1.2, 3);
         return {{"your improved result is", said_of(answer, truth, c, p).better, "m"},
                 {"for results that rise, your improved result is", said_of(answer, truth, -c, p).better, "m"}};
       },
       "from half to quarter the result came nearer to the truth. The improved result lies beyond quarter, by the "
       "error of quarter."},
      {"three steps of this chapter", 1,
       [](Random& random, const Answer& answer) -> std::vector<Reading> {
         const Real angle = random.between(Real(0.8), Real(1.2));
         const plain_24::Bob begin{{std::sin(angle), -std::cos(angle), 0}, Vec3::Zero(), 1};
         const auto order_of = [&](const auto& step) {
           return static_cast<Real>(
               answer.judge(way(step, begin, 16), way(step, begin, 32), way(step, begin, 64)).order);
         };
         return {{"your order of the whole step is", order_of(plain_24::whole_step), "", 1e-4},
                 {"your order of the half step is", order_of(plain_24::half_step), "", 1e-4},
                 {"your order of the composed step is", order_of(composed_step), "", 1e-3}};
       },
       "the three steps have the orders 1, 2 and 4, and the differences of their own results show it."},
  };
}

Exercise exercise() {
  return exercise_of(
      "an order without a truth",
      {"The differences whole - half and half - quarter do not contain the truth. They depend only on c and p.",
       "With the step h/2 the error is c h^p / 2^p. So the first difference is 2^p times the second.",
       "half - quarter is 2^p - 1 times the error of quarter. Subtract this error from quarter, with its sign."},
      Answer{right});
}

}  // namespace pushback::exercise_24_transfer
