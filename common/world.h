/// The bodies and the order of a step.
#pragma once

#include <functional>
#include <vector>

#include "common/body.h"
#include "common/contact.h"

namespace pushback {

class World {
 public:
  std::vector<Body> bodies;
  Vec3 gravity{0, Real(-9.81), 0};  ///< m/s^2
  /// Each is called as a step begins and adds to the bodies' `force` and `torque`. See common/forces.h.
  std::vector<std::function<void(World&)>> forces;
  /// What touched in the latest step, in ascending order of id, with what the solver did there.
  Contacts contacts;

  /// Puts a body into the world and returns its index. Throws InvalidInput if a number in it cannot be simulated.
  int add(const Body& body);

  /// Moves everything on by dt seconds. `solver` is whatever has `solve(Contacts&, Real dt, int sweeps)`.
  /// Throws InvalidInput unless dt > 0, sweeps >= 0 and every body's state is finite; then nothing has moved.
  template <class ContactSolver>
  void step(ContactSolver& solver, Real dt, int sweeps = 10) {
    check_step(dt, sweeps);
    apply_forces(dt);                    // 1.  v += h (g + F/m),  w += h I^-1 tau
    find_contacts();                     // 2.  points, normals, depths, ids
    solver.solve(contacts, dt, sweeps);  // 3.  start from the last step's impulses
                                         // 4.  sweep over the rows
                                         // 5.  keep the impulses
    move(dt);                            // 6.  x += h v,  q += h/2 (0, w) q,  refresh I^-1
    if constexpr (requires { solver.relax(contacts); }) solver.relax(contacts);  // 7. only where a solver has this
  }

  void apply_forces(Real dt);
  void find_contacts();
  void move(Real dt);

 private:
  void check_step(Real dt, int sweeps);
};

/// Turns a body by dt seconds of its own spin. Nothing acts on it, so its angular momentum L stays as it is, and
/// where its inertia differs from axis to axis the angular velocity has to follow (the gyroscopic term, w x I w).
void spin_freely(Body& body, Real dt);

}  // namespace pushback
