/// Chapter 25: the plain form of conservative advancement, compared with bisection, the closed form and the engine.
#include "pushback/chapters/25_moment_of_impact/plain.h"

#include "pushback/common/bodies/random.h"
#include "pushback/common/world/situations.h"
#include "pushback/engine/half_step/first_touch.h"
#include "tests/support/catch.h"
#include "tests/support/yardstick.h"

using namespace pushback;

namespace {

constexpr Real within = Real(1) / 30;                       // s
constexpr Real near = in_double ? Real(1e-9) : Real(1e-4);  // m

plain_25::Rod random_rod(Random& random) {
  plain_25::Rod rod{0, random.between(-8, 2), random.between(0, 3), random.between(-30, 30), Real(0.5)};
  rod.y = rod.half * std::abs(std::sin(rod.angle)) + random.between(Real(0.001), Real(0.3));
  return rod;
}
Real gap_after(plain_25::Rod rod, Real t) {
  plain_25::fly(rod, g, t);
  return plain_25::gap(rod);
}

/// The lowest gap of a motion that has been sampled, and the first time at which it is 0.
struct Sampled {
  Real lowest = 1;              // m
  std::optional<Real> touches;  // s
};
Sampled sampled(const plain_25::Rod& rod) {
  constexpr int samples = 2000;
  Sampled found;
  for (int i = 1; i <= samples && !found.touches; ++i) {
    Real before = within * static_cast<Real>(i - 1) / samples, after = within * static_cast<Real>(i) / samples;
    found.lowest = std::min(found.lowest, gap_after(rod, after));
    if (found.lowest > 0) continue;
    for (int k = 0; k < 100; ++k) {
      const Real middle = (before + after) / 2;
      (gap_after(rod, middle) > 0 ? before : after) = middle;
    }
    found.touches = after;
  }
  return found;
}

/// The time at which the engine has the rod touch. It is a capsule there, raised by its radius. It flies in `parts`, because a body
/// turns by 2 atan(w t / 2) in a step of the engine, and not by w t.
std::optional<Real> touch_of_engine(const plain_25::Rod& rod, int parts) {
  constexpr Real radius = Real(0.05);
  const Real part = within / static_cast<Real>(parts);
  const Body plane = ground();
  Body body = capsule(radius, rod.half, 1).turned(rod.angle - pi / 2, Vec3::UnitZ());
  body.at({0, rod.y + radius, 0}).moving({0, rod.v, 0}).spinning({0, 0, rod.spin});
  body.refresh_inertia();
  for (int i = 0; i < parts; ++i) {
    Flight still(plane, Vec3::Zero(), Vec3::Zero(), part), flies(body, {0, -g, 0}, Vec3::Zero(), part);
    if (const auto touch = first_touch(still, flies, part, near)) return static_cast<Real>(i) * part + *touch;
    const Body& later = flies.at(part);
    body.position = later.position;
    body.orientation = later.orientation;
    body.velocity.y() -= part * g;
    body.refresh_inertia();
  }
  return {};
}

}  // namespace

TEST_CASE("plain advancement: a rod is found to touch just before bisection says that it does, and never later") {
  if (!in_double) return;  // in floats a gap of 1e-9 m is rounding
  Random random(32);
  int met = 0, missed = 0;
  for (int i = 0; i < 2000; ++i) {
    CAPTURE(i);
    const plain_25::Rod rod = random_rod(random);
    const Sampled truth = sampled(rod);
    const auto touch = plain_25::time_of_impact(rod, g, within, near);
    if (!truth.touches && truth.lowest < Real(1e-5)) continue;  // it may dip below the ground between two samples
    REQUIRE(touch.has_value() == truth.touches.has_value());
    missed += !touch;
    if (!touch) continue;
    ++met;
    CHECK(*touch < *truth.touches);
    CHECK(gap_after(rod, *touch) > 0);
    CHECK(gap_after(rod, *touch) < Real(1.001) * near);
    const Real speed = (gap_after(rod, *touch) - gap_after(rod, *truth.touches + Real(1e-6))) /
                       (*truth.touches + Real(1e-6) - *touch);  // m/s, of the approach
    CHECK(*truth.touches - *touch < Real(1.1) * near / speed);
  }
  CHECK(met > 500);
  CHECK(missed > 500);
}

TEST_CASE("plain advancement: a rod that does not turn touches when the closed form says so") {
  for (const Real v : {Real(0), Real(3), Real(-4)}) {
    const plain_25::Rod rod{2, v, Real(0.7), 0, Real(0.5)};
    const auto touch = plain_25::time_of_impact(rod, g, 2, near);
    REQUIRE(touch);
    const Real closed = (v + std::sqrt(v * v + 2 * g * plain_25::gap(rod))) / g;
    CHECK(*touch == Approx(closed).margin(in_double ? 1e-9 : 1e-4));
  }
}

TEST_CASE("plain advancement: the engine finds the same time for the same motion") {
  if (!in_double) return;
  Random random(33);
  int met = 0;
  for (int i = 0; i < 200; ++i) {
    CAPTURE(i);
    plain_25::Rod rod = random_rod(random);
    if (i % 4 == 0) rod.spin = 0;
    const auto touch = plain_25::time_of_impact(rod, g, within, near);
    const auto of_engine = touch_of_engine(rod, rod.spin == 0 ? 1 : 1000);
    REQUIRE(touch.has_value() == of_engine.has_value());
    if (!touch) continue;
    CHECK(*touch == Approx(*of_engine).margin(1e-8));
    ++met;
  }
  CHECK(met > 50);
}
