#include "pushback/chapters/12_small_steps/steady_solver.h"
#include "pushback/chapters/13_global_solve/global_joints.h"
#include "pushback/chapters/catalogue/compile.h"

namespace pushback {

template struct Compiled<RelaxingSolver<SplitJoints, Clamping, SoftContacts, Restitution, Friction, WarmStart>>;
template struct Compiled<RelaxingSolver<SteadyJoints, Clamping, SoftContacts, Restitution, Friction, WarmStart>>;
template struct Compiled<RelaxingSolver<Clamping, SoftContacts, Restitution, Friction, WarmStart, GlobalJoints>>;
template struct Compiled<SteadyJointedSolver>;

}  // namespace pushback
