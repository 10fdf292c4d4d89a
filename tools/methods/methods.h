/// The methods of this folder as solvers.
#pragma once

#include "pushback/chapters/04_slop/slop.h"
#include "pushback/chapters/08_friction_cone/friction_cone.h"
#include "pushback/tools/methods/avbd.h"
#include "pushback/tools/methods/conjugate_sweeps.h"
#include "pushback/tools/methods/sap.h"
#include "pushback/tools/methods/xpbd.h"

namespace pushback {

/// Differs from chapter 08's by one effect.
using ConjugateSolver = Solver<Clamping, Baumgarte, Slop, Restitution, FrictionCone, WarmStart, ConjugateSweeps>;

/// SAP with the friction that Drake has by default.
struct SapLagged : Sap {
  SapLagged() { lagged = true; }
};

}  // namespace pushback
