/// Shared by the two halves of box against box: collide_box_box.cpp and collide_box_faces.cpp.
#pragma once

#include "pushback/common/collision/collide_outline.h"
#include "pushback/common/collision/collide_shapes.h"

namespace pushback {

// A corner of a box is a number from 0 to 7: bit i is set on the positive side of axis i. An edge along axis i is 8 i
// plus either of its corners with bit i cleared.
constexpr int edge_at(int axis, int corner) {
  return 8 * axis + (corner & ~(1 << axis));
}
/// The corner at which two edges with different directions meet.
constexpr int corner_between(int edge, int other) {
  return (edge | other) & 7;
}

/// The pose of two boxes relative to each other, m. `turn`: the columns are B's axes along A's, the rows A's axes along B's.
struct BoxPair {
  const Vec3 &a, &b;  // half-extents
  Mat3 turn;
  Vec3 offset;    // from A's centre to B's, along A's axes
  Vec3 offset_b;  // the same, along B's axes
  Real clearly;   // overlaps that differ by no more than this count as equal, so that rounding does not choose
  Real rounding;  // a gap up to this may be rounding
  Real margin;    // a gap up to this counts as touching
};

/// The face normal along which two boxes overlap least.
struct FaceAxis {
  bool of_b = false;
  int axis = 0;
  Real depth = std::numeric_limits<Real>::max();
};

/// Clips the incident face to the reference face, which `face` gives, and adds the points below it to `found`. Returns false if there
/// are none.
bool touch_at_faces(const Placed<Box>& a, const Placed<Box>& b, const BoxPair& pair, const FaceAxis& face,
                    Manifold& found);

}  // namespace pushback
