/// Exercise 01: a row, its J and K, and how an impulse is applied. The task is
/// chapters/01_velocity_constraint/exercise/task.md.
#pragma once

#include "pushback/chapters/01_velocity_constraint/exercise/asked.h"

namespace student {

using namespace pushback;

/// Sequential Impulses: `sweeps` times over all contacts, one after the other. Each is a row along its normal, with b = 0.
///
/// You read            world.contacts         for (const Contact& c : world.contacts)
///                     world.bodies_of(c)     const auto [a, b] = world.bodies_of(c);
/// of a contact        point                  m, world axes
///                     normal                 n, unit, world axes, from A to B
/// of a body           position               m, of its centre of mass
///                     inverse_mass           1/m, 1/kg
///                     inverse_inertia        I^-1 in world axes, 1/(kg m^2), a matrix
/// and read and change velocity               v, m/s, of its centre of mass
///                     angular_velocity       w, rad/s, world axes
inline void solve(World& world, int sweeps) {
  // TODO for each contact, in each of the sweeps: J V; K = J M^-1 J^T; lambda (the equation of the page);
  // then V += M^-1 J^T lambda
  (void)world, (void)sweeps;  // take this line out
  // TODO ends
}

inline const exercise_01::Answer answer{solve};

}  // namespace student
