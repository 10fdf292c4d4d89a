/// A bead on a wire, the simplest constraint.
#pragma once

#include "pushback/common/basics/input.h"
#include "pushback/common/world/joint.h"
#include "pushback/common/world/world.h"

namespace pushback {

/// A curve in the plane z = 0, given by a function that is 0 on the curve.
struct Wire {
  std::function<Real(Real x, Real y)> c;         ///< C(x, y)
  std::function<Vec3(Real x, Real y)> gradient;  ///< (dC/dx, dC/dy, 0); not 0 on the wire
  std::vector<Vec3> drawn;                       ///< m, corners of the line that is drawn
};

/// Keeps the body's centre of mass on the wire and in its plane.
///
///   C(x, y) = 0,   C' = grad C . v:   J is the gradient, so the impulse acts along it, across the wire
///
/// C and J are divided by |grad C|, so that n is a unit vector and the error approximates the distance from the wire, m.
/// Joint::ask throws InvalidInput where the gradient is 0.
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
