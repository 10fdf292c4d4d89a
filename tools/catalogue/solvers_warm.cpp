#include "pushback/chapters/07_warm_start/scaled.h"
#include "pushback/chapters/09_impacts/sequential.h"
#include "pushback/chapters/14_joints_under_load/jointed_solver.h"
#include "pushback/tools/catalogue/compile.h"

namespace pushback {

template struct Compiled<JointedSolver>;
template struct Compiled<Substeps<JointedSolver>>;
template struct Compiled<Solver<SplitJoints, Clamping, Baumgarte, Slop, RestitutionFromSurface, Friction, WarmStart>>;
template struct Compiled<
    Substeps<Solver<SplitJoints, Clamping, Baumgarte, Slop, SequentialImpacts, Friction, ScaledWarmStart>>>;

}  // namespace pushback
