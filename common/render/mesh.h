/// The triangles that every shape is an instance of.
#pragma once

#include <cstdint>
#include <vector>

#include "pushback/common/bodies/shape.h"

namespace pushback {

/// A vertex of an instance lies at  corner * half_extents + normal * radius  in the frame of its body, where the product
/// is taken axis by axis: one format for a box with bevels, a sphere (no half-extents), a capsule (one of them), a shaft.
struct Vertex {
  Eigen::Vector3f corner, normal;
};

struct Mesh {
  std::vector<Vertex> vertices;
  std::vector<std::uint16_t> indices;  ///< three a triangle, anticlockwise as seen from outside
};

/// A box with rounded edges; `steps` is how many facets make an eighth of a turn. 0 gives a sharp box that cuts through
/// the middle of the bevels: it casts the shadow of a rounded one, and none on it.
Mesh rounded_box(int steps);
/// Around y, from -1 to 1, open at the top.
Mesh shaft(int sides);
/// Around y, its base at -1, its tip at 1; shaded as one whose height is `slimness` times the radius of its base.
Mesh cone(int sides, float slimness);

/// A polyhedron with a bevel of this radius (m) at its edges, for instances that have this radius, and for half-extents
/// those of half_extents_of.
Mesh bevelled(const Polyhedron& solid, float radius);
/// How far the polyhedron reaches along each of its axes, either way, m.
Eigen::Vector3f half_extents_of(const Polyhedron& solid);
/// The same for shadows: cut back to about the middle of the bevels, it casts the shadow of the other, and none on it.
Mesh cut_back(Mesh mesh);

}  // namespace pushback
