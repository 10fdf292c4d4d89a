#include "pushback/common/live/hand.h"

#include <algorithm>

namespace pushback {

std::optional<Grab> grab(const World& world, const Ray& ray) {
  const std::optional<RayHit> hit = nearest_hit(world, ray);
  if (!hit || !world.body(hit->body).movable()) return {};
  return Grab{static_cast<std::size_t>(hit->body), point_on(world.body(hit->body), hit->point), hit->point};
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
