/// The order of a step.
#pragma once

#include <algorithm>

#include "pushback/common/world/step_parts.h"

namespace pushback {

/// Stages 1 and 2 of a step.
template <class Simulated>
void detect(World& world, Simulated& simulated, const Margin& margin) {
  remember_contacts(world);
  for (const Force& force : world.forces) force.apply(world);  // 1.  F, tau
  simulated.find_contacts(world, margin);                      // 2.  points, normals, depths, ids
}
/// Stage 3.
template <class Simulated>
void integrate_velocities(World& world, Real h, Simulated& simulated) {
  simulated.each(world, [&](Body& body) {  // 3.  v += h (g + F/m),  w += h I^-1 tau
    keep_velocity(body);
    integrate_velocity(body, world.gravity, h);
  });
}

/// One part of a step: a detection and its substeps of h (s) each. `first`: whether this is the first part of the step.
template <class Simulated>
void step_part(World& world, StepSolver& solver, const Plan& plan, const ForcesOfSubsteps& forces, Real h, int sweeps,
               bool first, Simulated& simulated) {
  if (!first) forces.apply_by_hand(world);
  simulated.check(world);
  check_solvable(world, solver);
  solver.check(world, h);
  const bool solver_moves = plan.moves_bodies && !forces.turn_bodies(world) && world.joints.empty();
  detect(world, simulated, plan.margin);
  solver.after_detection(world, h);
  for (int i = 0; i < plan.substeps; ++i) {
    if (i > 0) forces.apply(world);
    integrate_velocities(world, h, simulated);
    solver.solve(world, h, sweeps);  // 4.  start from the latest substep's impulses
                                     // 5.  sweep over the rows
                                     // 6.  keep the impulses
    if (solver_moves) solver.integrate_positions(world, h);
    else simulated.each(world, [h](Body& body) { move(body, h); });  // 7.  x += h v,  q += h/2 (0, w) q,  refresh I^-1
    world.time += h;
    solver.after_move(world, h);  // 8.  only if the solver defines it
    world.dt_before = h;
  }
  if (solver_moves) simulated.each(world, [](Body& body) { body.refresh_inertia(); });
  if (plan.substeps == 1)
    for (Contact& contact : world.contacts) contact.last_impulse = contact.impulse;
  solver.end_detection(world);
  world.last_impulses_known = true;
}

/// Advances the simulated bodies by dt (s), by this plan. Throws as World::step does.
template <class Simulated>
void step(World& world, StepSolver& solver, const Plan& plan, Real dt, int sweeps, Simulated& simulated) {
  check_step(dt, sweeps, world.gravity);
  const Real of_detection = dt / static_cast<Real>(plan.detections);
  const ForcesOfSubsteps forces(world, plan);
  for (Joint& joint : world.joints) std::fill(joint.impulses.begin(), joint.impulses.end(), 0);
  ImpulseSums sums;
  for (int i = 0; i < plan.detections; ++i) {
    step_part(world, solver, plan, forces, of_detection / static_cast<Real>(plan.substeps), sweeps, i == 0, simulated);
    if (plan.detections > 1) sums.add(world);
    simulated.end(world, of_detection);
  }
  if (plan.detections > 1) sums.write_to(world);
}

/// The same by the solver's own plan.
template <class Simulated>
void step(World& world, StepSolver& solver, Real dt, int sweeps, Simulated& simulated) {
  step(world, solver, solver.plan(dt), dt, sweeps, simulated);
}

}  // namespace pushback
