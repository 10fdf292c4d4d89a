/// What tests measure with: the step, gravity, rounding.
#pragma once

#include <limits>

#include "pushback/common/world/world.h"

inline constexpr pushback::Real h = pushback::Real(1) / 60;  ///< s
inline constexpr pushback::Real g = pushback::World::g;      ///< m/s^2
inline constexpr pushback::Real eps = std::numeric_limits<pushback::Real>::epsilon();
inline constexpr bool in_double = std::numeric_limits<pushback::Real>::digits > 24;
/// m: what rounding may do to a point some metres away.
inline constexpr pushback::Real point_rounding = in_double ? pushback::Real(1e-12) : pushback::Real(1e-4);
