#include "pushback/chapters/08_friction_cone/friction_cone.h"
#include "pushback/chapters/10_position_correction/nonlinear_gauss_seidel.h"
#include "pushback/chapters/10_position_correction/split_impulse.h"
#include "pushback/chapters/14_joints_under_load/jointed_solver.h"
#include "pushback/tools/catalogue/compile.h"

namespace pushback {

template struct Compiled<Solver<SplitJoints, Clamping, Baumgarte, Slop, Restitution, FrictionCone, WarmStart>>;
template struct Compiled<CorrectingSolver<SplitJoints, Clamping, SplitImpulse, Slop, Restitution, Friction, WarmStart>>;
template struct Compiled<
    CorrectingSolver<SplitJoints, Clamping, NonlinearGaussSeidel, Slop, Restitution, Friction, WarmStart>>;

}  // namespace pushback
