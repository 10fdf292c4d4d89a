/// Queries that change nothing in the world. They find bodies that a ray hits, and bodies that another body would touch.
///
/// Each query tests all bodies one after the other: first their groups, then their bounds, and only then their shapes.
#pragma once

#include <optional>
#include <vector>

#include "pushback/common/collision/ray.h"
#include "pushback/common/world/world.h"

namespace pushback {

/// The first body that the ray hits, and at equal distances the one with the lower index. Throws as check(ray).
std::optional<RayHit> nearest_hit(const World& world, const Ray& ray);
/// Every body that the ray hits, once each, by distance, then by index. Bodies do not stop the ray. Throws as check(ray).
std::vector<RayHit> all_hits(const World& world, const Ray& ray);

/// A body of the world that the ghost touches, and the contacts.
struct Overlap {
  int body = -1;  ///< Body::index
  /// At most four. A is the body of the world and B the ghost, with World::bodies.size() as id.body_b.
  Contacts contacts;
};
/// The bodies, in ascending order, that `ghost` would touch in its present pose, although it is not in the world. These are the
/// bodies that World::find_contacts would find, and immovable bodies even if the ghost is immovable. A ghost with a skin also
/// touches bodies within its skin. Mass and velocity do not matter. Two half-spaces never touch. Throws InvalidInput as World::add
/// does.
std::vector<Overlap> overlaps(const World& world, const Body& ghost);

}  // namespace pushback
