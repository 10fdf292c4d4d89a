#include "pushback/common/collision/broad_phase.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <functional>
#include <limits>

namespace pushback {

namespace {

/// The bounds of a shape along the world axes, about the body's position.
struct Reach {
  const Mat3& axes;
  Bounds operator()(const Sphere& s) const { return both_ways(Vec3::Constant(s.radius)); }
  Bounds operator()(const Box& b) const { return both_ways(axes.cwiseAbs() * b.half_extents); }
  Bounds operator()(const Capsule& c) const {
    return both_ways(c.half_length * axes.col(1).cwiseAbs() + Vec3::Constant(c.radius));
  }
  Bounds operator()(const HalfSpace&) const { return both_ways(Vec3::Constant(std::numeric_limits<Real>::infinity())); }
  Bounds operator()(const Hull& h) const {
    Bounds bounds = both_ways(Vec3::Zero());  // the centre of mass is inside
    for (const Vec3& corner : h.solid->corners) {
      const Vec3 at = axes * corner;
      bounds = {bounds.low.cwiseMin(at), bounds.high.cwiseMax(at)};
    }
    return bounds;
  }
  static Bounds both_ways(const Vec3& reach) { return {-reach, reach}; }
};

}  // namespace

Bounds bounds_of(const Body& body) {
  const Bounds reach = std::visit(Reach{body.orientation.toRotationMatrix()}, body.shape);
  // Rounded outwards: what touches exactly must not be lost here.
  const Vec3 farthest = body.position.cwiseAbs() + reach.high.cwiseMax(-reach.low);
  const Vec3 rounding = 16 * std::numeric_limits<Real>::epsilon() * farthest;
  return {body.position + reach.low - rounding, body.position + reach.high + rounding};
}

Bounds bounds_of(const Body& body, const Margin& margin) {
  const Bounds now = bounds_of(body);
  const Vec3 least = Vec3::Constant(margin.least), way = margin.ahead * body.velocity;
  return {now.low - least + way.cwiseMin(0), now.high + least + way.cwiseMax(0)};
}

namespace {

/// The bounds of a body that is not a half-space, and which body it is.
struct Entry {
  Bounds bounds;
  int index;
  bool movable;
};

/// The world axis along which the middles of the bounds are spread most.
int widest_axis(const std::vector<Entry>& entries) {
  Vec3 mean = Vec3::Zero(), variance = Vec3::Zero();
  for (const Entry& entry : entries) mean += (entry.bounds.low + entry.bounds.high) / Real(2 * entries.size());
  for (const Entry& entry : entries) variance += ((entry.bounds.low + entry.bounds.high) / 2 - mean).cwiseAbs2();
  if (variance.x() >= variance.y() && variance.x() >= variance.z()) return 0;
  return variance.y() >= variance.z() ? 1 : 2;
}

/// Whether the lowest corner of the bounds, as seen along the plane's normal, is not above the plane.
bool reaches_into(const Bounds& bounds, const Vec3& normal, const Vec3& point_on_plane) {
  const Vec3 lowest = (normal.array() > 0).select(bounds.low, bounds.high);
  return normal.dot(lowest - point_on_plane) <= 0;
}

/// Ascending by (first, second): dealt out by their first, then each hand sorted.
std::vector<BodyPair> in_order(const std::vector<BodyPair>& pairs, std::size_t bodies) {
  std::vector<int> begin(bodies + 1, 0);
  for (const BodyPair& pair : pairs) ++begin[std::size_t(pair.first) + 1];
  for (std::size_t i = 0; i < bodies; ++i) begin[i + 1] += begin[i];
  std::vector<BodyPair> ordered(pairs.size());
  std::vector<int> next = begin;
  for (const BodyPair& pair : pairs) ordered[std::size_t(next[std::size_t(pair.first)]++)] = pair;
  for (std::size_t i = 0; i < bodies; ++i) std::sort(ordered.begin() + begin[i], ordered.begin() + begin[i + 1]);
  return ordered;
}

/// The near pairs of these, each known by its place among them.
// Sort and sweep: in the order of their low ends along one axis, each body can only meet those that begin before it
// ends.
//   D. Baraff, Dynamic simulation of non-penetrating rigid bodies, PhD thesis, Cornell, 1992.
std::vector<BodyPair> near_places(const std::vector<const Body*>& bodies, const Margin& margin, Workers& workers) {
  constexpr std::size_t least = 128;  // bodies
  std::vector<Entry> entries;
  entries.reserve(bodies.size());
  std::vector<int> half_spaces;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    if (std::holds_alternative<HalfSpace>(bodies[i]->shape)) half_spaces.push_back(int(i));
    else entries.push_back({{Vec3::Zero(), Vec3::Zero()}, int(i), bodies[i]->movable()});
  }
  workers.each(entries.size(), least, [&](Part part) {
    for (std::size_t i = part.begin; i < part.end; ++i)
      entries[i].bounds = bounds_of(*bodies[std::size_t(entries[i].index)], margin);
  });

