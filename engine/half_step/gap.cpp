#include "pushback/engine/half_step/gap.h"

#include <algorithm>
#include <array>

#include "pushback/common/collision/collide.h"

namespace pushback {

namespace {

/// The point of a core that lies farthest along a direction, in body axes.
struct Farthest {
  const Vec3& along;
  Vec3 operator()(const Sphere&) const { return Vec3::Zero(); }
  Vec3 operator()(const Capsule& c) const { return {0, std::copysign(c.half_length, along.y()), 0}; }
  Vec3 operator()(const Box& b) const { return (along.array() < 0).select(-b.half_extents, b.half_extents); }
  Vec3 operator()(const Hull& h) const {
    const auto& corners = h.solid->corners;
    return *std::max_element(corners.begin(), corners.end(),
                             [this](const Vec3& p, const Vec3& q) { return along.dot(p) < along.dot(q); });
  }
  Vec3 operator()(const HalfSpace&) const { return Vec3::Zero(); }
};
/// From the body's position, world axes.
Vec3 farthest(const Body& body, const Vec3& direction) {
  if (std::holds_alternative<Sphere>(body.shape)) return Vec3::Zero();
  const Vec3 along = body.orientation.conjugate() * direction;
  return body.orientation * std::visit(Farthest{along}, body.shape);
}

/// Up to four corners, and the point of what they enclose that is nearest to the origin.
class Simplex {
 public:
  bool has(const Vec3& point) const { return std::find(points_.begin(), points_.begin() + count_, point) != end(); }
  /// Keeps the corners that the nearest point needs. If all four are needed, the origin is inside.
  Vec3 add(const Vec3& point) {
    points_[count_++] = point;
    nearest_ = points_[0];
    least_ = std::numeric_limits<Real>::infinity();
    for (std::size_t i = 0; i < count_; ++i) try_corners({i}, points_[i]);
    for (std::size_t i = 0; i < count_; ++i)
      for (std::size_t j = i + 1; j < count_; ++j) try_edge(i, j);
    for (std::size_t out = 0; count_ >= 3 && out < count_; ++out) try_face(out);
    if (count_ == 4 && holds_origin()) return Vec3::Zero();
    if (count_ == 4 || kept_.size() < count_) keep();
    return nearest_;
  }
  bool full() const { return count_ == 4; }

 private:
  struct Corners {
    std::array<std::size_t, 3> which;
    std::size_t count = 0;
    Corners() = default;
    Corners(std::initializer_list<std::size_t> of) : which{}, count(of.size()) {
      std::copy(of.begin(), of.end(), which.begin());
    }
    std::size_t size() const { return count; }
  };
  std::array<Vec3, 4>::const_iterator end() const { return points_.begin() + static_cast<std::ptrdiff_t>(count_); }

  void try_corners(const Corners& corners, const Vec3& point) {
    const Real size = point.squaredNorm();
    if (!(size < least_)) return;
    least_ = size;
    nearest_ = point;
    kept_ = corners;
  }
  void try_edge(std::size_t i, std::size_t j) {
    const Vec3 along = points_[j] - points_[i];
    const Real t = -points_[i].dot(along), whole = along.squaredNorm();
    if (t > 0 && t < whole) try_corners({i, j}, points_[i] + t / whole * along);
  }
  /// For three corners, or for four without this one.
  void try_face(std::size_t out) {
    if (count_ == 3 && out > 0) return;
    const std::size_t i = count_ == 3 ? 0 : (out + 1) % 4, j = count_ == 3 ? 1 : (out + 2) % 4,
                      k = count_ == 3 ? 2 : (out + 3) % 4;
    const Vec3 &p = points_[i], &q = points_[j], &r = points_[k];
    const Vec3 n = (q - p).cross(r - p);
    const Real squared = n.squaredNorm();
    if (!(n.dot(p.cross(q)) > 0 && n.dot(q.cross(r)) > 0 && n.dot(r.cross(p)) > 0)) return;
    try_corners({i, j, k}, n.dot(p) / squared * n);
  }
  /// Not in one that is flat but for rounding.
  bool holds_origin() const {
    constexpr Real flat = 64 * std::numeric_limits<Real>::epsilon();
    for (std::size_t out = 0; out < 4; ++out) {
      const Vec3 &p = points_[(out + 1) % 4], &q = points_[(out + 2) % 4], &r = points_[(out + 3) % 4];
      const Vec3 n = (q - p).cross(r - p);
      const Real height = n.dot(p - points_[out]);
      if (!(n.dot(p) * height > 0) || std::abs(height) <= flat * n.norm() * p.norm()) return false;
    }
    return true;
  }
  void keep() {
    std::array<Vec3, 4> left;
    for (std::size_t i = 0; i < kept_.count; ++i) left[i] = points_[kept_.which[i]];
    points_ = left;
    count_ = kept_.count;
  }

