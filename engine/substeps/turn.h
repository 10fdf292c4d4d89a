/// The free rotation of several bodies at a time. `spin_freely` of common/world explains the equation.
///
/// In an anonymous namespace, as lanes.h.
#pragma once

#include <limits>

#include "pushback/engine/substeps/lanes.h"

namespace pushback {
namespace {

/// A unit quaternion with the vector part v and the scalar part s.
template <class Lanes>
struct Orientation {
  Vec<Lanes> v;
  Lanes s;
};
/// Rotates a vector from body axes into world axes.
template <class Lanes>
[[gnu::always_inline]] inline Vec<Lanes> rotated(const Orientation<Lanes>& q, const Vec<Lanes>& p) {
  const Vec<Lanes> twice = Lanes(2) * cross(q.v, p);
  return p + q.s * twice + cross(q.v, twice);
}
/// Rotates a vector from world axes into body axes.
template <class Lanes>
[[gnu::always_inline]] inline Vec<Lanes> rotated_back(const Orientation<Lanes>& q, const Vec<Lanes>& p) {
  const Vec<Lanes> twice = Lanes(2) * cross(q.v, p);
  return p - q.s * twice + cross(q.v, twice);
}
/// q' = normalise(q + h/2 q (0, w)).   `half`: h/2 w, body axes.
template <class Lanes>
[[gnu::always_inline]] inline Orientation<Lanes> turned(const Orientation<Lanes>& q, const Vec<Lanes>& half) {
  const Vec<Lanes> v = q.v + q.s * half + cross(q.v, half);
  const Lanes s = q.s - dot(q.v, half), by = Lanes(1) / sqrt(dot(v, v) + s * s);
  return {by * v, by * s};
}
template <class Lanes>
[[gnu::always_inline]] inline Vec<Lanes> each_times(const Vec<Lanes>& p, const Vec<Lanes>& q) {
  return {p.x * q.x, p.y * q.y, p.z * q.z};
}

/// Solves p_m = p + h/2 p_m x w_m by Newton's method. `d` is h/2 times the differences of the inverse moments of inertia, so
/// that h/2 p_m x w_m = (d.x p.y p.z, d.y p.z p.x, d.z p.x p.y). A lane that is solved stays as it is while others go on, so
/// its bits do not depend on them.
template <class Lanes>
[[gnu::always_inline]] inline Vec<Lanes> midway(const Vec<Lanes>& p, const Vec<Lanes>& d,
                                                typename Lanes::mask_type going) {
  using Real = typename Lanes::value_type;
  constexpr Real enough = std::numeric_limits<Real>::epsilon() * std::numeric_limits<Real>::epsilon();
  const Lanes least = Lanes(enough) * dot(p, p), most(std::numeric_limits<Real>::max()), one(1);
  Vec<Lanes> m = p;
  for (int i = 0; i < 8; ++i) {
    const Vec<Lanes> error{m.x - p.x - d.x * m.y * m.z, m.y - p.y - d.y * m.z * m.x, m.z - p.z - d.z * m.x * m.y};
    const Lanes xy = -d.x * m.z, xz = -d.x * m.y, yx = -d.y * m.z, yz = -d.y * m.x, zx = -d.z * m.y,
                zy = -d.z * m.x;  // the derivative, whose diagonal is 1
    const Lanes cxx = one - yz * zy, cxy = yz * zx - yx, cxz = yx * zy - zx;
    const Lanes by = one / (cxx + xy * cxy + xz * cxz);
    const Vec<Lanes> correction{by * (cxx * error.x + (xz * zy - xy) * error.y + (xy * yz - xz) * error.z),
                                by * (cxy * error.x + (one - xz * zx) * error.y + (xz * yx - yz) * error.z),
                                by * (cxz * error.x + (xy * zx - zy) * error.y + (one - xy * yx) * error.z)};
    const Lanes size = dot(correction, correction);
    going = going && most >= size;  // false if it is not a number
    m = select(going, m - correction, m);
    going = going && size > least;
    if (none_of(going)) break;
  }
  return m;
}

template <class Lanes, class Real>
[[gnu::always_inline]] inline void store(const Orientation<Lanes>& q, EightRotations<Real>& to, int at) {
  store(q.v.x, to.x, at);
  store(q.v.y, to.y, at);
  store(q.v.z, to.z, at);
  store(q.s, to.s, at);
}

/// Rotates the bodies for h, s. A body that does not rotate keeps its bits, and a body with equal moments of inertia keeps its
/// w.
template <class Lanes, class Real>
void turn(EightRotations<Real>& all, Real h) {
  const Lanes zero(0), half(h / 2);
  for (int at = 0; at < lanes_per_bundle; at += int(Lanes::size())) {
    const Orientation<Lanes> q{{load<Lanes>(all.x, at), load<Lanes>(all.y, at), load<Lanes>(all.z, at)},
                               load<Lanes>(all.s, at)};
    const Vec<Lanes> w = load<Lanes>(all.w, at), given = load<Lanes>(all.inverse_inertia, at);
    const Lanes uneven = max(max(abs(given.x - given.y), abs(given.y - given.z)), abs(given.z - given.x));
    const auto turns = abs(w.x) + abs(w.y) + abs(w.z) > zero;
    const auto tumbles = turns && given.x > zero && given.y > zero && given.z > zero && uneven > zero;
    const Vec<Lanes> inverse = select(tumbles, given, Vec<Lanes>{1, 1, 1});
    const Vec<Lanes> spin = rotated_back(q, w);
    Lanes solved(1);
    if (none_of(tumbles)) {
      const Orientation<Lanes> after = turned(q, half * spin);
      store(Orientation<Lanes>{select(turns, after.v, q.v), select(turns, after.s, q.s)}, all, at);
    } else {
      const Vec<Lanes> p{spin.x / inverse.x, spin.y / inverse.y, spin.z / inverse.z};
      const Vec<Lanes> momentum = rotated(q, p);  // constant in world axes
      const Vec<Lanes> d = half * Vec<Lanes>{inverse.z - inverse.y, inverse.x - inverse.z, inverse.y - inverse.x};
      const Orientation<Lanes> after = turned(q, half * each_times(inverse, midway(p, d, tumbles)));
      const Vec<Lanes> p_after = rotated_back(after, momentum), spin_after = each_times(inverse, p_after);
      const Lanes twice_energy = dot(p, spin), gained = dot(p_after, spin_after) - twice_energy;
      constexpr Real rounding = Real(1e4) * std::numeric_limits<Real>::epsilon();
      where(tumbles && !(Lanes(rounding) * twice_energy >= abs(gained)), solved) = zero;
      store(Orientation<Lanes>{select(turns, after.v, q.v), select(turns, after.s, q.s)}, all, at);
      store(select(tumbles, rotated(after, spin_after), w), all.w, at);
    }
    store(solved, all.solved, at);
  }
}

}  // namespace
}  // namespace pushback
