/// A solver for all motions, of one body, of many, of what hangs.
#pragma once

#include "pushback/chapters/05_restitution/restitution.h"
#include "pushback/chapters/07_warm_start/warm_start.h"
#include "pushback/chapters/08_friction_cone/friction_cone.h"
#include "pushback/chapters/14_joints_under_load/split_joints.h"

namespace pushback {

using Jointed = Solver<SplitJoints, Clamping, Baumgarte, Restitution, FrictionCone, WarmStart>;

}  // namespace pushback
