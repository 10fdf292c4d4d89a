#include "pushback/chapters/14_joints_under_load/steady_joints.h"
#include "pushback/chapters/18_direct_joints/direct_joints.h"
#include "pushback/chapters/21_detected_once/detected_once.h"
#include "pushback/chapters/22_wide/recommended.h"
#include "pushback/tools/catalogue/compile.h"

namespace pushback {

template struct Compiled<RelaxingSolver<SplitJoints, Clamping, SoftContacts, Restitution, Friction, WarmStart>>;
template struct Compiled<RelaxingSolver<SteadyJoints, Clamping, SoftContacts, Restitution, Friction, WarmStart>>;
template struct Compiled<RelaxingSolver<Clamping, SoftContacts, Restitution, Friction, WarmStart, DirectJoints>>;
template struct Compiled<SteadyJointedSolver>;
template struct Compiled<DetectedOnce>;
template struct Compiled<Recommended>;

}  // namespace pushback
