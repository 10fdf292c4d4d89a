#include "pushback/common/collision/broad_phase.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <functional>
#include <limits>
#include <numeric>

namespace pushback {

namespace {

/// The bounds of a shape along the world axes, relative to the body's position.
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
  // Rounded outwards, so that bodies that touch exactly are not lost here.
  const Vec3 farthest = body.position.cwiseAbs() + reach.high.cwiseMax(-reach.low);
  const Vec3 beyond = 16 * std::numeric_limits<Real>::epsilon() * farthest + Vec3::Constant(body.skin);
  return {body.position + reach.low - beyond, body.position + reach.high + beyond};
}

Bounds bounds_of(const Body& body, const Margin& margin) {
  const Bounds now = bounds_of(body);
  const Vec3 least = Vec3::Constant(margin.least), way = margin.ahead * body.velocity;
  return {now.low - least + way.cwiseMin(0), now.high + least + way.cwiseMax(0)};
}

namespace {

/// The bounds and the index of a body that is not a half-space.
struct Entry {
  Bounds bounds;
  int index;
  bool movable;
};

/// The range and the mean size of the bounds along each axis, without the few bounds that are farthest out or largest, because one
/// of these would make the columns of all others wide.
struct Spread {
  Vec3 low = Vec3::Zero(), high = Vec3::Zero(), size = Vec3::Zero();

  explicit Spread(const std::vector<Entry>& entries) {
    if (entries.empty()) return;
    const std::size_t count = entries.size(), far = std::min(std::size_t(std::sqrt(Real(count))), (count - 1) / 2),
                      large = std::min<std::size_t>(far, 16);
    std::vector<Real> values(count);
    const auto lowest_but = [&](std::size_t few, const auto& value) {
      std::transform(entries.begin(), entries.end(), values.begin(), value);
      std::nth_element(values.begin(), values.begin() + std::ptrdiff_t(few), values.end());
      return values[few];
    };
    for (int axis = 0; axis < 3; ++axis) {
      low[axis] = lowest_but(far, [axis](const Entry& entry) { return entry.bounds.low[axis]; });
      high[axis] = -lowest_but(far, [axis](const Entry& entry) { return -entry.bounds.high[axis]; });
      lowest_but(count - 1 - large,
                 [axis](const Entry& entry) { return entry.bounds.high[axis] - entry.bounds.low[axis]; });
      size[axis] = std::accumulate(values.begin(), values.end() - std::ptrdiff_t(large), Real(0)) / Real(count - large);
    }
  }
  int widest_axis() const {
    int axis = 0;
    (high - low).maxCoeff(&axis);
    return axis;
  }
};

/// Whether the lowest corner of the bounds, as seen along the plane's normal, is not above the plane.
bool reaches_into(const Bounds& bounds, const Vec3& normal, const Vec3& point_on_plane) {
  const Vec3 lowest = (normal.array() > 0).select(bounds.low, bounds.high);
  return normal.dot(lowest - point_on_plane) <= 0;
}

/// Sorts by (first, second): a counting sort by the first index, then a sort of each group.
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

/// A grid of columns along one axis, and the bodies that reach into each. Columns are about twice as wide as the mean bounds, so that
/// each of many bodies is in a few columns and meets only the bodies there.
class Columns {
 public:
  /// The first and last column, along u and along v, that one body reaches into.
  struct Span {
    std::array<int, 2> first, last;
  };

  Columns(const std::vector<Entry>& entries, const Spread& spread, int u, int v) : across_{u, v} {
    const auto& [low, high, size] = spread;
    const Real most = std::sqrt(Real(entries.size()));
    for (std::size_t i = 0; i < 2; ++i) {
      const int axis = across_[i];
      const Real wanted = (high[axis] - low[axis]) / (2 * size[axis]);
      count_[i] = std::isfinite(wanted) && wanted >= 2 && most >= 2 ? int(std::min(most, wanted)) : 1;
      origin_[i] = low[axis];
      per_length_[i] = Real(count_[i]) / (high[axis] - low[axis]);
    }
    begin_.assign(std::size_t(count_[0]) * std::size_t(count_[1]) + 1, 0);
    for (const Entry& entry : entries) spans_.push_back(span_of(entry.bounds));
    each([this](int /*place*/, std::size_t column) { ++begin_[column + 1]; });
    for (std::size_t i = 1; i < begin_.size(); ++i) begin_[i] += begin_[i - 1];
    places_.resize(begin_.back());
    std::vector<std::size_t> next = begin_;
    each([&](int place, std::size_t column) { places_[next[column]++] = place; });
  }

