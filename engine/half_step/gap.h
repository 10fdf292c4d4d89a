/// The distance between two bodies.
#pragma once

#include "pushback/common/bodies/body.h"

namespace pushback {

/// The gap between the surfaces of two bodies, including their skins.
struct Gap {
  Real distance;  ///< m; 0 or less if they touch or overlap
  Vec3 normal;    ///< unit, world axes, from A to B, the direction of the distance
};

/// The gap between A and B. At most one of them may be a half-space, and at least one must be movable. If the cores overlap,
/// collision detection determines the result.
///
/// The shortest vector from A to B is the point nearest to the origin of B - A, the set of all differences of their points.
/// It is found from corners of that set, each the farthest one against the nearest point so far.
///   Gilbert, Johnson, Keerthi, IEEE J. Robotics and Automation 4(2), 1988.
Gap gap_between(const Body& a, const Body& b);

/// The radius of a body about its core, m. The core is a point, a segment or a polyhedron.
Real roundness(const Body& body);
/// The corners of a shape's core, body axes, m. A sphere has one and a capsule two. A half-space has one point on its plane.
std::vector<Vec3> corners_of_core(const Body& body);
/// The largest distance of these corners from the body's position, m. A rotation moves them by at most its angle times this.
Real reach_of_core(const Body& body);

}  // namespace pushback
