/// The bodies and the order of a step.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "common/body.h"
#include "common/contact.h"
#include "common/joint.h"

namespace pushback {

class World;

/// Something that pushes or pulls: called as a step begins, it adds to the `force` and `torque` of bodies.
struct Force {
  std::function<void(World&)> apply;
  std::string name = "a force";
  std::vector<int> bodies =
      {};  ///< indices of those that it acts on, and that feel each other through it; empty: of all
};

/// A solver that also solves what joints ask for. The others refuse a world with joints.
template <class ContactSolver>
concept JointSolver = requires(ContactSolver& solver, World& world, Real dt) { solver.hold(world, dt); };

class World {
 public:
  std::vector<Body> bodies;
  Vec3 gravity{0, Real(-9.81), 0};  ///< m/s^2
  std::vector<Force> forces;        ///< see common/forces.h
  std::vector<Joint> joints;
  Real time = 0;  ///< s, simulated so far
  /// What touched in the latest step, in ascending order of id, with what the solver did there.
  Contacts contacts;

  /// Puts a body into the world and returns its index. Throws InvalidInput if a number in it cannot be simulated.
  int add(const Body& body);

  /// Moves everything on by dt seconds. `solver` is whatever has `solve(Contacts&, Real dt, int sweeps)`.
  /// Throws InvalidInput unless dt > 0, sweeps >= 0 and every body's state is finite, or where there are joints and the
  /// solver holds none; then nothing has moved.
  template <class ContactSolver>
  void step(ContactSolver& solver, Real dt, int sweeps = 10) {
    check_step(dt, sweeps);
    if constexpr (!JointSolver<ContactSolver>) check_no_joints(joints);
    apply_forces(dt);  // 1.  v += h (g + F/m),  w += h I^-1 tau
    find_contacts();   // 2.  points, normals, depths, ids
    if constexpr (JointSolver<ContactSolver>) solver.hold(*this, dt);
    solver.solve(contacts, dt, sweeps);  // 3.  start from the last step's impulses
                                         // 4.  sweep over the rows
                                         // 5.  keep the impulses
    move(dt);                            // 6.  x += h v,  q += h/2 (0, w) q,  refresh I^-1
    if constexpr (requires { solver.relax(contacts); }) solver.relax(contacts);  // 7. only where a solver has this
    if constexpr (requires { solver.correct(); }) solver.correct();              // 8. likewise
  }

  void apply_forces(Real dt);
  void find_contacts();
  void move(Real dt);

 private:
  void check_step(Real dt, int sweeps);
};

// ---- what a step does to one body by itself; World does it to all of them -------------------------------------------

/// Throws InvalidInput unless dt > 0, sweeps >= 0 and the gravity is finite.
void check_step(Real dt, int sweeps, const Vec3& gravity);
/// Throws InvalidInput unless every number of the body's state is finite.
void check_state(const Body& body);
/// velocity_before and angular_velocity_before.
void begin_step(Body& body);
/// v += h (g + F/m),  w += h I^-1 tau,  and F = tau = 0.
void push(Body& body, const Vec3& gravity, Real dt);
/// x += h v, and the turn.
void move(Body& body, Real dt);

/// Whether a body's inertia differs from axis to axis, so that a free spin does not keep its axis.
bool tumbles(const Body& body);
/// Turns a body by dt seconds of its own spin. Nothing acts on it, so its angular momentum L stays as it is, and
/// where it tumbles the angular velocity has to follow (the gyroscopic term, w x I w).
void spin_freely(Body& body, Real dt);
/// The same for one that does not tumble: its angular velocity stays.   q' = normalise(q + h/2 (0, w) q)
void spin_evenly(Body& body, Real dt);

}  // namespace pushback
