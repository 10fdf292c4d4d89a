/// Clips a face of one box or hull to a face of another, and chooses four of the remaining points.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>

#include "pushback/common/basics/types.h"

namespace pushback {

// The feature id of a manifold point names a corner of A (on a face of B), a corner of B (on a face of A), or an edge of A and
// an edge of B that cross. No id says which shape has the reference face, so the ids stay the same when that changes. Corners and
// edges have numbers below 128.
constexpr std::uint32_t corner_of_a(int corner) {
  return 0x10000u | std::uint32_t(corner);
}
constexpr std::uint32_t corner_of_b(int corner) {
  return 0x20000u | std::uint32_t(corner);
}
constexpr std::uint32_t crossing(int edge_a, int edge_b) {
  return 0x30000u | std::uint32_t(edge_a) << 8 | std::uint32_t(edge_b);
}

/// A corner of the outline during clipping, m. u and v are measured along the reference face, and depth below it. The corner is the
/// intersection of two lines, `arriving` and `leaving`. Each is the number of an edge of the incident face or, from `reference` on,
/// of the reference face.
struct OutlinePoint {
  Real u, v, depth;
  int arriving, leaving;
};
constexpr int reference = 128;

/// A convex outline. Clipping it at one line adds at most one corner.
template <std::size_t room>
struct Outline {
  std::array<OutlinePoint, room> points;
  int count = 0;
  void add(const OutlinePoint& point) {
    if (count < int(points.size())) points[std::size_t(count++)] = point;
  }
};

/// Clips `outline` to the near side of a line, where the linear function `beyond` (m) is not above 0. Corners that stick out by no more
/// than `tolerance` (m) stay, so that two faces whose edges coincide have the same corners whatever the rounding. Other corners are cut
/// off exactly at the line, which gets the number `edge`.
///
///   I. Sutherland, G. Hodgman, Reentrant polygon clipping, CACM 17(1), 1974: clipping at one side at a time.
template <std::size_t room, class Beyond>
void cut(Outline<room>& outline, const Beyond& beyond, Real tolerance, int edge) {
  const auto end = outline.points.begin() + outline.count;
  if (std::all_of(outline.points.begin(), end, [&](const OutlinePoint& p) { return beyond(p) <= tolerance; })) return;
  Outline<room> left;
  for (int i = 0; i < outline.count; ++i) {
    const OutlinePoint& p = outline.points[std::size_t(i)];
    const OutlinePoint& q = outline.points[std::size_t(i + 1 == outline.count ? 0 : i + 1)];
    const Real beyond_p = beyond(p), beyond_q = beyond(q);
    const bool p_stays = beyond_p <= tolerance, q_stays = beyond_q <= tolerance;
    if (p_stays) left.add(p);
    if (p_stays == q_stays) continue;
    // Fraction of the way from the point that stays to the one that goes, 0 if the point that stays is on the line or beyond it.
    const OutlinePoint& stays = p_stays ? p : q;
    const OutlinePoint& goes = p_stays ? q : p;
    const Real from = p_stays ? beyond_p : beyond_q, to = p_stays ? beyond_q : beyond_p;
    const Real part = std::max(Real(0), -from / (to - from));
    OutlinePoint crossed;
    crossed.u = stays.u + part * (goes.u - stays.u);
    crossed.v = stays.v + part * (goes.v - stays.v);
    crossed.depth = stays.depth + part * (goes.depth - stays.depth);
    crossed.arriving = p_stays ? p.leaving : edge;
    crossed.leaving = p_stays ? edge : p.leaving;
    left.add(crossed);
  }
  outline.count = left.count;
  std::copy_n(left.points.begin(), left.count, outline.points.begin());
}

/// A point of the manifold, m, still in the frame of the reference face.
struct Candidate {
  Real u, v, depth;
  std::uint32_t feature;
};

/// Keeps the four candidates that span the largest quadrilateral. The candidates go round a convex outline, and the quadrilateral has
/// at least 2/pi of its area. The choice depends only on the outline and not on depths, which fluctuate in a stack, with two
/// exceptions. If the deepest point is deeper than the four by more than `clearly_deeper` (m), it has to be one of them. A point
/// that is apart by more than that never replaces a point that touches.
/// A later quadrilateral replaces an earlier one only if it is larger by 0.1 %. The outline begins at the point with the lowest
/// feature id, so that the order is the same in each step. `count`: at least 4.
void reduce_to_four(Candidate* candidates, int count, Real clearly_deeper);

/// Up to four points of the manifold, in ascending order of feature id.
template <std::size_t room>
struct Candidates {
  std::array<Candidate, room> points;
  int count = 0;
  const Candidate* begin() const { return points.data(); }
  const Candidate* end() const { return points.data() + count; }
};

/// The outline's points below the reference face, or above it by no more than `gap` (m). `of_b`: whether B has that face.
/// `name_of_corner(of_reference, edge, edge)` returns the feature id of the corner at which two edges of one shape meet.
/// `of_reference`: whether this shape has the reference face.
template <std::size_t room, class NameOfCorner>
Candidates<room> candidates_of(const Outline<room>& outline, bool of_b, Real gap, Real clearly_deeper,
                               const NameOfCorner& name_of_corner) {
  Candidates<room> found;
  for (int p = 0; p < outline.count; ++p) {
    const OutlinePoint& point = outline.points[std::size_t(p)];
    if (point.depth < -gap) continue;
    const bool from_reference = point.arriving >= reference, to_reference = point.leaving >= reference;
    const int arriving = point.arriving & (reference - 1), leaving = point.leaving & (reference - 1);
    std::uint32_t feature;
    if (from_reference == to_reference) {
      feature = name_of_corner(from_reference, arriving, leaving);
    } else {
      feature = from_reference == of_b ? crossing(leaving, arriving) : crossing(arriving, leaving);
    }
    found.points[std::size_t(found.count++)] = {point.u, point.v, point.depth, feature};
  }
  if (found.count > 4) {
    reduce_to_four(found.points.data(), found.count, clearly_deeper);
    found.count = 4;
  }
  std::sort(found.points.begin(), found.points.begin() + found.count,
            [](const Candidate& p, const Candidate& q) { return p.feature < q.feature; });
  return found;
}

}  // namespace pushback
