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
  LanesOfRow(const EightVectors<Real>& direction, const WideRow<Real>& row, int at)
      : n(load<Lanes>(direction, at)),
        ra_n(load<Lanes>(row.ra_n, at)),
        rb_n(load<Lanes>(row.rb_n, at)),
        dwa(load<Lanes>(row.dwa, at)),
        dwb(load<Lanes>(row.dwb, at)) {}
};

/// As many pairs of bodies, copied side by side.
template <class Lanes>
struct Pairs {
  struct Motion {
    Vec<Lanes> v, w;
  };
  Motion a, b;
  Lanes inverse_mass_a, inverse_mass_b;

  template <class Real>
  Pairs(const Bundle<Real>& bundle, const Twist<Real>* bodies, int at)
      : a(fetch(bundle.a + at, bodies)),
        b(fetch(bundle.b + at, bodies)),
        inverse_mass_a(load<Lanes>(bundle.inverse_mass_a, at)),
        inverse_mass_b(load<Lanes>(bundle.inverse_mass_b, at)) {}
  /// J V; of displacements: in m.
  Lanes along(const LanesOfRow<Lanes>& row) const {
    return dot(row.n, b.v - a.v) + (dot(row.rb_n, b.w) - dot(row.ra_n, a.w));
  }
  /// V += M^-1 J^T lambda.
  void apply(const Lanes& lambda, const LanesOfRow<Lanes>& row) {
    a.v = a.v - (inverse_mass_a * lambda) * row.n;
    b.v = b.v + (inverse_mass_b * lambda) * row.n;
    a.w = a.w - lambda * row.dwa;
    b.w = b.w + lambda * row.dwb;
  }
  template <class Real>
  void put_back(const Bundle<Real>& bundle, Twist<Real>* bodies, int at) const {
    put(a, bundle.a + at, bodies);
    put(b, bundle.b + at, bodies);
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
  template <class Real>
  static void put(const Motion& motion, const int* which, Twist<Real>* bodies) {
    for (int i = 0; i < int(Lanes::size()); ++i) {
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
    for (int c = bundle.first; c < bundle.end; ++c) rub(bundle, all.contacts[c], pairs, at);
    pairs.put_back(bundle, all.now, at);
  });
}

template <class Real, int width>
Passes<Real> passes_of(const char* processor) {
  using Lanes = LanesOf<Real, width>;
  return {processor, width, aim<Lanes, Real>, relax<Lanes, Real>, sweep<Lanes, Real>};
}
template <class Real>
Passes<Real> passes_for(const char* processor, int lanes) {
  if (lanes == 1) return passes_of<Real, 1>(processor);
  return lanes == 4 ? passes_of<Real, 4>(processor) : passes_of<Real, 8>(processor);
}

}  // namespace
}  // namespace pushback
