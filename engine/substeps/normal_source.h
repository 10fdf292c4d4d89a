/// What a contact goes along with, while bodies move and are not detected again.
#pragma once

#include <algorithm>
#include <limits>
#include <variant>

#include "pushback/common/collision/contact.h"
#include "pushback/common/world/world.h"

namespace pushback {

/// A face turns its normal with it, and a point of the other body stays on it. Two round bodies touch between their cores. Edges that
/// cross do neither: their rows are carried, as in chapter 21.
enum class NormalSource { none, face_a, face_b, cores };

/// m, from the core of a body, a point or a line, to its surface; 0 for a polyhedron.
inline Real radius_of(const Body& body) {
  if (const auto* ball = std::get_if<Sphere>(&body.shape)) return ball->radius;
  if (const auto* capsule = std::get_if<Capsule>(&body.shape)) return capsule->radius;
  return 0;
}
/// Whether `n`, world axes, is the normal of a face of the body, but for rounding.
inline bool has_face(const Body& body, const Vec3& n) {
  if (std::holds_alternative<HalfSpace>(body.shape)) return true;  // which has no other
  const Vec3 on_body = body.orientation.conjugate() * n;
  constexpr Real same = 1 - 64 * std::numeric_limits<Real>::epsilon();
  if (std::holds_alternative<Box>(body.shape)) return on_body.cwiseAbs().maxCoeff() > same;
  const auto* hull = std::get_if<Hull>(&body.shape);
  return hull != nullptr &&
         std::any_of(hull->solid->faces.begin(), hull->solid->faces.end(),
                     [&on_body](const Polyhedron::Face& face) { return face.normal.dot(on_body) > same; });
}
/// Of two faces that lie on each other, the one that nothing moves, or else the one with the longer arms, has the normal: corners
/// of the smaller one lie on the larger. `reach`: the longest arm, m.
inline NormalSource normal_source_of(const Body& a, const Body& b, const Vec3& n, Real reach_a, Real reach_b) {
  if (radius_of(a) > 0 && radius_of(b) > 0) return NormalSource::cores;
  const bool face_of_a = has_face(a, n), face_of_b = has_face(b, -n);
  const bool rather_a = !a.movable() || (b.movable() && reach_a >= reach_b);
  if (face_of_a && (rather_a || !face_of_b)) return NormalSource::face_a;
  return face_of_b ? NormalSource::face_b : NormalSource::none;
}

}  // namespace pushback
