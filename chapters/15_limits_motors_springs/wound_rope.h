/// A rope wound on a wheel. It only pulls, and the wheel pays out the length that the free end gains.
#pragma once

#include "pushback/chapters/15_limits_motors_springs/limits.h"

namespace pushback {

/// The direction in which the wheel turns about its axis to wind the rope up.
enum class Winding { forwards = 1, backwards = -1 };

/// The point T where a rope from a point P leaves a wheel, in the wheel's axes and from its centre.
///
///   T = R (cos alpha D^ + sigma sin alpha k x D^),   cos alpha = R / d         D = d D^: P without its component along the axis k
///   s = sqrt(d^2 - R^2) is the free length,  chi the angle of T on the wheel
struct WoundRope {
  Vec3 axis, across1, across2;  ///< k, and a basis across it: unit, right-handed
  Real radius;                  ///< R, m
  Real sigma;                   ///< 1 or -1, see Winding

  struct Tangent {
    Vec3 point;  ///< T, m
    Vec3 along;  ///< n, unit, from T to P
    Real free;   ///< s, m
    Real chi;    ///< rad, in (-pi, pi]
  };
  Tangent to(const Vec3& p) const {
    const Vec3 flat = p - p.dot(axis) * axis;
    const Real d = flat.norm();
    const Vec3 out = d > 0 ? Vec3(flat / d) : across1;
    const Real cosine = d > radius ? radius / d : 1;  // P inside the wheel counts as on the rim
    const Real sine = std::sqrt(1 - cosine * cosine);
    const Vec3 aside = sigma * axis.cross(out);
    const Vec3 from_centre = cosine * out + sine * aside;
    return {radius * from_centre, sine * out - cosine * aside, d * sine,
            std::atan2(from_centre.dot(across2), from_centre.dot(across1))};
  }
};

/// A rope of any length from the rim of a wheel, `radius` m from `centre`, to `point` of the load, taut for the current poses.
/// `centre`, `axis`, `point`: world axes. Lengths are measured in the wheel's plane. Throws InvalidInput if `point` is inside the
/// wheel.
///
///   C = L + sigma R chi - s >= 0,   C' = -n . (velocity of the load's P - velocity of the wheel there)
///
/// L is set so that C is 0 now. chi contains both the rotation of the wheel and the swing of the rope: in the wheel's axes only
/// the motion of P along n lengthens the rope. The force acts along one line, so it acts at P on both bodies.
inline Joint wound_rope(const World& world, int wheel, const Vec3& centre, const Vec3& axis, Real radius,
                        Winding winding, int load, const Vec3& point) {
  const std::string name = "a wound rope";
  check_joined(world, name, wheel, load);
  require_finite("centre of " + name, centre);
  require_finite("point of " + name, point);
  require_positive("radius of " + name, radius);
  const Body& carrier = body_of(world, wheel);
  const Quat to_wheel = carrier.orientation.conjugate();
  const Vec3 k = to_wheel * unit_axis(name, axis);
  const Tangents across = tangents_of(k);
  const WoundRope rope{k, across.tangent1, across.tangent2, radius, static_cast<Real>(winding)};
  const Vec3 middle = point_on(carrier, centre), on_load = point_on(body_of(world, load), point);
  const WoundRope::Tangent now = rope.to(point_on(carrier, point) - middle);
  if (!(now.free > 0)) {
    throw InvalidInput(
        fmt::format("{} of radius {} hangs from a point inside of the wheel: one outside is needed", name, radius));
  }
  const Real length = now.free - rope.sigma * radius * now.chi;

  const auto ask = [=, chi = CountedAngle(now.chi)](const Body& a, const Body& b, const TimeStep& moment,
                                                    Equations& equations) mutable {
    const Vec3 p = point_of(b, on_load);
    const WoundRope::Tangent tangent = rope.to(point_on(a, p) - middle);
    const Vec3 n = -(a.orientation * tangent.along);
    const Equation row{.jacobian = Jacobian::along(n, a, b, p)};
    const Real c = length + rope.sigma * radius * chi.count(tangent.chi) - tangent.free;
    equations.push_back(at_least_zero(row, c, moment.dt));
  };
  const auto line = [=](const Body& a, const Body& b) {
    const Vec3 p = point_of(b, on_load), to_p = point_on(a, p) - middle;
    const Vec3 beside = middle + to_p.dot(k) * k;  // drawn in the plane of the load
    std::vector<Vec3> corners{p};
    for (int i = 0; i <= 12; ++i) {  // and two thirds of a turn of the wound part
      const Quat on(Eigen::AngleAxis<Real>(rope.sigma * static_cast<Real>(i) * pi / 9, k));
      corners.push_back(point_of(a, beside + on * rope.to(to_p).point));
    }
    return corners;
  };
  return {name, wheel, load, ask, line};
}

}  // namespace pushback
