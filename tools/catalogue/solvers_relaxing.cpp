#include "pushback/chapters/14_joints_under_load/steady_joints.h"
#include "pushback/chapters/18_direct_joints/direct_joints.h"
#include "pushback/chapters/21_detected_once/detected_once.h"
#include "pushback/chapters/22_wide/wide.h"
#include "pushback/chapters/26_to_each_its_own/by_island.h"
#include "pushback/tools/catalogue/compile.h"

namespace pushback {

template struct Compiled<
    Substeps<RelaxingSolver<SplitJoints, Clamping, SoftContacts, Restitution, Friction, WarmStart>>>;
template struct Compiled<
    Substeps<RelaxingSolver<SteadyJoints, Clamping, SoftContacts, Restitution, Friction, WarmStart>>>;
template struct Compiled<
    Substeps<RelaxingSolver<Clamping, SoftContacts, Restitution, Friction, WarmStart, DirectJoints>>>;
template struct Compiled<Substeps<SteadyJointedSolver>>;
template struct Compiled<DetectedOnce>;
template struct Compiled<Wide<Real>>;
template struct Compiled<ByIsland>;

}  // namespace pushback
