/// Two steps of making a hull: find the faces (hull_faces.cpp), and build a polyhedron from them (polyhedron.cpp).
#pragma once

#include <vector>

#include "pushback/common/bodies/shape.h"

namespace pushback {

/// For each face of the convex hull, the numbers of the points at its corners, anticlockwise as seen from outside. The faces
/// close, so each edge belongs to two of them. Throws InvalidInput if the points (m) enclose no volume or no closed faces are found.
/// Expects 3 to most_corners points, all finite.
std::vector<std::vector<int>> faces_around(const std::vector<Vec3>& points);

/// Computes everything but `volume` and `rounding` from faces as above. Points that are in no face are left out.
Polyhedron polyhedron(const std::vector<Vec3>& points, const std::vector<std::vector<int>>& faces);

}  // namespace pushback
