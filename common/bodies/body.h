/// A rigid body: its state, its mass, its shape, how rough and bouncy it is, and what it touches.
#pragma once

#include <cstdint>
#include <vector>

#include "pushback/common/basics/types.h"
#include "pushback/common/bodies/shape.h"

namespace pushback {

/// All bits of Body::touches: what a body touches unless it says otherwise.
inline constexpr std::uint32_t every_group = 0xFFFFFFFF;

/// Positions and velocities are those of the centre of mass, in world axes.
///
/// The two velocities come first and the body starts on a cache line of its own: they are all that a sweep touches. A body
/// takes six cache lines: the order of its members leaves no holes.
struct alignas(64) Body {
  Vec3 velocity = Vec3::Zero();          ///< m/s
  Vec3 angular_velocity = Vec3::Zero();  ///< rad/s, world axes
  Vec3 position = Vec3::Zero();          ///< m
  Real inverse_mass = 0;                 ///< 1/kg; 0 for a body that nothing moves
  Quat orientation = Quat::Identity();   ///< unit; turns body axes into world axes

  Vec3 principal_inverse_inertia = Vec3::Zero();  ///< 1/(kg m^2), about the body's own axes
  Mat3 inverse_inertia = Mat3::Zero();  ///< 1/(kg m^2), world axes: R I_body^-1 R^T, refreshed whenever R changes

  Vec3 force = Vec3::Zero();   ///< N, applied during the next step, then cleared
  Vec3 torque = Vec3::Zero();  ///< N m, applied during the next step, then cleared

  Vec3 velocity_before = Vec3::Zero();          ///< m/s, as the step began: before any force or impulse
  Vec3 angular_velocity_before = Vec3::Zero();  ///< rad/s, likewise

  Shape shape = Sphere{Real(0.5)};
  Real friction = Real(0.5);            ///< mu; a pair rubs with the geometric mean of its two
  Real restitution = 0;                 ///< e; a pair bounces with the larger of its two
  Real skin = 0;                        ///< m; other bodies are kept this far from the shape
  int index = -1;                       ///< place in World::bodies, set by World::add
  bool asleep = false;                  ///< rests, and is left out of the simulation for now
  bool removed = false;                 ///< an empty place: see World::remove
  bool conveys = false;                 ///< immovable, and stays in its place: its velocities are those of its surface
  int colour = -1;                      ///< which colour of the palette draws it; -1: by its index
  std::uint32_t groups = 1;             ///< bits: what it is; see may_touch
  std::uint32_t touches = every_group;  ///< bits: the groups that it touches

  bool movable() const { return inverse_mass > 0; }
  /// Velocity of the body's point that is now at `point` (world axes, m).
  Vec3 velocity_at(const Vec3& point) const { return velocity + angular_velocity.cross(point - position); }
  /// R I_body^-1 R^T.
  void refresh_inertia();

  // What a scene says of a body, in the order in which one would say it. Each returns the body.
  Body& at(const Vec3& where);
  Body& oriented(const Quat& to);              ///< whatever turn it had; World::add makes it of unit length
  Body& turned(Real angle, const Vec3& axis);  ///< rad, about a world axis, after any turn it already has
  Body& moving(const Vec3& with_velocity);
  Body& spinning(const Vec3& with_angular_velocity);
  Body& rough(Real mu);
  Body& bouncy(Real e);
  Body& fixed();  ///< immovable from now on: infinite mass and inertia
  Body& coloured(int which);
  Body& in_groups(std::uint32_t bits);  ///< what it is; 0: nothing that anybody touches
  Body& touching(std::uint32_t bits);   ///< the groups that it touches; 0: none
  Body& with_skin(Real thickness);      ///< m; what touches is kept apart by the sum of both skins
  /// A conveyor: an immovable body that stays where it is while its surface moves, m/s, world axes. Faces along which the
  /// velocity points carry what lies on them. Faces across it push as if the body itself moved.
  Body& conveying(const Vec3& surface_velocity);

  /// Moves an immovable body by hand: sets both velocities so that the next step, of dt seconds, takes the body there, by
  /// the shorter turn, in however many substeps. The velocities stay after the step, so call this before each step. Throws
  /// InvalidInput if the body can move by itself or conveys, a number is not finite, or dt is not above 0.
  Body& moved_to(const Vec3& where, const Quat& to, Real dt);
  [[deprecated("moved_to needs no substeps any more")]] Body& moved_to(const Vec3& where, const Quat& to, Real dt,
                                                                       int /*substeps*/) {
    return moved_to(where, to, dt);
  }
};

/// Whether contacts between the two are detected: each one touches a group that the other is in.
inline bool may_touch(const Body& a, const Body& b) {
  return (a.touches & b.groups) != 0 && (b.touches & a.groups) != 0;
}

// Each throws InvalidInput where a length or a mass is not a finite number above 0.
Body sphere(Real radius, Real mass);
Body box(const Vec3& half_extents, Real mass);
Body capsule(Real radius, Real half_length, Real mass);
/// The convex hull of the points (m), uniform: 4 to 32 of them that enclose a volume, or InvalidInput is thrown.
///
/// As it comes, every point is where it was given: the body's position is the centre of mass, and where the axes of the
/// points are not principal axes, the body's orientation is that of axes which are. at() therefore moves the centre of
/// mass, wherever the points had it, and turned() turns the solid as it stands, about its centre of mass.
Body hull(const std::vector<Vec3>& points, Real mass);
/// Immovable, solid below the plane through the body's position, free on the side that `normal` points to.
Body half_space(const Vec3& normal);
/// The half-space below y = 0.
Body ground();

/// Throws InvalidInput, naming the value, unless every number in the body is one that can be simulated.
/// An orientation that is not quite of unit length is normalised; one of length 0 is refused.
void check(Body& body);

}  // namespace pushback
