/// Joints for substeps of one sweep.
#pragma once

#include "pushback/chapters/14_joints_under_load/split_joints.h"

namespace pushback {

/// For 32 substeps of one sweep in 1/60 s and a chain that carries a hundred times the mass of a link.
struct SteadyJoints : SplitJoints {
  SteadyJoints() { passes = 20; }
};

}  // namespace pushback
