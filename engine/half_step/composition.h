/// Steps of fourth order, made of steps of second.
#pragma once

#include <array>

#include "pushback/engine/half_step/half_step.h"

namespace pushback {

/// A symmetric step of second order is off by delta h^3 + O(h^5) of its own. Steps of a_i h in a row are off by
/// (sum a_i^3) delta h^3: with
///
///   sum a_i = 1,  sum a_i^3 = 0
///
/// that is gone, and the composed step is of order 4. One a_i has to be negative, a step back in time. Joints and gravity allow
/// it; friction and impacts do not.
///   Yoshida, Phys. Lett. A 150, 1990; Suzuki, Phys. Lett. A 146, 1990.
struct Yoshida {
  static constexpr Real one = Real(1.3512071919596578);  // 1 / (2 - 2^(1/3))
  static constexpr std::array<Real, 3> parts{one, 1 - 2 * one, one};
};
/// Longer, but none of its steps is longer than h: an error far smaller.
struct Suzuki {
  static constexpr Real one = Real(0.41449077179437571);  // 1 / (4 - 4^(1/3))
  static constexpr std::array<Real, 5> parts{one, one, 1 - 4 * one, one, one};
};

template <class Composition>
class Composed : public HalfStep {
 protected:
  std::span<const Real> parts() const override { return Composition::parts; }
};

}  // namespace pushback
