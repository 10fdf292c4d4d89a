/// Chooses the kind of step for each island of a world.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "pushback/common/world/islands.h"

namespace pushback {

/// How a body is moved in a step.
enum class StepType {
  none,        ///< the body is immovable
  flight,      ///< along a parabola, because the body has no contacts or joints
  half_steps,  ///< chapter 24's, cut at possible impacts (chapter 25), for few contacts, a tree of joints, or both
  substeps,    ///< chapter 22's, for everything else
};

/// Why an island gets its step. scene_questions.h puts it into words.
enum class StepReason : std::uint8_t {
  none,  ///< the body is immovable
  // flight
  no_contact,  ///< nothing touches or holds the body
  // half steps
  rigid_joints,      ///< joints form a tree, and no pair of bodies is nearby
  few_contacts,      ///< with or without such joints
  resting_contacts,  ///< many contacts, but without impacts and fast rotations
  single_contacts,   ///< many contacts, but each pair of bodies meets in one point, like balls
  // substeps, because of the contents of an island
  applied_force,        ///< a Force may act
  joint_loop,           ///< joints that form a loop
  joint_not_rigid,      ///< a limit, a motor or a spring
  asleep,               ///< a body sleeps
  moving_surface,       ///< an immovable body turns, or its surface does not move along its face
  unequal_grounds,      ///< immovable bodies move at different velocities, as in a press
  deep_overlap,         ///< an overlap that half steps would resolve too slowly
  contacts_and_joints,  ///< many contacts, and joints
  impact,               ///< many contacts, of which one is an impact
  fast_turn,            ///< many contacts, and a body turns fast
  large_pile,           ///< so many contacts that Fast moves the island; half steps may be tried once it is calm
  // substeps, because of half steps that were or would be tried
  no_savings,    ///< many contacts, but not enough savings to pay for half steps
  failed,        ///< half steps failed in this step
  failed_before  ///< and in an earlier step; they are not tried again yet
};
constexpr StepType type_of(StepReason reason) {
  if (reason == StepReason::none) return StepType::none;
  if (reason == StepReason::no_contact) return StepType::flight;
  return reason < StepReason::applied_force ? StepType::half_steps : StepType::substeps;
}

/// The limits between few contacts and many.
struct ClassifierLimits {
  int most = 8;             ///< contacts that touch or may touch in the step; with no more, half steps at any price
  int most_kept = 12;       ///< the same, if the island had half steps before, so that one contact more changes nothing
  int most_detections = 4;  ///< in a step, for substeps
  Real fast_turn =
      Real(0.04);  ///< rad per step; an island with many contacts and a body that turns faster gets substeps
  int most_single_contacts =
      40;  ///< contacts of pairs that meet in one point each, such as balls, which separate at once
  /// An island with at least this many contacts is large. The positions of its bodies cannot be predicted for a second, so only overlap,
  /// energy and rest matter. Fast moves such an island while it is in motion, unless it is more than `most_layers` bodies high. If Fast
  /// moved most of it in the previous step, half as many contacts are enough, and twice as many layers are allowed, because in a falling
  /// pile the shortest path of contacts to the ground is long for a moment.
  int large_pile = 256;
  int most_layers = 20;  ///< Fast's springs carry 24 boxes on top of each other (chapter 12, tall columns)
  /// The largest ratio of two masses near each other for which Fast moves a large island. A box sinks 0.07 mm into Fast's springs, and
  /// n times as deep under n times its own weight.
  Real most_mass_ratio = 30;
  Real calm_speed = Real(0.1);  ///< m/s, relative to the ground; if all bodies are slower, half steps may be tried
};

/// The distance by which the farthest points of a body may move in dt (s) due to its rotation, m.
Real way_of_tips(const Body& body, Real dt);

/// Bodies that may touch in this step, or are joined, form an island (chapter 20). The contents of an island determine its StepReason,
/// and the StepReason determines its StepType.
class StepClassifier {
 public:
  /// An island with a deeper overlap gets substeps, m. Half steps resolve a tenth of an overlap in 0.01 s, and only against gravity.
  static constexpr Real too_deep = Real(5e-3);

