/// A bead on a wire: the first constraint of all.
#pragma once

#include "pushback/common/basics/input.h"
#include "pushback/common/world/joint.h"
#include "pushback/common/world/world.h"

namespace pushback {

/// A curve in the plane z = 0, said by the function that is 0 on it.
struct Wire {
  std::function<Real(Real x, Real y)> c;         ///< C(x, y)
  std::function<Vec3(Real x, Real y)> gradient;  ///< (dC/dx, dC/dy, 0); not 0 on the wire
  std::vector<Vec3> drawn;                       ///< m, its corners, to be seen only
};

/// The body's centre of mass stays on the wire, and in its plane.
///
///   C(x, y) = 0,   C' = grad C . v:   J is the gradient, and what holds the bead acts along it, across the wire
///
/// Both are divided by |grad C|: then n is a unit vector, and the error near enough the distance from the wire, in m.
/// Catto, "Modeling and Solving Constraints", GDC 2009.
inline Joint bead_on(const World& world, const Wire& wire, int body) {
  check_joined(world, "a wire", the_world, body);
  if (!wire.c || !wire.gradient) throw InvalidInput("a wire has no C or no gradient: both are needed");
  const auto ask = [wire](const Body&, const Body& bead, const TimeStep&, Equations& equations) {
    const Real x = bead.position.x(), y = bead.position.y();
    const Vec3 gradient = wire.gradient(x, y);
    const Real size = gradient.norm();
    require_positive("size of the gradient of a wire", size);
    equations.push_back({.jacobian = {.n = gradient / size}, .error = wire.c(x, y) / size});
    equations.push_back({.jacobian = {.n = Vec3::UnitZ()}, .error = bead.position.z()});
  };
  return {"a wire", the_world, body, ask, [wire](const Body&, const Body&) { return wire.drawn; }};
}

}  // namespace pushback
