/// Random numbers that are the same with every standard library: std::mt19937_64 is specified to the bit, the
/// distributions of <random> are not. And random bodies, made of them.
#pragma once

#include <cmath>
#include <cstdint>
#include <random>

#include "pushback/common/bodies/body.h"

namespace pushback {

class Random {
 public:
  explicit Random(std::uint64_t seed) : bits_(seed) {}

  Real between(Real low, Real high) {
    const double unit = static_cast<double>(bits_() >> 11) * 0x1p-53;  // [0, 1), every multiple of 2^-53 alike
    return low + (high - low) * static_cast<Real>(unit);
  }
  /// As often from 1 to 10 as from 10 to 100.
  Real over_decades(Real low, Real high) { return std::exp(between(std::log(low), std::log(high))); }
  std::size_t below(std::size_t count) { return static_cast<std::size_t>(bits_() % count); }
  Vec3 vector(Real largest) {  // one statement each: the order of a function's arguments is the compiler's choice
    const Real x = between(-largest, largest);
    const Real y = between(-largest, largest);
    const Real z = between(-largest, largest);
    return {x, y, z};
  }
  Vec3 direction() {
    for (;;) {
      const Vec3 v = vector(1);
      if (v.squaredNorm() > Real(0.01) && v.squaredNorm() <= 1) return v.normalized();
    }
  }
  Quat orientation() {
    for (;;) {
      const Real w = between(-1, 1);
      const Vec3 v = vector(1);
      const Quat q(w, v.x(), v.y(), v.z());
      if (q.squaredNorm() > Real(0.01) && q.squaredNorm() <= 1) return q.normalized();
    }
  }
  /// A sphere, a box or a capsule of 0.1 to 1 m and `mass` kg, however turned.
  Body body(Real mass) {
    const Real x = between(Real(0.1), 1), y = between(Real(0.1), 1), z = between(Real(0.1), 1);
    const std::size_t shape = below(3);
    Body made = shape == 0 ? sphere(x, mass) : shape == 1 ? box({x, y, z}, mass) : capsule(x, y, mass);
    const Real angle = between(-pi, pi);
    return made.turned(angle, direction());
  }
  /// The same somewhere within 2 m of the origin, with some velocity and spin.
  Body moving_body(Real mass) {
    Body made = body(mass);
    return made.at(vector(2)).moving(vector(5)).spinning(vector(5));
  }

  template <class Values>
  void shuffle(Values& values) {
    for (std::size_t i = values.size(); i > 1; --i) std::swap(values[i - 1], values[below(i)]);
  }

 private:
  std::mt19937_64 bits_;
};

}  // namespace pushback
