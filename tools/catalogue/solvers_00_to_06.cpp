#include "pushback/chapters/00_naive_impulses/naive.h"
#include "pushback/chapters/04_slop/slop.h"
#include "pushback/tools/catalogue/compile.h"

namespace pushback {

template struct Compiled<NaiveAveraged>;
template struct Compiled<Solver<Joints>>;
template struct Compiled<Solver<Joints, Clamping>>;
template struct Compiled<Solver<Joints, Clamping, Baumgarte>>;
template struct Compiled<Solver<Joints, Clamping, Baumgarte, Slop>>;
template struct Compiled<Solver<Joints, Clamping, Baumgarte, Slop, Restitution>>;
template struct Compiled<Solver<Joints, Clamping, Baumgarte, Slop, Restitution, Friction>>;

}  // namespace pushback
