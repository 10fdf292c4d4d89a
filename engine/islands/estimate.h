/// How far a step is off, from the same step in half as many substeps.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "pushback/common/world/world.h"

namespace pushback {

/// Runge's estimate. In n substeps of order p a step is off by c / n^p, in half as many by 2^p times that:
///
///   x_n/2 - x_n = (2^p - 1) c / n^p
///
/// C. Runge, Math. Ann. 46, 1895; Hairer, Norsett, Wanner, Solving Ordinary Differential Equations I, II.4.
inline Real parts_of_difference(int order) {
  return std::exp2(static_cast<Real>(order)) - 1;
}

/// What a step in n substeps is worth. `off`: its error in parts of what is allowed; `before`: the same of the try before, in half as
/// many, infinite if there was none.
enum class Worth { kept, more, no_better };

inline Worth worth(Real off, Real before) {
  if (off <= 1) return Worth::kept;
  return off < before / 2 ? Worth::more : Worth::no_better;
}

/// Whether half as many will do: their error is 2^p times as large, and is to be below a half of what is allowed.
inline bool fewer_will_do(Real off, int order) {
  return off * std::exp2(static_cast<Real>(order)) < Real(0.5);
}

/// What `off` becomes where all turns `times` as fast. The error of a step of order p is one of its (p + 1)th derivatives, and what turns
/// w times as fast has them w^(p + 1) times as large. It tells when to look again.
inline Real off_when(Real times, Real off, int order) {
  return off * std::pow(times, static_cast<Real>(order + 1));
}

/// m, at most: what comes to rest, or to roll, in a substep of h does so as the substep begins. It loses a t^2 / 2 of its way, t <= h: as
/// much in a substep half as long, if that is not shorter than t. So two results agree, and both are off.
inline Real sticks_early(Real deceleration, Real h) {
  return deceleration * h * h / 2;
}

/// m: how far the bodies among `of` have sunk into what carries them, the deepest. A stack of N boxes on springs sinks by the sum of all
/// its depths, and that is the error of its law. A body that several carry has sunk by the mean of what these have, and of the depths
/// between, each by its part of the load:
///
///   s_b = sum of J (s_a + depth) / sum of J,   J: the impulse upwards from a, N s;   0 where nothing carries
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
  // From the bottom up: then one or two rounds are enough for a pile of any height.
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
