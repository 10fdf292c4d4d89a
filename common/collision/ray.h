/// Finds where a ray enters a body.
#pragma once

#include <cstdint>
#include <limits>
#include <optional>

#include "pushback/common/bodies/body.h"

namespace pushback {

/// A straight line that starts at a point, in world axes.
struct Ray {
  Vec3 origin = Vec3::Zero();                           ///< m
  Vec3 direction = Vec3::UnitY();                       ///< of any length above 0
  Real length = std::numeric_limits<Real>::infinity();  ///< m
  std::uint32_t touches = every_group;                  ///< bits: the groups whose bodies it hits
};

struct RayHit {
  int body = -1;               ///< Body::index
  Real distance = 0;           ///< m, from the ray's origin
  Vec3 point = Vec3::Zero();   ///< m, world axes: on the surface
  Vec3 normal = Vec3::Zero();  ///< unit, world axes, out of the body
  /// Whether the ray begins inside the body. It then hits at its origin, at distance 0, and the normal is minus its direction.
  bool inside = false;
};

/// Throws InvalidInput unless origin and direction are finite, the direction is longer than 0, and the length is a number, 0 or
/// more, or infinite.
void check(const Ray& ray);

/// The place where the ray enters the body, regardless of groups and skin, or nullopt if it does not enter within its length.
/// A ray that begins on a surface and leads out of the body does not hit it. Throws as check(ray).
///
/// The solution has a closed form, because a solid is an intersection of half-spaces, a ball, or for a capsule a cylinder between
/// two balls, and the ray is inside each from one distance to another.
/// Kay and Kajiya, "Ray Tracing Complex Scenes", SIGGRAPH 1986 (slabs); Haines, "Fast Ray-Convex Polyhedron Intersection",
/// Graphics Gems II, 1991.
std::optional<RayHit> first_hit(const Ray& ray, const Body& body);

}  // namespace pushback
