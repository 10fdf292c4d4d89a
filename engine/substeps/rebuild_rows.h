/// Rebuilds the rows of pairs that have moved and turned since detection.
///
/// In an anonymous namespace, as lanes.h.
#pragma once

#include "pushback/engine/substeps/pairs.h"
#include "pushback/engine/substeps/turn.h"

namespace pushback {
namespace {

/// The present state of pairs whose rows are rebuilt.
template <class Lanes>
struct RowRebuild {
  Pairs<Lanes> velocity, displacement;  // displacement: since detection
  Pairs<Lanes> impulse_velocity;        // the velocities that the impulses of the rows add
  PairGeometry<Lanes> geometry;         // with the present inertias
};
template <class Lanes, class Real>
void keep(const typename Lanes::mask_type& placed, const Lanes& number, EightNumbers<Real>& in, int at) {
  store(select(placed, number, load<Lanes>(in, at)), in, at);
}
template <class Lanes, class Real>
void keep(const typename Lanes::mask_type& placed, const Vec<Lanes>& vectors, EightVectors<Real>& in, int at) {
  store(select(placed, vectors, load<Lanes>(in, at)), in, at);
}
/// Updates the effective masses and C_0 of a contact whose rows have been rebuilt, in the lanes of `placed`.
template <class Lanes, class Real>
void update_contact(const Bundle<Real>& bundle, WideContact<Real>& contact, const typename Lanes::mask_type& placed,
                    const Lanes& C, const Lanes& K, const Lanes& k11, const Lanes& k22, RowRebuild<Lanes>& pairs,
                    int at) {
  const auto here = placed && load<Lanes>(contact.rigid_mass, at) > 0;
  const LanesOfRow<Lanes> normal(bundle.n, contact.normal, at), tangent1(bundle.tangent1, contact.tangent1, at),
      tangent2(bundle.tangent2, contact.tangent2, at);
  keep(here, Lanes(1 / K), contact.rigid_mass, at);
  keep(here, step_size_of(tangent1, tangent2, k11, k22), contact.step_size, at);
  keep(here, Lanes(C - pairs.displacement.along(normal)), contact.found, at);
}

// ---- rows with the normal as detected, as in chapter 21 ---------------------------------------------------------------

/// Updates a row of bodies that have moved past each other by `way` (m), so that both have a common contact point again (chapter 12).
/// Returns K, 1/kg.
template <class Lanes, class Real>
Lanes carry_row(WideRow<Real>& row, const Vec<Lanes>& n, const Vec<Lanes>& way, const typename Lanes::mask_type& placed,
                RowRebuild<Lanes>& pairs, int at) {
  const Vec<Lanes> m = cross(way, n);
  const Lanes of_a = abs(dot(m, pairs.velocity.a.w)), of_b = abs(dot(m, pairs.velocity.b.w)), both = of_a + of_b;
  Lanes s = pairs.velocity.inverse_mass_b / pairs.geometry.inverse_masses;
  where(both > 0, s) = of_b / both;
  const Vec<Lanes> ra_n = load<Lanes>(row.ra_n, at) + s * m, rb_n = load<Lanes>(row.rb_n, at) - (1 - s) * m;
  const Vec<Lanes> old_dwa = load<Lanes>(row.dwa, at), old_dwb = load<Lanes>(row.dwb, at);
  const Vec<Lanes> dwa = select(placed, pairs.geometry.inverse_inertia_a * ra_n, old_dwa);
  const Vec<Lanes> dwb = select(placed, pairs.geometry.inverse_inertia_b * rb_n, old_dwb);
  const Lanes impulse = load<Lanes>(row.impulse, at);
  pairs.impulse_velocity.a.w = pairs.impulse_velocity.a.w - impulse * (dwa - old_dwa);
  pairs.impulse_velocity.b.w = pairs.impulse_velocity.b.w + impulse * (dwb - old_dwb);
  keep(placed, ra_n, row.ra_n, at);
  keep(placed, rb_n, row.rb_n, at);
  store(dwa, row.dwa, at);
  store(dwb, row.dwb, at);
  return pairs.geometry.inverse_masses + (dot(rb_n, dwb) + dot(ra_n, dwa));
}
/// KeptContact::carry of chapter 21.
template <class Lanes, class Real>
void carry_pair(const BundleRange<Real>& all, Bundle<Real>& bundle, const typename Lanes::mask_type& placed,
                RowRebuild<Lanes>& pairs, int at) {
  const Vec<Lanes> way = pairs.displacement.b.v - pairs.displacement.a.v - load<Lanes>(bundle.rebuilt_displacement, at);
  for (int c = bundle.first; c < bundle.end; ++c) {
    WideContact<Real>& contact = all.contacts[c];
    const Lanes C = load<Lanes>(contact.found, at) + pairs.displacement.along({bundle.n, contact.normal, at});
    const Lanes K = carry_row(contact.normal, load<Lanes>(bundle.n, at), way, placed, pairs, at);
    const Lanes k11 = carry_row(contact.tangent1, load<Lanes>(bundle.tangent1, at), way, placed, pairs, at);
    const Lanes k22 = carry_row(contact.tangent2, load<Lanes>(bundle.tangent2, at), way, placed, pairs, at);
    update_contact(bundle, contact, placed, C, K, k11, k22, pairs, at);  // the separation stays
  }
}

// ---- rows that follow the bodies --------------------------------------------------------------------------------------

/// The rotation about theta (rad) by 2 atan(|theta| / 2), which is |theta| except for |theta|^3 / 12.
template <class Lanes>
Orientation<Lanes> turn_by(const Vec<Lanes>& theta) {
  const Vec<Lanes> v = Lanes(typename Lanes::value_type(0.5)) * theta;
  const Lanes s = Lanes(1) / sqrt(1 + dot(v, v));
  return {s * v, s};
}
/// The shortest rotation from a unit vector to another.
template <class Lanes>
Orientation<Lanes> turn_between(const Vec<Lanes>& from, const Vec<Lanes>& to) {
  const Vec<Lanes> v = cross(from, to);
  const Lanes s = 1 + dot(from, to), by = Lanes(1) / sqrt(dot(v, v) + s * s);
  return {by * v, by * s};
}
template <class Lanes>
Orientation<Lanes> select(const typename Lanes::mask_type& so, const Orientation<Lanes>& yes,
                          const Orientation<Lanes>& no) {
  return {select(so, yes.v, no.v), select(so, yes.s, no.s)};
}

/// The displacement of a point by a rotation, m. Computed directly, because in float the difference of two points far from the
/// centre would have too large a rounding error.
template <class Lanes>
Vec<Lanes> shifted(const Orientation<Lanes>& turn, const Vec<Lanes>& point) {
  const Vec<Lanes> twice = Lanes(2) * cross(turn.v, point);
  return turn.s * twice + cross(turn.v, twice);
}

/// The rotations of pairs since detection, and the present positions of their contacts.
template <class Lanes>
struct Riding {
  typename Lanes::mask_type face_a, face_b;  // n turns with A, with B; in other lanes it points from core to core
  Orientation<Lanes> turn_a, turn_b;
  Vec<Lanes> way, found_n;  // displacement of B minus displacement of A, and n as detected
  Lanes radius_a, radius_b;

