/// The obvious first attempt applies an impulse at every contact, and moves overlapping bodies apart directly.
///
///   f = -(1 + e) [ n . (v_B - v_A) + w_B . (r_B x n) - w_A . (r_A x n) ] / K
///   K = 1/m_A + 1/m_B + (r_A x n) . I_A^-1 (r_A x n) + (r_B x n) . I_B^-1 (r_B x n)
///
/// The lecture prints the factor -(1 + e) only before the first product, and the other two with the opposite sign. A spinning
/// body then gains or loses energy.
/// Palubicki, "CGP 9", Naive Take and Naive Take 2.
#pragma once

#include "pushback/common/world/step_solver.h"

namespace pushback {

/// The impulse along the normal, N s, after which the bodies separate e times as fast at this point as they approached.
inline Real pair_impulse(const World& world, const Contact& c) {
  const Real speed = separating_speed(world, c);
  if (speed >= 0) return 0;
  const auto [a, b] = world.bodies_of(c);
  const Vec3 ra_n = (c.point - a.position).cross(c.normal);
  const Vec3 rb_n = (c.point - b.position).cross(c.normal);
  const Real K =
      a.inverse_mass + b.inverse_mass + ra_n.dot(a.inverse_inertia * ra_n) + rb_n.dot(b.inverse_inertia * rb_n);
  return -(1 + c.restitution) * speed / K;
}

inline void apply_impulse(World& world, Contact& c, Real f) {
  const auto [a, b] = world.bodies_of(c);
  const Vec3 impulse = f * c.normal;
  a.velocity -= a.inverse_mass * impulse;
  a.angular_velocity -= a.inverse_inertia * (c.point - a.position).cross(impulse);
  b.velocity += b.inverse_mass * impulse;
  b.angular_velocity += b.inverse_inertia * (c.point - b.position).cross(impulse);
  c.impulse += impulse;
}

/// Moves the two bodies apart by the depth of the contact, the lighter one further.
inline void push_apart(World& world, const Contact& c) {
  const auto [a, b] = world.bodies_of(c);
  const Vec3 way = c.depth / (a.inverse_mass + b.inverse_mass) * c.normal;
  a.position -= a.inverse_mass * way;
  b.position += b.inverse_mass * way;
}

/// Take 1 solves every contact once, one after the other.
struct NaiveOnce : StepSolver {
  void solve(World& world, Real, int) override {
    for (Contact& c : world.contacts) {
      apply_impulse(world, c, pair_impulse(world, c));
      push_apart(world, c);
    }
  }
};

/// Take 2 solves all contacts several times in the same step, and averages the impulses over the points of each pair.
struct NaiveAveraged : StepSolver {
  void solve(World& world, Real, int times) override {
    Contacts& contacts = world.contacts;
    const auto same_pair = [](const Contact& c, const Contact& d) {
      return c.id.body_a == d.id.body_a && c.id.body_b == d.id.body_b;
    };
    for (int i = 0; i < times; ++i) {
      for (std::size_t first = 0, end = 0; first < contacts.size(); first = end) {
        while (end < contacts.size() && same_pair(contacts[end], contacts[first])) ++end;
        std::vector<Real> f;
        for (std::size_t k = first; k < end; ++k) f.push_back(pair_impulse(world, contacts[k]));
        for (std::size_t k = first; k < end; ++k)
          apply_impulse(world, contacts[k], f[k - first] / static_cast<Real>(end - first));
      }
    }
    for (const Contact& c : contacts) push_apart(world, c);
  }
};

}  // namespace pushback
