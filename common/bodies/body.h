/// A rigid body: its state, its mass, its shape, and how rough and bouncy it is.
#pragma once

#include <vector>

#include "pushback/common/basics/types.h"
#include "pushback/common/bodies/shape.h"

namespace pushback {

/// Positions and velocities are those of the centre of mass, in world axes.
///
/// The two velocities come first and the body starts on a cache line of its own: they are all that a sweep touches.
struct alignas(64) Body {
  Vec3 velocity = Vec3::Zero();          ///< m/s
  Vec3 angular_velocity = Vec3::Zero();  ///< rad/s, world axes
  Vec3 position = Vec3::Zero();          ///< m
  Quat orientation = Quat::Identity();   ///< unit; turns body axes into world axes

  Real inverse_mass = 0;                          ///< 1/kg; 0 for a body that nothing moves
  Vec3 principal_inverse_inertia = Vec3::Zero();  ///< 1/(kg m^2), about the body's own axes
  Mat3 inverse_inertia = Mat3::Zero();  ///< 1/(kg m^2), world axes: R I_body^-1 R^T, refreshed whenever R changes

  Vec3 force = Vec3::Zero();   ///< N, applied during the next step, then cleared
  Vec3 torque = Vec3::Zero();  ///< N m, applied during the next step, then cleared

  Vec3 velocity_before = Vec3::Zero();          ///< m/s, as the step began: before any force or impulse
  Vec3 angular_velocity_before = Vec3::Zero();  ///< rad/s, likewise

  Shape shape = Sphere{Real(0.5)};
  Real friction = Real(0.5);  ///< mu; a pair rubs with the geometric mean of its two
  Real restitution = 0;       ///< e; a pair bounces with the larger of its two
  int index = -1;             ///< place in World::bodies, set by World::add
  bool asleep = false;        ///< rests, and is left out of the simulation for now
  int colour = -1;            ///< which colour of the palette draws it; -1: by its index

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
};

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
