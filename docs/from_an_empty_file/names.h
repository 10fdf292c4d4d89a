/// Which points two boxes touch at, and what each is called, so that the next step knows it again.
#pragma once

#include "touch.h"

namespace empty_file {

/// A corner of a polygon, with the edge that leads from it to the next corner. An edge of the face that is clipped has one
/// of the names 0 to 3, one along a side that it was clipped at, 4 to 7.
struct Corner {
  Vec3 at;
  int name;  // 0 to 3: a corner of the face; 4 + 4 e + s: where its edge e meets the side s
  int edge;
};
using Polygon = std::vector<Corner>;

/// The face of a box that looks along n the most, its corners one after the other.
inline Polygon face_of(const Body& box, const Vec3& n) {
  const Mat3 axes = axes_of(box);
  const int axis = face_along(box, n), i = (axis + 1) % 3, j = (axis + 2) % 3;
  const double out = axes.col(axis).dot(n) > 0 ? 1 : -1;
  const Vec3 middle = box.position + out * box.half[axis] * axes.col(axis);
  const Vec3 across = box.half[i] * axes.col(i), over = box.half[j] * axes.col(j);
  return {{middle - across - over, 0, 0},
          {middle + across - over, 1, 1},
          {middle + across + over, 2, 2},
          {middle - across + over, 3, 3}};
}

/// What is left of the polygon where p . n <= offset.   I. Sutherland, G. Hodgman, Reentrant Polygon Clipping, 1974
inline Polygon clip(const Polygon& polygon, const Vec3& n, double offset, int side) {
  Polygon kept;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Corner &from = polygon[i], &to = polygon[(i + 1) % polygon.size()];
    const double before = from.at.dot(n) - offset, after = to.at.dot(n) - offset;
    if (before <= 0) kept.push_back(from);
    if ((before <= 0) == (after <= 0)) continue;
    const Vec3 cut = from.at + before / (before - after) * (to.at - from.at);
    kept.push_back({cut, 4 + 4 * from.edge + side, before <= 0 ? 4 + side : from.edge});
  }
  return kept;
}

/// The face with the least overlap is the reference. The other box's face against it is clipped at the four sides of the
/// reference; each corner that is then below the reference is a contact point.
inline Touches touch_of_faces(const Body& a, const Body& b, const Axis& axis) {
  const bool of_a = axis.axis_a >= 0;
  const Body &reference = of_a ? a : b, &incident = of_a ? b : a;
  const Vec3 out = of_a ? axis.normal : -axis.normal;  // of the reference
  const int face = of_a ? axis.axis_a : axis.axis_b;
  const Mat3 axes = axes_of(reference);
  Polygon polygon = face_of(incident, -out);
  for (int side = 0; side < 4; ++side) {
    const int across = (face + 1 + side / 2) % 3;
    const Vec3 n = (side % 2 == 0 ? 1 : -1) * axes.col(across);
    polygon = clip(polygon, n, reference.position.dot(n) + reference.half[across], side);
  }
  // Which two faces they are is part of each name: six of the reference, six of the other, and whose is which.
  const auto numbered = [](const Body& box, int at, const Vec3& n) {
    return 2 * at + (axes_of(box).col(at).dot(n) > 0);
  };
  const int faces =
      (6 * numbered(reference, face, out) + numbered(incident, face_along(incident, out), out)) * 2 + of_a;
  const double surface = reference.position.dot(out) + reference.half[face];
  Touches found;
  for (const Corner& corner : polygon) {
    const double depth = surface - corner.at.dot(out);
    if (depth >= 0) found.push_back({corner.at + depth / 2 * out, axis.normal, depth, 36 * faces + corner.name});
  }
  return found;
}

/// All points at which two boxes touch, each with a name of its own; none where they are apart.
inline Touches touch(const Body& a, const Body& b) {
  Axis axis;
  if (!least_overlap(a, b, axis)) return {};
  if (!axis.of_edges()) return touch_of_faces(a, b, axis);
  Touch edges = touch_of_edges(a, b, axis);
  int corners = 0;  // which of the four edges along each axis they are
  for (int i = 0; i < 3; ++i) {
    const bool high_a = i != axis.axis_a && axes_of(a).col(i).dot(axis.normal) > 0;
    const bool high_b = i != axis.axis_b && axes_of(b).col(i).dot(axis.normal) > 0;
    corners = 4 * corners + 2 * high_a + high_b;
  }
  edges.name = -1 - (corners * 9 + 3 * axis.axis_a + axis.axis_b);  // below 0: no name of a face
  return {edges};
}

/// The point of the same name among those of the step before, or none.
inline const Touch* same_point(const Touches& before, const Touch& now) {
  for (const Touch& old : before)
    if (old.name == now.name) return &old;
  return nullptr;
}

}  // namespace empty_file
