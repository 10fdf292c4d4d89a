/// Contacts in two stages: gaps are not to be below 0 after the drift, and speeds not when it is over.
#pragma once

#include <optional>

#include "pushback/common/collision/broad_phase.h"
#include "pushback/engine/direct/warm_direct_contacts.h"
#include "pushback/engine/half_step/contact_sums.h"
#include "pushback/engine/half_step/stage_contacts.h"

namespace pushback {

/// Chapter 17's, for contacts that are to be solved as exactly as rounding lets them.
WarmDirectContacts exact_direct_contacts();

inline BodyPair pair_of(const Contact& at) {
  return {static_cast<int>(at.id.body_a), static_cast<int>(at.id.body_b)};
}

/// All contacts solved at once, in each stage from what they bore in the step before:
///
///   positions     gap + h J v >= 0,  lambda >= 0      along J where the drift begins
///   velocities    J v >= 0,          lambda >= 0      along J where the bodies are, for those that touch there
///
/// with friction inside the cone in both. What sticks is not to have slid when the drift ends. A ball whose moments of inertia differ
/// changes w as it drifts, so where it rolls the first stage asks, with r the arm of the contact,
///
///   J_t v + h/2 (a x r)_t = 0,   a = -I^-1 (w x I w)      of both bodies: the mean speed of the drift
///
/// Sliding friction depends on a velocity. In the second stage it is against the slip that is left, in the first against the slip
/// before the step, lambda (n - mu t): backwards in time each is the other, and the step is of second order where the slip turns,
/// too. Where that would turn a contact back, it is to stick if it can.
///
/// What rests has the same impulses in all stages. So the guess is looked at before anything else, contact by contact, without
/// rows: it is given to the bodies, and if every speed is then within the law, it is the solution. Impulses that stay the same do not
/// hold a tall pile for ever: what rounding leaves grows. Then Newton's method makes it right to rounding again; from afar,
/// chapter 17.
class HeldContacts {
 public:
  /// m: a gap that is rounding
  static constexpr Real touches = std::numeric_limits<Real>::digits > 24 ? Real(1e-9) : Real(1e-5);

  Real threshold = Real(0.1);  ///< m/s; what arrives slower does not bounce
  double most_work = 1e10;     ///< multiplications, roughly, from `begin` to `begin`, before a stage fails
  /// Solve from nothing (chapter 17) where Newton's method fails from the guess. Otherwise a stage fails there.
  bool fall_back_to_full_solve = true;
  /// Of these pairs alone, ascending, contacts are held; without, of all.
  std::optional<std::vector<BodyPair>> only;
  bool holds(const ContactId& id) const;

  /// World::contacts are those where the bodies are. What each bore in the latest step comes from World::contacts_before.
  void begin(const World& world);
  /// How fast what touches approaches and slips, as a step begins.
  void look(const World& world);
  /// The first stage. False if it cannot be solved; `failure` says why.
  bool press(World& world, Real h);
  /// World::contacts are those where the bodies are now.
  void after_detection(const World& world);
  /// The drift after the next `press` turns this contact of World::contacts in by `depth` m more than J and earlier calls account for.
  /// The press aims higher by that much.
  void bends(std::size_t contact, Real depth) { known_[contact].bends += depth; }
  /// The second. False as above.
  bool project(World& world, Real h);
  const std::string& failure() const { return failure_; }
  /// What has acted at a contact of World::contacts between two steps: N s along its normal, its first and its second tangent. `look`
  /// once all of it has.
  void add(const World& world, std::size_t contact, const Vec3& impulses);
  /// Adds to the acceleration of each body, m/s^2, what it has from contacts that are held, if they bear what they bore in the stage
  /// before.
  void add_borne(const World& world, std::vector<Vec3>& accelerations) const;

  // ---- together with joints: each stage in two parts, between which somebody else solves --------------------------
  void begin_pressing(World& world, Real h);
  void end_pressing(const World& world, Real h);
  void begin_projecting(World& world, Real h);
  void end_projecting(const World& world, Real h);
  /// Rows of what takes part, from the guess, which the bodies have.
  void add_to(NewtonFromGuess& newton, World& world) { stage_.add_to(newton, world); }
  /// What they came to.
  void take(const World& world) { stage_.read_rows(world); }
  /// Whether some would now slide the other way: those are to stick, if they can. Rows have to be made anew.
  bool turns_back(const World& world) { return stage_.release_reversed(world); }
  /// The law is to find out who slides, and where to. Rows have to be made anew.
  void find_out() { stage_.release_all(); }

  /// Contact::impulse: what acted since `begin`, drawn back to the cone of now; and Contact::state. From there the next step starts.
  void report(World& world) const;
  /// Contact::impulse: the momentum that was given since `begin`. What has parted is listed as well.
  void report_sums(World& world) const { sums_.write_to(world.contacts); }

  /// Matrices that were factored since `begin`. None where the guess was the solution.
  int factored() const { return newton_.factored; }
  /// Whether the first matrix since `begin` would have taken more than most_work, so that it was not made.
  bool too_large() const { return newton_.too_large && newton_.factored == 0; }
  /// Of most_work.
  double work_left() const { return newton_.work; }
  int rows() const { return 3 * static_cast<int>(stage_.size()); }

 private:
  struct ContactMemory {  // of a contact, by its id
    ContactId id;
    Vec3 borne = Vec3::Zero();            // N, in both stages of the substep before
    Vec3 pressing = Vec3::Zero();         // N s, in the first stage
    Vec3 total = Vec3::Zero();            // N s, since `begin`: along the normal and both tangents of each stage
    Vec3 last = Vec3::Zero();             // N s, in the second
    Real approach = 0;                    // J v as the step began, m/s
    Vec3 slip = Vec3::Zero();             // u_t then, m/s
    bool pressed = false;                 // in the first stage
    Real bends = 0;                       // m: by how much the next drift turns it further in than J says
    std::size_t sum = ContactSums::none;  // its place in sums_
  };
  bool solve(World& world, Real h);
  bool solve_from_nothing(World& world, Real h);

  WarmDirectContacts direct_ = exact_direct_contacts();
  NewtonFromGuess newton_;
  StageContacts stage_;
  Contacts touching_;  // those of stage_
  std::string failure_;
  std::vector<ContactMemory> known_, known_before_;  // of World::contacts, ascending
  ContactSums sums_;                                 // since `begin`
};

}  // namespace pushback
