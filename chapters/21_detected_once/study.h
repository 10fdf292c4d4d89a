/// Solvers to compare with chapter 21's, and the error that its rows neglect.
#pragma once

#include "pushback/chapters/11_substeps/substeps.h"
#include "pushback/chapters/21_detected_once/detected_once.h"

namespace pushback::detected_once_scenes {

/// The same solver with contacts detected in each substep.
using DetectedInEach = RelaxingSolver<SteadyJoints, Clamping, SoftContacts, Restitution, FrictionCone, WarmStart>;

/// The mistake to avoid is to make rows only for bodies that touch at the start of the step.
struct WithoutMargin : DetectedOnce {
  Plan plan(Real /*dt*/) const override { return {.substeps = substeps, .sweeps = 1}; }
};

/// The error of C_0 + J dX after t s, m, at a corner `arm` (m) above the centre of a box that turns at `spin` (rad/s).
///
///   C = C_0 + arm (cos w t - 1),  J dX = 0
inline Real neglected(Real arm, Real spin, Real t) {
  return arm * (1 - std::cos(spin * t));
}

}  // namespace pushback::detected_once_scenes
