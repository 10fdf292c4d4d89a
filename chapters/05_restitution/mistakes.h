/// Other ways to apply restitution. Two of them are mistakes, and one applies it in a separate pass.
#pragma once

#include "pushback/chapters/05_restitution/restitution.h"

namespace pushback {

/// The mistake to avoid is to add bounce and push-out.
struct RestitutionAdded : Effect {
  void build(StepContext& step) {
    for (std::size_t i = 0; i < step.contacts.size(); ++i) {
      const Real approach = approach_speed(step.world, step.contacts[i]);
      if (approach < 0) step.rows[i].bias += step.contacts[i].restitution * approach;
    }
  }
};

/// A smaller mistake is to read the approach speed after this step's gravity has been added, because the ball has not fallen by
/// that gravity yet.
struct RestitutionWithGravity : Effect {
  Real threshold = 0;
  void build(StepContext& step) {
    for (std::size_t i = 0; i < step.contacts.size(); ++i) {
      Row& normal = step.rows[i];
      const Real approach = normal.speed();
      if (approach < -threshold) normal.bias = std::min(normal.bias, step.contacts[i].restitution * approach);
    }
  }
};

/// Applies the bounce in a separate pass. The sweeps stop the approach and push out. After the last sweep this pass adds the bounce.
struct RestitutionApart : Effect {
  std::vector<Real> departure;
  void build(StepContext& step) {
    departure.clear();
    for (const Contact& contact : step.contacts)
      departure.push_back(-contact.restitution * std::min(Real(0), approach_speed(step.world, contact)));
  }
  void finish(StepContext& step) {
    for (std::size_t i = 0; i < departure.size(); ++i) {
      Row& normal = step.rows[i];
      if (normal.impulse == 0 || departure[i] == 0) continue;
      normal.bias = -departure[i];
      normal.solve();
      ++rows_solved;
    }
  }
};

}  // namespace pushback
