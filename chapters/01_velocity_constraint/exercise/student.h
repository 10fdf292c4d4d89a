/// Exercise 01: a body on a rail. The task is chapters/01_velocity_constraint/exercise/task.md.
#pragma once

#include "pushback/chapters/01_velocity_constraint/exercise/asked.h"

namespace student {

using namespace pushback;

/// A body hangs with a ring on a straight rail without friction. The ring stays on the rail, and the body may turn in any
/// direction. `sweeps` are enough if your rows are solved one after the other.
///
/// You read            ring               m, world axes, the position of the ring, a point of the body
///                     rail               unit, world axes, the direction of the rail
///                     rails_velocity     m/s, world axes, the velocity of the rail itself
/// of the body         position           m, of its centre of mass
///                     inverse_mass       1/m, 1/kg
///                     inverse_inertia    I^-1 in world axes, 1/(kg m^2), a matrix
/// and read and change velocity           v, m/s, of its centre of mass
///                     angular_velocity   w, rad/s, world axes
///
/// const auto [t1, t2] = tangents_of(n);  gives two unit vectors at right angles to the unit vector n and to each other.
inline void hold(Body& body, const Vec3& ring, const Vec3& rail, const Vec3& rails_velocity, int sweeps) {
  // TODO the rows of a point that may only move along the rail: for each its J, b and K; lambda;
  // and the velocities that it makes
  (void)body, (void)ring, (void)rail, (void)rails_velocity, (void)sweeps;  // take this line out
  // TODO ends
}

inline const exercise_01::Answer answer{hold};

}  // namespace student
