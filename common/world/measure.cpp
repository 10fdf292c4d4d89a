#include "pushback/common/world/measure.h"

#include <algorithm>
#include <cstring>

namespace pushback {

Vec3 spin_momentum(const Body& body) {
  if (!body.movable()) return Vec3::Zero();
  const Vec3 w = body.orientation.conjugate() * body.angular_velocity;
  // The momentum about an axis with inverse inertia 0 could never change, so it does not count.
  const auto& inverse = body.principal_inverse_inertia.array();
  return body.orientation * Vec3((inverse > 0).select(w.array() / inverse, 0));
}

Real kinetic_energy(const World& world) {
  Real sum = 0;
  for (const Body& body : world.bodies) {
    if (body.movable()) {
      sum += (body.velocity.squaredNorm() / body.inverse_mass + body.angular_velocity.dot(spin_momentum(body))) / 2;
    }
  }
  return sum;
}

Real potential_energy(const World& world) {
  Real sum = 0;
  for (const Body& body : world.bodies) {
    if (body.movable()) sum -= world.gravity.dot(body.position) / body.inverse_mass;
  }
  return sum;
}

Vec3 momentum(const World& world) {
  Vec3 sum = Vec3::Zero();
  for (const Body& body : world.bodies) {
    if (body.movable()) sum += body.velocity / body.inverse_mass;
  }
  return sum;
}

Vec3 angular_momentum(const World& world) {
  Vec3 sum = Vec3::Zero();
  for (const Body& body : world.bodies) {
    if (body.movable()) sum += body.position.cross(body.velocity) / body.inverse_mass + spin_momentum(body);
  }
  return sum;
}

Real deepest_overlap(const World& world) {
  Real deepest = 0;
  for (const Contact& contact : world.contacts)
    if (!contact.parted) deepest = std::max(deepest, contact.depth);
  return deepest;
}

Real largest_speed(const World& world) {
  Real largest = 0;
  for (const Body& body : world.bodies) largest = std::max(largest, body.velocity.norm());
  return largest;
}

std::uint64_t hash_of(const World& world) {
  std::uint64_t hash = 14695981039346656037ULL;
  const auto eat = [&hash](const Real* values, int count) {
    for (int i = 0; i < count; ++i) {
      unsigned char bytes[sizeof(Real)];
      std::memcpy(bytes, values + i, sizeof(Real));
      for (const unsigned char byte : bytes) hash = (hash ^ byte) * 1099511628211ULL;
    }
  };
  for (const Body& body : world.bodies) {
    eat(body.position.data(), 3);
    eat(body.orientation.coeffs().data(), 4);
    eat(body.velocity.data(), 3);
    eat(body.angular_velocity.data(), 3);
  }
  return hash;
}

}  // namespace pushback
