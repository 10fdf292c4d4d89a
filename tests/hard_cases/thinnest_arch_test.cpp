/// The least thickness of an arch, beside what is known of it.
#include "pushback/tools/hard_cases/thinnest_arch.h"

#include <cmath>

#include "tests/support/catch.h"

using namespace pushback;

TEST_CASE("thinnest arch: with many wedges it is Milankovitch's, 0.1075 of the mean radius") {
  CHECK(thinnest_arch(2000).thickness == Approx(0.1075).margin(5e-5));
}

/// The joints that there were stay, and the line of thrust has to be within the new ones as well.
TEST_CASE("thinnest arch: wedges cut in two ask for as much, or for more") {
  Real before = 0;
  for (const int wedges : {13, 26, 52, 104, 208}) {
    const Real now = thinnest_arch(wedges).thickness;
    INFO(wedges);
    CHECK(now >= before);
    before = now;
  }
}

/// Two that lean on each other, and a stone between them: hinges at three joints, or four with none too many, make no mechanism.
TEST_CASE("thinnest arch: of two wedges or three it stands however thin") {
  CHECK(thinnest_arch(2).thickness < Real(1e-9));
  CHECK(thinnest_arch(3).thickness < Real(1e-9));
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

/// What each joint of the case's arch asks of friction, at the angle a from the crown: |H sin a - W cos a| / (H cos a + W sin a).
TEST_CASE("thinnest arch: no joint of 13 wedges slips with mu = 0.4") {
  const ThinnestArch arch = thinnest_arch(13);
  for (int i = 0; i <= 6; ++i) {
    const Real a = pi / 2 - pi / 13 * static_cast<Real>(i), weight = a / (pi / 2);
    const Real rubs = std::abs(arch.thrust * std::sin(a) - weight * std::cos(a));
    CHECK(rubs < Real(0.4) * (arch.thrust * std::cos(a) + weight * std::sin(a)));
  }
  CHECK(arch.thickness > Real(0.1));
  CHECK(arch.thickness < Real(0.1075));
}
