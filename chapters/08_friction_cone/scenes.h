/// Planks pushed off in all directions, their theoretical stopping places, and the error in the direction of friction.
#pragma once

#include "pushback/chapters/06_friction/scenes.h"

namespace pushback::friction_cone_scenes {

using friction_scenes::own_friction;
using friction_scenes::Push;

inline constexpr int headings = 12;
inline constexpr Real rim = Real(1.6);  ///< m, distance of the starts from the origin, so that planks do not touch
inline constexpr Real plank_height = Real(0.1);   ///< m, half the height, and half the width
inline constexpr Real longest_half = Real(0.35);  ///< m

/// 15, 45, 75 degrees and so on, in rad, along the pyramid's diagonals and in the directions in which it deflects most.
inline Real heading_of(int plank) {
  return pi / 6 * (static_cast<Real>(plank) + Real(0.5));
}
inline Vec3 way_of_heading(Real heading) {
  return {std::cos(heading), 0, -std::sin(heading)};
}
/// All planks lie along x, whatever their heading. At its corners, a plank is far harder to push along than across.
inline Body plank(Real half_length, const Vec3& from, Real heading, const Push& push) {
  return box({half_length, plank_height, plank_height}, 20)
      .at(from + Vec3(0, plank_height - Real(1e-5), 0))
      .moving(push.v0 * way_of_heading(heading))
      .rough(own_friction(push.mu));
}
/// A frame above the place where the plank should stop.
inline void frame(World& world, Real half_length, const Vec3& at) {
  const Real x = half_length + Real(0.05), z = plank_height + Real(0.05), thin = Real(0.03);
  const Vec3 above = at + Vec3(0, 2 * plank_height + Real(0.03), 0);
  for (const Real side : {Real(-1), Real(1)}) {
    world.add(box({x + thin, thin / 2, thin}, 1).fixed().at(above + Vec3(0, 0, side * z)).coloured(6));
    world.add(box({thin, thin / 2, z - thin}, 1).fixed().at(above + Vec3(side * x, 0, 0)).coloured(6));
  }
}
inline void planks(World& world, Real half_length, const Push& push = {}) {
  world.add(ground().rough(1));
  for (int i = 0; i < headings; ++i)
    world.add(plank(half_length, rim * way_of_heading(heading_of(i)), heading_of(i), push).coloured(i % 2));
}
/// The position at which that plank should stop, m.
inline Vec3 stop_of(int plank, Real h, const Push& push) {
  return (rim + push.stopping_distance(h)) * way_of_heading(heading_of(plank));
}
/// Adds first the planks, then the frames.
inline void wheel(World& world, Real half_length, Real h, const Push& push = {}) {
  planks(world, half_length, push);
  for (int i = 0; i < headings; ++i) frame(world, half_length, stop_of(i, h, push));
}

/// The displacement of a plank of the wheel from its start, m, along its heading and to the left of it.
struct Way {
  Real ahead, aside;
};
inline Way way_of(const World& world, int plank) {
  const Vec3 way = way_of_heading(heading_of(plank));
  const Vec3 moved = world.bodies[static_cast<std::size_t>(plank) + 1].position - rim * way;
  return {moved.dot(way), moved.dot(Vec3::UnitY().cross(way))};
}

/// The angle between the friction on B and the direction opposite to the slip of B, degrees.
inline Real direction_error(const Vec3& slip, const Vec3& friction) {
  return std::atan2(slip.cross(friction).norm(), -slip.dot(friction)) * 180 / pi;
}
/// The largest of all contacts that slip by more than 0.2 m/s, degrees. `h`: the latest step, s, from which the positions of the bodies
/// at the time of the solve are computed.
inline Real largest_direction_error(const World& world, Real h) {
  Real largest = 0;
  for (const Contact& contact : world.contacts) {
    const auto [a, b] = world.bodies_of(contact);
    const auto velocity_of = [&](const Body& body) {
      return Vec3(body.velocity + body.angular_velocity.cross(contact.point - (body.position - h * body.velocity)));
    };
    const auto in_plane = [&](const Vec3& v) { return Vec3(v - v.dot(contact.normal) * contact.normal); };
    const Vec3 slip = in_plane(velocity_of(b) - velocity_of(a)), friction = in_plane(contact.impulse);
    if (slip.norm() < Real(0.2) || friction.isZero()) continue;
    largest = std::max(largest, direction_error(slip, friction));
  }
  return largest;
}

/// A stick of 2 m and 5 kg that leans by 69 degrees to +x and touches the ground with its foot at one point. The foot slips in
/// the direction of `slip`. This is the only contact, and the solver is called directly.
struct Stick {
  World world;

  explicit Stick(Real slip, const Push& push = {}) {
    constexpr Real lean = Real(1.2);
    world.add(ground());
    world.add(
        capsule(Real(0.02), 1, 5).turned(-lean, Vec3::UnitZ()).moving(push.v0 * way_of_heading(slip) - Vec3(0, 1, 0)));
    Contact contact;
    contact.id = {0, 1, 0};
    contact.point = -Vec3(std::sin(lean), std::cos(lean), 0);
    contact.normal = Vec3::UnitY();
    contact.friction = push.mu;
    world.contacts = {contact};
  }
  Vec3 slip() const {
    const Vec3 v = world.bodies[1].velocity_at(contact().point);
    return {v.x(), 0, v.z()};
  }
  Vec3 friction() const { return {contact().impulse.x(), 0, contact().impulse.z()}; }
  const Contact& contact() const { return world.contacts[0]; }
};

}  // namespace pushback::friction_cone_scenes
