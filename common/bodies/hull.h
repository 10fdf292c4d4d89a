/// Convex polyhedra: from points to corners, edges and faces, and from those to mass. body.h has the body of one.
#pragma once

#include <memory>
#include <vector>

#include "pushback/common/bodies/shape.h"

namespace pushback {

/// A uniform convex solid and where it is.
struct PlacedSolid {
  std::shared_ptr<const Polyhedron> solid;  ///< about its centre of mass, along its principal axes
  Vec3 centre;                              ///< m, of mass, in the frame of the points it was made from
  Mat3 axes;                                ///< columns: its principal axes, right-handed, likewise
  Vec3 inertia_per_kilogram;                ///< m^2, about the principal axes
};

/// The convex hull of the points (m). Points inside it are left out; corners keep the order of the points. What is
/// flat, straight or in one place to about 1e-7 of the solid's size (2e-6 in single precision) counts as such, and to 30
/// times as much where that is ambiguous: four points of a plane make one face, not two.
///
/// The axes are those of the points wherever these are principal axes already, and otherwise called x, y and z such
/// that they are turned as little as possible.
///
/// Throws InvalidInput unless there are 4 to most_corners points, all finite, that enclose a volume.
PlacedSolid solid_of(const std::vector<Vec3>& points);

/// A box as a polyhedron. Bit i of a corner's number is set on the positive side of axis i.
Polyhedron polyhedron_of(const Box& box);

}  // namespace pushback
