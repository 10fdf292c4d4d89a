/// Exercise 00: the impulse of a pair. The task is chapters/00_naive_impulses/exercise/task.md.
#pragma once

#include "pushback/chapters/00_naive_impulses/exercise/asked.h"

namespace student {

using namespace pushback;

/// Two bodies touch at one point. Called once.
///
/// You read            contact.point        m, world axes
///                     contact.normal       n, unit, world axes, from A to B
///                     contact.restitution  e
/// of a body           position             m, of its centre of mass
///                     inverse_mass         1/m, 1/kg
///                     inverse_inertia      I^-1 in world axes, 1/(kg m^2), a matrix
/// and read and change velocity             v, m/s, of its centre of mass
///                     angular_velocity     w, rad/s, world axes
///
/// Vectors have x.dot(y) and x.cross(y); a matrix times a vector is I * x.
inline void impact(World& world, Contact& contact) {
  const auto [a, b] = world.bodies_of(contact);
  // TODO v_n of the points; K; f by Newton's law of impact (the equation of the page), none where the points separate;
  // then the velocities of both bodies
  (void)a, (void)b;  // take this line out
  // TODO ends
}

inline const exercise_00::Answer answer{impact};

}  // namespace student
