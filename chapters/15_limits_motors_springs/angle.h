/// The rotation of B relative to A: the angle of a hinge, a swing and a twist, and the rate of each.
#pragma once

#include <cmath>

#include "pushback/common/basics/input.h"
#include "pushback/common/world/joint.h"
#include "pushback/common/world/world.h"

namespace pushback {

/// theta' = gradient . (w_B - w_A), exactly, even if the bodies violate the joint.
struct Angle {
  Real value;     ///< theta, rad
  Vec3 gradient;  ///< world axes
};

/// The unit vector along an axis that a caller passed. Throws InvalidInput if the axis is 0 or not finite.
inline Vec3 unit_axis(const std::string& joint, const Vec3& axis) {
  require_finite("axis of " + joint, axis);
  require_positive("length of the axis of " + joint, axis.norm());
  return axis.normalized();
}

/// The equation of an angle: J = [ 0  -gradient  0  gradient ].
inline Equation turning(const Vec3& gradient) {
  return {.jacobian = Jacobian::about(gradient)};
}

/// The rotation of B relative to A about an axis fixed in A, in (-pi, pi]. It is 0 for the poses at construction.
///
///   p = u . t1,  q = u . t2,  theta = atan2(q, p)          u: fixed in B; t1, t2: fixed in A, across the axis
///   theta' = (p q' - q p') / (p^2 + q^2) = (w_B - w_A) . (u x (p t2 - q t1)) / (p^2 + q^2)
class HingeAngle {
 public:
  /// `axis`: unit, world axes.
  HingeAngle(const World& world, int a, int b, const Vec3& axis) {
    const Tangents across = tangents_of(axis);
    const Quat to_a = body_of(world, a).orientation.conjugate();
    t1_ = to_a * across.tangent1;
    t2_ = to_a * across.tangent2;
    u_ = body_of(world, b).orientation.conjugate() * across.tangent1;
  }
  Angle of(const Body& a, const Body& b) const {
    const Vec3 t1 = a.orientation * t1_, t2 = a.orientation * t2_, u = b.orientation * u_;
    const Real p = u.dot(t1), q = u.dot(t2), size = p * p + q * q;
    if (!(size > 0)) return {0, t1.cross(t2)};  // u is parallel to the axis, so the hinge is off by 90 degrees
    return {std::atan2(q, p), u.cross(p * t2 - q * t1) / size};
  }

 private:
  Vec3 t1_, t2_, u_;  // body axes
};

/// The rotation of B relative to A about an axis k fixed in A, without the swing of the axis, in [-pi, pi].
///
///   q_A* q_B = (w, v) in A's axes,   z = v . k,   theta = 2 atan2(z, w)
///   w' = -omega . v / 2,   z' = omega . (w k + v x k) / 2
///   theta' = omega . (w (w k + v x k) + z v) / (w^2 + z^2)
class TwistAngle {
 public:
  /// `axis`: unit, world axes.
  TwistAngle(const World& world, int a, int b, const Vec3& axis)
      : k_(body_of(world, a).orientation.conjugate() * axis),
        b_to_a_(body_of(world, b).orientation.conjugate() * body_of(world, a).orientation) {}

  Angle of(const Body& a, const Body& b) const {
    const Quat turn = a.orientation.conjugate() * b.orientation * b_to_a_;
    const Real sign = turn.w() < 0 ? Real(-1) : Real(1);  // q and -q are the same rotation, so take the shorter one
    const Real w = sign * turn.w();
    const Vec3 v = sign * turn.vec();
    const Real z = v.dot(k_), size = w * w + z * z;
    if (!(size > 0)) return {0, a.orientation * k_};  // the axis is reversed, so any twist is correct
    return {2 * std::atan2(z, w), a.orientation * ((w * (w * k_ + v.cross(k_)) + z * v) / size)};
  }

 private:
  Vec3 k_;       // in A's axes
  Quat b_to_a_;  // A's orientation in B's axes at construction
};

/// The angle between two directions (unit, world axes), s fixed in A and u fixed in B; in [0, pi].
///
///   theta = atan2(|s x u|, s . u),   theta' = (w_B - w_A) . (s x u) / |s x u|
inline Angle swing(const Vec3& s, const Vec3& u) {
  const Vec3 across = s.cross(u);
  const Real sine = across.norm();
  const Vec3 about = sine > 0 ? Vec3(across / sine) : tangents_of(s).tangent1;  // at 0 and pi, any axis across s
  return {std::atan2(sine, s.dot(u)), about};
}

/// Counts whole turns of an angle that is known only up to them: `count` returns the value nearest to the last one. The result is
/// right if the angle changes by less than pi between two calls. A second call with the same angle returns the same value.
class CountedAngle {
 public:
  explicit CountedAngle(Real first) : last_(first) {}
  Real count(Real angle) {
    last_ = angle + 2 * pi * std::round((last_ - angle) / (2 * pi));
    return last_;
  }

 private:
  Real last_;
};

}  // namespace pushback
