/// The methods of this folder as solvers. Where they differ from chapter 08's by one effect, that is the only difference.
#pragma once

#include "pushback/chapters/04_slop/slop.h"
#include "pushback/tools/methods/avbd.h"
#include "pushback/tools/methods/conjugate_sweeps.h"
#include "pushback/tools/methods/exact_contact.h"
#include "pushback/tools/methods/manifolds.h"
#include "pushback/tools/methods/sap.h"
#include "pushback/tools/methods/shock_propagation.h"
#include "pushback/tools/methods/xpbd.h"

namespace pushback {

using ExactSolver = VisitingSolver<Clamping, Baumgarte, Slop, Restitution, WholeContacts, WarmStart>;
using BlockSolver = VisitingSolver<Clamping, Baumgarte, Slop, Restitution, Manifolds, FrictionCone, WarmStart>;
using ShockSolver = Solver<Clamping, Baumgarte, Slop, Restitution, FrictionCone, WarmStart, ShockPropagation>;
using ConjugateSolver = Solver<Clamping, Baumgarte, Slop, Restitution, FrictionCone, WarmStart, ConjugateSweeps>;

}  // namespace pushback
