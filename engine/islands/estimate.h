/// The error of a step, estimated from the same step with half as many substeps.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "pushback/common/world/world.h"

namespace pushback {

/// Runge's estimate. With n substeps of order p, a step has the error c / n^p, and with half as many 2^p times that:
///
///   x_n/2 - x_n = (2^p - 1) c / n^p
///
/// C. Runge, Math. Ann. 46, 1895; Hairer, Norsett, Wanner, Solving Ordinary Differential Equations I, II.4.
inline Real parts_of_difference(int order) {
  return std::exp2(static_cast<Real>(order)) - 1;
}

/// The verdict on a step of n substeps. `off`: its error as a fraction of the allowed one; `before`: the same for the previous
/// try with half as many, or infinity if there was none.
enum class Worth { kept, more, no_better };

inline Worth worth(Real off, Real before) {
  if (off <= 1) return Worth::kept;
  return off < before / 2 ? Worth::more : Worth::no_better;
}

/// Whether half as many are enough. Their error is 2^p times as large, and must be below half of the allowed error.
inline bool fewer_will_do(Real off, int order) {
  return off * std::exp2(static_cast<Real>(order)) < Real(0.5);
}

/// `off` if all motions were `times` as fast. The error of a step of order p is one of its (p + 1)th derivatives, and a rotation
/// w times as fast has derivatives w^(p + 1) times as large. It decides when to check again.
inline Real off_when(Real times, Real off, int order) {
  return off * std::pow(times, static_cast<Real>(order + 1));
}

/// m, at most: a body that comes to rest, or to roll, in a substep of h does so at its start. It loses a t^2 / 2 of its way,
/// t <= h, and as much in a substep half as long, if this is not shorter than t. So two results agree although both are wrong.
inline Real sticks_early(Real deceleration, Real h) {
  return deceleration * h * h / 2;
}

/// m: the largest depth to which the bodies of `of` have sunk into their supports. A stack of N boxes on springs sinks by the
/// sum of its depths, and this is the error of its law. A body on several supports has sunk by the mean of their values plus the
/// depths between, each weighted by its share of the load:
///
///   s_b = sum of J (s_a + depth) / sum of J,   J: the impulse upwards from a, N s;   0 without supports
template <class Among>
Real sunken(const World& world, const Among& among) {
  struct Carries {
    std::size_t below, above;
    Real impulse, depth;  // N s; m
  };
  std::vector<Carries> all;
  std::vector<Real> load(world.bodies.size());
  for (const Contact& contact : world.contacts) {
    const Real upwards = -contact.impulse.dot(world.gravity.normalized());
    if (contact.parted || contact.depth < 0 || upwards == 0) continue;
    std::size_t below = contact.id.body_a, above = contact.id.body_b;
    if (upwards < 0) std::swap(below, above);
    if (!world.bodies[above].movable()) continue;
    all.push_back({below, above, std::abs(upwards), contact.depth});
    load[above] += std::abs(upwards);
  }
  // From the bottom up, one or two rounds are enough for a pile of any height.
  const auto lower = [&world](const Carries& p, const Carries& q) {
    const auto fallen = [&world](std::size_t body) { return world.bodies[body].position.dot(world.gravity); };
    const Real one = fallen(p.above), other = fallen(q.above);
    return one != other ? one > other : p.above < q.above;
  };
  std::stable_sort(all.begin(), all.end(), lower);
  std::vector<Real> sunk(world.bodies.size());
  bool changed = true;
  for (std::size_t round = 0; changed && round < world.bodies.size(); ++round) {
    changed = false;
    for (auto one = all.begin(); one != all.end();) {
      const std::size_t above = one->above;
      Real now = 0;
      for (; one != all.end() && one->above == above; ++one)
        now += one->impulse / load[above] * (sunk[one->below] + one->depth);
      changed |= std::abs(now - sunk[above]) > now / 1000;
      sunk[above] = now;
    }
  }
  Real deepest = 0;
  for (const Body& body : world.bodies)
    if (body.movable() && among(body.index)) deepest = std::max(deepest, sunk[std::size_t(body.index)]);
  return deepest;
}

}  // namespace pushback
