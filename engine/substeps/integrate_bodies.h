/// The positions and orientations of many bodies after a substep.
#pragma once

#include <span>

#include "pushback/common/world/world.h"
#include "pushback/engine/substeps/bundle.h"

namespace pushback {

/// Moves each of `bodies` for h, s, as `integrate_position` of common/world does, but `turn`, which is Passes::turn, rotates eight
/// bodies at a time.
void integrate_bodies(std::span<Body> bodies, Real h, void (*turn)(EightRotations<Real>&, Real h));

}  // namespace pushback
