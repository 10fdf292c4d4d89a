/// Friction holds the contact point still, as far as the normal impulse lets it.
#pragma once

#include "chapters/05_restitution/restitution.h"

namespace pushback {

/// Appends its rows in `build`, and solves them in `sweep`: after the normals, whose impulses bound them.
///
/// Two rows along the tangents, b = 0:   |sum(lambda_t)| <= mu sum(lambda_n),   each by itself (a pyramid)
struct Friction : Effect {
  void build(const Contacts& contacts, Rows& rows, Real) {
    first_ = rows.size();
    mu_.clear();
    for (std::size_t i = 0; i < contacts.size(); ++i) {
      if (contacts[i].friction == 0) continue;  // no rows where none can act
      const auto [tangent1, tangent2] = tangents_of(contacts[i].normal);
      rows.emplace_back(contacts[i], tangent1, static_cast<int>(i));
      rows.emplace_back(contacts[i], tangent2, static_cast<int>(i));
      mu_.push_back(contacts[i].friction);
    }
  }
  /// The bound follows the normal impulse of this very sweep.
  void sweep(Rows& rows) {
    Row* tangent = rows.data() + first_;
    for (std::size_t i = 0; i < mu_.size(); ++i) {
      const Real bound = mu_[i] * rows[tangent->contact].impulse;
      for (int axis = 0; axis < 2; ++axis, ++tangent) {
        tangent->lo = -bound;
        tangent->hi = bound;
        tangent->solve();
      }
    }
    rows_solved += 2 * mu_.size();
  }
  void report(Contacts& contacts, const Rows& rows) {
    for (std::size_t i = 0; i < mu_.size(); ++i) {
      const Row& first = rows[first_ + 2 * i];
      const Row& second = rows[first_ + 2 * i + 1];
      const bool held = std::abs(first.impulse) < first.hi && std::abs(second.impulse) < second.hi;
      contacts[first.contact].state = held ? ContactState::sticking : ContactState::sliding;
    }
  }

 protected:
  std::size_t first_ = 0;  // of the tangent rows: two for each contact that can rub
  std::vector<Real> mu_;   // of those contacts; the first rows are the normals, so rows[tangent.contact] is its normal
};

}  // namespace pushback