  std::vector<BodyPair> pairs;
  for (const int half_space : half_spaces) {  // not swept: every body begins before a half-space ends
    const Body& plane = *bodies[std::size_t(half_space)];
    const Vec3 normal = plane.orientation * std::get<HalfSpace>(plane.shape).normal;
    const Vec3 highest = plane.position + margin.ahead * std::max(Real(0), plane.velocity.dot(normal)) * normal;
    for (const Entry& entry : entries) {
      if (entry.movable && reaches_into(entry.bounds, normal, highest)) {
        pairs.push_back(std::minmax(entry.index, half_space));
      }
    }
  }

  const int axis = widest_axis(entries), u = (axis + 1) % 3, v = (axis + 2) % 3;
  std::sort(entries.begin(), entries.end(), [axis](const Entry& p, const Entry& q) {
    return p.bounds.low[axis] != q.bounds.low[axis] ? p.bounds.low[axis] < q.bounds.low[axis] : p.index < q.index;
  });
  std::vector<std::vector<BodyPair>> of_others(workers.parts(entries.size(), least) - 1);
  workers.each(entries.size(), least, [&](Part part) {
    std::vector<BodyPair>& into = part.index == 0 ? pairs : of_others[part.index - 1];
    std::vector<const Entry*> met(entries.size());
    for (std::size_t i = part.begin; i < part.end; ++i) {
      const Entry& entry = entries[i];
      const Vec3 low = entry.bounds.low, high = entry.bounds.high;
      std::size_t count = 0;
      for (std::size_t k = i + 1; k < entries.size() && entries[k].bounds.low[axis] <= high[axis]; ++k) {
        // Written down in any case, kept if near: a branch that nobody can predict would take longer.
        const Bounds& bounds = entries[k].bounds;
        met[count] = &entries[k];
        count += std::size_t(bounds.low[u] <= high[u]) & std::size_t(low[u] <= bounds.high[u]) &
                 std::size_t(bounds.low[v] <= high[v]) & std::size_t(low[v] <= bounds.high[v]);
      }
      for (std::size_t k = 0; k < count; ++k)
        if (entry.movable || met[k]->movable) into.push_back(std::minmax(entry.index, met[k]->index));
    }
  });
  for (const auto& found : of_others) pairs.insert(pairs.end(), found.begin(), found.end());
  return in_order(pairs, bodies.size());
}

}  // namespace

std::vector<BodyPair> near_pairs(const std::vector<Body>& bodies, const Margin& margin, Workers& workers) {
  std::vector<const Body*> all;
  all.reserve(bodies.size());
  for (const Body& body : bodies) all.push_back(&body);
  return near_places(all, margin, workers);
}

std::vector<BodyPair> near_pairs(const std::vector<Body>& bodies, std::span<const int> which, const Margin& margin) {
  assert(std::adjacent_find(which.begin(), which.end(), std::greater_equal<>()) == which.end());
  std::vector<const Body*> these;
  these.reserve(which.size());
  for (const int index : which) these.push_back(&bodies[std::size_t(index)]);
  std::vector<BodyPair> pairs = near_places(these, margin, alone());
  for (BodyPair& pair : pairs) pair = {which[std::size_t(pair.first)], which[std::size_t(pair.second)]};
  return pairs;  // in order still: indices ascend as places do
}

}  // namespace pushback
