// Face against face. The *reference face* gives the normal of the contact. The *incident face* is the face of the other box
// that is most nearly opposite. The incident face is clipped to the outline of the reference face, and the points left below the
// reference face touch.
#include <array>
#include <cmath>

#include "pushback/common/collision/collide_box_box.h"

namespace pushback {

bool touch_at_faces(const Placed<Box>& a, const Placed<Box>& b, const BoxPair& pair, const FaceAxis& face,
                    Manifold& found) {
  const Placed<Box>& box = face.of_b ? b : a;  // the box with the reference face
  const Vec3& extents = box.shape.half_extents;
  const Vec3& incident_extents = face.of_b ? pair.a : pair.b;
  const Mat3 turn = face.of_b ? Mat3(pair.turn.transpose()) : pair.turn;  // columns: axes of the incident box
  const Vec3 offset = face.of_b ? Vec3(-pair.offset_b) : pair.offset;     // of the incident box, in the frame of `box`

  const int i = face.axis, iu = (i + 1) % 3, iv = (i + 2) % 3;
  const Real outward = offset[i] < -pair.clearly ? -1 : 1;

  // The axis of the incident face is the one most nearly parallel to the axis of the reference face. Ties go to the first.
  int j = 0;
  for (int axis = 1; axis < 3; ++axis) {
    if (std::abs(turn(i, axis)) > std::abs(turn(i, j)) + Real(1e-3)) j = axis;
  }
  const int ju = (j + 1) % 3, jv = (j + 2) % 3;
  const int incident_side = turn(i, j) * outward > 0 ? 0 : 1 << j;
  Outline<16> outline;  // clipped at four lines: at most 8 corners; the rest is room for rounding
  for (const auto& [u, v] : {std::pair{0, 0}, {1, 0}, {1, 1}, {0, 1}}) {
    const int corner = incident_side | u << ju | v << jv;
    const Vec3 side((corner & 1) ? 1 : -1, (corner & 2) ? 1 : -1, (corner & 4) ? 1 : -1);
    const Vec3 at = offset + turn * side.cwiseProduct(incident_extents);
    // (0,0) -> (1,0) runs along ju, (1,0) -> (1,1) along jv, and so on
    const int arriving = edge_at(u == v ? jv : ju, corner), leaving = edge_at(u == v ? ju : jv, corner);
    outline.add({at[iu], at[iv], extents[i] - outward * at[i], arriving, leaving});
  }

  const Real tolerance = Real(1e-3) * std::min({extents[iu], extents[iv], incident_extents[ju], incident_extents[jv]});
  const int reference_side = outward > 0 ? 1 << i : 0;
  for (const int sign : {0, 1}) {
    const Real side = sign == 1 ? 1 : -1;
    cut(
        outline, [&](const OutlinePoint& p) { return side * p.u - extents[iu]; }, tolerance,
        reference + edge_at(iv, reference_side | sign << iu));
    cut(
        outline, [&](const OutlinePoint& p) { return side * p.v - extents[iv]; }, tolerance,
        reference + edge_at(iu, reference_side | sign << iv));
  }

  const auto name_of_corner = [&](bool of_reference, int one, int other) {
    const int corner = corner_between(one, other);
    return of_reference == face.of_b ? corner_of_b(corner) : corner_of_a(corner);
  };
  const auto candidates = candidates_of(outline, face.of_b, pair.rounding + pair.margin, pair.clearly, name_of_corner);
  if (candidates.count == 0) return false;

  found.normal = box.axes.col(i) * (face.of_b ? -outward : outward);
  for (const Candidate& candidate : candidates) {
    Vec3 midway;
    midway[i] = outward * (extents[i] - candidate.depth / 2);
    midway[iu] = candidate.u;
    midway[iv] = candidate.v;
    found.add(box.centre + box.axes * midway, candidate.depth, candidate.feature);
  }
  return true;
}

}  // namespace pushback
