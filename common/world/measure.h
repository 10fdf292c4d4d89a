/// Measures of a world: energies, momenta, overlap. SI units, world axes.
#pragma once

#include "pushback/common/world/world.h"

namespace pushback {

Real kinetic_energy(const World& world);    ///< J: sum of m v^2 / 2 + w . I w / 2
Real potential_energy(const World& world);  ///< J: sum of -m g . x, gravity only
Vec3 momentum(const World& world);          ///< N s
Vec3 angular_momentum(const World& world);  ///< N m s, about the world's origin: sum of x x m v + I w
Real deepest_overlap(const World& world);   ///< m, of the contacts of the latest step that have not parted; 0 if none
Real largest_speed(const World& world);     ///< m/s, of the centres of mass
Vec3 spin_momentum(const Body& body);       ///< N m s, I w; 0 for an immovable body
std::uint64_t hash_of(const World& world);  ///< FNV-1a over the bits of every body's state

}  // namespace pushback