  /// `contacts`: all contacts within the margin, ascending. A contact that approaches faster than `threshold` (m/s) and may close within
  /// dt (s) is an impact.
  void classify(const World& world, const Contacts& contacts, Real dt, Real threshold, const ClassifierLimits& limits);
  /// How a body is moved in this step, or StepType::none if `classify` did not see the body.
  StepType step_of(int body) const { return type_of(reason_of(body)); }
  /// The reason for this step.
  StepReason reason_of(int body) const {
    return std::size_t(body) < reasons_.size() ? reasons_[std::size_t(body)] : StepReason::none;
  }
  /// The lowest index of a body's island. The functions below take it as `island`.
  int island_of(int body) { return islands_.island_of(body); }
  /// Whether bodies may meet in this step.
  bool impact(int island) const { return at(island).impact; }
  /// Whether Fast moved most of the island in the previous step, and may move it now.
  bool was_large(int island) const { return at(island).large && at(island).was_large(); }
  /// Whether Fast moves this body, if it gets substeps.
  bool is_moved_by_fast(int body) const { return std::size_t(body) < by_fast_.size() && by_fast_[std::size_t(body)]; }
  /// Marks an island whose bodies met unexpectedly.
  void mark_impact(int island) { at(island).impact = true; }
  /// Whether any pair is within the margin. Joints may pull such a pair together.
  bool near(int island) const { return at(island).near > 0; }
  /// The sum of the overlaps of the island's contacts, m.
  Real overlap(int island) const { return at(island).overlap; }
  /// The deepest overlap of the island, or 0 if none of its contacts overlaps, m.
  Real deepest(int island) const { return at(island).deepest; }
  /// The number of contacts that may act in this step, and whether they are many.
  int contacts(int island) const { return at(island).contacts; }
  bool many_contacts(int island) const { return at(island).many; }
  /// The limit above which they are many. It is 0 in a step whose bodies have met others too often.
  int contact_limit(int island) const { return at(island).limit; }
  /// The index of the force, joint or body that caused the StepReason.
  int cause(int island) const { return at(island).cause; }
  /// Gives substeps to a body that half steps could not move, or not within its budget.
  void leave_to_substeps(int body, StepReason reason) {
    reasons_[std::size_t(body)] = reason;
    by_fast_[std::size_t(body)] = at(island_of(body)).large;
  }

 private:
  struct Island {
    int near = 0;                 // pairs within the margin
    int contacts = 0, pairs = 0;  // that may act in this step
    int joints = 0;
    Real overlap = 0, deepest = 0;        // m
    std::optional<Vec3> ground_velocity;  // m/s, of all immovable bodies that are near
    Real fastest = 0;                     // m/s, the fastest body relative to the ground
    bool impact = false, many = false;
    bool large = false, may_be_large = true;
    bool kept = true;                       // whether all of its bodies had half steps in the previous step
    int bodies = 0, by_fast = 0;            // its movable bodies, and how many of them Fast moved in the previous step
    StepReason refused = StepReason::none;  // the first reason why half steps cannot move it
    int turning = -1;                       // the first body that turns fast
    int cause = -1;
    int limit = 0;  // see contact_limit

    bool was_large() const { return 2 * by_fast > bodies; }
    void refuse(StepReason why, int of = -1) {
      if (refused == StepReason::none) refused = why, cause = of;
      may_be_large &=
          why == StepReason::moving_surface || why == StepReason::unequal_grounds || why == StepReason::deep_overlap;
    }
  };
  Island& at(int island) { return by_island_[std::size_t(island)]; }
  const Island& at(int island) const { return by_island_[std::size_t(island)]; }
  Island& of_movable(const Body& a, const Body& b) { return at(island_of((a.movable() ? a : b).index)); }
  void read_contacts(const World& world, const Contacts& contacts, Real dt, Real threshold);
  void read_joints(const World& world);
  void read_bodies(const World& world, Real turn);  // rad/s
  void find_large(const World& world, const Contacts& contacts, const ClassifierLimits& limits);
  static StepReason reason_for(Island& island, const ClassifierLimits& limits);

  Islands islands_;
  std::vector<int> all_;             // indices of its bodies
  std::vector<Island> by_island_;    // by the lowest body of each island
  std::vector<StepReason> reasons_;  // of each body
  std::vector<bool> by_fast_;        // of each body
};

}  // namespace pushback
