/// The step that each island of a world gets.
#pragma once

#include <optional>
#include <vector>

#include "pushback/common/world/islands.h"

namespace pushback {

/// How a body is moved in a step.
enum class StepType {
  none,        ///< the body is immovable
  flight,      ///< along a parabola: nothing touches or holds it
  half_steps,  ///< chapter 24's, cut at impacts (25) if there may be some: few contacts, a tree of joints, or both
  substeps,    ///< chapter 22's: everything else
};

/// The limits between few contacts and many.
struct ClassifierLimits {
  int most = 8;  ///< contacts that touch, or may within the step: an island with no more gets half steps at any price
  int most_kept = 12;       ///< the same, if the island had half steps before, so that one contact more changes nothing
  int most_detections = 4;  ///< in a step, for substeps
  Real turn = Real(0.04);   ///< rad: in an island with many contacts, bodies that turn further in a step get substeps
  int most_meeting = 40;    ///< contacts of bodies that meet in one point each, such as balls, which part at once
};

/// m: how far the tips of a body may get in dt as it turns.
Real way_of_tips(const Body& body, Real dt);

/// Bodies that may touch in this step, or are joined, form an island (chapter 20). It gets
///
///   flight       if it is one body without a contact
///   half steps   if it has contacts, or rigid joints that form a tree, or few contacts and such joints
///   substeps     otherwise: if many bodies meet or turn fast, a Force may act, a body sleeps, the ground turns or moves in two ways, or
///                contacts overlap by more than half steps resolve soon
class StepClassifier {
 public:
  /// `contacts`: all within the margin, ascending. A contact that approaches faster than `threshold`, m/s, and may close within dt is an
  /// impact.
  void classify(const World& world, const Contacts& contacts, Real dt, Real threshold, const ClassifierLimits& limits);
  /// None for a body that `classify` did not see.
  StepType step_of(int body) const {
    return std::size_t(body) < step_of_.size() ? step_of_[std::size_t(body)] : StepType::none;
  }
  /// The lowest body of the island. The functions below take it as `island`.
  int island_of(int body) { return islands_.island_of(body); }
  /// Whether bodies may meet in this step.
  bool impact(int island) const { return at(island).impact; }
  /// Marks an island whose bodies met unexpectedly.
  void mark_impact(int island) { at(island).impact = true; }
  /// Whether any pair is within the margin. Joints may pull such a pair together.
  bool near(int island) const { return at(island).near > 0; }
  /// m: the sum over its contacts.
  Real overlap(int island) const { return at(island).overlap; }
  /// m: the deepest contact, 0 if none overlaps.
  Real deepest(int island) const { return at(island).deepest; }
  /// Contacts that may act in this step, and whether they are many.
  int contacts(int island) const { return at(island).contacts; }
  bool many_contacts(int island) const { return at(island).many; }
  /// For a body that half steps could not move, or not at this price.
  void leave_to_substeps(int body) { step_of_[std::size_t(body)] = StepType::substeps; }

 private:
  struct Island {
    int near = 0;                 // pairs within the margin
    int contacts = 0, pairs = 0;  // that may act in this step
    int joints = 0;
    Real overlap = 0, deepest = 0;        // m
    std::optional<Vec3> ground_velocity;  // m/s: of everything immovable that is near
    bool impact = false, refused = false, many = false, turns = false;
    bool kept = true;  // all of its bodies had half steps in the step before
  };
  Island& at(int island) { return by_island_[std::size_t(island)]; }
  const Island& at(int island) const { return by_island_[std::size_t(island)]; }
  Island& of_movable(const Body& a, const Body& b) { return at(island_of((a.movable() ? a : b).index)); }
  void read_contacts(const World& world, const Contacts& contacts, Real dt, Real threshold);
  void read_joints(const World& world);
  void read_bodies(const World& world, Real turn);  // rad/s
  static StepType step_for(Island& island, const ClassifierLimits& limits);

  Islands islands_;
  std::vector<int> all_;           // bodies
  std::vector<Island> by_island_;  // of each body that is the lowest of its island
  std::vector<StepType> step_of_;  // of each body
};

}  // namespace pushback
