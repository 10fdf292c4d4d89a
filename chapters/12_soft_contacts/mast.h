/// The theory of a column of boxes on soft contacts as a mast, with its largest height and its bending.
#pragma once

#include "pushback/common/world/situations.h"

namespace pushback {

/// A mast stands on a fixed foot and carries its own weight. It can stand bent once c = q L^3 / EI is as large as this, and so it
/// buckles. q (N/m) is its weight per length, L (m) its length, and EI (N m^2) its bending stiffness.
/// Greenhill, "Determination of the greatest height ... a vertical pole or mast can be made", Proc. Cambridge Phil. Soc. 4, 1881.
inline constexpr Real greenhill = Real(7.83734744);

/// The shape of a buckling mast whose top is displaced by 1 m.
struct MastShape {
  Real aside;  ///< m
  Real slope;  ///< d aside / d up
};

/// The shape at the height `up`, 0 at the foot and 1 at the top. With s = 1 - up and the slope theta:
///
///   theta'' = -c s theta,  theta'(0) = 0      the weight above bends it, and at its top there is none
///   theta = sum_k a_k s^3k,  a_0 = 1,  a_k = -c a_(k-1) / ((3k - 1) 3k)
///   theta(1) = 0                              the mast is upright at the foot; the smallest such c is Greenhill's
inline MastShape mast_shape(Real up) {
  const Real s = 1 - up;
  Real a = 1, theta = 0, aside = 0, top = 0;
  for (int k = 0; k < 12; ++k) {  // a_12 is 1e-18
    const int n = 3 * k;
    if (k > 0) a *= -greenhill / static_cast<Real>((n - 1) * n);
    theta += a * std::pow(s, static_cast<Real>(n));
    aside += a * (1 - std::pow(s, static_cast<Real>(n + 1))) / static_cast<Real>(n + 1);
    top += a / static_cast<Real>(n + 1);
  }
  return {aside / top, theta / top};
}

/// The largest number of equal cubes that can stand on each other on contacts of w rad/s. A higher column buckles.
///
///   n^3 = 7.84 K_theta / (m g a)                           q = m g / a,  EI = K_theta a,  L = n a
///   K_theta = sum k x^2 = 4 (w^2 m / 8) (a / 2)^2          1/K = m / 8 at a corner that two cubes share
inline Real tallest_column(Real w, Real edge = 1) {
  return std::cbrt(greenhill / 8 * w * w * edge / World::g);
}

/// A stack of cubes of 1 m, as deep in contacts of w rad/s as their springs carry it, and bent like a buckling mast.
struct BentColumn {
  int boxes;
  Real w;
  Real aside = Real(0.01);  ///< m, displacement of the centre of its topmost box

  void operator()(World& world) const {
    stack(world, boxes);
    bend(world);
  }
  /// Bends a stack that is already in the world.
  void bend(World& world) const {
    const Real height = static_cast<Real>(boxes), yield = World::g / (w * w);
    const Real scale = aside / mast_shape(1 - Real(0.5) / height).aside;
    Real sunk = 0;
    for (int i = 0; i < boxes; ++i) {
      Body& body = world.bodies[static_cast<std::size_t>(i) + 1];
      const MastShape shape = mast_shape((static_cast<Real>(i) + Real(0.5)) / height);
      sunk += (i == 0 ? height : 2 * (height - static_cast<Real>(i))) * yield;
      body.position += Vec3(scale * shape.aside, -sunk, 0);
      body.turned(-scale * shape.slope / height, Vec3::UnitZ());
    }
  }
};

}  // namespace pushback
