/// Several numbers as one, and vectors of them.
///
/// In an anonymous namespace: each file that includes this has its own, made for the processor that it is compiled for.
#pragma once

#include <experimental/simd>

#include "pushback/chapters/22_wide/bundle.h"

namespace pushback {
namespace {

namespace simd = std::experimental;

/// `width` lanes: what is done to one of them is done to all. With one, it is a number.
template <class Real, int width>
using LanesOf = simd::simd<Real, simd::simd_abi::deduce_t<Real, width>>;

template <class Lanes>
struct Vec {
  Lanes x, y, z;
  friend Vec operator+(const Vec& p, const Vec& q) { return {p.x + q.x, p.y + q.y, p.z + q.z}; }
  friend Vec operator-(const Vec& p, const Vec& q) { return {p.x - q.x, p.y - q.y, p.z - q.z}; }
  friend Vec operator*(const Lanes& s, const Vec& p) { return {s * p.x, s * p.y, s * p.z}; }
};
template <class Lanes>
Lanes dot(const Vec<Lanes>& p, const Vec<Lanes>& q) {
  return p.x * q.x + p.y * q.y + p.z * q.z;
}

/// Lanes of eight numbers, from the one at `at` on.
template <class Lanes, class Real>
Lanes load(const Eight<Real>& from, int at) {
  return Lanes(from.of + at, simd::element_aligned);
}
template <class Lanes, class Real>
Vec<Lanes> load(const EightVectors<Real>& from, int at) {
  return {load<Lanes>(from.x, at), load<Lanes>(from.y, at), load<Lanes>(from.z, at)};
}
template <class Lanes, class Real>
void store(const Lanes& lanes, Eight<Real>& to, int at) {
  lanes.copy_to(to.of + at, simd::element_aligned);
}

}  // namespace
}  // namespace pushback
