/// The distance between two bodies.
#pragma once

#include "pushback/common/bodies/body.h"

namespace pushback {

/// Between the surfaces of two bodies, with their skins.
struct Gap {
  Real distance;  ///< m; 0 or less if they touch or overlap
  Vec3 normal;    ///< unit, world axes, from A to B: the distance is along it
};

/// For two bodies, one of which is no half-space and one of which moves. For overlapping cores it is as in collision detection.
///
/// The shortest vector from A to B is the point nearest to the origin of B - A, the set of all differences of their points.
/// It is found from corners of that set, each the farthest one against the nearest point so far.
///   Gilbert, Johnson, Keerthi, IEEE J. Robotics and Automation 4(2), 1988.
Gap gap_between(const Body& a, const Body& b);

/// m: a body is everything within this of its core, which is a point, a segment or a polyhedron.
Real roundness(const Body& body);
/// The points, in body axes, of whose hull a shape is a rounded version: one for a sphere, two for a capsule. A half-space has
/// one on its plane.
std::vector<Vec3> corners_of_core(const Body& body);
/// m: the largest distance of these points from the body's position. A rotation moves them by at most its angle times this.
Real reach_of_core(const Body& body);

}  // namespace pushback
