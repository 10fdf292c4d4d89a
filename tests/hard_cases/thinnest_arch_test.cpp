/// The least thickness of an arch, beside what is known of it.
#include "pushback/tools/measure/hard_cases/thinnest_arch.h"

#include <cmath>

#include "tests/support/catch.h"

using namespace pushback;

TEST_CASE("thinnest arch: with many wedges it is Milankovitch's, 0.1075 of the mean radius") {
  CHECK(thinnest_arch(2000).thickness == Approx(0.1075).margin(5e-5));
}

/// Of four wedges the line touches the outer edge at crown and springing and the inner one at 45 degrees. The joint at a distance r
/// bears H (y0 - r cos a) = W r sin a - M.
TEST_CASE("thinnest arch: of four wedges, the moments about the three hinges of its collapse balance") {
  const ThinnestArch arch = thinnest_arch(4);
  const Real inner = 1 - arch.thickness / 2, outer = 1 + arch.thickness / 2;
  const Real area = (outer * outer - inner * inner) / 2, moment = (std::pow(outer, 3) - std::pow(inner, 3)) / 3;
  const Real thrust = arch.thrust * area * pi / 2;
  CHECK(thrust * outer == Approx(area * pi / 2 * outer - moment).epsilon(1e-9));
  const Real r = inner * std::sqrt(Real(0.5));
  CHECK(thrust * (outer - r) == Approx(area * pi / 4 * r - (1 - std::sqrt(Real(0.5))) * moment).epsilon(1e-9));
  CHECK(arch.thickness > Real(0.05));
}
