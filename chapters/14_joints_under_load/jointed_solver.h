/// The solver of chapters 01 to 07, with joints.
#pragma once

#include "pushback/chapters/07_warm_start/full_solver.h"
#include "pushback/chapters/14_joints_under_load/split_joints.h"

namespace pushback {

using JointedSolver = Solver<SplitJoints, Clamping, Baumgarte, Slop, Restitution, Friction, WarmStart>;

}  // namespace pushback
