/// common/basics/quantile.h: medians and quartiles.
#include "pushback/common/basics/quantile.h"

#include <limits>

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

TEST_CASE("what has no quantile is refused, by name") {
  CHECK(contains(complaint([] { quantile({}, 0.5); }), "no values"));
  CHECK(contains(complaint([] { quantile({1, 2}, -0.01); }), "-0.01"));
  CHECK(contains(complaint([] { quantile({1, 2}, 1.01); }), "1.01"));
  CHECK(contains(complaint([] { quantile({1, 2}, std::nan("")); }), "nan"));
  CHECK(contains(complaint([] { quantile({1, std::nan("")}, 0); }), "nan"));
  CHECK(contains(complaint([] { quantile({-infinite, infinite}, 0.5); }), "between -inf and inf"));
}
