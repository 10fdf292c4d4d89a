/// The answer to exercise 13, and its checks.
#pragma once

#include "pushback/common/exercise/exercise.h"
#include "pushback/common/world/joint.h"

namespace pushback::exercise_13 {

/// A rail in the shape of a ring, fixed to A, and the slider on it, a point of B.
struct RoundRail {
  Vec3 centre;  ///< Q, m, A's axes, from A's centre of mass
  Vec3 axis;    ///< m, unit, A's axes; perpendicular to the plane of the rail
  Real radius;  ///< R, m
  Vec3 slider;  ///< P, m, B's axes, from B's centre of mass
};

struct Answer {
  void (*ask)(const RoundRail& rail, const Body& a, const Body& b, Equations& equations);
};

std::vector<Check<Answer>> checks_of(const Answer& /*any*/);

}  // namespace pushback::exercise_13
