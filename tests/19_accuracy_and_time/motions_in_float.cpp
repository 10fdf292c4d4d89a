/// Chapter 19: motions played in single precision, beside the same in double.
#include "tests/19_accuracy_and_time/errors_in.h"

TEST_CASE("in float a bounce errs as in double, and what lies still only by what float rounds") {
  const std::string settings = "full/8/4 slim/16/1 direct-contacts/8/1 soft/8/1";
  const auto in_double = errors_in(MOTION_PROGRAM, "bounce", settings);
  const auto in_float = errors_in(MOTION_FLOAT_PROGRAM, "bounce", settings);
  REQUIRE(in_double.size() == in_float.size());
  for (std::size_t i = 0; i < in_double.size(); ++i) CHECK(in_float[i] == Approx(in_double[i]).epsilon(0.01));
  // A box whose centre is at 1.5 m is known to 6e-8 of that; and a rest depth of 1 um is then not one to a per cent any more.
  const double rest_depth = errors_in(MOTION_PROGRAM, "heavy-on-light", "direct-contacts/8/1").at(0);
  const double of_float = errors_in(MOTION_FLOAT_PROGRAM, "heavy-on-light", "direct-contacts/8/1").at(0);
  CHECK(rest_depth == Approx(2e-6).epsilon(1e-3));
  INFO(of_float);
  CHECK(of_float > 1e-7 * 1.5);
  CHECK(std::abs(of_float - rest_depth) > 1e-3 * rest_depth);  // double it is not
}
