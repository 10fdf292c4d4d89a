/// What one would write first: an impulse for every contact, and bodies that overlap moved apart by hand.
///
///   f = -(1 + e) [ n . (v_B - v_A) + w_B . (r_B x n) - w_A . (r_A x n) ] / K
///   K = 1/m_A + 1/m_B + (r_A x n) . I_A^-1 (r_A x n) + (r_B x n) . I_B^-1 (r_B x n)
///
/// The lecture prints this with -(1 + e) on the first product alone, and the spins with the other sign: a spinning body
/// then gains or loses energy.
/// Palubicki, "CGP 9", Naive Take and Naive Take 2.
#pragma once

#include "common/contact.h"

namespace pushback {

/// The impulse along the normal, N s, that turns the approach at this point into a departure, e times as fast.
inline Real pair_impulse(const Contact& c) {
  const Real speed = c.separating_speed();
  if (speed >= 0) return 0;
  const Vec3 ra_n = (c.point - c.a->position).cross(c.normal);
  const Vec3 rb_n = (c.point - c.b->position).cross(c.normal);
  const Real K = c.a->inverse_mass + c.b->inverse_mass + ra_n.dot(c.a->inverse_inertia * ra_n) +
                 rb_n.dot(c.b->inverse_inertia * rb_n);
  return -(1 + c.restitution) * speed / K;
}

inline void apply_impulse(Contact& c, Real f) {
  const Vec3 impulse = f * c.normal;
  c.a->velocity -= c.a->inverse_mass * impulse;
  c.a->angular_velocity -= c.a->inverse_inertia * (c.point - c.a->position).cross(impulse);
  c.b->velocity += c.b->inverse_mass * impulse;
  c.b->angular_velocity += c.b->inverse_inertia * (c.point - c.b->position).cross(impulse);
  c.impulse += impulse;
}

/// Moves the two bodies out of each other, the lighter one further.
inline void push_apart(const Contact& c) {
  const Vec3 way = c.depth / (c.a->inverse_mass + c.b->inverse_mass) * c.normal;
  c.a->position -= c.a->inverse_mass * way;
  c.b->position += c.b->inverse_mass * way;
}

/// Take 1: every contact once, one after the other.
struct NaiveOnce {
  void solve(Contacts& contacts, Real, int) {
    for (Contact& c : contacts) {
      apply_impulse(c, pair_impulse(c));
      push_apart(c);
    }
  }
};

/// Take 2: all of them again and again in the same tick; what the points of one pair ask for is averaged.
struct NaiveAveraged {
  void solve(Contacts& contacts, Real, int times) {
    for (int i = 0; i < times; ++i) {
      for (std::size_t first = 0, end = 0; first < contacts.size(); first = end) {
        while (end < contacts.size() && contacts[end].a == contacts[first].a && contacts[end].b == contacts[first].b)
          ++end;
        std::vector<Real> f;
        for (std::size_t k = first; k < end; ++k) f.push_back(pair_impulse(contacts[k]));
        for (std::size_t k = first; k < end; ++k)
          apply_impulse(contacts[k], f[k - first] / static_cast<Real>(end - first));
      }
    }
    for (const Contact& c : contacts) push_apart(c);
  }
};

}  // namespace pushback
