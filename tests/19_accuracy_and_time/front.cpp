/// Chapter 19: fronts of what was measured, and which of two settings is the faster.
#include "pushback/chapters/19_accuracy_and_time/front.h"

#include <algorithm>
#include <cmath>
#include <random>

#include "tests/support/catch.h"

using namespace pushback::study;

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

/// Settings of few methods, knobs, times and errors, so that many are alike; some are lost, or given up.
Measurements some(std::mt19937& random) {
  Measurements found;
  for (std::size_t count = 1 + random() % 30; found.size() < count;) {
    const auto end = random() % 12;
    found.push_back({.engine = random() % 2 == 0 ? "motion" : "motion_ode",
                     .method = random() % 2 == 0 ? "slim" : "soft",
                     .substeps = 1 << random() % 5,
                     .sweeps = static_cast<int>(random() % 3),
                     .error = end < 2 ? infinite : static_cast<double>(random() % 8),
                     .late = end == 0,
                     .seconds = {1 + static_cast<double>(random() % 8)}});
  }
  return found;
}
bool no_worse(const Measured& one, const Measured& other) {
  return one.median() <= other.median() && one.error <= other.error;
}

}  // namespace

TEST_CASE("the front is sorted, nobody on it is worse than another, and all else is; the cheapest is the fastest") {
  std::mt19937 random(14);
  for (int trial = 0; trial < 500; ++trial) {
    const Measurements all = some(random), found = front(all);
    for (std::size_t i = 1; i < found.size(); ++i) {
      CHECK(found[i - 1].median() < found[i].median());
      CHECK(found[i - 1].error > found[i].error);
    }
    for (const Measured& one : all) {
      const auto beats = [&](const Measured& other) { return no_worse(other, one); };
      CHECK((!std::isfinite(one.error) || std::any_of(found.begin(), found.end(), beats)));
      for (const double slack : {1.0, 2.0, 3.5}) {
        const auto is_far_better = [&](const Measured& other) {
          return other.error <= one.error && slack * other.median() < one.median();
        };
        CHECK(is_near_front(one, all, slack) ==
              (std::isfinite(one.error) && std::none_of(all.begin(), all.end(), is_far_better)));
      }
    }
    for (const Measured& one : found)
      for (const Measured& other : all) CHECK((!no_worse(other, one) || no_worse(one, other)));
    for (double error = -0.5; error < 9; ++error) {
      double least = infinite;
      for (const Measured& one : all)
        if (one.error <= error) least = std::min(least, one.median());
      const auto nearest = cheapest(all, error);
      REQUIRE(nearest.has_value() == std::isfinite(least));
      if (nearest) CHECK((nearest->median() == least && nearest->error <= error));
    }
  }
  CHECK(front({}).empty());
  CHECK(!cheapest({}, 1));
}

TEST_CASE("a robust error is the largest of all that are as fine, and what is good by chance is not chosen") {
  std::mt19937 random(15);
  for (int trial = 0; trial < 200; ++trial) {
    const Measurements all = some(random), counted = robust(all);
    REQUIRE(counted.size() == all.size());
    for (std::size_t i = 0; i < all.size(); ++i) {
      double largest = all[i].error;
      for (const Measured& finer : all)
        if (!finer.late && finer.engine == all[i].engine && finer.method == all[i].method &&
            finer.substeps >= all[i].substeps && finer.sweeps >= all[i].sweeps)
          largest = std::max(largest, finer.error);
      CHECK(counted[i].error == largest);
      CHECK((counted[i].setting() == all[i].setting() && counted[i].seconds == all[i].seconds));
    }
  }
  for (int lucky = 0; lucky < 5; ++lucky) {  // errors fall with the step, but for one that is fast enough to be chosen
    Measurements all;
    for (int i = 0; i < 6; ++i)
      all.push_back({.engine = "motion",
                     .method = "slim",
                     .substeps = 1 << i,
                     .sweeps = 1,
                     .error = std::ldexp(i == lucky ? 0.01 : 1, -i),
                     .seconds = {std::ldexp(1, i)}});
    const double wanted = all[static_cast<std::size_t>(lucky)].error;
    CHECK(cheapest(all, wanted)->substeps == 1 << lucky);
    CHECK(!cheapest(robust(all), wanted));
  }
}

TEST_CASE("times that noise may turn round are equal, and no setting near the bound of an error decides") {
  const auto timed = [](double error, const std::vector<double>& seconds) {
    return Measured{.engine = "motion", .method = "slim", .error = error, .seconds = seconds};
  };
  CHECK(faster(timed(1, {1}), timed(1, {1.4})) == 0);  // a single timing may be a fifth off
  CHECK(faster(timed(1, {1}), timed(1, {1.6})) == 1);
  CHECK(faster(timed(1, {1, 1}), timed(1, {1.4, 1.4})) == 1);
  CHECK(faster(timed(1, {1.4, 1.4}), timed(1, {1, 1})) == -1);
  CHECK(faster(timed(1, {1, 1}), timed(1, {1.09, 1.09})) == 0);
  CHECK(faster(timed(1, {1, 1, 2, 2}), timed(1, {1.4, 1.7, 2, 3})) == 0);
  const Measurements ones{timed(0.5, {1, 1})};
  CHECK(faster(ones, {timed(0.5, {2, 2})}, 1) == 1);
  CHECK(faster({timed(0.9, {1, 1})}, {timed(0.5, {2, 2})}, 1) == 0);  // 0.8 it does not reach
  CHECK(faster(ones, {timed(1.3, {0.5, 0.5})}, 1) == 1);
  CHECK(faster(ones, {timed(1.2, {0.5, 0.5})}, 1) == 0);
  CHECK((faster({}, ones, 1) == -1 && faster({}, {}, 1) == 0));
}
