#include "pushback/chapters/05_restitution/in_turn.h"
#include "pushback/chapters/07_warm_start/scaled.h"
#include "pushback/chapters/09_joints/jointed_solver.h"
#include "pushback/chapters/catalogue/compile.h"

namespace pushback {

template struct Compiled<JointedSolver>;
template struct Compiled<Solver<SplitJoints, Clamping, Baumgarte, Slop, RestitutionFromSurface, Friction, WarmStart>>;
template struct Compiled<Solver<SplitJoints, Clamping, Baumgarte, Slop, ImpactsInTurn, Friction, ScaledWarmStart>>;

}  // namespace pushback
