/// What the chapters up to this one come to, in one word.
#pragma once

#include "pushback/chapters/09_impacts/simultaneous.h"
#include "pushback/chapters/07_warm_start/scaled.h"
#include "pushback/chapters/08_friction_cone/friction_cone.h"
#include "pushback/chapters/11_substeps/substeps.h"

namespace pushback {

/// For 32 small steps of one sweep in 1/60 s. A pair of heavy on light, a blow, a tall stack, a slide at any heading:
/// what it holds, and which hard cases it does not, is in docs/hard_cases.md under "all together".
using SteadySolver = RelaxingSolver<Clamping, SoftContacts, SimultaneousImpacts, FrictionCone, ScaledWarmStart>;

}  // namespace pushback