  std::size_t count() const { return begin_.size() - 1; }
  /// The places of the entries in this column, in their order.
  std::span<const int> in(std::size_t column) const {
    return std::span(places_).subspan(begin_[column], begin_[column + 1] - begin_[column]);
  }
  /// Whether this is the first of the columns that both entries reach into. The pair is found only there.
  bool found_in(std::size_t column, int p, int q) const {
    const Span &one = spans_[std::size_t(p)], &other = spans_[std::size_t(q)];
    return column == column_at(std::max(one.first[0], other.first[0]), std::max(one.first[1], other.first[1]));
  }

 private:
  std::size_t column_at(int u, int v) const { return std::size_t(u) * std::size_t(count_[1]) + std::size_t(v); }
  /// Ascends with the coordinate, so that overlapping bounds have a column in common. Coordinates out of range belong to the outermost
  /// column.
  int along(std::size_t i, Real coordinate) const {
    if (count_[i] == 1) return 0;
    return int(std::clamp((coordinate - origin_[i]) * per_length_[i], Real(0), Real(count_[i] - 1)));
  }
  Span span_of(const Bounds& bounds) const {
    const auto [u, v] = across_;
    return {{along(0, bounds.low[u]), along(1, bounds.low[v])}, {along(0, bounds.high[u]), along(1, bounds.high[v])}};
  }
  /// Calls `act(place, column)` for each entry in each of its columns.
  template <class Act>
  void each(const Act& act) const {
    for (std::size_t place = 0; place < spans_.size(); ++place) {
      const Span& span = spans_[place];
      for (int u = span.first[0]; u <= span.last[0]; ++u)
        for (int v = span.first[1]; v <= span.last[1]; ++v) act(int(place), column_at(u, v));
    }
  }

  std::array<int, 2> across_, count_{1, 1};
  std::array<Real, 2> origin_{}, per_length_{};
  std::vector<Span> spans_;         // of the entries
  std::vector<std::size_t> begin_;  // of each column, in places_
  std::vector<int> places_;
};

/// The near pairs of these bodies, as their places in `bodies`; `ways` replaces the margin if it is not empty.
// Sort and sweep: in the order of their low ends along one axis, each body can only meet the bodies that begin before it
// ends.
//   D. Baraff, Dynamic simulation of non-penetrating rigid bodies, PhD thesis, Cornell, 1992.
std::vector<BodyPair> near_places(const std::vector<const Body*>& bodies, const Margin& margin,
                                  std::span<const Real> ways, Workers& workers) {
  constexpr std::size_t least = 128;  // bodies
  constexpr std::size_t least_columns = 16;
  const auto margin_of = [&](int index) { return ways.empty() ? margin : Margin{.least = ways[std::size_t(index)]}; };
  std::vector<Entry> entries;
  entries.reserve(bodies.size());
  std::vector<int> half_spaces;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    if (bodies[i]->removed) continue;
    if (std::holds_alternative<HalfSpace>(bodies[i]->shape)) half_spaces.push_back(int(i));
    else entries.push_back({{Vec3::Zero(), Vec3::Zero()}, int(i), bodies[i]->movable()});
  }
  workers.each(entries.size(), least, [&](Part part) {
    for (std::size_t i = part.begin; i < part.end; ++i)
      entries[i].bounds = bounds_of(*bodies[std::size_t(entries[i].index)], margin_of(entries[i].index));
  });

