/// How far apart two bodies are.
#pragma once

#include "pushback/common/bodies/body.h"

namespace pushback {

/// Between the surfaces of two bodies, with their skins.
struct Gap {
  Real distance;  ///< m; 0 or less where they touch or overlap
  Vec3 normal;    ///< unit, world axes, from A to B: along it they are this far apart
};

/// Of two bodies one of which is no half-space, and one of which moves. Where cores overlap, it is what collision detection says.
///
/// The vector from A to B that is shortest is the point nearest to the origin of B - A, the set of all differences of their points.
/// It is found from corners of that set, each the farthest one against the nearest point so far.
///   Gilbert, Johnson, Keerthi, IEEE J. Robotics and Automation 4(2), 1988.
Gap gap_between(const Body& a, const Body& b);

/// m: a body is everything within this of its core, which is a point, a segment or a polyhedron.
Real roundness(const Body& body);
/// The points, in body axes, that a shape is the hull of, but for what is round: one for a sphere, two for a capsule. A half-space has
/// one on its plane.
std::vector<Vec3> corners_of_core(const Body& body);
/// m: of the farthest of them from the body's position. What turns by an angle moves them by no more than the angle times this.
Real reach_of_core(const Body& body);

}  // namespace pushback
