/// A rod whose lower end slides ahead of it, and the motion of rigid bodies with Coulomb friction in this scene.
#pragma once

#include "pushback/common/world/world.h"

namespace pushback {

/// Painleve's paradox. In the plane of x and y, with the contact at r = (r_x, r_y) from the centre of mass, r_y < 0 < r_x, and
/// the tip sliding along +x, friction is -mu N and the normal force N changes the tip's normal speed by N dt times
///
///   k = K_nn - mu K_nt,   K_nn = 1/m + r_x^2 / I,   K_nt = -r_x r_y / I
///
/// For a thin uniform rod of length 2 l at the angle a to the ground, m k = 1 + 3 cos(a) (cos(a) - mu sin(a)). This is negative if
/// mu > (tan(a) + 4 / tan(a)) / 3. The right side is smallest at tan(a) = 2, with mu = 4/3. If k < 0, a normal force accelerates the
/// tip into the ground. No finite force keeps it out while it slides, so with gravity there is no solution by forces only.
///
/// There is a solution by impulses, an impact without collision. The tip stops at once, J V = 0 along both directions, by
/// lambda = -K^-1 (v_n, v_t). With v_n = 0 the ratio |lambda_t| / lambda_n is K_nn / K_nt, which is within the cone if and only if
/// k < 0. The impulse acts at the tip, so the angular momentum about the tip is conserved:
///
///   w = -(|r_y| v - r_x g t) m / (I + m r^2)       including gravity over the time t, to first order
struct Paradox {
  Real normal_mass = 0;  ///< k, 1/kg
  Real cone_share = 0;   ///< K_nn / (mu K_nt), the tangential impulse as a fraction of the cone's limit
  Real turning = 0;      ///< w about z after `time`, rad/s
};

/// The rod and the ground, mu = 2 between them.
void sliding_rod(World& world);
/// The edge with which the last body of the world touches, m.
Vec3 tip_of(const World& world);
Paradox paradox_of(const World& world, Real time);

}  // namespace pushback
