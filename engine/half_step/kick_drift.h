/// Advances a world by half steps, each of which is a kick, a drift and a kick.
#pragma once

#include <string>

#include "pushback/engine/half_step/body_state.h"
#include "pushback/engine/half_step/half_step_settings.h"
#include "pushback/engine/half_step/held_contacts.h"
#include "pushback/engine/half_step/held_joints.h"

namespace pushback {

/// x += h v and the rotation by h w, as a free body moves. Does not refresh I^-1.
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
  bool cuts = false;         ///< whether ImpactCuts runs, so that only `near_pairs` are detected if no pair is held
  std::vector<BodyPair> near_pairs;
  bool detected_ahead = false;  ///< whether World::contacts includes the contacts that may touch in the next drift
  std::vector<BodyState> before_drift;  ///< each body, before the latest drift
  std::string failure;

  /// Throws InvalidInput if half steps cannot solve this world. `backwards`: whether some steps of the composition go back in time.
  void check(const World& world, bool backwards);
  /// Begins a step of h, s, in which contacts are held if `with_contacts`. The bodies have their velocities before gravity acts.
  void begin(World& world, Real h, bool with_contacts);
  /// A half step of h, halved if Newton's method does not converge.
  bool advance(World& world, Real h) { return step_or_halve(world, h, 0); }
  /// Writes the impulses of the step into joints and contacts.
  void report(World& world);

  /// Finds the contacts at the end of a drift of h.
  void detect_contacts(World& world, Real h);
  /// Finds the contacts that may touch in a drift of h from the present positions.
  void detect_ahead(World& world, Real h);
  /// The margin of a drift of h, which is the distance by which two bodies may approach. `gravity`: m/s^2.
  static Margin margin(Real gravity, Real h);
  /// The acceleration of a body by forces, at the present positions.
  Acceleration acceleration(const World& world, std::size_t body) const;
  /// Counts multiplications of the caller. Returns false if they exceed the rest.
  bool spend(double work);
  double work_left() const { return settings.most_work - work(); }
  Snapshot snapshot(const World& world) const;
  void restore(World& world, const Snapshot& snapshot);
  /// Solves an impact in a substep of h, with the rows of all normals, then two tangents of each contact, and with the joints. Returns
  /// false if it cannot be solved.
  bool solve_impact(World& world, const Contacts& at, Rows& rows, Real h);

  // ---- of the latest step ---------------------------------------------------------------------------------------------
  int halvings() const { return halvings_; }
  int rounds() const { return rounds_ + contacts.factorizations(); }
  double work() const {
    return (settings.most_work - together_.work_left) + (settings.most_work - contacts.work_left());
  }
  int rows() const { return joints_.rows() + contacts.rows(); }
  Real speed_error() const { return speed_error_; }  ///< m/s

 private:
  bool step_or_halve(World& world, Real h, int halvings);
  bool step(World& world, Real h);
  void accelerate(World& world);
  void kick(World& world, Real h) const;
  bool solved_together() const;
  bool solve_positions(World& world, Real h);
  bool solve_positions_together(World& world, Real h);
  bool solve_velocities(World& world, Real h);
  bool solve_together(World& world, Real h);
  void collect_rows(World& world);
  bool solve_without_slip_directions(World& world, Real h);

  HeldJoints joints_;
  NewtonFromGuess together_;
  std::vector<std::pair<Vec3, Vec3>> by_hand_;  // force and torque of each body, or empty if no body has any
  std::vector<Acceleration> accelerations_;     // of each body at its present position, or empty if only gravity acts
  std::vector<BodyState> begun_;                // each body at the beginning of the half step
  Real time_ = 0;                               // s, the time to which the bodies have been moved
  Real speed_error_ = 0;
  int halvings_ = 0, rounds_ = 0;
};

}  // namespace pushback
