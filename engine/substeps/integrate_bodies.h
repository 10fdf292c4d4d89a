/// The positions and orientations of many bodies after a substep.
#pragma once

#include <span>

#include "pushback/common/world/world.h"
#include "pushback/engine/substeps/bundle.h"

namespace pushback {

/// x += h v, and the turn of a free body, for each of `bodies`: `integrate_position` of common/world. `turn` is Passes::turn, which turns
/// eight bodies at a time.
void integrate_bodies(std::span<Body> bodies, Real h, void (*turn)(EightRotations<Real>&, Real h));

}  // namespace pushback
