/// One half step of a world, as kick, drift and kick.
#pragma once

#include <string>

#include "pushback/engine/half_step/body_state.h"
#include "pushback/engine/half_step/half_step_settings.h"
#include "pushback/engine/half_step/held_contacts.h"
#include "pushback/engine/half_step/held_joints.h"

namespace pushback {

/// x += h v and the turn of h w, as a free body moves. I^-1 stays behind until it is refreshed.
void drift(Body& body, Real h);

/// The state of a step that is divided into half steps, for HalfStep and ImpactCuts. Functions that return false leave the reason
/// in `failure`, and the caller restores the world.
///   Andersen, "Rattle", J. Comput. Phys. 1983; Hairer, Lubich, Wanner, Geometric Numerical Integration, VII.1.
class KickDrift {
 public:
  struct Acceleration {
    Vec3 linear, angular;  // m/s^2, rad/s^2
  };
  /// Everything that a half step changes.
  struct Snapshot {
    std::vector<Body> bodies;
    Contacts contacts;
    HeldContacts held;
    HeldJoints joints;
    std::vector<Acceleration> accelerations;
    Real time;
  };

  HalfStepSettings settings;
  HeldContacts contacts;
  bool contact_free = true;  ///< no bodies come near each other in this step, so contacts are skipped
  bool cuts = false;         ///< ImpactCuts is at work: where no pair is held, only `near_pairs` are detected
  std::vector<BodyPair> near_pairs;
  bool detected_ahead = false;          ///< World::contacts lists what may touch in the next drift
  std::vector<BodyState> before_drift;  ///< each body, before the latest drift
  std::string failure;

  /// Throws InvalidInput if half steps cannot take this world. `backwards`: the step is composed of steps that go back in time.
  void check(const World& world, bool backwards);
  /// Begins a step of h, s, in which contacts are held if `with_contacts`. The bodies have the velocities from before gravity.
  void begin(World& world, Real h, bool with_contacts);
  /// A half step of h, divided where Newton's method does not converge.
  bool advance(World& world, Real h) { return halve(world, h, 0); }
  /// Writes the impulses of the step into joints and contacts.
  void report(World& world);

  /// Finds the contacts where a drift of h has ended.
  void detect_contacts(World& world, Real h);
  /// Finds what may touch in a drift of h from where the bodies are.
  void look_ahead(World& world, Real h);
  /// The margin of a drift of h, which is the distance by which two bodies may approach.
  static Margin margin(Real gravity, Real h);
  /// From forces, where the bodies are.
  Acceleration acceleration(const World& world, std::size_t body) const;
  /// Counts multiplications of the caller. False if they exceed what is left.
  bool spend(double work);
  double work_left() const { return settings.most_work - work(); }
  Snapshot snapshot(const World& world) const;
  void restore(World& world, const Snapshot& snapshot);
  /// An impact in a substep of h, with rows of all normals, then two tangents of each contact, and the joints. False if it cannot
  /// be solved.
  bool strike(World& world, const Contacts& at, Rows& rows, Real h);

  // ---- of the latest step ---------------------------------------------------------------------------------------------
  int halvings() const { return halvings_; }
  int rounds() const { return rounds_ + contacts.factored(); }
  double work() const { return (settings.most_work - together_.work) + (settings.most_work - contacts.work_left()); }
  int rows() const { return joints_.rows() + contacts.rows(); }
  Real speed_error() const { return speed_error_; }  ///< m/s

 private:
  bool halve(World& world, Real h, int halvings);
  bool step(World& world, Real h);
  void accelerate(World& world);
  void kick(World& world, Real h) const;
  bool solved_together() const;
  bool press(World& world, Real h);
  bool press_together(World& world, Real h);
  bool project(World& world, Real h);
  bool solve_together(World& world, Real h);
  void collect_rows(World& world);
  bool let_law_decide(World& world, Real h);

  HeldJoints joints_;
  NewtonFromGuess together_;
  std::vector<std::pair<Vec3, Vec3>> by_hand_;  // force and torque of each body; empty if no body has any
  std::vector<Acceleration> accelerations_;     // of each body, where it is; empty if only gravity acts
  std::vector<BodyState> begun_;                // the half step
  Real time_ = 0;                               // s: of the bodies
  Real speed_error_ = 0;
  int halvings_ = 0, rounds_ = 0;
};

}  // namespace pushback
