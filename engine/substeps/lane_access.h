/// Copies single vectors and matrices into a lane of a bundle, and back.
#pragma once

#include <cstddef>

#include "pushback/common/basics/types.h"
#include "pushback/engine/substeps/bundle.h"

namespace pushback {

template <class Scalar>
void write_lane(const Vec3& vector, EightVectors<Scalar>& to, std::size_t lane) {
  to.x.values[lane] = static_cast<Scalar>(vector.x());
  to.y.values[lane] = static_cast<Scalar>(vector.y());
  to.z.values[lane] = static_cast<Scalar>(vector.z());
}
template <class Scalar>
void write_lane(const Mat3& symmetric, EightSymmetricMatrices<Scalar>& to, std::size_t lane) {
  to.xx.values[lane] = static_cast<Scalar>(symmetric(0, 0));
  to.xy.values[lane] = static_cast<Scalar>(symmetric(0, 1));
  to.xz.values[lane] = static_cast<Scalar>(symmetric(0, 2));
  to.yy.values[lane] = static_cast<Scalar>(symmetric(1, 1));
  to.yz.values[lane] = static_cast<Scalar>(symmetric(1, 2));
  to.zz.values[lane] = static_cast<Scalar>(symmetric(2, 2));
}
template <class Scalar>
Vec3 read_lane(const EightVectors<Scalar>& from, std::size_t lane) {
  return {static_cast<Real>(from.x.values[lane]), static_cast<Real>(from.y.values[lane]),
          static_cast<Real>(from.z.values[lane])};
}

/// Writes each number to its place. A Twist that is built elsewhere and then copied would be read before its writes have left the
/// processor's store buffer, and the copy would wait for them.
template <class Scalar>
void write_twist(const Vec3& v, const Vec3& w, Twist<Scalar>& to) {
  for (int i = 0; i < 3; ++i) to.values[i] = static_cast<Scalar>(v[i]), to.values[3 + i] = static_cast<Scalar>(w[i]);
}
template <class Scalar>
Vec3 linear_of(const Twist<Scalar>& twist) {
  return {static_cast<Real>(twist.values[0]), static_cast<Real>(twist.values[1]), static_cast<Real>(twist.values[2])};
}
template <class Scalar>
Vec3 angular_of(const Twist<Scalar>& twist) {
  return {static_cast<Real>(twist.values[3]), static_cast<Real>(twist.values[4]), static_cast<Real>(twist.values[5])};
}
template <class Scalar>
Inertia<Scalar> inertia_of(const Mat3& m) {
  return {{static_cast<Scalar>(m(0, 0)), static_cast<Scalar>(m(0, 1)), static_cast<Scalar>(m(0, 2)),
           static_cast<Scalar>(m(1, 1)), static_cast<Scalar>(m(1, 2)), static_cast<Scalar>(m(2, 2))},
          {}};
}

}  // namespace pushback
