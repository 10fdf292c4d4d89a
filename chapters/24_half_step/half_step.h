/// Kick, drift, kick: a step of second order.
#pragma once

#include <span>

#include "pushback/chapters/24_half_step/held_contacts.h"
#include "pushback/chapters/24_half_step/held_joints.h"
#include "pushback/common/world/step_solver.h"

namespace pushback {

/// In the place of a solver in World::step, of which it keeps the calls and not the order:
///
///   v += h/2 M^-1 f(x)                          half of the kick
///   v += M^-1 J(x)^T lambda                     so that C = 0 after the drift: lambda by Newton's method
///   x += h v,  q turns by h w                   the drift, as a free body would
///   v += h/2 M^-1 f(x)                          the other half, with the forces of the new place
///   v += M^-1 J(x)^T lambda                     so that J v = 0
///
/// The position is a constraint of its own, so no error is fed back as a velocity: there is no beta. Backwards in time
/// it is the same step. Forces are to depend on places and on time: one that depends on velocities, as drag does, is of first
/// order.
///
/// Contacts are held in both stages as well, see held_contacts.h. An impact within a step is of first order.
///
/// Where Newton's method does not get there, the step is divided in two, and these again. Refused are joints and contacts in the
/// same world, sleeping bodies, and joints with limits, limited forces or springs.
///   Andersen, "Rattle", J. Comput. Phys. 1983; Hairer, Lubich, Wanner, Geometric Numerical Integration, VII.1.
class HalfStep : public StepSolver {
 public:
  int substeps = 1;                                                                   ///< of each step
  Real tolerance = std::numeric_limits<Real>::digits > 24 ? Real(1e-8) : Real(2e-6);  ///< m or rad: the largest |C|
  int most_rounds = 20;        ///< of Newton's method, before a step is divided
  Real threshold = Real(0.1);  ///< m/s; what arrives slower does not bounce
  int most_halvings = 8;       ///< before it is refused: InvalidInput

  Plan plan(Real /*dt*/) const override { return {.sweeps = 1}; }
  bool holds_joints() const override { return true; }
  void check(World& world, Real h) override;
  void detected(World& world, Real h) override;
  /// The whole step, with its own drift. `sweeps` do not matter.
  void solve(World& world, Real h, int sweeps) override;
  /// World::step has moved the bodies, which `solve` left standing still where they are to be: they get their velocities.
  void moved(World& world, Real h) override;
  Solved solved() const override { return {joints_.rows() + contacts_.rows(), off_}; }
  /// In the latest step: how often one was divided in two.
  int halvings() const { return halvings_; }
  /// In the latest step: of Newton's method, all together.
  int rounds() const { return rounds_; }

 protected:
  /// One after the other, in parts of a substep; they add up to 1. One that is negative goes back in time.
  virtual std::span<const Real> parts() const;

 private:
  struct State {
    Vec3 velocity, angular_velocity, position;
    Quat orientation;
    explicit State(const Body& body);
    void give(Body& body) const;
  };
  struct Acceleration {
    Vec3 linear, angular;
  };
  void advance(World& world, Real h, int halvings);
  bool step(World& world, Real h);
  void accelerate(World& world);
  void kick(World& world, Real h) const;
  static void keep(const World& world, std::vector<State>& states);
  static void give(World& world, const std::vector<State>& states);

  bool holds_contacts(const World& world) const;
  static Margin margin(const World& world, Real h);

  HeldJoints joints_;
  HeldContacts contacts_;
  std::vector<std::pair<Vec3, Vec3>> by_hand_;  // force and torque of each body; none where nobody has any
  std::vector<Acceleration> accelerations_;     // of each body, where it is; none where gravity is all
  std::vector<State> begun_;                    // the step
  std::vector<State> before_;                   // the drift
  std::vector<State> after_;                    // all steps
  Real time_ = 0;                               // s: of the bodies
  Real off_ = 0;
  int halvings_ = 0, rounds_ = 0;
};

}  // namespace pushback
