/// The passes of chapter 21 over its contacts, with `Real` replaced by lanes.
///
/// In an anonymous namespace, as lanes.h.
#pragma once

#include "pushback/chapters/22_wide/lanes.h"

namespace pushback {
namespace {

/// J and M^-1 J^T of a row, of as many pairs as there are lanes.
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

/// As many pairs of bodies, copied side by side. Inlined in any case: what is in memory instead of a register takes a third longer.
template <class Lanes>
struct Pairs {
  struct Motion {
    Vec<Lanes> v, w;
  };
  Motion a, b;
  Lanes inverse_mass_a, inverse_mass_b;

  template <class Real>
  [[gnu::always_inline]] Pairs(const Bundle<Real>& bundle, const Twist<Real>* bodies, int at)
      : a(fetch(bundle.a + at, bodies)),
        b(fetch(bundle.b + at, bodies)),
        inverse_mass_a(load<Lanes>(bundle.inverse_mass_a, at)),
        inverse_mass_b(load<Lanes>(bundle.inverse_mass_b, at)) {}
  /// J V; of displacements: in m.
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
    put(a, bundle.a + at, bundle.inverse_mass_a.of + at, bodies);
    put(b, bundle.b + at, bundle.inverse_mass_b.of + at, bodies);
  }

 private:
  template <class Real>
  static Motion fetch(const int* which, const Twist<Real>* bodies) {
    const auto each = [&](auto number) { return Lanes([&](int i) { return number(bodies[which[i]]); }); };
    return {{each([](const auto& t) { return t.v[0]; }), each([](const auto& t) { return t.v[1]; }),
             each([](const auto& t) { return t.v[2]; })},
            {each([](const auto& t) { return t.w[0]; }), each([](const auto& t) { return t.w[1]; }),
             each([](const auto& t) { return t.w[2]; })}};
  }
  /// What nothing moves is not written: other bundles of the set have it, too.
  template <class Real>
  static void put(const Motion& motion, const int* which, const Real* inverse_masses, Twist<Real>* bodies) {
    for (int i = 0; i < int(Lanes::size()); ++i) {
      if (inverse_masses[i] == 0) continue;
      const auto lane = static_cast<std::size_t>(i);
      Twist<Real>& body = bodies[which[i]];
      body.v[0] = motion.v.x[lane], body.v[1] = motion.v.y[lane], body.v[2] = motion.v.z[lane];
      body.w[0] = motion.w.x[lane], body.w[1] = motion.w.y[lane], body.w[2] = motion.w.z[lane];
    }
  }
};

/// `act(bundle, at)` for each bundle, in the order of the list; lanes from `at` on.
template <class Lanes, class Real, class Act>
void each_bundle(const Bundles<Real>& all, const Act& act) {
  for (int i = 0; i < all.count; ++i)
    for (int at = 0; at < lanes_of_bundle; at += int(Lanes::size())) act(all.bundles[i], at);
}

/// What the two bodies of a pair have to do with any row of theirs.
template <class Lanes>
struct Levers {
  Vec<Lanes> arm_a, arm_b;
  Symmetric<Lanes> inverse_inertia_a, inverse_inertia_b;
  Lanes inverse_masses;
};
/// J and M^-1 J^T of a row along `n`. Returns K, 1/kg.
template <class Lanes, class Real>
Lanes make_row(WideRow<Real>& row, const Vec<Lanes>& n, const Levers<Lanes>& levers, int at) {
  const Vec<Lanes> ra_n = cross(levers.arm_a, n), rb_n = cross(levers.arm_b, n);
  const Vec<Lanes> dwa = levers.inverse_inertia_a * ra_n, dwb = levers.inverse_inertia_b * rb_n;
  store(ra_n, row.ra_n, at);
  store(rb_n, row.rb_n, at);
  store(dwa, row.dwa, at);
  store(dwb, row.dwb, at);
  return levers.inverse_masses + (dot(rb_n, dwb) + dot(ra_n, dwa));
}

/// Once in a step: the rows, and what the impulses that they start from give the bodies.
template <class Lanes, class Real>
void prepare(const Bundles<Real>& all) {
  each_bundle<Lanes>(all, [&](const Bundle<Real>& bundle, int at) {
    Pairs<Lanes> given(bundle, all.given, at);
    Levers<Lanes> levers{.arm_a = {},
                         .arm_b = {},
                         .inverse_inertia_a = load<Lanes>(bundle.inverse_inertia_a, at),
                         .inverse_inertia_b = load<Lanes>(bundle.inverse_inertia_b, at),
                         .inverse_masses = given.inverse_mass_a + given.inverse_mass_b};
    for (int c = bundle.first; c < bundle.end; ++c) {
      WideContact<Real>& contact = all.contacts[c];
      levers.arm_a = load<Lanes>(all.points[c].arm_a, at);
      levers.arm_b = load<Lanes>(all.points[c].arm_b, at);
      const auto present = load<Lanes>(all.points[c].present, at) > 0;
      const Lanes K = make_row(contact.normal, load<Lanes>(bundle.n, at), levers, at);
      const Lanes k11 = make_row(contact.tangent1, load<Lanes>(bundle.tangent1, at), levers, at);
      const Lanes k22 = make_row(contact.tangent2, load<Lanes>(bundle.tangent2, at), levers, at);
      const LanesOfRow<Lanes> normal(bundle.n, contact.normal, at), tangent1(bundle.tangent1, contact.tangent1, at),
          tangent2(bundle.tangent2, contact.tangent2, at);
      const Lanes k12 = dot(tangent2.rb_n, tangent1.dwb) + dot(tangent2.ra_n, tangent1.dwa), half = (k11 - k22) / 2;
      Lanes mass = 0, step_size = 0;
      where(present, mass) = 1 / K;
      where(present, step_size) =
          1 / ((k11 + k22) / 2 + sqrt(half * half + k12 * k12));  // chapter 08: the larger eigenvalue
      store(mass, contact.rigid_mass, at);
      store(step_size, contact.step_size, at);
      given.apply(load<Lanes>(contact.normal.impulse, at), normal);
      given.apply(load<Lanes>(contact.tangent1.impulse, at), tangent1);
      given.apply(load<Lanes>(contact.tangent2.impulse, at), tangent2);
    }
    given.put_back(bundle, all.given, at);
  });
}

/// J V + b + gamma lambda = 0.
template <class Lanes, class Real>
void ask(WideContact<Real>& contact, const Lanes& bias, const Lanes& gamma_by_K, int at) {
  const Lanes rigid = load<Lanes>(contact.rigid_mass, at);
  Lanes gamma = 0;
  where(rigid > 0, gamma) = gamma_by_K / rigid;
  store(bias, contact.bias, at);
  store(gamma, contact.softness, at);
  store(Lanes(rigid / (1 + gamma_by_K)), contact.mass, at);
}

/// C = C_0 + J dX, and what each normal is to do in a substep.
template <class Lanes, class Real>
void aim(const Bundles<Real>& all, const WidePushOut<Real>& push_out) {
  each_bundle<Lanes>(all, [&](const Bundle<Real>& bundle, int at) {
    const Pairs<Lanes> moved(bundle, all.moved, at);
    for (int c = bundle.first; c < bundle.end; ++c) {
      WideContact<Real>& contact = all.contacts[c];
      const LanesOfRow<Lanes> normal(bundle.n, contact.normal, at);
      const Lanes C = load<Lanes>(contact.found, at) + moved.along(normal), e = load<Lanes>(contact.restitution, at);
      Lanes bounce = 0;
      if (any_of(e > 0)) {
        const Lanes approach = Pairs<Lanes>(bundle, all.before, at).along(normal);
        where(approach < -push_out.threshold && C + push_out.h * approach < 0, bounce) = e * approach;
      }
      Lanes bias = push_out.rate * C, gamma_by_K = push_out.gamma_by_K;
      const auto too_fast = bias < -push_out.fastest, apart = C > 0, bounces = bounce < 0;
      where(too_fast, bias) = -push_out.fastest;
      where(apart, bias) = C / push_out.h;
      where(bounces, bias) = bounce;
      where(too_fast || apart || bounces, gamma_by_K) = 0;
      store(bounce, contact.bounce, at);
      ask(contact, bias, gamma_by_K, at);
    }
  });
}

template <class Lanes, class Real>
void relax(const Bundles<Real>& all) {
  each_bundle<Lanes>(all, [&](const Bundle<Real>& bundle, int at) {
    for (int c = bundle.first; c < bundle.end; ++c) {
      WideContact<Real>& contact = all.contacts[c];
      const Lanes bounce = load<Lanes>(contact.bounce, at);
      Lanes bias = load<Lanes>(contact.bias, at);
      where(bias < 0, bias) = 0;
      where(bounce < 0, bias) = bounce;
      ask(contact, bias, Lanes(0), at);
    }
  });
}

template <class Lanes, class Real>
void push(const Bundle<Real>& bundle, WideContact<Real>& contact, Pairs<Lanes>& pairs, int at) {
  const LanesOfRow<Lanes> row(bundle.n, contact.normal, at);
  const Lanes impulse = load<Lanes>(contact.normal.impulse, at);
  const Lanes error = pairs.along(row) + (load<Lanes>(contact.bias, at) + load<Lanes>(contact.softness, at) * impulse);
  Lanes total = impulse - load<Lanes>(contact.mass, at) * error;
  where(total < 0, total) = 0;
  pairs.apply(total - impulse, row);
  store(total, contact.normal.impulse, at);
}

template <class Lanes, class Real>
void rub(const Bundle<Real>& bundle, WideContact<Real>& contact, Pairs<Lanes>& pairs, int at) {
  const LanesOfRow<Lanes> row1(bundle.tangent1, contact.tangent1, at), row2(bundle.tangent2, contact.tangent2, at);
  const Lanes step_size = load<Lanes>(contact.step_size, at);
  const Lanes impulse1 = load<Lanes>(contact.tangent1.impulse, at),
              impulse2 = load<Lanes>(contact.tangent2.impulse, at);
  Lanes total1 = impulse1 - step_size * pairs.along(row1), total2 = impulse2 - step_size * pairs.along(row2);
  const Lanes radius = load<Lanes>(bundle.friction, at) * load<Lanes>(contact.normal.impulse, at);
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
}

/// Normals first, then friction, of each bundle.
template <class Lanes, class Real>
void sweep(const Bundles<Real>& all) {
  each_bundle<Lanes>(all, [&](const Bundle<Real>& bundle, int at) {
    Pairs<Lanes> pairs(bundle, all.now, at);
    for (int c = bundle.first; c < bundle.end; ++c) push(bundle, all.contacts[c], pairs, at);
    pairs.put_back(bundle, all.now, at);
  });
  each_bundle<Lanes>(all, [&](const Bundle<Real>& bundle, int at) {
    Pairs<Lanes> pairs(bundle, all.now, at);
    for (int c = bundle.first; c < bundle.end; ++c) rub(bundle, all.contacts[c], pairs, at);
    pairs.put_back(bundle, all.now, at);
  });
}

template <class Real, int width>
Passes<Real> passes_of(const char* processor) {
  using Lanes = LanesOf<Real, width>;
  return {processor, width, prepare<Lanes, Real>, aim<Lanes, Real>, relax<Lanes, Real>, sweep<Lanes, Real>};
}
template <class Real>
Passes<Real> passes_for(const char* processor, int lanes) {
  if (lanes == 1) return passes_of<Real, 1>(processor);
  return lanes == 4 ? passes_of<Real, 4>(processor) : passes_of<Real, 8>(processor);
}

}  // namespace
}  // namespace pushback
