/// The passes over contacts of chapter 21, for several pairs at a time.
///
/// In an anonymous namespace, as lanes.h.
#pragma once

#include <algorithm>

#include "pushback/engine/substeps/rebuild_rows.h"

namespace pushback {
namespace {

/// Once per step: builds the rows, and applies the initial impulses.
template <class Lanes, class Real>
void prepare(const BundleRange<Real>& all) {
  each_bundle<Lanes>(all, [&](const Bundle<Real>& bundle, int at) {
    Pairs<Lanes> given(bundle, all.impulse_velocities, at);
    PairGeometry<Lanes> geometry{.arm_a = {},
                                 .arm_b = {},
                                 .inverse_inertia_a = load<Lanes>(bundle.inverse_inertia_a, at),
                                 .inverse_inertia_b = load<Lanes>(bundle.inverse_inertia_b, at),
                                 .inverse_masses = given.inverse_mass_a + given.inverse_mass_b};
    for (int c = bundle.first; c < bundle.end; ++c) {
      WideContact<Real>& contact = all.contacts[c];
      geometry.arm_a = load<Lanes>(all.points[c].arm_a, at);
      geometry.arm_b = load<Lanes>(all.points[c].arm_b, at);
      const auto present = load<Lanes>(all.points[c].present, at) > 0;
      const Lanes K = make_row(contact.normal, load<Lanes>(bundle.n, at), geometry, at);
      const Lanes k11 = make_row(contact.tangent1, load<Lanes>(bundle.tangent1, at), geometry, at);
      const Lanes k22 = make_row(contact.tangent2, load<Lanes>(bundle.tangent2, at), geometry, at);
      const LanesOfRow<Lanes> tangent1(bundle.tangent1, contact.tangent1, at),
          tangent2(bundle.tangent2, contact.tangent2, at);
      Lanes mass = 0, step_size = 0;
      where(present, mass) = 1 / K;
      where(present, step_size) = step_size_of(tangent1, tangent2, k11, k22);
      store(mass, contact.rigid_mass, at);
      store(step_size, contact.step_size, at);
      give(given, bundle, contact, Lanes(1), at);
    }
    given.put_back(bundle, all.impulse_velocities, at);
  });
}

/// Sets the equation of the normal row, J V + b + gamma lambda = 0.
template <class Lanes, class Real>
void set_equation(WideContact<Real>& contact, const Lanes& bias, const Lanes& gamma_by_K, int at) {
  const Lanes rigid = load<Lanes>(contact.rigid_mass, at);
  Lanes gamma = 0;
  where(rigid > 0, gamma) = gamma_by_K / rigid;
  store(bias, contact.bias, at);
  store(gamma, contact.softness, at);
  store(Lanes(rigid / (1 + gamma_by_K)), contact.mass, at);
}

/// A bounce within a substep: Bounce of chapter 21, which derives the formulas.
template <class Lanes>
struct WideBounce {
  Lanes way, speed;

