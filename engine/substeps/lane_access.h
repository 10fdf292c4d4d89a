/// Copies single vectors and matrices into a lane of a bundle, and back.
#pragma once

#include <cstddef>

#include "pushback/common/basics/types.h"
#include "pushback/engine/substeps/bundle.h"

namespace pushback {

template <class Scalar>
void write_lane(const Vec3& vector, EightVectors<Scalar>& to, std::size_t lane) {
  to.x.of[lane] = static_cast<Scalar>(vector.x());
  to.y.of[lane] = static_cast<Scalar>(vector.y());
  to.z.of[lane] = static_cast<Scalar>(vector.z());
}
template <class Scalar>
void write_lane(const Mat3& symmetric, EightSymmetric<Scalar>& to, std::size_t lane) {
  to.xx.of[lane] = static_cast<Scalar>(symmetric(0, 0));
  to.xy.of[lane] = static_cast<Scalar>(symmetric(0, 1));
  to.xz.of[lane] = static_cast<Scalar>(symmetric(0, 2));
  to.yy.of[lane] = static_cast<Scalar>(symmetric(1, 1));
  to.yz.of[lane] = static_cast<Scalar>(symmetric(1, 2));
  to.zz.of[lane] = static_cast<Scalar>(symmetric(2, 2));
}
template <class Scalar>
Vec3 read_lane(const EightVectors<Scalar>& from, std::size_t lane) {
  return {static_cast<Real>(from.x.of[lane]), static_cast<Real>(from.y.of[lane]), static_cast<Real>(from.z.of[lane])};
}

/// Writes each number to its place. A Twist that is built elsewhere and then copied would be read before its writes have left the
/// processor's store buffer, and the copy would wait for them.
template <class Scalar>
void write_twist(const Vec3& v, const Vec3& w, Twist<Scalar>& to) {
  for (int i = 0; i < 3; ++i) to.of[i] = static_cast<Scalar>(v[i]), to.of[3 + i] = static_cast<Scalar>(w[i]);
}
template <class Scalar>
Vec3 linear_of(const Twist<Scalar>& twist) {
  return {static_cast<Real>(twist.of[0]), static_cast<Real>(twist.of[1]), static_cast<Real>(twist.of[2])};
}
template <class Scalar>
Vec3 angular_of(const Twist<Scalar>& twist) {
  return {static_cast<Real>(twist.of[3]), static_cast<Real>(twist.of[4]), static_cast<Real>(twist.of[5])};
}
template <class Scalar>
Inertia<Scalar> inertia_of(const Mat3& m) {
  return {{static_cast<Scalar>(m(0, 0)), static_cast<Scalar>(m(0, 1)), static_cast<Scalar>(m(0, 2)),
           static_cast<Scalar>(m(1, 1)), static_cast<Scalar>(m(1, 2)), static_cast<Scalar>(m(2, 2))},
          {}};
}

}  // namespace pushback
