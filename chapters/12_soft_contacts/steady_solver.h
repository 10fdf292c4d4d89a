/// The solver of chapters 01 to 12 as one type.
#pragma once

#include "pushback/chapters/07_warm_start/scaled.h"
#include "pushback/chapters/08_friction_cone/friction_cone.h"
#include "pushback/chapters/09_impacts/simultaneous.h"
#include "pushback/chapters/11_substeps/substeps.h"
#include "pushback/chapters/12_soft_contacts/soft_contacts.h"

namespace pushback {

/// For 32 substeps of one sweep in 1/60 s. Which hard cases it passes (heavy on light, impacts, tall stacks, slides in any
/// direction), and which it does not, is in docs/hard_cases.md under "all together".
using SteadySolver = RelaxingSolver<Clamping, SoftContacts, SimultaneousImpacts, FrictionCone, ScaledWarmStart>;

}  // namespace pushback