  std::array<Vec3, 4> points_;
  std::size_t count_ = 0;
  Corners kept_;
  Vec3 nearest_ = Vec3::Zero();
  Real least_ = 0;
};

Gap from_plane(const Body& plane, const Body& body) {
  const Vec3 n = plane.orientation * std::get<HalfSpace>(plane.shape).normal;
  const Vec3 lowest = body.position - plane.position + farthest(body, -n);
  return {n.dot(lowest) - roundness(body) - plane.skin, n};
}

}  // namespace

Real roundness(const Body& body) {
  if (const auto* ball = std::get_if<Sphere>(&body.shape)) return ball->radius + body.skin;
  if (const auto* capsule = std::get_if<Capsule>(&body.shape)) return capsule->radius + body.skin;
  return body.skin;
}

Gap gap_between(const Body& a, const Body& b) {
  if (std::holds_alternative<HalfSpace>(a.shape)) return from_plane(a, b);
  if (std::holds_alternative<HalfSpace>(b.shape)) {
    const Gap gap = from_plane(b, a);
    return {gap.distance, -gap.normal};
  }
  constexpr Real exact = Real(1e-10), rounding = 16 * std::numeric_limits<Real>::epsilon();
  constexpr int most_rounds = 64;
  const Vec3 between = b.position - a.position;
  const Real radii = roundness(a) + roundness(b);
  Simplex simplex;
  Vec3 nearest = between.isZero(0) ? Vec3(Vec3::UnitY()) : between;
  Real size = 0;
  for (int round = 0; round < most_rounds; ++round) {
    const Vec3 corner = between + farthest(b, -nearest) - farthest(a, nearest);
    const Real length = nearest.norm(), along = nearest.dot(corner) / length;
    size = std::max(size, corner.norm());
    // Beyond the plane through `corner`, across `nearest`, there is nothing: the distance is `along` or more.
    if (round > 0 && (length - along <= exact * length + rounding * size || simplex.has(corner)))
      return {along - radii, nearest / length};
    const Vec3 normal = nearest / length;
    nearest = simplex.add(corner);
    // Faces almost parallel: the corner is nearer than rounding lets one see.
    if (round > 0 && !simplex.full() && !(nearest.norm() < length)) return {along - radii, normal};
    if (simplex.full() || nearest.norm() <= rounding * size) break;
  }
  Contacts found;
  collide(a, b, found, {.least = rounding * size});
  Gap gap{-radii, between.isZero(0) ? Vec3(Vec3::UnitY()) : Vec3(between.normalized())};
  for (const Contact& at : found)
    if (-at.depth < gap.distance || &at == found.data()) gap = {-at.depth, at.normal};
  return gap;
}

std::vector<Vec3> corners_of_core(const Body& body) {
  if (const auto* capsule = std::get_if<Capsule>(&body.shape))
    return {{0, -capsule->half_length, 0}, {0, capsule->half_length, 0}};
  if (const auto* hull = std::get_if<Hull>(&body.shape)) return hull->solid->corners;
  const auto* box = std::get_if<Box>(&body.shape);
  if (box == nullptr) return {Vec3::Zero()};
  std::vector<Vec3> corners;
  for (unsigned i = 0; i < 8; ++i)
    corners.push_back(box->half_extents.cwiseProduct(Vec3(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1)));
  return corners;
}

Real reach_of_core(const Body& body) {
  if (const auto* box = std::get_if<Box>(&body.shape)) return box->half_extents.norm();
  if (const auto* capsule = std::get_if<Capsule>(&body.shape)) return capsule->half_length;
  const auto* hull = std::get_if<Hull>(&body.shape);
  if (hull == nullptr) return 0;
  Real squared = 0;
  for (const Vec3& corner : hull->solid->corners) squared = std::max(squared, corner.squaredNorm());
  return std::sqrt(squared);
}

}  // namespace pushback
