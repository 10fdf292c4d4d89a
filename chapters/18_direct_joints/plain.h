/// The direct solve of a hanging chain, as plain functions on 3 x 3 blocks.
#pragma once

#include <Eigen/LU>
#include <vector>

#include "pushback/common/basics/types.h"

namespace pushback::plain_18 {

/// A rigid link between two ball-and-socket joints, world axes. Link i hangs by joint i from link i - 1, and link 0 from the hook. The
/// lower end of the last link is free.
struct Link {
  Real mass;             // kg
  Mat3 inverse_inertia;  // 1/(kg m^2)
  Vec3 upper, lower;     // m, from its centre of mass to its joints
  Vec3 v, w;             // m/s, rad/s
};
using Chain = std::vector<Link>;

/// The velocity of the point at r from its centre of mass, m/s.
inline Vec3 velocity_at(const Link& link, const Vec3& r) {
  return link.v + link.w.cross(r);
}

/// The change of the velocity at `at` by an impulse of 1 N s at `by`, 1/kg.
inline Mat3 response(const Link& link, const Vec3& at, const Vec3& by) {
  return Mat3::Identity() / link.mass - skew(at) * link.inverse_inertia * skew(by);
}

/// A = J M^-1 J^T, 1/kg. Only neighbours share a link, so all other blocks are 0, and A_i+1,i is the transpose of A_i,i+1.
struct ChainMatrix {
  std::vector<Mat3> own, next;  // A_ii; A_i,i+1
};
inline ChainMatrix matrix_of(const Chain& chain) {
  ChainMatrix a;
  for (std::size_t i = 0; i < chain.size(); ++i) {
    a.own.push_back(response(chain[i], chain[i].upper, chain[i].upper));
    if (i == 0) continue;
    const Link& above = chain[i - 1];
    a.own[i] += response(above, above.lower, above.lower);
    a.next.push_back(-response(above, above.upper, above.lower));
  }
  return a;
}

/// A = L D L^T, eliminated from the free end to the hook.
struct Factors {
  std::vector<Mat3> mass;  // D_i^-1, the effective mass at joint i while all joints below it hold, kg
  std::vector<Mat3> l;     // L_i,i+1
};
inline Factors factor(ChainMatrix a) {
  Factors factors{std::vector<Mat3>(a.own.size()), std::vector<Mat3>(a.next.size())};
  for (std::size_t i = a.own.size(); i-- > 0;) {
    factors.mass[i] = a.own[i].inverse();
    if (i == 0) break;
    factors.l[i - 1] = a.next[i - 1] * factors.mass[i];
    a.own[i - 1] -= factors.l[i - 1] * a.next[i - 1].transpose();
  }
  return factors;
}

/// A lambda = x. Up the chain with L, across with D, down with L^T.
inline std::vector<Vec3> solve(const Factors& factors, std::vector<Vec3> x) {
  for (std::size_t i = x.size(); i-- > 1;) x[i - 1] -= factors.l[i - 1] * x[i];
  for (std::size_t i = 0; i < x.size(); ++i) x[i] = factors.mass[i] * x[i];
  for (std::size_t i = 1; i < x.size(); ++i) x[i] -= factors.l[i - 1].transpose() * x[i - 1];
  return x;
}

/// J V, the velocity of each link's upper end relative to the point from which it hangs, m/s.
inline std::vector<Vec3> separation(const Chain& chain) {
  std::vector<Vec3> speeds;
  for (std::size_t i = 0; i < chain.size(); ++i) {
    speeds.push_back(velocity_at(chain[i], chain[i].upper));
    if (i > 0) speeds[i] -= velocity_at(chain[i - 1], chain[i - 1].lower);
  }
  return speeds;
}

/// The impulses of the joints on the link below each, N s, after which no joint separates: A lambda = -J V.
inline std::vector<Vec3> impulses_of(const Chain& chain) {
  std::vector<Vec3> wanted = separation(chain);
  for (Vec3& speed : wanted) speed = -speed;
  return solve(factor(matrix_of(chain)), wanted);
}

}  // namespace pushback::plain_18
