/// A second-order step of kick, drift and kick.
#pragma once

#include <span>

#include "pushback/common/world/solver_from.h"
#include "pushback/engine/half_step/composition.h"
#include "pushback/engine/half_step/impact_cuts.h"

namespace pushback {

/// The result of one attempt at a step.
struct StepOutcome {
  bool converged = false;
  double work = 0;        ///< multiplications, roughly
  Real energy_error = 0;  ///< as a fraction of the allowed error, see energy_control.h
};

/// The functions of `HalfStep`, a solver with its own integrator. World::step calls them at the usual times. Each substep of h is:
///
///   v += h/2 M^-1 f(x)                          the first half of the kick
///   v += M^-1 J(x)^T lambda                     so that C = 0 after the drift, by Newton's method for lambda
///   x += h v,  q turns by h w                   the drift, as a free body would move
///   v += h/2 M^-1 f(x)                          the second half, with the forces at the new positions
///   v += M^-1 J(x)^T lambda                     so that J v = 0
///
/// The position has its own constraint, so no position error is fed back as a velocity and there is no beta. The step is
/// symmetric in time. Forces may depend on positions and time. Velocity-dependent forces, such as drag, reduce its order to 1.
///
/// Contacts are also solved in both stages (held_contacts.h), and so are limits, motors and springs (held_joints.h). Rows that
/// cannot be solved one kind at a time are solved together by newton_from_guess.h. An impact reduces the order of a step to 1,
/// unless `impacts` cuts the step there, and so does friction that changes its sign.
///
/// If Newton's method does not converge, the step is halved, and each half may be halved again. HalfStep refuses sleeping bodies and
/// springs whose force has a limit or that oscillate too fast for h. A composed step also refuses whatever does not run backwards in
/// time, which are damping and forces with limits.
class HalfStepIntegrator : public HalfStepSettings {
 public:
  std::optional<Impacts> impacts;  ///< how impacts are solved at which the step is cut; none: it is not cut
  int most_events = 64;            ///< impacts in a substep; after them contacts are held for the rest of it
  std::span<const Real> composition = one_step;  ///< the steps that make up a substep, see composition.h

  using HalfStepSettings::check;
  Plan plan(Real dt) const;
  static bool supports_joints() { return true; }
  void check(World& world, Real h);
  void after_detection(World& world, Real h);
  /// A step of h, with its own drift. Ignores `sweeps`. If the step does not converge, moves the bodies back to their old positions
  /// and throws InvalidInput.
  void solve(World& world, Real h, int sweeps);
  void end_detection(World& world);
  /// Restores the velocities of the bodies. `solve` leaves the bodies at their new positions with zero velocities, so that World::step
  /// does not move them.
  void after_move(World& world, Real h);
  SolveStats stats() const { return {motion_.rows(), motion_.speed_error()}; }

  /// A step of dt, s, as World::step takes it. If it does not converge, the bodies are restored, but contacts and forces are not.
  StepOutcome try_step(World& world, Real dt);

  // ---- of the latest step ---------------------------------------------------------------------------------------------
  /// How often a step was halved.
  int halvings() const { return motion_.halvings(); }
  /// The rounds of Newton's method in all substeps. 0 if contacts carry the same loads as before.
  int rounds() const { return motion_.rounds(); }
  /// Whether a single matrix of contacts would have taken more than an eighth of `most_work`.
  bool too_large() const { return motion_.contacts.too_large(); }
  /// The approximate multiplications of all systems and sweeps, including a step that failed.
  double work() const { return motion_.work(); }
  /// The number of impacts, whether `most_events` was reached, the kinetic energy that impacts dissipated (J), and whether contacts were
  /// held. Only with `impacts`. The energy is negative if Newton's rule and friction added energy, which happens only with joints.
  int events() const { return cuts_.events(); }
  bool bound_reached() const { return cuts_.bound_reached(); }
  Real dissipated_energy() const { return cuts_.dissipated_energy(); }
  bool contacts_held() const { return cuts_.contacts_held(); }

 private:
  bool run(World& world, Real h);
  bool holds_contacts() const { return composition.size() == 1; }

  KickDrift motion_;
  ImpactCuts cuts_;
  std::vector<BodyState> states_;  // of all bodies, at the beginning or at the end of the step
};

using HalfStep = SolverFrom<HalfStepIntegrator>;

/// A HalfStep that is cut at impacts.
HalfStep at_impacts(Impacts impacts = Impacts::simultaneous);
/// A fourth-order HalfStep, composed of second-order steps.
HalfStep composed(std::span<const Real> composition = suzuki);

}  // namespace pushback
