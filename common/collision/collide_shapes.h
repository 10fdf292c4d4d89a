/// What the functions of the narrow phase share: where a shape is, and what they find. Only collide*.cpp need it.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include "pushback/common/basics/types.h"
#include "pushback/common/bodies/shape.h"

namespace pushback {

/// A shape and where it is. Positions are relative to the first body of the pair: far from the world's origin, two
/// positions that differ by little would otherwise leave few digits for the depth.
template <class S>
struct Placed {
  const S& shape;
  Vec3 centre;
  Mat3 axes;  ///< columns: the body's axes
};

/// A sphere or a capsule is everything within `radius` of its core, the segment from centre - half to centre + half.
/// The core of a sphere is a point: half = 0. One function then serves both.
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

/// Where two shapes touch: up to four points that share a normal, from the first shape to the second.
struct Manifold {
  Real margin = 0;  ///< m: so far apart still counts
  Vec3 normal = Vec3::UnitY();
  Real overlap =
      -std::numeric_limits<Real>::max();  ///< m, along the normal; known within the margin, though no point touches
  bool passes = false;                    ///< they meet in a sliver alone, and no point touches
  bool ahead = false;                     ///< of where they would touch: see Margin
  int count = 0;
  Touch touches[4];

  void add(const Vec3& point, Real depth, std::uint32_t feature) {
    if (count < 4) touches[count++] = {point, std::max(Real(0) - margin, depth), feature};
  }
};

/// Shapes of this size that touch exactly may seem this far apart after rounding. They still count as touching, or a
/// box that was put exactly onto another would touch it at one, two or three corners.
inline Real rounding_of(Real size) {
  return 8 * std::numeric_limits<Real>::epsilon() * size;
}

/// Two shapes that overlap along a face's normal by no more than `clearly`, m, pass each other at that face: whatever direction
/// across it they come from, they meet in a sliver at most, which holds nothing. So a box slides over tiles that lie flush.
inline bool passes_at_face(const Vec3& face, Real overlap, const Vec3& normal, Real clearly) {
  return overlap <= clearly && std::abs(face.dot(normal)) < Real(0.5);
}

// Features of round shapes.
inline constexpr std::uint32_t somewhere = 0;      ///< the one point of a sphere, or between the ends of a capsule
inline constexpr std::uint32_t lower_end = 1;      ///< the end towards -y of the (first) capsule, of what lies in reach
inline constexpr std::uint32_t upper_end = 2;      ///< the end towards +y
inline constexpr std::uint32_t passing = 0x60000;  ///< of two that pass each other
/// What slopes by less than this (the sine of about 1 degree) towards what it lies on lies flat: a capsule touches at
/// two points, a box at up to four.
inline constexpr Real parallel = Real(0.02);

// Each adds what it finds to the manifold, whose normal points from the first argument to the second.
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
