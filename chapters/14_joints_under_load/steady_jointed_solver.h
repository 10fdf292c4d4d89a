/// Chapter 12's solver for substeps, with joints.
#pragma once

#include "pushback/chapters/12_soft_contacts/steady_solver.h"
#include "pushback/chapters/14_joints_under_load/steady_joints.h"

namespace pushback {

using SteadyJointedSolver =
    RelaxingSolver<SteadyJoints, Clamping, SoftContacts, SimultaneousImpacts, FrictionCone, ScaledWarmStart>;

}  // namespace pushback
