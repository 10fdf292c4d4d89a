/// Pairs of bodies and their rows, one pair per lane.
///
/// In an anonymous namespace, as lanes.h.
#pragma once

#include "pushback/engine/substeps/motions.h"

namespace pushback {
namespace {

/// J and M^-1 J^T of a row of each pair.
template <class Lanes>
struct LanesOfRow {
  Vec<Lanes> n, ra_n, rb_n, dwa, dwb;
  template <class Real>
  [[gnu::always_inline]] LanesOfRow(const EightVectors<Real>& direction, const WideRow<Real>& row, int at)
      : n(load<Lanes>(direction, at)),
        ra_n(load<Lanes>(row.ra_n, at)),
        rb_n(load<Lanes>(row.rb_n, at)),
        dwa(load<Lanes>(row.dwa, at)),
        dwb(load<Lanes>(row.dwb, at)) {}
};

/// The velocities of pairs of bodies, copied into lanes. The functions are always inlined, because a pass takes a third longer
/// if the lanes are in memory instead of registers.
template <class Lanes>
struct Pairs {
  Motions<Lanes> a, b;
  Lanes inverse_mass_a, inverse_mass_b;

  template <class Real>
  [[gnu::always_inline]] Pairs(const Bundle<Real>& bundle, const Twist<Real>* bodies, int at)
      : a(fetch<Lanes>(bundle.a + at, bodies)),
        b(fetch<Lanes>(bundle.b + at, bodies)),
        inverse_mass_a(load<Lanes>(bundle.inverse_mass_a, at)),
        inverse_mass_b(load<Lanes>(bundle.inverse_mass_b, at)) {}
  /// J V, m/s, or m for displacements.
  [[gnu::always_inline]] Lanes along(const LanesOfRow<Lanes>& row) const {
    return dot(row.n, b.v - a.v) + (dot(row.rb_n, b.w) - dot(row.ra_n, a.w));
  }
  /// V += M^-1 J^T lambda.
  [[gnu::always_inline]] void apply(const Lanes& lambda, const LanesOfRow<Lanes>& row) {
    a.v = a.v - (inverse_mass_a * lambda) * row.n;
    b.v = b.v + (inverse_mass_b * lambda) * row.n;
    a.w = a.w - lambda * row.dwa;
    b.w = b.w + lambda * row.dwb;
  }
  template <class Real>
  [[gnu::always_inline]] void put_back(const Bundle<Real>& bundle, Twist<Real>* bodies, int at) const {
    put(a, bundle.a + at, bundle.inverse_mass_a.values + at, bodies);
    put(b, bundle.b + at, bundle.inverse_mass_b.values + at, bodies);
  }
};

/// The present I^-1 of these bodies, world axes.
template <class Lanes, class Real>
Symmetric<Lanes> fetch(const int* which, const Inertia<Real>* inertias) {
  const auto each = [&](int number) { return Lanes([&](int i) { return inertias[which[i]].values[number]; }); };
  return {each(0), each(1), each(2), each(3), each(4), each(5)};
}

/// Calls `act(bundle, at)` for each bundle in the order of the list. `at`: the first of the lanes.
template <class Lanes, class Real, class Act>
void each_bundle(const BundleRange<Real>& all, const Act& act) {
  for (int i = 0; i < all.count; ++i)
    for (int at = 0; at < lanes_per_bundle; at += int(Lanes::size())) act(all.bundles[i], at);
}

/// The arms, inertias and masses from which all rows of a contact are built.
template <class Lanes>
struct PairGeometry {
  Vec<Lanes> arm_a, arm_b;
  Symmetric<Lanes> inverse_inertia_a, inverse_inertia_b;
  Lanes inverse_masses;
};
/// Writes J and M^-1 J^T of a row along `n`. Returns K, 1/kg.
template <class Lanes, class Real>
Lanes make_row(WideRow<Real>& row, const Vec<Lanes>& n, const PairGeometry<Lanes>& geometry, int at) {
  const Vec<Lanes> ra_n = cross(geometry.arm_a, n), rb_n = cross(geometry.arm_b, n);
  const Vec<Lanes> dwa = geometry.inverse_inertia_a * ra_n, dwb = geometry.inverse_inertia_b * rb_n;
  store(ra_n, row.ra_n, at);
  store(rb_n, row.rb_n, at);
  store(dwa, row.dwa, at);
  store(dwb, row.dwb, at);
  return geometry.inverse_masses + (dot(rb_n, dwb) + dot(ra_n, dwa));
}

/// 1 / k, kg, of both tangents. k is the larger eigenvalue of their block (chapter 08).
template <class Lanes>
Lanes step_size_of(const LanesOfRow<Lanes>& tangent1, const LanesOfRow<Lanes>& tangent2, const Lanes& k11,
                   const Lanes& k22) {
  const Lanes k12 = dot(tangent2.rb_n, tangent1.dwb) + dot(tangent2.ra_n, tangent1.dwa), half = (k11 - k22) / 2;
  return 1 / ((k11 + k22) / 2 + sqrt(half * half + k12 * k12));
}
/// Applies `times` the impulses of a contact to the velocities of its pair.
template <class Lanes, class Real>
void give(Pairs<Lanes>& given, const Bundle<Real>& bundle, const WideContact<Real>& contact, const Lanes& times,
          int at) {
  given.apply(times * load<Lanes>(contact.normal.impulse, at), {bundle.n, contact.normal, at});
  given.apply(times * load<Lanes>(contact.tangent1.impulse, at), {bundle.tangent1, contact.tangent1, at});
  given.apply(times * load<Lanes>(contact.tangent2.impulse, at), {bundle.tangent2, contact.tangent2, at});
}
/// The impulse of a contact, N s, on B, world axes.
template <class Lanes, class Real>
Vec<Lanes> impulse_of(const Bundle<Real>& bundle, const WideContact<Real>& contact, int at) {
  return load<Lanes>(contact.normal.impulse, at) * load<Lanes>(bundle.n, at) +
         load<Lanes>(contact.tangent1.impulse, at) * load<Lanes>(bundle.tangent1, at) +
         load<Lanes>(contact.tangent2.impulse, at) * load<Lanes>(bundle.tangent2, at);
}
template <class Lanes, class Real>
void add(const Vec<Lanes>& vectors, EightVectors<Real>& to, int at) {
  store(load<Lanes>(to, at) + vectors, to, at);
}

}  // namespace
}  // namespace pushback
