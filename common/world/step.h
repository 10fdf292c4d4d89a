/// The order of a step, and what it asks of a solver.
#pragma once

#include <concepts>

#include "pushback/common/world/world.h"

namespace pushback {

/// What a solver derives from. It has  void solve(World& world, Real dt, int sweeps),  which changes the velocities of bodies
/// and says in each contact what was done there; and defines of these what it needs.
struct StepSolver {
  /// Throws InvalidInput if it cannot solve what is in this world; nothing has changed yet. This one holds no joints.
  void check(World& world, Real /*dt*/) { check_no_joints(world.joints); }
  /// The bodies have moved.
  void after_move(World&, Real /*dt*/) {}
};

/// What solves joints as well derives from this.
struct HoldsJoints {};

/// Throws InvalidInput if there is something in the world that `ContactSolver` does not know.
template <class ContactSolver>
void check_solvable(const World& world) {
  if constexpr (!std::derived_from<ContactSolver, HoldsJoints>) check_no_joints(world.joints);
}

/// Who takes part in a step, and finds what touches. This one leaves nobody out.
struct Everybody {
  static void check(const World& world) {
    for (const Body& body : world.bodies) check_state(body);
  }
  static void find_contacts(World& world) { world.find_contacts(); }
  template <class Act>
  static void each(World& world, const Act& act) {
    for (Body& body : world.bodies) act(body);
  }
  static void end(World&, Real /*dt*/) {}
};

/// 1 to 3 of a step.
template <class Simulated>
void begin_step(World& world, Real dt, Simulated& simulated) {
  world.contacts_before.swap(world.contacts);
  for (const Force& force : world.forces) force.apply(world);  // 1.  F, tau
  simulated.find_contacts(world);                              // 2.  points, normals, depths, ids
  simulated.each(world, [&](Body& body) {                      // 3.  v += h (g + F/m),  w += h I^-1 tau
    keep_velocity(body);
    push(body, world.gravity, dt);
  });
}

/// Moves those who are simulated on by dt seconds. Throws as World::step does.
template <class ContactSolver, class Simulated>
void step(World& world, ContactSolver& solver, Real dt, int sweeps, Simulated& simulated) {
  check_step(dt, sweeps, world.gravity);
  simulated.check(world);
  solver.check(world, dt);
  begin_step(world, dt, simulated);
  solver.solve(world, dt, sweeps);                              // 4.  start from the last step's impulses
                                                                // 5.  sweep over the rows
                                                                // 6.  keep the impulses
  simulated.each(world, [dt](Body& body) { move(body, dt); });  // 7.  x += h v,  q += h/2 (0, w) q,  refresh I^-1
  world.time += dt;
  solver.after_move(world, dt);  // 8.  only where a solver has this
  world.dt_before = dt;
  simulated.end(world, dt);
}

template <class ContactSolver>
void World::step(ContactSolver& solver, Real dt, int sweeps) {
  Everybody everybody;
  pushback::step(*this, solver, dt, sweeps, everybody);
}

}  // namespace pushback
