/// The five shapes, each in the frame of its body, whose origin is the centre of mass.
#pragma once

#include <memory>
#include <variant>
#include <vector>

#include "pushback/common/basics/types.h"

namespace pushback {

struct Sphere {
  Real radius;  ///< m
};

/// All points within half_extents of the origin along the body's axes.
struct Box {
  Vec3 half_extents;  ///< m
};

/// All points within `radius` of the segment from (0, -half_length, 0) to (0, half_length, 0).
struct Capsule {
  Real radius;       ///< m
  Real half_length;  ///< m, of the segment
};

/// All points p with normal . p <= 0: solid below, free above. Always immovable.
struct HalfSpace {
  Vec3 normal;  ///< unit, pointing out of the solid
};

/// Corners, edges and faces of a convex solid that contains the origin. Their numbers make up the feature ids of its contacts.
struct Polyhedron {
  struct Face {
    Vec3 normal;               ///< unit, outward
    Real offset = 0;           ///< m; normal . p = offset for every p of the face
    Real half_width = 0;       ///< m, half the least width of the face within its plane
    std::vector<int> corners;  ///< anticlockwise as seen from outside
    std::vector<int> edges;    ///< edges[k] joins corners[k] to the next
  };
  struct Edge {
    int from, to;     ///< corners, from < to
    int left, right;  ///< faces; as seen from outside, `left` lies on the left of the direction from `from` to `to`
  };
  std::vector<Vec3> corners;  ///< m; at most most_corners
  std::vector<Edge> edges;    ///< ascending by (from, to)
  std::vector<Face> faces;
  Real half_width = 0;  ///< m, half the least distance between a face and the corner farthest from it
  Real volume = 0;      ///< m^3
  Real rounding = 0;    ///< m; a gap up to this may come from the rounding of the given corners
};
inline constexpr int most_corners = 32;

/// A convex polyhedron, made by hull() in body.h. Copies share the solid.
struct Hull {
  std::shared_ptr<const Polyhedron> solid;  ///< never null in a world
};

using Shape = std::variant<Sphere, Box, Capsule, HalfSpace, Hull>;

}  // namespace pushback
