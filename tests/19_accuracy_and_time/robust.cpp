/// Robust errors: each property holds for settings of few methods, knobs, times and errors, so that many are alike. rapidcheck
/// draws them, and shrinks what fails.
#include <rapidcheck.h>

#include <algorithm>
#include <cmath>

#include "pushback/chapters/19_accuracy_and_time/front.h"
#include "tests/support/catch.h"

using namespace pushback::study;

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

Measured drawn() {
  Measured one{.engine = *rc::gen::element<std::string>("motion", "motion_ode"),
               .method = *rc::gen::element<std::string>("slim", "soft"),
               .substeps = 1 << *rc::gen::inRange(0, 5),
               .sweeps = *rc::gen::element(0, 1, 4, 16),
               .error = *rc::gen::inRange(0, 8) / 1.0,
               .seconds = {*rc::gen::inRange(1, 9) / 8.0}};
  const int end = *rc::gen::inRange(0, 12);  // one of six is lost, another given up
  one.late = end < 2;
  if (end < 4) one.error = infinite;
  return one;
}
Measurements some() {
  return *rc::gen::container<Measurements>(rc::gen::exec(drawn));
}

}  // namespace

TEST_CASE("a robust front is never below the plain one, and its settings are those that were measured") {
  CHECK(rc::check([] {
    const Measurements all = some(), counted = robust(all);
    RC_ASSERT(counted.size() == all.size());
    for (std::size_t i = 0; i < all.size(); ++i) {
      RC_ASSERT(counted[i].error >= all[i].error);
      RC_ASSERT(counted[i].setting() == all[i].setting());
      RC_ASSERT(counted[i].seconds == all[i].seconds);
    }
    for (double error = 0; error < 8; ++error) {
      const auto plain = cheapest(all, error), sure = cheapest(counted, error);
      RC_ASSERT((!sure || plain->median() <= sure->median()));
    }
  }));
}

TEST_CASE(
    "a setting that is good by chance is not chosen for it: errors cancel in it, and not in those that are finer") {
  CHECK(rc::check([] {
    // Errors fall with the step. One, not the finest, is a hundredth of what it should be, and fast enough to be chosen.
    Measurements all;
    const int lucky = *rc::gen::inRange(0, 5);
    const double times = *rc::gen::inRange(1, 100) / 10.0;
    for (int i = 0; i < 6; ++i)
      all.push_back({.engine = "motion",
                     .method = "slim",
                     .substeps = 1 << i,
                     .sweeps = 1,
                     .error = times * std::ldexp(1, -i) * (i == lucky ? 0.01 : 1),
                     .seconds = {std::ldexp(1, i)}});
    const double wanted = all[std::size_t(lucky)].error;
    RC_ASSERT(cheapest(all, wanted)->substeps == 1 << lucky);
    const auto found = cheapest(robust(all), wanted);
    RC_ASSERT((!found || found->substeps > 1 << lucky));
    for (const Measured& one : front(robust(all))) RC_ASSERT(one.error > wanted);
  }));
}
