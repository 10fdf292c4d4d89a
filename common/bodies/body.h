/// A rigid body: its state, mass, shape, friction, restitution and collision groups.
#pragma once

#include <cstdint>
#include <vector>

#include "pushback/common/basics/types.h"
#include "pushback/common/bodies/shape.h"

namespace pushback {

/// All bits of Body::touches. By default a body touches every group.
inline constexpr std::uint32_t every_group = 0xFFFFFFFF;

/// Position and velocity refer to the centre of mass, in world axes.
///
/// The two velocities come first and the body starts on a cache line of its own, because a sweep accesses only them. In double
/// precision a body takes six cache lines, because the order of its members leaves no padding between them.
struct alignas(64) Body {
  Vec3 velocity = Vec3::Zero();          ///< m/s
  Vec3 angular_velocity = Vec3::Zero();  ///< rad/s, world axes
  Vec3 position = Vec3::Zero();          ///< m
  Real inverse_mass = 0;                 ///< 1/kg; 0 for an immovable body
  Quat orientation = Quat::Identity();   ///< unit; turns body axes into world axes

  Vec3 principal_inverse_inertia = Vec3::Zero();  ///< 1/(kg m^2), about the body's own axes
  Mat3 inverse_inertia = Mat3::Zero();  ///< 1/(kg m^2), world axes: R I_body^-1 R^T, refreshed whenever R changes

  Vec3 force = Vec3::Zero();   ///< N, applied during the next step, then cleared
  Vec3 torque = Vec3::Zero();  ///< N m, applied during the next step, then cleared

  Vec3 velocity_before = Vec3::Zero();  ///< m/s, at the start of the latest substep, before any force or impulse
  Vec3 angular_velocity_before = Vec3::Zero();  ///< rad/s, likewise

  Shape shape = Sphere{Real(0.5)};
  Real friction = Real(0.5);            ///< mu; a contact's mu is the geometric mean of its bodies' values
  Real restitution = 0;                 ///< e; a contact's e is the larger of its bodies' values
  Real skin = 0;                        ///< m; other bodies are kept this far from the shape
  int index = -1;                       ///< in World::bodies, set by World::add
  bool asleep = false;                  ///< at rest, and left out of the simulation for now
  bool removed = false;                 ///< an unused element, see World::remove
  bool conveys = false;                 ///< immovable and never moved; its velocities describe its surface
  int colour = -1;                      ///< number in the palette; -1: chosen by `index`
  std::uint32_t groups = 1;             ///< bits: the groups that it belongs to, see may_touch
  std::uint32_t touches = every_group;  ///< bits: the groups that it touches

  bool movable() const { return inverse_mass > 0; }
  /// Velocity (m/s) of the body's point that is now at `point` (m), both in world axes.
  Vec3 velocity_at(const Vec3& point) const { return velocity + angular_velocity.cross(point - position); }
  /// R I_body^-1 R^T.
  void refresh_inertia();

  // Setters for scenes, in the units and axes of the members. Each returns the body.
  Body& at(const Vec3& where);
  Body& oriented(const Quat& to);              ///< replaces any earlier turn; World::add normalises it
  Body& turned(Real angle, const Vec3& axis);  ///< rad, about a world axis, after any turn it already has
  Body& moving(const Vec3& with_velocity);
  Body& spinning(const Vec3& with_angular_velocity);
  Body& rough(Real mu);
  Body& bouncy(Real e);
  Body& fixed();  ///< immovable from now on: infinite mass and inertia
  Body& coloured(int which);
  Body& in_groups(std::uint32_t bits);  ///< sets `groups`; 0: no body touches it
  Body& touching(std::uint32_t bits);   ///< sets `touches`; 0: it touches no body
  Body& with_skin(Real thickness);      ///< m; touching bodies stay apart by the sum of their skins
  /// Makes an immovable body a conveyor, which stays in place while its surface moves (m/s, world axes). Faces parallel to the
  /// velocity carry the bodies on them. Faces across it push as if the body itself moved.
  Body& conveying(const Vec3& surface_velocity);

  /// Moves an immovable body by hand. Sets both velocities so that the next step of dt seconds takes the body there, by the
  /// shorter turn, whatever the number of substeps. The velocities stay after the step, so call this before each step. Throws
  /// InvalidInput if the body can move by itself or conveys, a number is not finite, `to` has length 0, or dt is not above 0.
  Body& moved_to(const Vec3& where, const Quat& to, Real dt);
  [[deprecated("moved_to needs no substeps any more")]] Body& moved_to(const Vec3& where, const Quat& to, Real dt,
                                                                       int /*substeps*/) {
    return moved_to(where, to, dt);
  }
};

/// Whether contacts between the two are detected. Each must touch a group that the other belongs to.
inline bool may_touch(const Body& a, const Body& b) {
  return (a.touches & b.groups) != 0 && (b.touches & a.groups) != 0;
}

// Lengths in m, masses in kg. Each throws InvalidInput if a length or a mass is not a finite number above 0.
Body sphere(Real radius, Real mass);
Body box(const Vec3& half_extents, Real mass);
Body capsule(Real radius, Real half_length, Real mass);
/// The convex hull of the points (m), of uniform density. Throws InvalidInput unless there are 4 to 32 points that enclose a
/// volume.
///
/// At first every point is where it was given, and the body's position is the centre of mass. If the axes of the points are not
/// principal axes, the body's orientation gives the principal axes. at() therefore sets the position of the centre of mass,
/// and turned() turns the solid about its centre of mass from the orientation in which it was given.
Body hull(const std::vector<Vec3>& points, Real mass);
/// Immovable, solid below the plane through the body's position, free on the side to which `normal` points. Throws InvalidInput
/// if the normal is not finite or has length 0.
Body half_space(const Vec3& normal);
/// The half-space below y = 0.
Body ground();

/// Throws InvalidInput, naming the value, unless every number in the body can be simulated. Normalises the orientation and the
/// normal of a half-space, whose lengths must be above 0, and refreshes the inertia.
void check(Body& body);

}  // namespace pushback
