/// Kick, drift, kick: a step of second order.
#pragma once

#include <span>

#include "pushback/common/world/step_solver.h"
#include "pushback/engine/half_step/composition.h"
#include "pushback/engine/half_step/impact_cuts.h"

namespace pushback {

/// The result of one attempt at a step.
struct StepOutcome {
  bool converged = false;
  double work = 0;        ///< multiplications, roughly
  Real energy_error = 0;  ///< as a fraction of what is allowed; see energy_control.h
};

/// A solver with an integrator of its own. World::step calls it at the usual times, and it does this:
///
///   v += h/2 M^-1 f(x)                          the first half of the kick
///   v += M^-1 J(x)^T lambda                     so that C = 0 after the drift: lambda by Newton's method
///   x += h v,  q turns by h w                   the drift, as a free body would move
///   v += h/2 M^-1 f(x)                          the second half, with the forces at the new place
///   v += M^-1 J(x)^T lambda                     so that J v = 0
///
/// The position is a separate constraint, so no error is fed back as a velocity and there is no beta. The step is the same
/// backwards in time. Forces may depend on positions and time. Velocity-dependent forces, such as drag, make it first order.
///
/// Contacts are also held in both stages (held_contacts.h), and so are limits, motors and springs (held_joints.h). Rows that
/// cannot be solved one kind at a time are solved together by newton_from_guess.h. An impact makes a step of first order, unless
/// `impacts` cuts the step there, and so does friction that changes sign.
///
/// Where Newton's method does not converge, the step is divided in two, and these again. HalfStep refuses sleeping bodies, springs whose
/// force has a limit or that oscillate too fast for h, and in a composed step everything that does not run backwards.
class HalfStep : public StepSolver, public HalfStepSettings {
 public:
  std::optional<Impacts> impacts;                ///< whether the step is cut at impacts, and how these are solved
  int most_events = 64;                          ///< impacts in a substep, before contacts are held for the rest of it
  std::span<const Real> composition = one_step;  ///< each substep: a composition of steps, see composition.h

  using HalfStepSettings::check;
  Plan plan(Real dt) const override;
  bool supports_joints() const override { return true; }
  void check(World& world, Real h) override;
  void after_detection(World& world, Real h) override;
  /// A step of h, with its own drift. `sweeps` is ignored. Throws InvalidInput if it does not converge, with the bodies back
  /// at their old places.
  void solve(World& world, Real h, int sweeps) override;
  void end_detection(World& world) override;
  /// World::step has moved the bodies, which `solve` left at rest at their new places. Gives them their velocities.
  void after_move(World& world, Real h) override;
  SolveStats stats() const override { return {motion_.rows(), motion_.speed_error()}; }

  /// A step of dt, s, as World::step takes it. If it does not converge, bodies are where they were, but contacts and forces are not.
  StepOutcome try_step(World& world, Real dt);

  // ---- of the latest step ---------------------------------------------------------------------------------------------
  /// How often a step was divided in two.
  int halvings() const { return motion_.halvings(); }
  /// Of Newton's method, all together. 0 if contacts bear the same loads as before.
  int rounds() const { return motion_.rounds(); }
  /// Whether a single matrix of contacts would have taken more than `most_work`.
  bool too_large() const { return motion_.contacts.too_large(); }
  /// Multiplications, roughly, of all systems and sweeps, including a step that failed.
  double work() const { return motion_.work(); }
  /// How often bodies met, whether `most_events` were too few, the kinetic energy that impacts dissipated (J), and whether contacts were
  /// held. Only with `impacts`. The energy is below 0 if Newton's rule and friction added some, which happens only with joints.
  int events() const { return cuts_.events(); }
  bool bound_reached() const { return cuts_.bound_reached(); }
  Real taken() const { return cuts_.taken(); }
  bool held() const { return cuts_.held(); }

 private:
  bool run(World& world, Real h);
  bool holds_contacts() const { return composition.size() == 1; }

  KickDrift motion_;
  ImpactCuts cuts_;
  std::vector<BodyState> states_;  // of all bodies, as the step began, or as it ended
};

/// HalfStep, cut at impacts.
HalfStep at_impacts(Impacts impacts = Impacts::simultaneous);
/// HalfStep, composed: of fourth order.
HalfStep composed(std::span<const Real> composition = suzuki);

}  // namespace pushback
