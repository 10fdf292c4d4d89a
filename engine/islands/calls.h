/// What each island of a world calls for.
#pragma once

#include <optional>
#include <vector>

#include "pushback/common/world/islands.h"

namespace pushback {

/// How a body is moved.
enum class MovedBy {
  nothing,     ///< it is immovable
  flight,      ///< along a parabola: nothing touches or holds it
  half_steps,  ///< chapter 24's, cut at impacts (25) where there may be some: few contacts, a tree of joints, or both
  substeps,    ///< chapter 22's: all else
};

/// From where an island counts as one of many contacts.
struct Limits {
  int most = 8;  ///< contacts that touch, or may within the step, of an island of few: it has half steps at any price
  int most_kept = 12;  ///< and of one that was one of few in the step before: a contact more or less changes nothing
  int most_detections = 4;  ///< in a step, for all else
  Real turn = Real(0.04);   ///< rad: where a body turns further in a step, what many contacts do changes within it
  int most_meeting = 40;    ///< where bodies meet that touch in one point each, as balls do: they part at once
};

/// m: how far the tips of a body may get in dt as it turns.
Real way_of_tips(const Body& body, Real dt);

/// Bodies that may touch in this step, or are joined, form an island (chapter 20). It calls for
///
///   flight       if it is one body, without a contact
///   half steps   if it has contacts, or rigid joints that form a tree; or both, if contacts are few
///   substeps     else: if many meet or turn fast, a Force may act, a body sleeps, ground turns or moves in two ways, or overlap is more
///                than half steps let out soon
class Calls {
 public:
  /// `contacts`: all within the margin, ascending. What arrives faster than `threshold`, m/s, within dt is an impact.
  void find(const World& world, const Contacts& contacts, Real dt, Real threshold, const Limits& limits);
  /// Of a body that was not there: nothing.
  MovedBy of(int body) const {
    return std::size_t(body) < moved_by_.size() ? moved_by_[std::size_t(body)] : MovedBy::nothing;
  }
  /// The lowest body of the island.
  int island_of(int body) { return islands_.island_of(body); }
  /// Whether bodies may meet in this step; `island`: its lowest body.
  bool impact(int island) const { return of_[std::size_t(island)].impact; }
  /// Marks an island whose bodies met unexpectedly.
  void have_met(int island) { of_[std::size_t(island)].impact = true; }
  /// Whether any are within the margin. Where joints pull them together, these may meet as well.
  bool near(int island) const { return of_[std::size_t(island)].near > 0; }
  /// m: of all of its contacts together.
  Real overlap(int island) const { return of_[std::size_t(island)].overlap; }
  /// m: of the deepest one, 0 where none overlap.
  Real deepest(int island) const { return of_[std::size_t(island)].deepest; }
  /// Contacts of the island that may act in this step, and whether they are more than a few.
  int contacts(int island) const { return of_[std::size_t(island)].contacts; }
  bool many(int island) const { return of_[std::size_t(island)].many; }
  /// What half steps were called for, and could not do, or not at this price.
  void leave_to_substeps(int body) { moved_by_[std::size_t(body)] = MovedBy::substeps; }

 private:
  struct Island {
    int near = 0;                 // pairs within the margin
    int contacts = 0, pairs = 0;  // that may act in this step
    int joints = 0;
    Real overlap = 0, deepest = 0;    // m
    std::optional<Vec3> ground_goes;  // m/s: all that is immovable and near
    bool impact = false, refused = false, many = false, turns = false;
    bool kept = true;  // all of its bodies had half steps in the step before
  };
  Island& of_movable(const Body& a, const Body& b) { return of_[std::size_t(island_of((a.movable() ? a : b).index))]; }
  void look_at_contacts(const World& world, const Contacts& contacts, Real dt, Real threshold);
  void look_at_joints(const World& world);
  void look_at_bodies(const World& world, Real turn);  // rad/s
  static MovedBy called_for(Island& island, const Limits& limits);

  Islands islands_;
  std::vector<int> all_;           // bodies
  std::vector<Island> of_;         // of each body that is the lowest of its island
  std::vector<MovedBy> moved_by_;  // each body
};

}  // namespace pushback
