/// Fourth-order steps, composed of second-order steps.
#pragma once

#include <array>

#include "pushback/common/basics/types.h"

namespace pushback {

/// A symmetric step of second order has an error of delta h^3 + O(h^5). Steps of a_i h in a row have (sum a_i^3) delta h^3. With
///
///   sum a_i = 1,  sum a_i^3 = 0
///
/// this error vanishes, and the composed step has order 4. One a_i has to be negative, a step back in time. Joints and gravity allow
/// this, but friction and impacts do not.
///   Yoshida, Phys. Lett. A 150, 1990; Suzuki, Phys. Lett. A 146, 1990.
inline constexpr std::array<Real, 3> yoshida = [] {
  constexpr Real one = Real(1.3512071919596578);  // 1 / (2 - 2^(1/3))
  return std::array<Real, 3>{one, 1 - 2 * one, one};
}();
/// More steps, none of which is longer than h, so the error is far smaller.
inline constexpr std::array<Real, 5> suzuki = [] {
  constexpr Real one = Real(0.41449077179437571);  // 1 / (4 - 4^(1/3))
  return std::array<Real, 5>{one, one, 1 - 4 * one, one, one};
}();
/// No composition.
inline constexpr std::array<Real, 1> one_step{1};

}  // namespace pushback