  std::vector<BodyPair> pairs;
  for (const int half_space : half_spaces) {  // not swept, because every body begins before a half-space ends
    const Body& plane = *bodies[std::size_t(half_space)];
    const Vec3 normal = plane.orientation * std::get<HalfSpace>(plane.shape).normal;
    const Real nearer =
        ways.empty() ? margin.ahead * std::max(Real(0), plane.velocity.dot(normal)) : ways[std::size_t(half_space)];
    const Vec3 highest = plane.position + (nearer + plane.skin) * normal;
    for (const Entry& entry : entries) {
      if (entry.movable && reaches_into(entry.bounds, normal, highest)) {
        pairs.push_back(std::minmax(entry.index, half_space));
      }
    }
  }

  const Spread spread(entries);
  const int axis = spread.widest_axis(), u = (axis + 1) % 3, v = (axis + 2) % 3;
  std::sort(entries.begin(), entries.end(), [axis](const Entry& p, const Entry& q) {
    return p.bounds.low[axis] != q.bounds.low[axis] ? p.bounds.low[axis] < q.bounds.low[axis] : p.index < q.index;
  });
  const Columns columns(entries, spread, u, v);
  std::vector<std::vector<BodyPair>> of_others(workers.parts(columns.count(), least_columns) - 1);
  workers.each(columns.count(), least_columns, [&](Part part) {
    std::vector<BodyPair>& into = part.index == 0 ? pairs : of_others[part.index - 1];
    std::vector<Entry> here;
    std::vector<std::size_t> met(entries.size());
    for (std::size_t column = part.begin; column < part.end; ++column) {
      const std::span<const int> places = columns.in(column);
      here.clear();
      for (const int place : places) here.push_back(entries[std::size_t(place)]);
      for (std::size_t i = 0; i < here.size(); ++i) {
        const Entry& entry = here[i];
        const Vec3 low = entry.bounds.low, high = entry.bounds.high;
        std::size_t count = 0;
        for (std::size_t k = i + 1; k < here.size() && here[k].bounds.low[axis] <= high[axis]; ++k) {
          // Always written, but kept only if near, because an unpredictable branch would take longer.
          const Bounds& bounds = here[k].bounds;
          met[count] = k;
          count += std::size_t(bounds.low[u] <= high[u]) & std::size_t(low[u] <= bounds.high[u]) &
                   std::size_t(bounds.low[v] <= high[v]) & std::size_t(low[v] <= bounds.high[v]);
        }
        for (std::size_t n = 0; n < count; ++n) {
          const std::size_t k = met[n];
          if ((entry.movable || here[k].movable) && columns.found_in(column, places[i], places[k]))
            into.push_back(std::minmax(entry.index, here[k].index));
        }
      }
    }
  });
  for (const auto& found : of_others) pairs.insert(pairs.end(), found.begin(), found.end());
  return in_order(pairs, bodies.size());
}

std::vector<const Body*> all_of(const std::vector<Body>& bodies) {
  std::vector<const Body*> all;
  all.reserve(bodies.size());
  for (const Body& body : bodies) all.push_back(&body);
  return all;
}

}  // namespace

std::vector<BodyPair> near_pairs(const std::vector<Body>& bodies, const Margin& margin, Workers& workers) {
  return near_places(all_of(bodies), margin, {}, workers);
}

std::vector<BodyPair> near_pairs(const std::vector<Body>& bodies, const std::vector<Real>& ways) {
  assert(ways.size() == bodies.size());
  return near_places(all_of(bodies), {}, ways, alone());
}

std::vector<BodyPair> near_pairs(const std::vector<Body>& bodies, std::span<const int> which, const Margin& margin) {
  assert(std::adjacent_find(which.begin(), which.end(), std::greater_equal<>()) == which.end());
  std::vector<const Body*> these;
  these.reserve(which.size());
  for (const int index : which) these.push_back(&bodies[std::size_t(index)]);
  std::vector<BodyPair> pairs = near_places(these, margin, {}, alone());
  for (BodyPair& pair : pairs) pair = {which[std::size_t(pair.first)], which[std::size_t(pair.second)]};
  return pairs;  // still in order, because indices ascend as places do
}

}  // namespace pushback
