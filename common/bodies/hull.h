/// Finds the corners, edges and faces of the convex hull of points, and its mass properties. hull() in body.h makes a body of it.
#pragma once

#include <memory>
#include <vector>

#include "pushback/common/bodies/shape.h"

namespace pushback {

/// A uniform convex solid and its pose.
struct PlacedSolid {
  std::shared_ptr<const Polyhedron> solid;  ///< about its centre of mass, along its principal axes
  Vec3 centre;                              ///< m, centre of mass in the frame of the given points
  Mat3 axes;                                ///< columns: its principal axes in the same frame, right-handed
  Vec3 inertia_per_kilogram;                ///< m^2, about the principal axes
};

/// The convex hull of the points (m). Points inside it are left out, and corners keep the order of the points. Points that are
/// coplanar, collinear or coincident to about 1e-7 of the solid's size (2e-6 in single precision) count as such, so that four
/// points in one plane make one face, not two. If the faces do not close with this tolerance, it grows up to 30 times.
///
/// The solid keeps the axes of the points if these are principal axes already. Otherwise its principal axes are named x, y and z
/// so that they are turned as little as possible.
///
/// Throws InvalidInput unless there are 4 to most_corners points, all finite, that enclose a volume with faces that close.
PlacedSolid solid_of(const std::vector<Vec3>& points);

/// A box as a polyhedron. Bit i of a corner's number is set on the positive side of axis i.
Polyhedron polyhedron_of(const Box& box);

}  // namespace pushback