  WideBounce(const Lanes& e, const Lanes& C, const Lanes& u, const Lanes& gained, const Lanes& h) {
    const Lanes none = 0;
    const Lanes ha = max(none, gained), aC = ha * C / h;
    const Lanes s = max(none, u * u / 2 + aC + ha * u / 2), at_surface = sqrt(2 * s);
    way = e * h * at_surface;
    where(C > 0, way) = e * (h * at_surface - C) - C;
    speed = ha / 2 + sqrt(max(none, ha * ha / 4 + 2 * (e * e * s - aC - ha * way / h)));
  }
};

/// A normal row with this bias never acts, m/s. See KeptContact of chapter 21.
template <class Real>
constexpr Real free_speed = Real(1e9);

/// Computes C = C_0 + J dX, and sets the equation of each normal for a substep. Returns the fastest bounce, m/s.
template <class Lanes, class Real>
Real prepare_substep(const BundleRange<Real>& all, const WidePushOut<Real>& push_out) {
  Real fastest = 0;
  each_bundle<Lanes>(all, [&](const Bundle<Real>& bundle, int at) {
    const Pairs<Lanes> moved(bundle, all.displacements, at);
    const Lanes h = push_out.h;
    for (int c = bundle.first; c < bundle.end; ++c) {
      WideContact<Real>& contact = all.contacts[c];
      const LanesOfRow<Lanes> normal(bundle.n, contact.normal, at);
      const Lanes C = load<Lanes>(contact.found, at) + moved.along(normal), e = load<Lanes>(contact.restitution, at);
      Lanes bias = push_out.rate * C, gamma_by_K = push_out.gamma_by_K, bounce = 0;
      const auto too_fast = bias < -push_out.fastest, apart = C > 0;
      where(too_fast, bias) = -push_out.fastest;
      where(apart, bias) = C / h;
      where(too_fast || apart, gamma_by_K) = 0;
      if (any_of(e > 0)) {
        const Lanes approach = Pairs<Lanes>(bundle, all.velocities_before, at).along(normal);
        const auto bounces = e > 0 && approach < -push_out.threshold && C + h * approach < 0;
        const WideBounce<Lanes> back(e, C, -approach, approach - Pairs<Lanes>(bundle, all.velocities, at).along(normal),
                                     h);
        where(e > 0 && C > h * push_out.threshold, bias) = free_speed<Real>;
        where(bounces, bias) = -back.way / h;
        where(bounces, gamma_by_K) = 0;
        where(bounces, bounce) = -back.speed;
        fastest = std::max(fastest, Real(hmax(Lanes(-bounce))));
      }
      store(bounce, contact.bounce, at);
      set_equation(contact, bias, gamma_by_K, at);
    }
  });
  return fastest;
}

template <class Lanes, class Real>
void relax(const BundleRange<Real>& all) {
  each_bundle<Lanes>(all, [&](const Bundle<Real>& bundle, int at) {
    for (int c = bundle.first; c < bundle.end; ++c) {
      WideContact<Real>& contact = all.contacts[c];
      const Lanes bounce = load<Lanes>(contact.bounce, at);
      Lanes bias = load<Lanes>(contact.bias, at);
      where(bias < 0, bias) = 0;
      where(bounce < 0, bias) = bounce;
      set_equation(contact, bias, Lanes(0), at);
    }
  });
}

/// Returns the change of the speed, m/s.
template <class Lanes, class Real>
[[gnu::always_inline]] inline Lanes solve_normal_of(const Bundle<Real>& bundle, WideContact<Real>& contact,
                                                    Pairs<Lanes>& pairs, int at) {
  const LanesOfRow<Lanes> row(bundle.n, contact.normal, at);
  const Lanes impulse = load<Lanes>(contact.normal.impulse, at);
  const Lanes error = pairs.along(row) + (load<Lanes>(contact.bias, at) + load<Lanes>(contact.softness, at) * impulse);
  Lanes total = impulse - load<Lanes>(contact.mass, at) * error;
  where(total < 0, total) = 0;
  pairs.apply(total - impulse, row);
  store(total, contact.normal.impulse, at);
  const Lanes rigid = load<Lanes>(contact.rigid_mass, at);
  Lanes change = 0;
  where(rigid > 0, change) = abs(total - impulse) / rigid;
  return change;
}

/// `last`: whether this is the last pass of a substep, whose final impulses are added to the sum.
template <class Lanes, class Real, bool last>
void solve_friction_of(const Bundle<Real>& bundle, WideContact<Real>& contact, Pairs<Lanes>& pairs, int at) {
  const LanesOfRow<Lanes> row1(bundle.tangent1, contact.tangent1, at), row2(bundle.tangent2, contact.tangent2, at);
  const Lanes step_size = load<Lanes>(contact.step_size, at);
  const Lanes impulse1 = load<Lanes>(contact.tangent1.impulse, at),
              impulse2 = load<Lanes>(contact.tangent2.impulse, at);
  Lanes total1 = impulse1 - step_size * pairs.along(row1), total2 = impulse2 - step_size * pairs.along(row2);
  const Lanes pushed = load<Lanes>(contact.normal.impulse, at);
  const Lanes radius = load<Lanes>(bundle.friction, at) * pushed;
  const Lanes squared = total1 * total1 + total2 * total2;
  if (const auto slides = squared > radius * radius; any_of(slides)) {
    Lanes kept = 1;
    where(slides, kept) = radius / sqrt(squared);
    total1 *= kept;
    total2 *= kept;
  }
  pairs.apply(total1 - impulse1, row1);
  pairs.apply(total2 - impulse2, row2);
  store(total1, contact.tangent1.impulse, at);
  store(total2, contact.tangent2.impulse, at);
  if constexpr (last) {
    add(impulse_of<Lanes>(bundle, contact, at), contact.sum, at);
  }
}

/// Calls `act(bundle, contact, pairs, at)` for each contact of each bundle, alternating between two bundles. While a contact
/// waits for the velocities that the previous contact changes, the processor solves a contact of other bodies. All bundles must
/// belong to one set.
template <class Lanes, class Real, class Act>
void two_at_a_time(const BundleRange<Real>& all, const Act& act) {
  constexpr int parts = lanes_per_bundle / int(Lanes::size());
  for (int i = 0; i < all.count * parts; i += 2) {
    const Bundle<Real>&first = all.bundles[i / parts], &second = all.bundles[(i + 1) / parts];
    const int at = i % parts * int(Lanes::size()), at2 = (i + 1) % parts * int(Lanes::size());
    Pairs<Lanes> one(first, all.velocities, at);
    if (i + 1 == all.count * parts) {
      for (int c = first.first; c < first.end; ++c) act(first, all.contacts[c], one, at);
      one.put_back(first, all.velocities, at);
      break;
    }
    Pairs<Lanes> two(second, all.velocities, at2);
    for (int c = first.first, d = second.first; c < first.end || d < second.end; ++c, ++d) {
      if (c < first.end) act(first, all.contacts[c], one, at);
      if (d < second.end) act(second, all.contacts[d], two, at2);
    }
    one.put_back(first, all.velocities, at);
    two.put_back(second, all.velocities, at2);
  }
}

template <class Lanes, class Real>
Real solve_normals(const BundleRange<Real>& all) {
  Lanes change = 0;
  two_at_a_time<Lanes>(
      all, [&](const Bundle<Real>& bundle, WideContact<Real>& contact, Pairs<Lanes>& pairs, int at)
               __attribute__((always_inline)) { change = max(change, solve_normal_of(bundle, contact, pairs, at)); });
  return hmax(change);
}
/// Solves friction after all normals, because the friction limit depends on the normal impulse.
template <class Lanes, class Real>
void solve_friction(const BundleRange<Real>& all) {
  two_at_a_time<Lanes>(all, solve_friction_of<Lanes, Real, false>);
}
/// The last pass of a substep.
template <class Lanes, class Real>
void solve_friction_and_sum(const BundleRange<Real>& all) {
  two_at_a_time<Lanes>(all, solve_friction_of<Lanes, Real, true>);
}

/// Stores the initial impulses of a substep with a bounce. `restore_impulses` makes the next substep start from them as well.
template <class Lanes, class Real>
void save_impulses(const BundleRange<Real>& all) {
  each_bundle<Lanes>(all, [&](const Bundle<Real>& bundle, int at) {
    for (int c = bundle.first; c < bundle.end; ++c) {
      const WideContact<Real>& contact = all.contacts[c];
      store(load<Lanes>(contact.normal.impulse, at), all.start_impulses[c].x, at);
      store(load<Lanes>(contact.tangent1.impulse, at), all.start_impulses[c].y, at);
      store(load<Lanes>(contact.tangent2.impulse, at), all.start_impulses[c].z, at);
    }
  });
}
template <class Lanes, class Real>
void restore_impulses(const BundleRange<Real>& all) {
  each_bundle<Lanes>(all, [&](const Bundle<Real>& bundle, int at) {
    Pairs<Lanes> given(bundle, all.impulse_velocities, at);
    for (int c = bundle.first; c < bundle.end; ++c) {
      WideContact<Real>& contact = all.contacts[c];
      give(given, bundle, contact, Lanes(-1), at);
      store(load<Lanes>(all.start_impulses[c].x, at), contact.normal.impulse, at);
      store(load<Lanes>(all.start_impulses[c].y, at), contact.tangent1.impulse, at);
      store(load<Lanes>(all.start_impulses[c].z, at), contact.tangent2.impulse, at);
      give(given, bundle, contact, Lanes(1), at);
    }
    given.put_back(bundle, all.impulse_velocities, at);
  });
}

template <class Real, int width>
Passes<Real> passes_of(const char* processor) {
  using Lanes = LanesOf<Real, width>;
  return {processor,
          width,
          prepare<Lanes, Real>,
          prepare_substep<Lanes, Real>,
          rebuild_rows<Lanes, Real>,
          relax<Lanes, Real>,
          solve_normals<Lanes, Real>,
          solve_friction<Lanes, Real>,
          solve_friction_and_sum<Lanes, Real>,
          save_impulses<Lanes, Real>,
          restore_impulses<Lanes, Real>,
          turn<Lanes, Real>};
}
template <class Real>
Passes<Real> passes_for(const char* processor, int lanes) {
  if (lanes == 1) return passes_of<Real, 1>(processor);
  return lanes == 4 ? passes_of<Real, 4>(processor) : passes_of<Real, 8>(processor);
}

}  // namespace
}  // namespace pushback
