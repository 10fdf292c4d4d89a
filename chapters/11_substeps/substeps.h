/// Many small steps instead of many sweeps.
#pragma once

#include "pushback/chapters/07_warm_start/full_solver.h"
#include "pushback/chapters/12_soft_contacts/soft_contacts.h"
#include "pushback/common/world/world.h"

namespace pushback {

/// A step of dt as `count` steps of dt / count, one sweep each. Contacts are found anew in every one of them.
/// Macklin et al., "Small Steps in Physics Simulation", SCA 2019.
template <class ContactSolver>
void substeps(World& world, ContactSolver& solver, Real dt, int count, int sweeps = 1) {
  for (int i = 0; i < count; ++i) world.step(solver, dt / static_cast<Real>(count), sweeps);
}

/// FullSolver with soft contacts in the place of Baumgarte and Slop.
using SoftSolver = RelaxingSolver<Clamping, SoftContacts, Restitution, Friction, WarmStart>;

}  // namespace pushback
