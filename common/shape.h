/// The four shapes, each in the frame of its body, whose origin is the centre of mass.
#pragma once

#include <variant>

#include "common/types.h"

namespace pushback {

struct Sphere {
  Real radius;  ///< m
};

/// All points within half_extents of the origin along the body's axes.
struct Box {
  Vec3 half_extents;  ///< m
};

/// All points within `radius` of the segment from (0, -half_length, 0) to (0, half_length, 0).
struct Capsule {
  Real radius;       ///< m
  Real half_length;  ///< m, of the segment alone
};

/// All points p with normal . p <= 0: solid below, free above. Always immovable.
struct HalfSpace {
  Vec3 normal;  ///< unit, pointing out of the solid
};

using Shape = std::variant<Sphere, Box, Capsule, HalfSpace>;

}  // namespace pushback
