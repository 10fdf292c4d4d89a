#include "pushback/common/world/situations.h"

#include <cmath>

namespace pushback {

int slab(World& world) {
  world.add(half_space(Vec3::UnitY()).at({0, Real(-0.5), 0}));
  return world.add(box({4, Real(0.25), Real(0.47)}, 1).fixed().at({0, Real(-0.25), 0}));
}

void stack(World& world, int count, Real gap, Real mass) {
  world.add(ground());
  for (int i = 0; i < count; ++i) {
    world.add(box(Vec3::Constant(Real(0.5)), mass).at({0, Real(0.5) + static_cast<Real>(i) * (1 + gap), 0}));
  }
}

void stack_before_posts(World& world, int count) {
  for (const int side : {-1, 1}) {
    const Vec3 at(static_cast<Real>(side) * Real(0.66), 0, -2);
    world.add(box({Real(0.04), static_cast<Real>(count), Real(0.04)}, 1).fixed().at(at));
  }
  stack(world, count);
}

void pyramid(World& world, int base) {
  world.add(ground());
  for (int row = 0; row < base; ++row) {
    for (int i = 0; i < base - row; ++i) {
      const Real x = static_cast<Real>(i) - static_cast<Real>(base - row - 1) / 2;
      world.add(box(Vec3::Constant(Real(0.5)), 100).at({x * Real(1.1), Real(0.5) + static_cast<Real>(row), 0}));
    }
  }
}

void heap(World& world, int n, int high, Real first) {
  world.add(ground());
  for (int i = 0; i < n * n * high; ++i) {
    const int layer = i / (n * n);
    const Vec3 place{static_cast<Real>(i % n) + first, Real(0.6) + static_cast<Real>(layer) * Real(1.1),
                     static_cast<Real>(i / n % n) + first};
    world.add(box({Real(0.4), Real(0.3), Real(0.45)}, 100)
                  .turned(static_cast<Real>(i % 7) * Real(0.2), Vec3(1, 2, 3))
                  .at(place));
  }
}

int incline(World& world, Real angle, Real friction) {
  constexpr Real thickness = Real(0.4);
  const Vec3 down = Vec3(std::sin(angle), -std::cos(angle), 0);
  return world.add(
      box({6, thickness / 2, 2}, 1).fixed().turned(angle, Vec3::UnitZ()).at(thickness / 2 * down).rough(friction));
}

}  // namespace pushback
