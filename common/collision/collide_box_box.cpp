// Box against box. The axis of least overlap gives the normal. If it belongs to a face, collide_box_faces.cpp compares the
// faces. If it belongs to two edges, the edges touch at one point.
//
//   S. Gottschalk, M. Lin, D. Manocha, OBBTree, SIGGRAPH 1996: the fifteen axes.
#include "pushback/common/collision/collide_box_box.h"

#include <cmath>

namespace pushback {

namespace {

struct EdgeAxis {
  int axis_a = -1, axis_b = -1;
  Vec3 direction = Vec3::Zero();  // unit, from A to B, along A's axes
  Real depth = std::numeric_limits<Real>::max();
};

/// The overlaps of the boxes along the normals of their faces, m.
struct FaceDepths {
  Vec3 a, b;
  explicit FaceDepths(const BoxPair& pair) {
    const Mat3 reach = pair.turn.cwiseAbs();
    a = pair.a + reach * pair.b - pair.offset.cwiseAbs();
    b = pair.b + reach.transpose() * pair.a - pair.offset_b.cwiseAbs();
  }
};

/// False if one of the six face normals separates the boxes. A's faces come first, and are preferred.
bool least_overlap_of_faces(const BoxPair& pair, const FaceDepths& depths, FaceAxis& best) {
  if (std::min(depths.a.minCoeff(), depths.b.minCoeff()) < -pair.rounding - pair.margin) return false;
  for (int i = 0; i < 6; ++i) {
    const Real depth = i < 3 ? depths.a[i] : depths.b[i - 3];
    if (depth < best.depth - pair.clearly) best = {i >= 3, i % 3, depth};
  }
  return true;
}

/// `normal`: along A's axes.
bool pass_each_other(const BoxPair& pair, const FaceDepths& depths, const Vec3& normal) {
  for (int i = 0; i < 3; ++i) {
    if (passes_at_face(Vec3::Unit(i), depths.a[i], normal, pair.clearly) ||
        passes_at_face(pair.turn.col(i), depths.b[i], normal, pair.clearly))
      return true;
  }
  return false;
}

/// False if one of the nine cross products a_i x b_j separates the boxes.
bool least_overlap_of_edges(const BoxPair& pair, EdgeAxis& best) {
  // The cross product of nearly parallel edges is too inexact, and the faces next to them decide as well.
  constexpr Real as_good_as_parallel = std::numeric_limits<Real>::digits > 24 ? Real(1e-10) : Real(1e-4);
  for (int i = 0; i < 3; ++i) {
    const int k = (i + 1) % 3, l = (i + 2) % 3;
    for (int j = 0; j < 3; ++j) {
      const int m = (j + 1) % 3, n = (j + 2) % 3;
      const auto b_j = pair.turn.col(j);
      const Real squared = b_j[k] * b_j[k] + b_j[l] * b_j[l];
      if (squared < as_good_as_parallel) continue;
      // Along A's axes, a_i x b_j is -b_j[l] at k and b_j[k] at l.
      const Real between = b_j[k] * pair.offset[l] - b_j[l] * pair.offset[k];
      const Real reach_a = pair.a[k] * std::abs(b_j[l]) + pair.a[l] * std::abs(b_j[k]);
      const Real reach_b = pair.b[m] * std::abs(pair.turn(i, n)) + pair.b[n] * std::abs(pair.turn(i, m));
      const Real length = std::sqrt(squared);
      const Real depth = (reach_a + reach_b - std::abs(between)) / length;
      if (depth < -pair.rounding / length - pair.margin)
        return false;  // the shorter the product, the less exact its direction
      if (depth < best.depth - pair.clearly) {
        const Real scale = (between < -pair.clearly * length ? -1 : 1) / length;
        best = {i, j, Vec3::Zero(), depth};
        best.direction[k] = -scale * b_j[l];
        best.direction[l] = scale * b_j[k];
      }
    }
  }
  return true;
}

void touch_at_edges(const Placed<Box>& a, const BoxPair& pair, const EdgeAxis& axis, Manifold& found) {
  // The edge of A that lies farthest along the normal, and the edge of B that lies farthest against it.
  const Vec3& normal = axis.direction;
  const Vec3 normal_b = pair.turn.transpose() * normal;
  Vec3 on_a = Vec3::Zero(), on_b = Vec3::Zero();
  int corner_a = 0, corner_b = 0;
  for (int i = 0; i < 3; ++i) {
    if (i != axis.axis_a) on_a[i] = normal[i] > 0 ? pair.a[i] : -pair.a[i];
    if (i != axis.axis_b) on_b[i] = normal_b[i] > 0 ? -pair.b[i] : pair.b[i];
    if (on_a[i] > 0) corner_a |= 1 << i;
    if (on_b[i] > 0) corner_b |= 1 << i;
  }
  // The nearest points of the two lines: on_a + s a_i and pair.offset + B (on_b) + t b_j.
  const Vec3 start_b = pair.offset + pair.turn * on_b;
  const Vec3 along_b = pair.turn.col(axis.axis_b);
  const Vec3 apart = start_b - on_a;
  const Real cosine = along_b[axis.axis_a];
  const Real p = apart[axis.axis_a], q = along_b.dot(apart);
  const Real sine2 = std::max(along_b.squaredNorm() - cosine * cosine, std::numeric_limits<Real>::epsilon());
  const Real s = std::clamp((p - cosine * q) / sine2, -pair.a[axis.axis_a], pair.a[axis.axis_a]);
  const Real t = std::clamp((cosine * p - q) / sine2, -pair.b[axis.axis_b], pair.b[axis.axis_b]);
  on_a[axis.axis_a] = s;
  const Vec3 midway = (on_a + start_b + t * along_b) / 2;

  found.normal = a.axes * normal;
  found.add(a.centre + a.axes * midway, axis.depth,
            crossing(edge_at(axis.axis_a, corner_a), edge_at(axis.axis_b, corner_b)));
}

}  // namespace

void touch(const Placed<Box>& a, const Placed<Box>& b, Manifold& found) {
  const Vec3 &extents_a = a.shape.half_extents, &extents_b = b.shape.half_extents;
  BoxPair pair{extents_a, extents_b,   a.axes.transpose() * b.axes, a.axes.transpose() * (b.centre - a.centre), {}, 0,
               0,         found.margin};
  pair.offset_b = pair.turn.transpose() * pair.offset;
  pair.clearly = Real(1e-3) * std::min(extents_a.minCoeff(), extents_b.minCoeff());
  pair.rounding = rounding_of(std::max(extents_a.maxCoeff(), extents_b.maxCoeff()));

  const FaceDepths depths(pair);
  FaceAxis face;
  EdgeAxis edge;
  if (!least_overlap_of_faces(pair, depths, face) || !least_overlap_of_edges(pair, edge)) return;

  // Edges win only if their overlap is clearly less and their normal is no near copy of the face's. Otherwise a slightly tilted
  // plate on another plate would come to rest on the one point at which two of their edges cross.
  constexpr Real near_copy = 1 - parallel * parallel / 2;  // the cosine of the angle whose sine is `parallel`
  const Vec3 face_normal = face.of_b ? Vec3(pair.turn.col(face.axis)) : Vec3(Vec3::Unit(face.axis));
  const bool edges_win =
      edge.depth < face.depth - pair.clearly && std::abs(edge.direction.dot(face_normal)) < near_copy;
  const Real outward = face.of_b ? (pair.offset_b[face.axis] > pair.clearly ? 1 : -1)
                                 : (pair.offset[face.axis] < -pair.clearly ? -1 : 1);
  const Vec3 normal = edges_win ? edge.direction : Vec3(outward * face_normal);
  found.normal = a.axes * normal;
  found.overlap = edges_win ? edge.depth : face.depth;
  found.passes = pass_each_other(pair, depths, normal);
  if (found.passes) return;
  if (!edges_win && touch_at_faces(a, b, pair, face, found)) return;
  if (edge.axis_a >= 0 && !pass_each_other(pair, depths, edge.direction)) touch_at_edges(a, pair, edge, found);
}

}  // namespace pushback
