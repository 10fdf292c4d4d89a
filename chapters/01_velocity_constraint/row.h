/// One scalar constraint between two bodies, and the impulse that satisfies it.
///
///   J = [ -n  -(r_A x n)  n  (r_B x n) ]    V = (v_A, w_A, v_B, w_B)    target: J V + b = 0
///   lambda = -(J V + b) / K                 K = J M^-1 J^T              then:   V += M^-1 J^T lambda
///
/// This type serves every constraint. Constraints differ in J, in b, and in the interval [lo, hi] of the accumulated impulse of a
/// step.   Catto, "Modeling and Solving Constraints", GDC 2009.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "pushback/common/world/jacobian.h"
#include "pushback/common/world/world.h"

namespace pushback {

struct Row : Jacobian {
  Body *a, *b;
  Vec3 dva, dwa, dvb, dwb;                           // M^-1 J^T: the change of each velocity by an impulse of 1 N s
  Real effective_mass;                               // 1 / K, kg
  Real separation = 0;                               // C, the position error that b may feed back, m
  Real bias = 0;                                     // b, minus the target separating speed, m/s
  Real lo = -std::numeric_limits<Real>::infinity();  // limits of the accumulated impulse, N s
  Real hi = std::numeric_limits<Real>::infinity();
  Real impulse = 0;   // lambda, accumulated over the sweeps, N s
  std::size_t owner;  // index of the contact to which the row belongs

  Row(Body& first, Body& second, const Jacobian& jacobian, std::size_t index)
      : Jacobian(jacobian), a(&first), b(&second), owner(index) {
    weigh();
  }
  /// The row of a contact along a direction (unit, world axes), which is its normal or a tangent.
  Row(World& world, const Contact& at, const Vec3& direction, std::size_t index)
      : Row(world.bodies_of(at), at.point, direction, index) {}

  /// Computes M^-1 J^T and K from J and the present state of the bodies.
  void weigh() {
    dva = -a->inverse_mass * n;
    dwa = -a->inverse_inertia * ra_n;
    dvb = b->inverse_mass * n;
    dwb = b->inverse_inertia * rb_n;
    const Real linear = n.isZero(0) ? 0 : a->inverse_mass + b->inverse_mass;  // n is a unit vector
    effective_mass = 1 / (linear + rb_n.dot(dwb) - ra_n.dot(dwa));
  }
  /// Replaces J, for the same two bodies.
  void place(const Jacobian& jacobian) {
    Jacobian::operator=(jacobian);
    weigh();
  }
  /// J V, m/s.
  Real speed() const {
    return n.dot(b->velocity - a->velocity) + (rb_n.dot(b->angular_velocity) - ra_n.dot(a->angular_velocity));
  }
  /// V += M^-1 J^T lambda.   Always inlined, because g++ would call it in programs with many solvers.
  [[gnu::always_inline]] void apply(Real lambda) {
    Body &first = *a, &second = *b;
    first.velocity += lambda * dva;
    first.angular_velocity += lambda * dwa;
    second.velocity += lambda * dvb;
    second.angular_velocity += lambda * dwb;
  }
  /// Changes the accumulated impulse to `total`, or to the limit that is nearest. The limits are rarely reached, so processors
  /// predict the branch correctly. With std::clamp the sweep would be a quarter slower.
  void reach(Real total) {
    if (total < lo || total > hi) [[unlikely]]
      total = total < lo ? lo : hi;
    const Real lambda = total - impulse;
    impulse = total;
    apply(lambda);
  }
  /// The accumulated impulse that would make J V + b = 0 if no other row existed.
  Real wanted() const { return impulse - effective_mass * (speed() + bias); }
  void solve() { reach(wanted()); }
  /// The residual of the row, m/s, which is the change of J V that another `solve` would make.
  Real error() const { return std::abs(std::clamp(wanted(), lo, hi) - impulse) / effective_mass; }

 private:
  Row(const std::pair<Body&, Body&>& pair, const Vec3& point, const Vec3& direction, std::size_t index)
      : Row(pair.first, pair.second, Jacobian::along(direction, pair.first, pair.second, point), index) {}
};

using Rows = std::vector<Row>;

}  // namespace pushback
