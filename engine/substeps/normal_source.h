/// The body with which the normal of a contact rotates while bodies move and contacts are not detected again.
#pragma once

#include <algorithm>
#include <limits>
#include <variant>

#include "pushback/common/collision/contact.h"
#include "pushback/common/world/world.h"

namespace pushback {

///   face_a, face_b   the normal belongs to a face and rotates with its body, and the contact is a point of the other body
///   cores            the normal points from the core of one round body to the core of the other
///   none             two edges cross, and the normal stays as detected, as in chapter 21
enum class NormalSource { none, face_a, face_b, cores };

/// The radius of a sphere or capsule, whose core is a point or a segment, or 0 for a polyhedron, m.
inline Real radius_of(const Body& body) {
  if (const auto* ball = std::get_if<Sphere>(&body.shape)) return ball->radius;
  if (const auto* capsule = std::get_if<Capsule>(&body.shape)) return capsule->radius;
  return 0;
}
/// Whether `n`, world axes, is the normal of a face of the body, to rounding.
inline bool has_face(const Body& body, const Vec3& n) {
  if (std::holds_alternative<HalfSpace>(body.shape)) return true;  // a half-space has no other normal
  const Vec3 on_body = body.orientation.conjugate() * n;
  constexpr Real same = 1 - 64 * std::numeric_limits<Real>::epsilon();
  if (std::holds_alternative<Box>(body.shape)) return on_body.cwiseAbs().maxCoeff() > same;
  const auto* hull = std::get_if<Hull>(&body.shape);
  return hull != nullptr &&
         std::any_of(hull->solid->faces.begin(), hull->solid->faces.end(),
                     [&on_body](const Polyhedron::Face& face) { return face.normal.dot(on_body) > same; });
}
/// If two faces touch, the normal belongs to the face of the immovable body, or otherwise to the larger face, on which corners of the
/// smaller one lie. `reach_a`, `reach_b`: the longest arms, m.
inline NormalSource normal_source_of(const Body& a, const Body& b, const Vec3& n, Real reach_a, Real reach_b) {
  if (radius_of(a) > 0 && radius_of(b) > 0) return NormalSource::cores;
  const bool face_of_a = has_face(a, n), face_of_b = has_face(b, -n);
  const bool rather_a = !a.movable() || (b.movable() && reach_a >= reach_b);
  if (face_of_a && (rather_a || !face_of_b)) return NormalSource::face_a;
  return face_of_b ? NormalSource::face_b : NormalSource::none;
}

}  // namespace pushback
