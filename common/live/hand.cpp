#include "pushback/common/live/hand.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pushback {

namespace {

constexpr Real infinity = std::numeric_limits<Real>::infinity();

/// The part of a ray that is within all the half-spaces so far, m.
struct Within {
  const Ray& ray;
  Real from = 0, to = infinity;

  /// normal . p <= offset
  void cut(const Vec3& normal, Real offset) {
    const Real approach = normal.dot(ray.direction), left = offset - normal.dot(ray.from);
    if (approach == 0) {
      if (left < 0) to = -infinity;
    } else if (approach < 0) {
      from = std::max(from, left / approach);
    } else {
      to = std::min(to, left / approach);
    }
  }
  std::optional<Real> entry() const { return from < to ? std::optional(from) : std::nullopt; }
};

/// Where it comes within `radius` of the segment from `-half_length` to `half_length` on the y axis: by steps as long as the
/// distance that is left.
std::optional<Real> distance_to_round(const Ray& ray, Real half_length, Real radius) {
  Real along = 0;
  constexpr int most_steps = 96;
  for (int i = 0; i < most_steps; ++i) {
    const Vec3 at = ray.from + along * ray.direction;
    const Real left = (at - std::clamp(at.y(), -half_length, half_length) * Vec3::UnitY()).norm() - radius;
    if (left < Real(1e-4) * radius) return along;
    along += left;
    if (along > 1000 * (half_length + radius) + ray.from.norm()) break;
  }
  return {};
}

/// For a ray in the axes of the body.
struct Entry {
  const Ray& ray;

  std::optional<Real> operator()(const Sphere& ball) const { return distance_to_round(ray, 0, ball.radius); }
  std::optional<Real> operator()(const Capsule& capsule) const {
    return distance_to_round(ray, capsule.half_length, capsule.radius);
  }
  std::optional<Real> operator()(const Box& box) const {
    Within within{ray};
    for (int axis = 0; axis < 3; ++axis) {
      within.cut(Vec3::Unit(axis), box.half_extents(axis));
      within.cut(-Vec3::Unit(axis), box.half_extents(axis));
    }
    return within.entry();
  }
  std::optional<Real> operator()(const HalfSpace& space) const {
    Within within{ray};
    within.cut(space.normal, 0);
    return within.entry();
  }
  std::optional<Real> operator()(const Hull& hull) const {
    Within within{ray};
    for (const Polyhedron::Face& face : hull.solid->faces) within.cut(face.normal, face.offset);
    return within.entry();
  }
};

}  // namespace

std::optional<Real> distance_to(const Body& body, const Ray& ray) {
  const Quat back = body.orientation.conjugate();
  const Ray in_its_axes{back * (ray.from - body.position), back * ray.direction};
  return std::visit(Entry{in_its_axes}, body.shape);
}

std::optional<Grab> grab(const World& world, const Ray& ray) {
  const Body* nearest = nullptr;
  Real distance = infinity;
  for (const Body& body : world.bodies) {
    const std::optional<Real> its = distance_to(body, ray);
    if (!its || *its >= distance) continue;
    distance = *its;
    nearest = &body;
  }
  if (nearest == nullptr || !nearest->movable()) return {};
  const Vec3 point = ray.from + distance * ray.direction;
  return Grab{static_cast<std::size_t>(nearest->index), point_on(*nearest, point), point};
}

Force pull_of(const Grab& grab, Real dt) {
  const Real frequency = std::min(Real(12), Real(0.25) / dt);  // rad/s
  const auto pull = [=](World& world) {
    Body& body = world.bodies.at(grab.body);
    const Vec3 point = point_of(body, grab.on_body);
    const Vec3 wanted = frequency * (frequency * (grab.hand - point) - Real(1.4) * body.velocity_at(point));  // m/s^2
    const Vec3 force = wanted / body.inverse_mass;
    body.force += force;
    body.torque += (point - body.position).cross(force);
  };
  return {pull, "the hand", {static_cast<int>(grab.body)}};
}

}  // namespace pushback
