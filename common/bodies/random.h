/// Random numbers that are the same with every standard library, and random bodies. The standard specifies std::mt19937_64 to
/// the bit, but not the distributions of <random>.
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
    const double unit = static_cast<double>(bits_() >> 11) * 0x1p-53;  // [0, 1), each multiple of 2^-53 equally likely
    return low + (high - low) * static_cast<Real>(unit);
  }
  /// Uniform in the logarithm: as often from 1 to 10 as from 10 to 100.
  Real over_decades(Real low, Real high) { return std::exp(between(std::log(low), std::log(high))); }
  std::size_t below(std::size_t count) { return static_cast<std::size_t>(bits_() % count); }
  Vec3 vector(Real largest) {  // one statement each, because the compiler chooses the order of a function's arguments
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
  /// A sphere, a box or a capsule of `mass` kg with radii, half-extents and a half-length of 0.1 to 1 m, turned at random.
  Body body(Real mass) {
    const Real x = between(Real(0.1), 1), y = between(Real(0.1), 1), z = between(Real(0.1), 1);
    const std::size_t shape = below(3);
    Body made = shape == 0 ? sphere(x, mass) : shape == 1 ? box({x, y, z}, mass) : capsule(x, y, mass);
    const Real angle = between(-pi, pi);
    return made.turned(angle, direction());
  }
  /// The same with coordinates of up to 2 m, and components of up to 5 m/s and 5 rad/s.
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
