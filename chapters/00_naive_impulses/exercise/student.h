/// Exercise 00: a bat that turns about a pivot. The task is chapters/00_naive_impulses/exercise/task.md.
#pragma once

#include "pushback/chapters/00_naive_impulses/exercise/asked.h"

namespace student {

using namespace pushback;

/// A ball meets a bat. The bat may turn in any direction about its pivot, a point of it that never moves. Called once.
///
/// You read            pivot                m, world axes
///                     contact.point        m, world axes
///                     contact.normal       n, unit, world axes, from the bat towards the ball's centre
///                     contact.restitution  e
/// of a body           position             m, of its centre of mass
///                     inverse_mass         1/m, 1/kg
///                     inverse_inertia      I^-1 about the centre of mass, world axes, 1/(kg m^2), a matrix
///                     velocity_at(point)   m/s, of a point of the body
/// and read and change velocity             v, m/s, of its centre of mass
///                     angular_velocity     w, rad/s, world axes
///
/// A matrix M has M.inverse(). Mat3::Identity() is the unit matrix, d * d.transpose() the matrix of all d_i d_j.
inline void hit(Body& bat, const Vec3& pivot, Body& ball, const Contact& contact) {
  // TODO the inertia of the bat about its pivot, by Steiner's theorem, then K of this pair, then the impulse,
  // and finally the velocities of both bodies
  (void)bat, (void)pivot, (void)ball, (void)contact;  // take this line out
  // TODO ends
}

inline const exercise_00::Answer answer{hit};

}  // namespace student
