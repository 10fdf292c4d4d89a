#include "pushback/common/world/any_solver.h"

namespace pushback {

template void World::step(AnySolver& solver, Real dt, int sweeps);

}  // namespace pushback
