#include "pushback/chapters/07_warm_start/flat.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pushback {

FlatSolver::Direction FlatSolver::direction(const Body& a, const Body& b, const Vec3& point, const Vec3& n) {
  Direction d;
  d.n = n;
  d.ra_n = (point - a.position).cross(n);
  d.rb_n = (point - b.position).cross(n);
  d.dva = -a.inverse_mass * n;
  d.dwa = -a.inverse_inertia * d.ra_n;
  d.dvb = b.inverse_mass * n;
  d.dwb = b.inverse_inertia * d.rb_n;
  d.effective_mass = 1 / (a.inverse_mass + b.inverse_mass + d.rb_n.dot(d.dwb) - d.ra_n.dot(d.dwa));
  d.impulse = 0;
  return d;
}

Real FlatSolver::speed(const Point& p, const Direction& d) {
  return d.n.dot(p.b->velocity - p.a->velocity) +
         (d.rb_n.dot(p.b->angular_velocity) - d.ra_n.dot(p.a->angular_velocity));
}

void FlatSolver::apply(const Point& p, const Direction& d, Real lambda) {
  p.a->velocity += lambda * d.dva;
  p.a->angular_velocity += lambda * d.dwa;
  p.b->velocity += lambda * d.dvb;
  p.b->angular_velocity += lambda * d.dwb;
}

void FlatSolver::reach(const Point& p, Direction& d, Real total, Real lo, Real hi) {
  if (total < lo || total > hi) [[unlikely]]
    total = total < lo ? lo : hi;
  const Real change = total - d.impulse;
  d.impulse = total;
  apply(p, d, change);
}

void FlatSolver::solve(World& world, Real dt, int sweeps) {
  Contacts& contacts = world.contacts;
  constexpr Real inf = std::numeric_limits<Real>::infinity();

  // 01: a row for each direction.   K = 1/m_A + 1/m_B + (r_A x n) . I_A^-1 (r_A x n) + (r_B x n) . I_B^-1 (r_B x n)
  points_.clear();
  for (const Contact& c : contacts) {
    const auto [a, b] = world.bodies_of(c);
    const auto [t1, t2] = tangents_of(c.normal);
    points_.push_back({&a, &b, 0, c.friction, direction(a, b, c.point, c.normal), direction(a, b, c.point, t1),
                       direction(a, b, c.point, t2)});
  }

  for (std::size_t i = 0; i < contacts.size(); ++i) {
    const Contact& c = contacts[i];
    Point& p = points_[i];
    // 04: a little overlap is left alone.   C = min(0, -depth + slop)
    const Real separation = std::min(Real(0), -c.depth + slop);
    // 03: the rest becomes a wanted speed.   b = beta / h C
    p.bias = std::min(Real(0), beta / dt * separation);
    // 05: or the bounce, whichever asks for more.   b = min(b, e v_n)
    const Vec3 va = p.a->velocity_before + p.a->angular_velocity_before.cross(c.point - p.a->position);
    const Vec3 vb = p.b->velocity_before + p.b->angular_velocity_before.cross(c.point - p.b->position);
    const Real approach = (vb - va).dot(c.normal);
    if (approach < -threshold) p.bias = std::min(p.bias, c.restitution * approach);
  }

  // 07: start from what the same point had one step before. Both lists ascend.
  std::vector<bool> known(contacts.size(), false);
  std::vector<Vec3> first_guess(contacts.size(), Vec3::Zero());
  const Real scale = world.impulse_scale(dt);
  const Contacts& before = world.contacts_before;
  auto old = before.begin();
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    while (old != before.end() && old->id < contacts[i].id) ++old;
    if (old == before.end() || old->id != contacts[i].id) continue;
    known[i] = true;
    first_guess[i] = scale * old->impulse;
  }
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    Point& p = points_[i];
    reach(p, p.normal, first_guess[i].dot(p.normal.n), 0, inf);
  }
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    Point& p = points_[i];
    if (p.friction == 0) continue;
    reach(p, p.tangent1, first_guess[i].dot(p.tangent1.n), -inf, inf);
    reach(p, p.tangent2, first_guess[i].dot(p.tangent2.n), -inf, inf);
  }

  for (int sweep = 0; sweep < sweeps; ++sweep) {
    // 02: what a normal has pushed so far is not negative.   sum(lambda) in [0, inf)
    for (Point& p : points_) {
      Direction& n = p.normal;
      reach(p, n, n.impulse - n.effective_mass * (speed(p, n) + p.bias), 0, inf);
    }
    // 06: what a tangent has rubbed so far is bounded by it.   |sum(lambda_t)| <= mu sum(lambda_n)
    for (Point& p : points_) {
      if (p.friction == 0) continue;
      const Real bound = p.friction * p.normal.impulse;
      for (Direction* t : {&p.tangent1, &p.tangent2}) {
        reach(p, *t, t->impulse - t->effective_mass * (speed(p, *t) + 0), -bound, bound);
      }
    }
  }

  // Tell the contacts: they remember.
  for (std::size_t i = 0; i < contacts.size(); ++i)
    contacts[i].impulse += points_[i].normal.impulse * points_[i].normal.n;
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    Contact& c = contacts[i];
    const Point& p = points_[i];
    c.state = ContactState::warm;
    if (p.friction > 0) {
      c.impulse += p.tangent1.impulse * p.tangent1.n;
      c.impulse += p.tangent2.impulse * p.tangent2.n;
      const Real bound = p.friction * p.normal.impulse;
      const bool held = std::abs(p.tangent1.impulse) < bound && std::abs(p.tangent2.impulse) < bound;
      c.state = held ? ContactState::sticking : ContactState::sliding;
    }
    if (!known[i]) c.state = ContactState::fresh;
  }
}

}  // namespace pushback
