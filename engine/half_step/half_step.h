/// Kick, drift, kick: a step of second order.
#pragma once

#include <span>

#include "pushback/common/world/step_solver.h"
#include "pushback/engine/half_step/held_contacts.h"
#include "pushback/engine/half_step/held_joints.h"

namespace pushback {

/// x += h v and the turn of h w, as a free body moves; I^-1 stays behind until it is refreshed.
void drift(Body& body, Real h);

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
/// Contacts are held in both stages as well, see held_contacts.h; so are limits, motors and springs, see held_joints.h. What
/// cannot be solved by itself is solved together: newton_from_guess.h. An impact within a step is of first order.
///
/// Where Newton's method does not get there, the step is divided in two, and these again. Refused are sleeping bodies, springs whose
/// force has a limit or that swing too fast for h, and in a composed step all that does not run backwards.
///   Andersen, "Rattle", J. Comput. Phys. 1983; Hairer, Lubich, Wanner, Geometric Numerical Integration, VII.1.
class HalfStep : public StepSolver {
 public:
  int substeps = 1;                                                                   ///< of each step
  Real tolerance = std::numeric_limits<Real>::digits > 24 ? Real(1e-8) : Real(2e-6);  ///< m or rad: the largest |C|
  int most_rounds = 20;        ///< of Newton's method, before a step is divided
  Real threshold = Real(0.1);  ///< m/s; what arrives slower does not bounce
  int most_halvings = 8;       ///< before it is refused: InvalidInput
  double most_work = 1e10;     ///< multiplications in a step, roughly; what needs more is refused
  bool from_afar = true;  ///< contacts are solved from nothing (17) where Newton's method fails; else that is refused

  /// Settings alone, of those above.
  void set_as(const HalfStep& other);
  /// Throws InvalidInput if one of them cannot be used.
  void check_settings() const;
  Plan plan(Real dt) const override;
  bool holds_joints() const override { return true; }
  void check(World& world, Real h) override;
  void detected(World& world, Real h) override;
  /// The whole step, with its own drift. `sweeps` do not matter.
  void solve(World& world, Real h, int sweeps) override;
  /// Contacts keep what they bore for the next step, and report what was given in this one.
  void done(World& world) override;
  /// World::step has moved the bodies, which `solve` left standing still where they are to be: they get their velocities.
  void moved(World& world, Real h) override;
  Solved solved() const override { return {joints_.rows() + contacts_.rows(), off_}; }
  /// In the latest step: how often one was divided in two.
  int halvings() const { return halvings_; }
  /// In the latest step: of Newton's method, all together. None where what contacts bore before is what they bear.
  int rounds() const { return rounds_ + contacts_.factored(); }
  /// Whether the latest step was refused because a single matrix of its contacts would take more than `most_work`.
  bool too_large() const { return contacts_.too_large(); }
  /// In the latest step: multiplications, roughly, of all systems and sweeps. A step that was refused has them, too.
  double work() const { return (most_work - together_.work) + (most_work - contacts_.work_left()); }

 protected:
  /// One after the other, in parts of a substep; they add up to 1. One that is negative goes back in time.
  virtual std::span<const Real> parts() const;
  /// A part of a substep, as it is or in pieces of its own: each is a call of this one.
  virtual void advance(World& world, Real h);

  struct Acceleration {
    Vec3 linear, angular;
  };
  bool holds_contacts() const;
  /// World::contacts, where a step of h s begins, and where a drift of h s has ended.
  virtual void begin_contacts(World& world, Real h);
  virtual void detect_contacts(World& world, Real h);
  /// By forces, where the bodies are, m/s^2 and rad/s^2.
  Acceleration acceleration(const World& world, std::size_t body) const;
  /// Multiplications of somebody else in this step. Throws InvalidInput where they are more than are left.
  void spend(double work);

  struct State {
    Vec3 velocity, angular_velocity, position;
    Quat orientation;
    explicit State(const Body& body);
    void give(Body& body) const;
  };
  /// Between two steps: all that a step changes.
  struct Moment {
    std::vector<Body> bodies;
    Contacts contacts;
    HeldContacts held;
    HeldJoints joints;
    std::vector<Acceleration> accelerations;
    Real time;
  };
  Moment moment(const World& world) const;
  void back_to(World& world, const Moment& moment);
  /// An impact, which takes no time: rows of contacts, all normals and then two tangents of each, with everything that joints hold
  /// meanwhile. False where that cannot be solved. `h`: of the step.
  bool strike(World& world, const Contacts& contacts, Rows& rows, Real h);

  HeldContacts contacts_;
  bool alone_ = true;          // nobody comes near anybody in the step: contacts are not even asked for
  std::vector<State> before_;  // the latest drift

 private:
  void halve(World& world, Real h, int halvings);
  bool step(World& world, Real h);
  void accelerate(World& world);
  void kick(World& world, Real h) const;
  static void keep(const World& world, std::vector<State>& states);
  static void give(World& world, const std::vector<State>& states);

  bool holds_together() const;
  bool press(World& world, Real h);
  void project(World& world, Real h);
  bool solve_together(World& world, Real h);
  static Margin margin(Real gravity, Real h);
  static bool moves(const World& world, Real h);

  HeldJoints joints_;
  NewtonFromGuess together_;
  std::vector<std::pair<Vec3, Vec3>> by_hand_;  // force and torque of each body; none where nobody has any
  std::vector<Acceleration> accelerations_;     // of each body, where it is; none where gravity is all
  std::vector<State> begun_;                    // the step
  std::vector<State> after_;                    // all steps
  Real time_ = 0;                               // s: of the bodies
  Real off_ = 0;
  int halvings_ = 0, rounds_ = 0;
};

}  // namespace pushback