  /// The arms to both surfaces and to both cores, and the gap, as detected.
  struct Found {
    Vec<Lanes> surface_a, surface_b, core_a, core_b;
    Lanes gap;
  };
  template <class Real>
  Found found(const WidePoint<Real>& point, int at) const {
    const Vec<Lanes> arm_a = load<Lanes>(point.arm_a, at), arm_b = load<Lanes>(point.arm_b, at);  // to their midpoint
    const Lanes gap = load<Lanes>(point.gap, at), half = gap / 2;
    return {arm_a - half * found_n, arm_b + half * found_n, arm_a - (radius_a + half) * found_n,
            arm_b + (radius_b + half) * found_n, gap};
  }
  /// The turn from the detected n to the present one.
  Orientation<Lanes> turn_of_normal(const Found& point) const {
    const Vec<Lanes> line = (radius_a + radius_b + point.gap) * found_n + way + shifted(turn_b, point.core_b) -
                            shifted(turn_a, point.core_a);
    const Lanes length = sqrt(dot(line, line));
    const auto ahead = 2 * dot(line, found_n) > length;  // if the cores have passed through each other, n stays
    const Vec<Lanes> n = select(ahead, (Lanes(1) / length) * line, found_n);
    return select(face_a, turn_a, select(face_b, turn_b, turn_between(found_n, n)));
  }
  struct Point {
    Vec<Lanes> arm_a, arm_b;  // to the point midway between both surfaces, m
    Lanes C;
  };
  Point point(const Found& point, const Vec<Lanes>& n) const {
    const Vec<Lanes> of_a = shifted(turn_a, point.core_a) + radius_a * (n - found_n),
                     of_b = shifted(turn_b, point.core_b) - radius_b * (n - found_n);
    const Lanes C = dot(n, point.gap * found_n + way + select(face_b, shifted(turn_b, point.surface_b), of_b) -
                               select(face_a, shifted(turn_a, point.surface_a), of_a));
    const Vec<Lanes> middle = C / 2 * n, gap = point.gap * found_n;
    return {select(face_a, point.surface_a + gap + way + of_b - middle, point.surface_a + of_a + middle),
            select(face_a, point.surface_b + of_b - middle, point.surface_b - gap - way + of_a + middle), C};
  }
};

/// Writes J and M^-1 J^T of a row along `n`, in the lanes of `placed`. Returns K, 1/kg.
template <class Lanes, class Real>
Lanes ride(WideRow<Real>& row, const Vec<Lanes>& n, const PairGeometry<Lanes>& geometry,
           const typename Lanes::mask_type& placed, int at) {
  WideRow<Real> anew;
  const Lanes K = make_row(anew, n, geometry, at);
  keep(placed, load<Lanes>(anew.ra_n, at), row.ra_n, at);
  keep(placed, load<Lanes>(anew.rb_n, at), row.rb_n, at);
  keep(placed, load<Lanes>(anew.dwa, at), row.dwa, at);
  keep(placed, load<Lanes>(anew.dwb, at), row.dwb, at);
  return K;
}
/// Makes n, both arms and C follow the bodies:
///
///   a corner, or a round body, on a face:   n turns with the face,   P is a point of the other body
///   two round bodies:                       n is the direction from core to core
template <class Lanes, class Real>
void ride(const BundleRange<Real>& all, Bundle<Real>& bundle, const typename Lanes::mask_type& placed,
          RowRebuild<Lanes>& pairs, int at) {
  const Riding<Lanes> riding{.face_a = load<Lanes>(bundle.face_a, at) > 0,
                             .face_b = load<Lanes>(bundle.face_b, at) > 0,
                             .turn_a = turn_by(pairs.displacement.a.w),
                             .turn_b = turn_by(pairs.displacement.b.w),
                             .way = pairs.displacement.b.v - pairs.displacement.a.v,
                             .found_n = load<Lanes>(bundle.found_n, at),
                             .radius_a = load<Lanes>(bundle.radius_a, at),
                             .radius_b = load<Lanes>(bundle.radius_b, at)};
  const Lanes once = select(placed, Lanes(1), Lanes(0));  // other lanes keep their bits
  for (int c = bundle.first; c < bundle.end; ++c) {  // impulses so far are summed along the n along which they acted
    WideContact<Real>& contact = all.contacts[c];
    give(pairs.impulse_velocity, bundle, contact, Lanes(-once), at);
    add(once * impulse_of<Lanes>(bundle, contact, at), contact.sum, at);
  }
  const Orientation<Lanes> turn = riding.turn_of_normal(riding.found(all.points[bundle.first], at));
  keep(placed, rotated(turn, riding.found_n), bundle.n, at);
  keep(placed, rotated(turn, load<Lanes>(bundle.found_tangent1, at)), bundle.tangent1, at);
  keep(placed, rotated(turn, load<Lanes>(bundle.found_tangent2, at)), bundle.tangent2, at);
  const Vec<Lanes> n = load<Lanes>(bundle.n, at), tangent1 = load<Lanes>(bundle.tangent1, at),
                   tangent2 = load<Lanes>(bundle.tangent2, at);
  for (int c = bundle.first; c < bundle.end; ++c) {
    WideContact<Real>& contact = all.contacts[c];
    const auto point = riding.point(riding.found(all.points[c], at), n);
    pairs.geometry.arm_a = point.arm_a;
    pairs.geometry.arm_b = point.arm_b;
    const Lanes K = ride(contact.normal, n, pairs.geometry, placed, at);
    const Lanes k11 = ride(contact.tangent1, tangent1, pairs.geometry, placed, at);
    const Lanes k22 = ride(contact.tangent2, tangent2, pairs.geometry, placed, at);
    update_contact(bundle, contact, placed, point.C, K, k11, k22, pairs, at);
    give(pairs.impulse_velocity, bundle, contact, once, at);
    add(-once * impulse_of<Lanes>(bundle, contact, at), contact.sum, at);
  }
}

// ---- the pass -------------------------------------------------------------------------------------------------------------

/// Called after the bodies have moved. Rebuilds the rows of pairs that have moved past each other, or rotated, far enough.
template <class Lanes, class Real>
void rebuild_rows(const BundleRange<Real>& all) {
  each_bundle<Lanes>(all, [&](Bundle<Real>& bundle, int at) {
    const Pairs<Lanes> moved(bundle, all.displacements, at);
    const Vec<Lanes> way = moved.b.v - moved.a.v, passed = way - load<Lanes>(bundle.rebuilt_displacement, at),
                     turned_a = moved.a.w - load<Lanes>(bundle.rebuilt_turn_a, at),
                     turned_b = moved.b.w - load<Lanes>(bundle.rebuilt_turn_b, at);
    const Lanes least = load<Lanes>(bundle.rebuild_distance_squared, at), reach_a = load<Lanes>(bundle.reach_a, at),
                reach_b = load<Lanes>(bundle.reach_b, at), by_a = dot(turned_a, turned_a),
                by_b = dot(turned_b, turned_b);
    const auto passes = dot(passed, passed) >= least,
               turns = reach_a * reach_a * by_a >= least || reach_b * reach_b * by_b >= least;
    // rad^2. If n turned by more than this in one substep, the stored impulses would accelerate the bodies wrongly, so n stays as it is.
    const Lanes at_once(typename Lanes::value_type(0.0625));
    const auto rides =
        load<Lanes>(bundle.face_a, at) + load<Lanes>(bundle.face_b, at) + load<Lanes>(bundle.cores, at) > 0 &&
        by_a < at_once && by_b < at_once;
    const auto placed = passes || turns;
    if (none_of(placed)) return;
    Lanes bounce = 0;  // an impact takes no time, so the relaxing pass needs the n at the beginning of the impact
    for (int c = bundle.first; c < bundle.end; ++c) bounce = bounce + load<Lanes>(all.contacts[c].bounce, at);
    const auto ridden = placed && rides && bounce >= 0, carried = placed && !ridden;
    RowRebuild<Lanes> pairs{.velocity = Pairs<Lanes>(bundle, all.velocities, at),
                            .displacement = moved,
                            .impulse_velocity = Pairs<Lanes>(bundle, all.impulse_velocities, at),
                            .geometry = {.arm_a = {},
                                         .arm_b = {},
                                         .inverse_inertia_a = fetch<Lanes>(bundle.a + at, all.inertias),
                                         .inverse_inertia_b = fetch<Lanes>(bundle.b + at, all.inertias),
                                         .inverse_masses = moved.inverse_mass_a + moved.inverse_mass_b}};
    if (any_of(carried)) carry_pair(all, bundle, carried, pairs, at);
    if (any_of(ridden)) ride(all, bundle, ridden, pairs, at);
    keep(placed, way, bundle.rebuilt_displacement, at);
    keep(placed, moved.a.w, bundle.rebuilt_turn_a, at);
    keep(placed, moved.b.w, bundle.rebuilt_turn_b, at);
    pairs.impulse_velocity.put_back(bundle, all.impulse_velocities, at);
  });
}

}  // namespace
}  // namespace pushback
