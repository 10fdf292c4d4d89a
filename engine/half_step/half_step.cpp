#include "pushback/engine/half_step/half_step.h"

#include <algorithm>

#include "pushback/common/basics/input.h"
#include "pushback/common/world/step.h"

namespace pushback {

void HalfStepIntegrator::check(World& world, Real /*h*/) {
  HalfStepSettings::check();
  if (most_events < 0)
    throw InvalidInput(fmt::format("most_events is {}: a whole number, 0 or more, is needed", most_events));
  motion_.settings = *this;
  motion_.cuts = impacts.has_value();
  motion_.check(world, !holds_contacts());
}

/// The margin is the whole step's. If no pair is that near, the substeps need no detection of their own. In a step that is cut, bodies
/// that are apart are no contacts.
Plan HalfStepIntegrator::plan(Real dt) const {
  if (impacts) return {.sweeps = 1, .margin = {.least = HeldContacts::touch_distance}};
  return {.sweeps = 1, .margin = holds_contacts() ? KickDrift::margin(World::g, dt) : Margin{}};
}

void HalfStepIntegrator::after_detection(World& world, Real /*h*/) {
  if (holds_contacts()) return;
  const auto touches = [](const Contact& contact) { return contact.depth >= 0; };
  const auto found = std::find_if(world.contacts.begin(), world.contacts.end(), touches);
  if (found == world.contacts.end()) return;
  throw InvalidInput(fmt::format("bodies {} and {} touch: a composed step goes back in time, and contacts do not",
                                 found->id.body_a, found->id.body_b));
}

bool HalfStepIntegrator::run(World& world, Real h) {
  for (Body& body : world.bodies) {
    body.velocity = body.velocity_before;
    body.angular_velocity = body.angular_velocity_before;
  }
  save_states(world, states_);
  motion_.begin(world, h, holds_contacts());
  cuts_.impacts = impacts.value_or(Impacts::simultaneous);
  cuts_.most_events = most_events;
  cuts_.begin();
  const Real of_substep = h / static_cast<Real>(substeps);
  for (int i = 0; i < substeps; ++i)
    for (const Real fraction : composition) {
      const Real length = fraction * of_substep;
      if (impacts ? cuts_.advance(motion_, world, length) : motion_.advance(world, length)) continue;
      restore_states(world, states_);
      for (Body& body : world.bodies) body.refresh_inertia();
      return false;
    }
  motion_.report(world);
  save_states(world, states_);
  for (Body& body : world.bodies) {
    body.velocity.setZero();
    body.angular_velocity.setZero();
  }
  return true;
}

void HalfStepIntegrator::solve(World& world, Real h, int /*sweeps*/) {
  if (!run(world, h)) throw InvalidInput(motion_.failure);
}

void HalfStepIntegrator::end_detection(World& world) {
  if (!motion_.contact_free) motion_.contacts.report_sums(world);
}

void HalfStepIntegrator::after_move(World& world, Real /*h*/) {
  restore_states(world, states_);
}

/// The order of step.h, for one detection and one call of `solve`.
StepOutcome HalfStepIntegrator::try_step(World& world, Real dt) {
  AllBodies all_bodies;
  for (Joint& joint : world.joints) std::fill(joint.impulses.begin(), joint.impulses.end(), 0);
  all_bodies.check(world);
  check(world, dt);
  detect(world, all_bodies, plan(dt).margin);
  after_detection(world, dt);
  integrate_velocities(world, dt, all_bodies);
  if (!run(world, dt)) return {.converged = false, .work = work()};
  all_bodies.each(world, [dt](Body& body) { move(body, dt); });
  world.time += dt;
  after_move(world, dt);
  world.dt_before = dt;
  for (Contact& contact : world.contacts) contact.last_impulse = contact.impulse;
  end_detection(world);
  world.last_impulses_known = true;
  return {.converged = true, .work = work()};
}

HalfStep at_impacts(Impacts impacts) {
  HalfStep solver;
  solver.impacts = impacts;
  solver.tolerance =
      std::min(solver.tolerance, HeldContacts::touch_distance / 4);  // m, because an error of a joint is no gap
  return solver;
}

HalfStep composed(std::span<const Real> composition) {
  HalfStep solver;
  solver.composition = composition;
  return solver;
}

}  // namespace pushback
