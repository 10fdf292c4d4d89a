#include "pushback/common/collision/ray.h"

#include <algorithm>
#include <cmath>

#include "pushback/common/basics/input.h"

namespace pushback {

namespace {

constexpr Real infinite = std::numeric_limits<Real>::infinity();

/// The stretch of its line, m, in which a ray is inside a convex solid; empty unless enter <= leave.
struct Within {
  Real enter = -infinite, leave = infinite;
  Vec3 normal = Vec3::Zero();  // of the surface at `enter`

  bool empty() const { return !(enter <= leave); }
  static Within nowhere() { return {infinite, -infinite, Vec3::Zero()}; }

  /// Intersects the stretch with the half-space normal . p <= offset.
  void cut(const Vec3& from, const Vec3& along, const Vec3& its_normal, Real offset) {
    const Real above = its_normal.dot(from) - offset, climb = its_normal.dot(along);
    if (climb < 0 && above / -climb > enter) {
      enter = above / -climb;
      normal = its_normal;
    } else if (climb > 0) {
      leave = std::min(leave, -above / climb);
    } else if (climb == 0 && above > 0) {
      *this = nowhere();
    }
  }
};

/// |p - centre| = r.   `along` is of unit length, so the nearest point of the line is at -b:
///
///   b = (from - centre) . along,   distance = -b -+ sqrt(r^2 - |from - centre - b along|^2)
Within inside_ball(const Vec3& from, const Vec3& along, const Vec3& centre, Real radius) {
  const Vec3 to_origin = from - centre;
  const Real b = to_origin.dot(along), under_root = radius * radius - (to_origin - b * along).squaredNorm();
  if (under_root < 0) return Within::nowhere();
  const Real half = std::sqrt(under_root), enter = -b - half;
  return {enter, -b + half, (to_origin + enter * along).normalized()};
}

/// The same in the plane perpendicular to the y axis, for the cylinder about it between y = -half_length and half_length. Its two
/// ends are inside the balls of the capsule, so a ray never enters the capsule there.
Within inside_cylinder(const Vec3& from, const Vec3& along, const Capsule& c) {
  Within span;
  span.cut(from, along, Vec3::UnitY(), c.half_length);
  span.cut(from, along, -Vec3::UnitY(), c.half_length);
  const Real a = along.x() * along.x() + along.z() * along.z();
  const Real b = from.x() * along.x() + from.z() * along.z();
  const Real across = from.x() * along.z() - from.z() * along.x();
  if (a == 0) return from.x() * from.x() + from.z() * from.z() <= c.radius * c.radius ? span : Within::nowhere();
  const Real under_root = c.radius * c.radius * a - across * across;
  if (under_root < 0) return Within::nowhere();
  const Real half = std::sqrt(under_root), enter = (-b - half) / a;
  if (enter > span.enter) {
    const Vec3 point = from + enter * along;
    span.enter = enter;
    span.normal = Vec3(point.x(), 0, point.z()).normalized();
  }
  span.leave = std::min(span.leave, (-b + half) / a);
  return span;
}

/// The stretch of a line inside a shape, in body axes, relative to the centre of mass.
struct Inside {
  const Vec3& from;
  const Vec3& along;  // unit

  Within operator()(const Sphere& s) const { return inside_ball(from, along, Vec3::Zero(), s.radius); }
  Within operator()(const Box& b) const {
    Within span;
    for (int i = 0; i < 3; ++i) {
      span.cut(from, along, Vec3::Unit(i), b.half_extents[i]);
      span.cut(from, along, -Vec3::Unit(i), b.half_extents[i]);
    }
    return span;
  }
  /// A capsule is convex, so the ray is inside from the first entry into one of the three parts to the last exit.
  Within operator()(const Capsule& c) const {
    Within all = Within::nowhere();
    for (const Within& part :
         {inside_cylinder(from, along, c), inside_ball(from, along, {0, c.half_length, 0}, c.radius),
          inside_ball(from, along, {0, -c.half_length, 0}, c.radius)}) {
      if (part.empty()) continue;
      if (part.enter < all.enter) all.enter = part.enter, all.normal = part.normal;
      all.leave = std::max(all.leave, part.leave);
    }
    return all;
  }
  Within operator()(const HalfSpace& h) const {
    Within span;
    span.cut(from, along, h.normal, 0);
    return span;
  }
  Within operator()(const Hull& h) const {
    Within span;
    for (const Polyhedron::Face& face : h.solid->faces) span.cut(from, along, face.normal, face.offset);
    return span;
  }
};

}  // namespace

void check(const Ray& ray) {
  require_finite("origin of a ray", ray.origin);
  require_finite("direction of a ray", ray.direction);
  require_positive("length of the direction of a ray", ray.direction.norm());
  if (!(ray.length >= 0)) {
    throw InvalidInput(fmt::format("length of a ray is {}: a number, 0 or more, or infinity, is needed", ray.length));
  }
}

std::optional<RayHit> first_hit(const Ray& ray, const Body& body) {
  check(ray);
  const Vec3 direction = ray.direction.normalized();
  const Vec3 from = body.orientation.conjugate() * (ray.origin - body.position);
  const Vec3 along = body.orientation.conjugate() * direction;
  const Within span = std::visit(Inside{from, along}, body.shape);
  if (span.empty() || !(span.leave > 0) || span.enter > ray.length) return std::nullopt;
  if (span.enter < 0) return RayHit{body.index, 0, ray.origin, -direction, true};
  return RayHit{body.index, span.enter, ray.origin + span.enter * direction, body.orientation * span.normal, false};
}

}  // namespace pushback
