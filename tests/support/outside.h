/// The distance of a point from each shape, written down once more for the tests.
#pragma once

#include <algorithm>
#include <limits>

#include "pushback/common/bodies/body.h"

namespace pushback {

/// How far outside of the body a point lies; below 0 inside. Near a face, m from its plane; near what is round, m from the surface.
inline Real outside(const Body& body, const Vec3& point) {
  const Vec3 p = body.orientation.conjugate() * (point - body.position);
  if (const auto* s = std::get_if<Sphere>(&body.shape)) return p.norm() - s->radius;
  if (const auto* b = std::get_if<Box>(&body.shape)) return (p.cwiseAbs() - b->half_extents).maxCoeff();
  if (const auto* s = std::get_if<HalfSpace>(&body.shape)) return s->normal.dot(p);
  if (const auto* c = std::get_if<Capsule>(&body.shape)) {
    const Real y = std::clamp(p.y(), -c->half_length, c->half_length);
    return (p - Vec3(0, y, 0)).norm() - c->radius;
  }
  Real most = -std::numeric_limits<Real>::infinity();
  for (const auto& face : std::get<Hull>(body.shape).solid->faces)
    most = std::max(most, face.normal.dot(p) - face.offset);
  return most;
}

}  // namespace pushback
