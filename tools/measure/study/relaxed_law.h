/// With a convex relaxation of Coulomb's law, a sliding body lifts off.
///
///   Coulomb          r in K,   u + mu |u_t| n in K*,   r . (u + mu |u_t| n) = 0
///   relaxed          r in K,   u in K*,                r . u = 0                     the minimum of r^T W r / 2 + q^T r over K
///
/// Without De Saxce's term mu |u_t| the normal speed of a sliding contact is not 0. r is on the edge of the cone, (1, -mu) times r_n,
/// and r . u = r_n (u_n - mu |u_t|) = 0, so u_n = mu |u_t|. With a mass m and a slip of v before a short step:
///
///   m u_n = r_n,   m u_t = m v - k mu r_n     =>     u_n = mu v / (1 + k mu^2),   u_t = v / (1 + k mu^2)
///
/// k is m times the inverse effective mass of the contact along a tangent. It is 1 if friction does not rotate the body, and 7/2 for a
/// ball. A box does not rotate as long as its four corners can shift the pressure forward, because these impulses satisfy all
/// conditions, and u is unique.
///
/// In flight and at landings, friction is -mu times the normal impulse, so that  v_t + mu v_n = v_0 - mu g t  for the centre of mass.
/// Hence x + mu y equals the true x. At the height y a body is sqrt(1 + mu^2) y away from its true position. The error is largest at
/// the top of the first hop, and 0 at each landing. With k = 1 the speed of each hop is (1 - mu^2) / (1 + mu^2) of the previous one.
#pragma once

#include <cmath>
#include <optional>

#include "pushback/chapters/19_accuracy_and_time/truth.h"

namespace pushback {

struct Hop {
  double speed = 0;   ///< m/s, upwards, at the first lift-off, as h -> 0
  double height = 0;  ///< m, of the first hop
  double error = 0;   ///< m, at the top of the first hop
};

/// The hop of the last body of a motion, a box or a ball that slides on fixed level ground. None for other motions.
inline std::optional<Hop> hop_of(const Motion& motion) {
  World world;
  motion.fill(world);
  const Body& body = world.bodies.back();
  const double slip = static_cast<double>(body.velocity.norm()), mu = static_cast<double>(body.friction);
  if (slip == 0 || mu == 0 || !motion.pins.empty()) return {};
  if (!body.angular_velocity.isZero(0)) return {};  // the body may roll
  if (body.velocity.y() != 0 || world.bodies.front().conveys) return {};
  double k = 1;
  if (const auto* ball = std::get_if<Sphere>(&body.shape))
    k += static_cast<double>(ball->radius * ball->radius * body.principal_inverse_inertia.x() / body.inverse_mass);
  const double speed = mu * slip / (1 + k * mu * mu), height = speed * speed / (2 * truth::g);
  return Hop{speed, height, std::sqrt(1 + mu * mu) * height};
}

}  // namespace pushback
