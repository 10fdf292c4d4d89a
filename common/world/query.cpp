#include "pushback/common/world/query.h"

#include <algorithm>
#include <limits>

#include "pushback/common/collision/broad_phase.h"
#include "pushback/common/collision/collide.h"

namespace pushback {

namespace {

/// The bodies that a ray may hit, by their groups and bounds. The shapes of all others need no test.
class Candidates {
 public:
  explicit Candidates(const Ray& ray) : ray_(ray), direction_(ray.direction.normalized()) {}

  bool include(const Body& body, Real length) const {
    return (body.groups & ray_.touches) != 0 && passes_through(bounds_of(body), length);
  }

 private:
  bool passes_through(const Bounds& bounds, Real length) const {
    Real enter = 0, leave = length;
    for (int i = 0; i < 3; ++i) {
      const Real low = bounds.low[i] - ray_.origin[i], high = bounds.high[i] - ray_.origin[i];
      if (direction_[i] == 0) {
        if (low > 0 || high < 0) return false;
        continue;
      }
      const auto [first, second] = std::minmax({low / direction_[i], high / direction_[i]});
      enter = std::max(enter, first);
      leave = std::min(leave, second);
    }
    constexpr Real rounding = 16 * std::numeric_limits<Real>::epsilon();  // of the quotients; bounds have their own
    return enter <= leave + rounding * enter;
  }

  const Ray& ray_;
  Vec3 direction_;  // unit
};

}  // namespace

std::optional<RayHit> nearest_hit(const World& world, const Ray& ray) {
  check(ray);
  const Candidates candidates(ray);
  std::optional<RayHit> nearest;
  Ray rest = ray;
  for (const Body& body : world.bodies) {
    if (!candidates.include(body, rest.length)) continue;
    const std::optional<RayHit> hit = first_hit(rest, body);
    if (!hit || (nearest && hit->distance >= nearest->distance)) continue;
    nearest = hit;
    rest.length = hit->distance;
  }
  return nearest;
}

std::vector<RayHit> all_hits(const World& world, const Ray& ray) {
  check(ray);
  const Candidates candidates(ray);
  std::vector<RayHit> hits;
  for (const Body& body : world.bodies) {
    if (!candidates.include(body, ray.length)) continue;
    if (const std::optional<RayHit> hit = first_hit(ray, body)) hits.push_back(*hit);
  }
  std::stable_sort(hits.begin(), hits.end(), [](const RayHit& p, const RayHit& q) { return p.distance < q.distance; });
  return hits;
}

std::vector<Overlap> overlaps(const World& world, const Body& ghost) {
  Body asked = ghost;
  check(asked);
  asked.index = static_cast<int>(world.bodies.size());
  asked.inverse_mass = 1;  // because collide() finds no contacts of two immovable bodies
  const Bounds bounds = bounds_of(asked);
  std::vector<Overlap> found;
  Contacts contacts;
  for (const Body& body : world.bodies) {
    if (!may_touch(body, asked) || !bounds_of(body).overlaps(bounds)) continue;
    contacts.clear();
    collide(body, asked, contacts);
    if (!contacts.empty()) found.push_back({body.index, contacts});
  }
  return found;
}

}  // namespace pushback
