/// A small ball rides on a large one, and both are dropped.
#include <cmath>

#include "pushback/common/world/measure.h"
#include "pushback/tools/measure/hard_cases/cases.h"
#include "pushback/tools/measure/hard_cases/standing.h"

namespace pushback {

namespace {

/// A basketball and a tennis ball: m and kg. Both bounce with e = 0.9, from 1 m, and 3 mm are between them.
constexpr Real large_radius = Real(0.12), small_radius = Real(0.033), large_mass = Real(0.62), small_mass = Real(0.058);
constexpr Real dropped_from = 1, gap_between = Real(0.003), balls_e = Real(0.9);

void tennis_on_basketball(World& world) {
  world.add(ground().bouncy(balls_e));
  world.add(sphere(large_radius, large_mass).at({0, dropped_from + large_radius, 0}).bouncy(balls_e));
  world.add(sphere(small_radius, small_mass)
                .at({0, dropped_from + 2 * large_radius + gap_between + small_radius, 0})
                .bouncy(balls_e));
}

/// m, of the tennis ball's lowest point above the ground at its apex, by Newton's impacts in turn. Both come down with v, the
/// basketball leaves the ground with e v, and the two meet after the time t in which they close the gap. Both accelerate alike, so
/// they close with (1 + e) v:
///
///   v = sqrt(2 g h),  t = gap / ((1 + e) v),  V = e v - g t,  u = -v - g t
///   u' = u + (1 + e) M / (M + m) (V - u)
Real apex() {
  const Real v = std::sqrt(2 * World::g * dropped_from), t = gap_between / ((1 + balls_e) * v);
  const Real ball = balls_e * v - World::g * t, small = -v - World::g * t;
  const Real after = small + (1 + balls_e) * large_mass / (large_mass + small_mass) * (ball - small);
  const Real met = 2 * large_radius + balls_e * v * t - World::g * t * t / 2;
  return met + after * after / (2 * World::g);
}

std::vector<Real> how_high(Trial& trial) {
  const Real start = World::g * dropped_from * (large_mass + small_mass);  // J, above the lowest
  Play play = trial.play(tennis_on_basketball, Allowance{.energy = start / 1000});
  Real highest = 0;
  bool bounced = false;
  // It meets the basketball after 0.45 s and is at its apex after 1.5 s.
  play.run(Real(1.8), frame, [&](const World& world) {
    const Body& ball = world.bodies[2];
    bounced = bounced || ball.velocity.y() > 0;
    if (bounced) highest = std::max(highest, ball.position.y() - small_radius);
  });
  return {100 * std::abs(highest / apex() - 1), 100 * play.watcher().energy_gained() / start};
}

}  // namespace

std::vector<HardCase> ball_cases() {
  HardCase balls;
  balls.name = "basketball";
  balls.title = "tennis ball on a basketball";
  balls.stresses = "two impacts within half a millisecond, and the order of them makes five times the height";
  balls.criteria = {{"apex of the tennis ball, off by", "%", 1}, {"energy gained", "%", Real(0.1)}};
  balls.scene = {
      .name = balls.title, .fill = tennis_on_basketball, .camera = view({0, Real(0.8), 0}, Real(1.8)), .seconds = 0};
  balls.run = how_high;
  return {balls};
}

}  // namespace pushback
