/// Shapes in their pose, and manifolds, shared by the functions of the narrow phase.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include "pushback/common/basics/types.h"
#include "pushback/common/bodies/shape.h"

namespace pushback {

/// A shape in its pose. Positions (m) are relative to the first body of the pair, because far from the world's origin the
/// difference of two positions would leave few digits for the depth.
template <class S>
struct Placed {
  const S& shape;
  Vec3 centre;
  Mat3 axes;  ///< columns: the body's axes
};

/// A sphere or a capsule, all points of which are within `radius` of its core, the segment from centre - half to centre + half.
/// The core of a sphere is a point (half = 0), so one function serves both.
struct Round {
  Vec3 centre, half;
  Real radius;
};
inline Round round_of(const Placed<Sphere>& s) {
  return {s.centre, Vec3::Zero(), s.shape.radius};
}
inline Round round_of(const Placed<Capsule>& c) {
  return {c.centre, c.shape.half_length * c.axes.col(1), c.shape.radius};
}

/// One point of a manifold, before it becomes a Contact.
struct Touch {
  Vec3 point;  ///< midway between the surfaces, relative to the first body
  Real depth;
  std::uint32_t feature;
};

/// Up to four points at which two shapes touch. They share a normal, from the first shape to the second.
struct Manifold {
  Real margin = 0;  ///< m: shapes this far apart still touch
  Vec3 normal = Vec3::UnitY();
  /// m, along the normal. Set within the margin if the first shape is a box or a hull, even if no point touches.
  Real overlap = -std::numeric_limits<Real>::max();
  bool passes = false;  ///< they meet only in a sliver, where no point touches
  bool ahead = false;   ///< the normal is the one with which they would touch: see Margin
  int count = 0;
  Touch touches[4];

  void add(const Vec3& point, Real depth, std::uint32_t feature) {
    if (count < 4) touches[count++] = {point, std::max(Real(0) - margin, depth), feature};
  }
};

/// Shapes of this size (m) that touch exactly may seem this far apart (m) after rounding. They still count as touching. Otherwise
/// a box that was put exactly onto another would touch it at one, two or three corners.
inline Real rounding_of(Real size) {
  return 8 * std::numeric_limits<Real>::epsilon() * size;
}

/// Whether two shapes pass each other at a face. They do if they overlap along its normal by no more than `clearly` (m), and the
/// contact normal is more than 60 degrees from it. Then they meet in a sliver at most, which can carry no load. A box therefore
/// slides over flush tiles.
inline bool passes_at_face(const Vec3& face, Real overlap, const Vec3& normal, Real clearly) {
  return overlap <= clearly && std::abs(face.dot(normal)) < Real(0.5);
}

// Features of round shapes.
inline constexpr std::uint32_t somewhere = 0;      ///< the one point of a sphere, or between the ends of a capsule
inline constexpr std::uint32_t lower_end = 1;      ///< the end towards -y of the (first) capsule's stretch in reach
inline constexpr std::uint32_t upper_end = 2;      ///< the end towards +y
inline constexpr std::uint32_t passing = 0x60000;  ///< of two shapes that pass each other
/// A shape that slopes by less than this (the sine of about 1 degree) against its support lies flat. A capsule then touches at
/// two points, a box at up to four.
inline constexpr Real parallel = Real(0.02);

// Each adds the points it finds to the manifold, whose normal points from the first argument to the second.
void touch(const Round& a, const Round& b, Manifold& found);
void touch(const Placed<Box>& a, const Round& b, Manifold& found);
void touch(const Placed<Box>& a, const Placed<Box>& b, Manifold& found);
void touch(const Placed<HalfSpace>& a, const Round& b, Manifold& found);
void touch(const Placed<HalfSpace>& a, const Placed<Box>& b, Manifold& found);
void touch(const Placed<HalfSpace>& a, const Placed<Hull>& b, Manifold& found);
void touch(const Placed<Hull>& a, const Round& b, Manifold& found);
void touch(const Placed<Hull>& a, const Placed<Box>& b, Manifold& found);
void touch(const Placed<Hull>& a, const Placed<Hull>& b, Manifold& found);

}  // namespace pushback
