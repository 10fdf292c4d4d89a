/// A rod whose lower end slides ahead of it: the scene, and what rigid bodies with Coulomb's friction must do there.
#pragma once

#include "pushback/common/world/world.h"

namespace pushback {

/// Painleve's paradox. In the plane of x and y, with the contact at r = (r_x, r_y) from the centre of mass, r_y < 0 < r_x, and
/// the tip sliding along +x, friction is -mu N and the normal force N changes the tip's normal speed by N dt times
///
///   k = K_nn - mu K_nt,   K_nn = 1/m + r_x^2 / I,   K_nt = -r_x r_y / I
///
/// For a thin uniform rod of length 2 l at the angle a to the ground, m k = 1 + 3 cos(a) (cos(a) - mu sin(a)): negative where
/// mu > (tan(a) + 4 / tan(a)) / 3, and that is least at tan(a) = 2, mu = 4/3. Where k < 0, pressing draws the tip into the
/// ground. No finite force keeps it out while it slides: with gravity, forces alone have no solution.
///
/// Impulses have one: an impact without collision. The tip stops at once, J V = 0 along both directions, which takes
/// lambda = -K^-1 (v_n, v_t). With v_n = 0 the part |lambda_t| / lambda_n is K_nn / K_nt: within the cone exactly where
/// k < 0. The impulse acts at the tip, so the angular momentum about it is conserved:
///
///   w = -(|r_y| v - r_x g t) m / (I + m r^2)       with the gravity of the time t, to first order
struct Paradox {
  Real normal_mass = 0;  ///< k, 1/kg
  Real cone_share = 0;   ///< K_nn / (mu K_nt): how much of the cone the impulse needs
  Real turning = 0;      ///< w about z after `time`, rad/s
};

/// The rod and the ground, mu = 2 between them.
void sliding_rod(World& world);
/// The edge by which it touches, of the world's latest body.
Vec3 tip_of(const World& world);
Paradox paradox_of(const World& world, Real time);

}  // namespace pushback
