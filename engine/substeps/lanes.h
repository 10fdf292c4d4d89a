/// SIMD: several numbers as one value, and vectors of such values.
///
/// All functions are in an anonymous namespace, so that each file that includes this header has its own copy, compiled for its
/// processor.
#pragma once

#include "pushback/engine/substeps/bundle.h"

#ifdef __EMSCRIPTEN__
#include "pushback/engine/substeps/one_lane.h"
#else
#include <experimental/simd>

namespace pushback {
namespace {

namespace simd = std::experimental;

/// A vector of `width` numbers on all of which an operation acts at once. With a width of 1, it is a number.
template <class Real, int width>
using LanesOf = simd::simd<Real, simd::simd_abi::deduce_t<Real, width> >;

}  // namespace
}  // namespace pushback
#endif

namespace pushback {
namespace {

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
template <class Lanes>
Vec<Lanes> cross(const Vec<Lanes>& p, const Vec<Lanes>& q) {
  return {p.y * q.z - p.z * q.y, p.z * q.x - p.x * q.z, p.x * q.y - p.y * q.x};
}
template <class Lanes>
struct Symmetric {
  Lanes xx, xy, xz, yy, yz, zz;
  friend Vec<Lanes> operator*(const Symmetric& m, const Vec<Lanes>& p) {
    return {m.xx * p.x + m.xy * p.y + m.xz * p.z, m.xy * p.x + m.yy * p.y + m.yz * p.z,
            m.xz * p.x + m.yz * p.y + m.zz * p.z};
  }
};

/// `yes` in the lanes in which `so` is true, `no` in the others.
template <class Lanes>
Lanes select(const typename Lanes::mask_type& so, const Lanes& yes, Lanes no) {
  where(so, no) = yes;
  return no;
}
template <class Lanes>
Vec<Lanes> select(const typename Lanes::mask_type& so, const Vec<Lanes>& yes, const Vec<Lanes>& no) {
  return {select(so, yes.x, no.x), select(so, yes.y, no.y), select(so, yes.z, no.z)};
}

/// Loads as many of eight numbers as there are lanes, from index `at` on.
template <class Lanes, class Real>
Lanes load(const EightNumbers<Real>& from, int at) {
  return Lanes(from.values + at, simd::element_aligned);
}
template <class Lanes, class Real>
Vec<Lanes> load(const EightVectors<Real>& from, int at) {
  return {load<Lanes>(from.x, at), load<Lanes>(from.y, at), load<Lanes>(from.z, at)};
}
template <class Lanes, class Real>
Symmetric<Lanes> load(const EightSymmetricMatrices<Real>& from, int at) {
  return {load<Lanes>(from.xx, at), load<Lanes>(from.xy, at), load<Lanes>(from.xz, at),
          load<Lanes>(from.yy, at), load<Lanes>(from.yz, at), load<Lanes>(from.zz, at)};
}
template <class Lanes, class Real>
void store(const Lanes& lanes, EightNumbers<Real>& to, int at) {
  lanes.copy_to(to.values + at, simd::element_aligned);
}
template <class Lanes, class Real>
void store(const Vec<Lanes>& vectors, EightVectors<Real>& to, int at) {
  store(vectors.x, to.x, at);
  store(vectors.y, to.y, at);
  store(vectors.z, to.z, at);
}

}  // namespace
}  // namespace pushback
