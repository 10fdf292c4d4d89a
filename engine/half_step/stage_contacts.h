/// The contacts that take part in one stage of a half step, with their impulses and rows.
#pragma once

#include "pushback/engine/half_step/newton_from_guess.h"

namespace pushback {

struct StageContact {
  std::size_t index;     ///< in World::contacts
  Real bias;             ///< b of its normal, m/s
  Vec3 tangential_bias;  ///< b of its tangents, m/s, world axes
  Vec3 impulse;          ///< N s, on B, world axes
  Vec3 slip_direction;   ///< unit, opposite to friction; 0 if Coulomb's law decides the direction

  bool slides() const { return !slip_direction.isZero(0); }
};

/// The squared error of Coulomb's law for the speed u = J v + b (m/s, world axes), |r - Pi(r - s)|^2 with the symbols of
/// chapter 16's contact_problem.h. If the contact slides, only its normal counts.
Real squared_error(const Contact& contact, const StageContact& at, const Vec3& u);

/// A contact with a slip direction has one unknown, the normal impulse, because its impulse acts along n - mu slip_direction. Each other
/// contact has three, which Coulomb's law keeps inside the cone.
class StageContacts {
 public:
  void clear() { contacts_.clear(); }
  void add(const StageContact& contact) { contacts_.push_back(contact); }
  std::size_t size() const { return contacts_.size(); }
  std::vector<StageContact>::const_iterator begin() const { return contacts_.begin(); }
  std::vector<StageContact>::const_iterator end() const { return contacts_.end(); }

  /// Applies the impulses to the bodies. Impulses below `tolerance` times `unit()` become 0, because such a contact has parted.
  void apply_guess(World& world, double tolerance);
  /// The unit of residuals, m/s. It is the largest |J V + b| before the impulses were applied, and at least so large that the rounding
  /// of velocities is within the tolerance.
  double unit() const { return unit_; }
  /// Chapter 16's relative_residual of the worst contact. Infinite if a contact slides against its slip direction.
  double residual(const World& world) const;

  /// Makes the rows at the present positions, first all normals, then both tangents of each contact without a slip direction.
  void build_rows(World& world);
  /// Makes the rows and adds them to `newton`.
  void add_to(NewtonFromGuess& newton, World& world);
  Rows& rows() { return rows_; }
  /// Takes the impulses from the rows.
  void read_rows(const World& world);
  /// Removes the slip direction of each contact that slides against it. Returns whether there is one. If so, rebuild the rows.
  bool release_reversed(const World& world);
  /// Removes all slip directions. Rebuild the rows afterwards.
  void release_all();

 private:
  std::vector<StageContact> contacts_;
  Rows rows_;
  double unit_ = 1;
};

}  // namespace pushback
