/// The triangle meshes of which all drawn shapes are instances.
#pragma once

#include <cstdint>
#include <vector>

#include "pushback/common/bodies/shape.h"

namespace pushback {

/// A vertex of an instance is at  corner * half_extents + normal * radius  in body axes, where the first product is taken axis by axis.
/// This one format describes a box with bevels, a sphere (no half-extents), a capsule (one half-extent) and a shaft.
struct Vertex {
  Eigen::Vector3f corner, normal;
};

struct Mesh {
  std::vector<Vertex> vertices;
  std::vector<std::uint16_t> indices;  ///< three per triangle, anticlockwise as seen from outside
};

/// A box with rounded edges. `steps`: facets per eighth of a turn. 0 gives a sharp box that cuts through the middle of the bevels. It
/// casts the shadow of a rounded box, but does not shade that box.
Mesh rounded_box(int steps);
/// A cylinder around y, from -1 to 1, open at the top.
Mesh shaft(int sides);
/// A cone around y, its base at -1, its tip at 1, shaded like a cone whose height is `slimness` times the radius of its base.
Mesh cone(int sides, float slimness);

/// A polyhedron with a bevel of this radius (m) at its edges, for instances with this radius and the half-extents from
/// half_extents_of.
Mesh bevelled(const Polyhedron& solid, float radius);
/// The largest distance of a corner from the origin along each body axis, in either direction, m.
Eigen::Vector3f half_extents_of(const Polyhedron& solid);
/// The bevelled mesh for shadows, cut back to about the middle of the bevels. It casts the shadow of `mesh`, but does not shade it.
Mesh cut_back(Mesh mesh);

}  // namespace pushback
