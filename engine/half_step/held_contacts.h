/// Contacts in two stages. After the drift no gap may be negative, and at its end no separating speed may be negative.
#pragma once

#include <optional>

#include "pushback/common/collision/broad_phase.h"
#include "pushback/engine/direct/warm_direct_contacts.h"
#include "pushback/engine/half_step/contact_sums.h"
#include "pushback/engine/half_step/stage_contacts.h"

namespace pushback {

/// The solver of chapter 17, for contacts that are solved up to rounding.
WarmDirectContacts exact_direct_contacts();

inline BodyPair pair_of(const Contact& at) {
  return {static_cast<int>(at.id.body_a), static_cast<int>(at.id.body_b)};
}

/// All contacts are solved together, and each stage starts from the impulses of the previous step:
///
///   positions     gap + h J v >= 0,  lambda >= 0      J: at the beginning of the drift
///   velocities    J v >= 0,          lambda >= 0      J: at the present positions, for contacts that touch there
///
/// with friction inside the cone in both. A sticking contact must not have slid at the end of the drift. A ball whose moments of
/// inertia differ changes w as it drifts. So if it rolls, the first stage solves, with r the arm of the contact,
///
///   J_t v + h/2 (a x r)_t = 0,   a = -I^-1 (w x I w)      for both bodies, which is the mean speed of the drift
///
/// Sliding friction depends on a velocity. It opposes the remaining slip in the second stage, and the slip before the step in the
/// first, lambda (n - mu t). Backwards in time the two slips are exchanged, so the step is also of second order if the slip changes
/// its direction. If friction would reverse the slip, the contact is tried as sticking.
///
/// A resting contact has the same impulses in all stages. So the guess is tried first, contact by contact and without rows. It is
/// applied to the bodies, and if every speed then satisfies the contact law, it is the solution. Constant impulses do not hold a
/// tall pile for ever, because rounding errors grow. Then Newton's method solves up to rounding again, or chapter 17's solver if
/// the guess is too far off. Such a solution also corrects the errors of many earlier stages. The next guess therefore adopts only
/// the part of the correction that belongs to this stage,
///
///   2 (1 - left / residual)      of the difference between solution and guess
///
/// where `left` is the residual of the previous stage. If the guess adopted all of it, its error would be as large in the opposite
/// direction, and a pyramid at rest would have to be solved in every fourth stage.
class HeldContacts {
 public:
  /// A gap up to this is rounding, m.
  static constexpr Real touch_distance = std::numeric_limits<Real>::digits > 24 ? Real(1e-9) : Real(1e-5);

  Real threshold = Real(0.1);  ///< m/s; slower impacts do not bounce
  double most_work = 1e10;     ///< approximate multiplications from one `begin` to the next, before a stage fails
  /// Whether a stage is solved without a guess (chapter 17) if Newton's method fails from the guess. If not, the stage fails.
  bool fall_back_to_full_solve = true;
  /// Contacts are held only for these pairs, ascending, or for all pairs if not given.
  std::optional<std::vector<BodyPair>> held_pairs;
  bool holds(const ContactId& id) const;

  /// Begins with World::contacts, which are for the present positions. Their previous impulses come from World::contacts_before.
  void begin(const World& world);
  /// Stores the approach speed and the slip of each touching contact at the start of a step.
  void store_approach(const World& world);
  /// The first stage. Returns false if it cannot be solved, and then `failure` gives the reason.
  bool solve_positions(World& world, Real h);
  /// Continues with World::contacts, which have been detected again at the present positions.
  void after_detection(const World& world);
  /// Announces that the drift after the next `solve_positions` will deepen this contact of World::contacts by `depth` m more than J and earlier
  /// calls predict, because the bodies rotate. `solve_positions` then requires a gap that is larger by `depth`.
  void expect_deepening(std::size_t contact, Real depth) { known_[contact].deepening += depth; }
  /// The second stage. Returns false as `solve_positions` does.
  bool solve_velocities(World& world, Real h);
  const std::string& failure() const { return failure_; }
  /// Adds an impulse that acted at a contact of World::contacts between two steps, N s, along its normal, its first and its second
  /// tangent. Call `store_approach` after the last one.
  void add_impact(const World& world, std::size_t contact, const Vec3& impulses);
  /// Adds to each body's acceleration (m/s^2) the acceleration by the held contacts, if they carry the same load as in the previous
  /// stage.
  void add_loads(const World& world, std::vector<Vec3>& accelerations) const;

  // ---- together with joints, where each stage has two parts and another solver runs in between -------------------
  void begin_positions(World& world, Real h);
  void end_positions(const World& world, Real h);
  void begin_velocities(World& world, Real h);
  void end_velocities(const World& world, Real h);
  /// Adds the rows of the contacts that take part. They start from the guess, which has been applied to the bodies.
  void add_to(NewtonFromGuess& newton, World& world) { stage_.add_to(newton, world); }
  /// Stores the impulses of these rows.
  void read_rows(const World& world) { stage_.read_rows(world); }
  /// Whether some contacts would now slide in the opposite direction. They are tried as sticking, and the rows must be rebuilt.
  bool release_reversed(const World& world) { return stage_.release_reversed(world); }
  /// Lets Coulomb's law decide which contacts slide, and in which direction. The rows must be rebuilt.
  void release_all() { stage_.release_all(); }

  /// Sets Contact::impulse to the sum since `begin`, projected to the present cone, and Contact::state. The next step starts from both.
  void report(World& world) const;
  /// Sets Contact::impulse to the sum since `begin`, and adds the contacts that have parted to World::contacts.
  void report_sums(World& world) const { sums_.write_to(world.contacts); }

  /// The number of matrices factored since `begin`. 0 if the guess was the solution.
  int factorizations() const { return newton_.factorizations; }
  /// Whether the first matrix since `begin` would have taken more than an eighth of most_work, so that it was not made.
  bool too_large() const { return newton_.too_large && newton_.factorizations == 0; }
  /// The multiplications that count towards most_work.
  double work_left() const { return newton_.work_left; }
  int rows() const { return 3 * static_cast<int>(stage_.size()); }

 private:
  struct ContactMemory {  // of one contact, found by its id
    ContactId id;
    Vec3 load = Vec3::Zero();              // N, in both stages of the previous substep
    Vec3 position_impulse = Vec3::Zero();  // N s, in the first stage
    Vec3 total = Vec3::Zero();             // N s, since `begin`, along the normal and both tangents of each stage
    Vec3 last = Vec3::Zero();              // N s, in the second stage
    Real approach = 0;                     // J v at the beginning of the step, m/s
    Vec3 slip = Vec3::Zero();              // u_t then, m/s
    bool pressed = false;                  // in the first stage
    Real deepening = 0;                    // m, see `expect_deepening`
    std::size_t sum = ContactSums::none;   // its place in sums_
  };
  bool solve(World& world, Real h);
  Vec3 adopted_impulse(const StageContact& at, Real h) const;
  bool solve_without_guess(World& world, Real h);

  WarmDirectContacts direct_ = exact_direct_contacts();
  NewtonFromGuess newton_;
  StageContacts stage_;
  double previous_residual_ = 0;  // m/s, the residual of the previous stage
  double adopted_fraction_ = 1;  // the fraction of the difference between solution and guess that the next guess adopts
  Contacts touching_;            // the touching contacts of stage_
  std::string failure_;
  std::vector<ContactMemory> known_, known_before_;  // of World::contacts, ascending
  ContactSums sums_;                                 // since `begin`
};

}  // namespace pushback
