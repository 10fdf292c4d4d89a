// Face against face. The *reference face* is the one whose normal the contact has; the *incident face* is the face of
// the other box that looks at it most squarely. The incident face is cut to the outline of the reference face, and what
// is left below the reference face touches.
//
//   I. Sutherland, G. Hodgman, Reentrant polygon clipping, CACM 17(1), 1974: cutting one side at a time.
#include <array>
#include <cmath>

#include "common/collide_box_box.h"

namespace pushback {

namespace {

/// A corner of the outline that is being cut. u, v: along the reference face; depth: below it. Two lines meet in it:
/// edges of the incident box, by number, or, from `reference` on, edges of the reference face.
struct OutlinePoint {
  Real u, v, depth;
  int arriving, leaving;
};
constexpr int reference = 32;

/// Cutting a convex outline at four lines adds at most one corner each time; the rest is room for rounding.
struct Outline {
  std::array<OutlinePoint, 16> points;
  int count = 0;
  void add(const OutlinePoint& point) {
    if (count < int(points.size())) points[std::size_t(count++)] = point;
  }
};

/// What is left of `outline` on the near side of a line: where side * (u or v) <= limit. What sticks out by less than
/// `tolerance` is not cut off, so that two faces whose edges coincide have the same corners whatever the rounding; what
/// is cut is cut exactly at the line.
Outline cut(const Outline& outline, Real OutlinePoint::* coordinate, Real side, Real limit, Real tolerance, int edge) {
  Outline left;
  const auto beyond = [&](const OutlinePoint& p) { return side * p.*coordinate - limit; };
  for (int i = 0; i < outline.count; ++i) {
    const OutlinePoint& p = outline.points[std::size_t(i)];
    const OutlinePoint& q = outline.points[std::size_t(i + 1 == outline.count ? 0 : i + 1)];
    const Real beyond_p = beyond(p), beyond_q = beyond(q);
    const bool p_stays = beyond_p <= tolerance, q_stays = beyond_q <= tolerance;
    if (p_stays) left.add(p);
    if (p_stays == q_stays) continue;
    // From the point that stays towards the one that goes; not at all if the former is on the line already.
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
  return left;
}

/// A point of the manifold, still in the frame of the reference face.
struct Candidate {
  Real u, v, depth;
  std::uint32_t feature;
};

/// Keeps the four of the candidates, which go round a convex outline, that span the largest quadrilateral: it has at
/// least 2/pi of the outline's area, and depends on the outline alone, not on depths, which change as a stack breathes.
/// But the deepest point must not get lost: if it is clearly deeper than those four, it has to be one of them.
/// One choice is preferred to an earlier one only if it is clearly better. So that the order is the same in each step,
/// the outline begins with the point of the lowest name.
int reduce_to_four(Candidate* candidates, int count, Real clearly_deeper) {
  const auto by_name = [](const Candidate& p, const Candidate& q) { return p.feature < q.feature; };
  std::rotate(candidates, std::min_element(candidates, candidates + count, by_name), candidates + count);
  std::array<Candidate, 4> best{};
  const auto try_all = [&](int required) {
    Real largest = -1;
    for (int i = 0; i < count; ++i) {
      for (int j = i + 1; j < count; ++j) {
        for (int k = j + 1; k < count; ++k) {
          for (int l = k + 1; l < count; ++l) {
            if (required >= 0 && i != required && j != required && k != required && l != required) continue;
            const Candidate &p = candidates[i], &q = candidates[j], &r = candidates[k], &s = candidates[l];
            const Real area = std::abs((r.u - p.u) * (s.v - q.v) - (r.v - p.v) * (s.u - q.u)) / 2;
            if (area > largest * Real(1.001)) {
              largest = area;
              best = {p, q, r, s};
            }
          }
        }
      }
    }
  };
  try_all(-1);
  const auto by_depth = [](const Candidate& p, const Candidate& q) { return p.depth < q.depth; };
  const Candidate* deepest = std::max_element(candidates, candidates + count, by_depth);
  if (deepest->depth > std::max_element(best.begin(), best.end(), by_depth)->depth + clearly_deeper) {
    try_all(int(deepest - candidates));
  }
  std::copy(best.begin(), best.end(), candidates);
  return 4;
}

}  // namespace

bool touch_at_faces(const Placed<Box>& a, const Placed<Box>& b, const BoxPair& pair, const FaceAxis& face,
                    Manifold& found) {
  const Placed<Box>& box = face.of_b ? b : a;  // the one with the reference face
  const Vec3& extents = box.shape.half_extents;
  const Vec3& incident_extents = face.of_b ? pair.a : pair.b;
  const Mat3 turn = face.of_b ? Mat3(pair.turn.transpose()) : pair.turn;  // columns: axes of the incident box
  const Vec3 offset = face.of_b ? Vec3(-pair.offset_b) : pair.offset;     // of the incident box, in the frame of `box`

  const int i = face.axis, iu = (i + 1) % 3, iv = (i + 2) % 3;
  const Real outward = offset[i] < -pair.clearly ? -1 : 1;

  // The incident face: whose axis is most nearly that of the reference face. Ties go to the first.
  int j = 0;
  for (int axis = 1; axis < 3; ++axis) {
    if (std::abs(turn(i, axis)) > std::abs(turn(i, j)) + Real(1e-3)) j = axis;
  }
  const int ju = (j + 1) % 3, jv = (j + 2) % 3;
  const int incident_side = turn(i, j) * outward > 0 ? 0 : 1 << j;
  Outline outline;
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
    outline = cut(outline, &OutlinePoint::u, side, extents[iu], tolerance,
                  reference + edge_at(iv, reference_side | sign << iu));
    outline = cut(outline, &OutlinePoint::v, side, extents[iv], tolerance,
                  reference + edge_at(iu, reference_side | sign << iv));
  }

  std::array<Candidate, 16> candidates;
  int count = 0;
  for (int p = 0; p < outline.count; ++p) {
    const OutlinePoint& point = outline.points[std::size_t(p)];
    if (point.depth < -pair.rounding) continue;
    const bool from_reference = point.arriving >= reference, to_reference = point.leaving >= reference;
    const int arriving = point.arriving & 31, leaving = point.leaving & 31;
    std::uint32_t feature;
    if (from_reference == to_reference) {
      const int corner = corner_between(arriving, leaving);
      feature = from_reference == face.of_b ? corner_of_b(corner) : corner_of_a(corner);
    } else {
      feature = from_reference == face.of_b ? crossing(leaving, arriving) : crossing(arriving, leaving);
    }
    candidates[std::size_t(count++)] = {point.u, point.v, point.depth, feature};
  }
  if (count == 0) return false;
  if (count > 4) count = reduce_to_four(candidates.data(), count, pair.clearly);
  std::sort(candidates.begin(), candidates.begin() + count,
            [](const Candidate& p, const Candidate& q) { return p.feature < q.feature; });

  found.normal = box.axes.col(i) * (face.of_b ? -outward : outward);
  for (int p = 0; p < count; ++p) {
    const Candidate& candidate = candidates[std::size_t(p)];
    Vec3 midway;
    midway[i] = outward * (extents[i] - candidate.depth / 2);
    midway[iu] = candidate.u;
    midway[iv] = candidate.v;
    found.add(box.centre + box.axes * midway, candidate.depth, candidate.feature);
  }
  return true;
}

}  // namespace pushback
