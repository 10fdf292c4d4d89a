/// One scalar constraint between two bodies, and the impulse that satisfies it.
///
///   J = [ -n  -(r_A x n)  n  (r_B x n) ]    V = (v_A, w_A, v_B, w_B)    want: J V + b = 0
///   lambda = -(J V + b) / K                 K = J M^-1 J^T             then: V += M^-1 J^T lambda
///
/// The same type serves every constraint: they differ in J, in b, and in the interval [lo, hi] in which the sum of all
/// impulses of a step has to stay.   Catto, "Modeling and Solving Constraints", GDC 2009.
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
  Vec3 dva, dwa, dvb, dwb;                           // M^-1 J^T: what an impulse of 1 N s adds to each velocity
  Real effective_mass;                               // 1 / K, kg
  Real separation = 0;                               // C, m: the position error that b may feed back
  Real bias = 0;                                     // b, m/s: minus the target separating speed
  Real lo = -std::numeric_limits<Real>::infinity();  // limits of the accumulated impulse, N s
  Real hi = std::numeric_limits<Real>::infinity();
  Real impulse = 0;   // lambda, accumulated over the sweeps, N s
  std::size_t owner;  // index of what it belongs to: of the contact

  Row(Body& first, Body& second, const Jacobian& jacobian, std::size_t index)
      : Jacobian(jacobian), a(&first), b(&second), owner(index) {
    weigh();
  }
  /// For a contact, along a direction (unit, world axes), which is its normal or a tangent.
  Row(World& world, const Contact& at, const Vec3& direction, std::size_t index)
      : Row(world.bodies_of(at), at.point, direction, index) {}

  /// M^-1 J^T and K, of J and of the bodies as they lie now.
  void weigh() {
    dva = -a->inverse_mass * n;
    dwa = -a->inverse_inertia * ra_n;
    dvb = b->inverse_mass * n;
    dwb = b->inverse_inertia * rb_n;
    const Real linear = n.isZero(0) ? 0 : a->inverse_mass + b->inverse_mass;  // n is a unit vector
    effective_mass = 1 / (linear + rb_n.dot(dwb) - ra_n.dot(dwa));
  }
  /// Another J, for the same two bodies.
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
  /// Brings the sum to `total`, or as near as the limits let it. A branch, since the limits are rarely met: a processor
  /// that guesses so goes on without waiting. std::clamp makes the sweep a quarter slower.
  void reach(Real total) {
    if (total < lo || total > hi) [[unlikely]]
      total = total < lo ? lo : hi;
    const Real lambda = total - impulse;
    impulse = total;
    apply(lambda);
  }
  /// The sum that would make J V + b = 0 if no other row existed.
  Real wanted() const { return impulse - effective_mass * (speed() + bias); }
  void solve() { reach(wanted()); }
  /// How far the row is from being solved, m/s: the change of J V that another `solve` would make.
  Real error() const { return std::abs(std::clamp(wanted(), lo, hi) - impulse) / effective_mass; }

 private:
  Row(const std::pair<Body&, Body&>& pair, const Vec3& point, const Vec3& direction, std::size_t index)
      : Row(pair.first, pair.second, Jacobian::along(direction, pair.first, pair.second, point), index) {}
};

using Rows = std::vector<Row>;

}  // namespace pushback
