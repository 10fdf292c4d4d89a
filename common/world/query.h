/// Questions to a world in which nothing moves: what does a ray hit, and what would a body touch?
///
/// Each asks all bodies one after the other: first for their groups, then for their bounds, and only then for their shapes.
#pragma once

#include <optional>
#include <vector>

#include "pushback/common/collision/ray.h"
#include "pushback/common/world/world.h"

namespace pushback {

/// The first body on the ray's way; of two at the same distance, the one with the lower index. Throws as check(ray).
std::optional<RayHit> nearest_hit(const World& world, const Ray& ray);
/// Every body that the ray enters, once, by distance, then by index: the bodies do not stop it. Throws as check(ray).
std::vector<RayHit> all_hits(const World& world, const Ray& ray);

/// A body of the world that another one touches, and where.
struct Overlap {
  int body = -1;  ///< Body::index
  /// At most four. A is the body of the world, B the other one: id.body_b is World::bodies.size().
  Contacts contacts;
};
/// The bodies that `ghost`, which is not in the world, would touch where it is, in ascending order: what World::find_contacts would
/// find, and immovable bodies whether the ghost is movable or not. A ghost with a skin finds what is that near. Mass and
/// velocity do not matter. Two half-spaces never touch. Throws InvalidInput as World::add does.
std::vector<Overlap> overlaps(const World& world, const Body& ghost);

}  // namespace pushback
