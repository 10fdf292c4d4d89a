/// The two halves of making a hull: which points make a face (hull_faces.cpp), and what the faces enclose (hull.cpp).
#pragma once

#include <vector>

#include "pushback/common/bodies/shape.h"

namespace pushback {

/// For each face of the convex hull, the numbers of the points at its corners, anticlockwise as seen from outside.
/// Wherever one face ends another begins. Throws InvalidInput where the points enclose no volume. Expects 3 to most_corners points, all finite.
std::vector<std::vector<int>> faces_around(const std::vector<Vec3>& points);

/// Works out everything but `volume` and `rounding`, for faces as above. Points that are in no face are left out.
Polyhedron polyhedron(const std::vector<Vec3>& points, const std::vector<std::vector<int>>& faces);

}  // namespace pushback
