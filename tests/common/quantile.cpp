/// common/basics/quantile.h: medians and quartiles.
#include "pushback/common/basics/quantile.h"

#include <limits>
#include <random>

#include "tests/support/call.h"
#include "tests/support/catch.h"
#include "tests/support/complaint.h"

using namespace pushback;

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

/// Lower quartile, median, upper quartile.
std::vector<double> quartiles(const std::vector<double>& values) {
  return {quantile(values, 0.25), quantile(values, 0.5), quantile(values, 0.75)};
}

}  // namespace

TEST_CASE("quartiles of one to five values, in whatever order they come, lie between their neighbours by proportion") {
  CHECK(quartiles({7}) == std::vector<double>{7, 7, 7});
  CHECK(quartiles({8, 4}) == std::vector<double>{5, 6, 7});
  CHECK(quartiles({8, 2, 4}) == std::vector<double>{3, 4, 6});
  CHECK(quartiles({16, 4, 1, 8}) == std::vector<double>{3.25, 6, 10});
  CHECK(quartiles({50, 1, 3, 4, 2}) == std::vector<double>{2, 3, 4});
  CHECK(median({16, 4, 1, 8}) == 6);
}

TEST_CASE(
    "a quantile is monotone in p, the least value at 0, the greatest at 1, and no order of the values changes it") {
  std::mt19937 random(13);
  for (int trial = 0; trial < 200; ++trial) {
    std::vector<double> values(1 + random() % 12);
    for (double& value : values) value = static_cast<double>(random() % 7) - 3;
    std::vector<double> mirrored(values.rbegin(), values.rend()), ascending = values;
    std::sort(ascending.begin(), ascending.end());
    CHECK(quantile(values, 0) == ascending.front());
    CHECK(quantile(values, 1) == ascending.back());
    double before = -infinite;
    for (double p = 0; p <= 1; p += 1.0 / 64) {
      const double now = quantile(values, p);
      CHECK(now >= before);
      CHECK(now == quantile(mirrored, p));
      before = now;
    }
    for (double& value : mirrored) value = -value;
    CHECK(median(mirrored) == -median(values));
    for (std::size_t i = 0; i < ascending.size(); ++i)  // at its own place each value itself
      if (ascending.size() > 1)
        CHECK(quantile(values, static_cast<double>(i) / static_cast<double>(ascending.size() - 1)) ==
              Approx(ascending[i]).margin(1e-12));
  }
}

TEST_CASE("what has no quantile is refused, by name") {
  CHECK(contains(complaint([] { quantile({}, 0.5); }), "no values"));
  CHECK(contains(complaint([] { quantile({1, 2}, -0.01); }), "-0.01"));
  CHECK(contains(complaint([] { quantile({1, 2}, 1.01); }), "1.01"));
  CHECK(contains(complaint([] { quantile({1, 2}, std::nan("")); }), "nan"));
  CHECK(contains(complaint([] { quantile({1, std::nan("")}, 0); }), "nan"));
  CHECK(contains(complaint([] { quantile({-infinite, infinite}, 0.5); }), "between -inf and inf"));
}
