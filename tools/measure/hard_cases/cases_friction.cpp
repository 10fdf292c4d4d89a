/// What must stick sticks, and what slides gets as far as mu lets it.
#include <cmath>

#include "pushback/tools/measure/hard_cases/cases.h"
#include "pushback/tools/measure/hard_cases/sliding.h"
#include "pushback/tools/measure/hard_cases/standing.h"

namespace pushback {

namespace {

/// It sticks if and only if tan(theta) < mu; else it slides, and moves by steps of dt as far as
///
///   a t (t + dt) / 2,   a = g (sin(theta) - mu cos(theta)),   t = 2 s      dt: the stage's own substep
std::vector<Real> slopes(Trial& trial) {
  Real creep = 0, off = 0;
  for (const int degrees : {5, 15, 25, 35, 45}) {
    const Real theta = static_cast<Real>(degrees) * pi / 180;
    const Vec3 down{-std::cos(theta), -std::sin(theta), 0};
    for (const Real part : {Real(0.1), Real(0.5), Real(0.9), Real(0.99), Real(1.01), Real(1.1), Real(2)}) {
      const Real mu = part * std::tan(theta);
      Play play = trial.play([=](World& world) { box_on_slope(world, theta, mu); }, standing);
      const Vec3 start = play.world.bodies[1].position;
      play.run(1);
      const Vec3 after_1_s = play.world.bodies[1].position;
      play.run(1);
      const Vec3 end = play.world.bodies[1].position;
      if (part > 1) creep = std::max(creep, (end - after_1_s).norm());
      if (part > 1) continue;
      const Real way = World::g * (std::sin(theta) - mu * std::cos(theta)) * 2 * (2 + trial.substep()) / 2;
      off = std::max(off, std::abs((end - start).dot(down) / way - 1));
    }
  }
  return {1000 * creep, 100 * off};
}

/// Where it has got to when it should have stopped half a second ago.
Vec3 way_of(Trial& trial, Real mu, Real speed, Real heading) {
  Play play = trial.play([=](World& world) { sliding_box(world, mu, speed, heading); }, standing);
  const Vec3 start = play.world.bodies[1].position;
  play.run(speed / (mu * World::g) + Real(0.5));
  return play.world.bodies[1].position - start;
}

std::vector<Real> stopping_distances(Trial& trial) {
  Real off = 0;
  for (const Real mu : {Real(0.2), Real(0.5), Real(0.8)}) {
    for (const Real speed : {Real(3), Real(10)}) {
      const Real way = way_of(trial, mu, speed, 0).x();
      off = std::max(off, std::abs(way / discrete_distance(mu, speed, trial.substep()) - 1));
    }
  }
  return {100 * off};
}

constexpr int headings = 12;

std::vector<Real> all_headings(Trial& trial) {
  constexpr Real mu = Real(0.5), speed = 5;
  Real off = 0, astray = 0;
  for (int i = 0; i < headings; ++i) {
    const Real heading = 2 * pi * static_cast<Real>(i) / headings;
    const Vec3 way = way_of(trial, mu, speed, heading);
    const Vec3 ahead{std::cos(heading), 0, -std::sin(heading)}, aside{std::sin(heading), 0, std::cos(heading)};
    const Real should = discrete_distance(mu, speed, trial.substep());
    off = std::max(off, std::abs(way.dot(ahead) / should - 1));
    astray = std::max(astray, std::abs(way.dot(aside)) / should);
  }
  return {100 * off, 100 * astray};
}

constexpr Real ball = Real(0.2);  // m, the radius

/// One ball in the hollow of three that touch each other: the steepest heap that balls can make. The lines between the centres are
/// theta off the upright, sin(theta) = 1 / sqrt(3). What presses on a lower ball from above must meet its other two forces in the point on
/// the ground, and the line from there to the point of contact is theta / 2 off the normal, so the balls stay if and only if
///
///   mu > tan(theta / 2) = 0.318                      on the ground a quarter of it is enough
void four_balls(World& world, Real part_of_needed) {
  const Real mu = part_of_needed * std::tan(std::asin(1 / std::sqrt(Real(3))) / 2), out = 2 * ball / std::sqrt(Real(3));
  world.add(ground().rough(mu));
  for (int i = 0; i < 3; ++i) {
    const Real at = 2 * pi * static_cast<Real>(i) / 3;
    world.add(sphere(ball, 10).at({out * std::cos(at), ball, out * std::sin(at)}).rough(mu));
  }
  world.add(sphere(ball, 10).at({0, ball + 2 * ball * std::sqrt(Real(2) / 3), 0}).rough(mu));
}

std::vector<Real> smallest_heap(Trial& trial) {
  const auto after = [&](Real part, Real seconds) {
    Play play = trial.play([part](World& world) { four_balls(world, part); }, standing);
    const Stood stood = stand(play, seconds);
    return std::pair{stood.drift, play.world.bodies.back().position.y() - ball};
  };
  const Real stays = after(Real(1.05), 10).first, falls = after(Real(0.95), 3).second;
  return {1000 * stays, 1000 * falls};
}

}  // namespace

std::vector<HardCase> friction_cases() {
  HardCase slope;
  slope.name = "slopes";
  slope.title = "35 slopes";
  slope.stresses = "5 angles, mu from 0.1 to 2 times the tangent: sticks or slides, and no creeping";
  slope.criteria = {{"creep in the last second, where it must stick", "mm/s", Real(0.1)},
                    {"distance where it slides, off by", "%", Real(0.1)}};
  slope.scene = {.name = slope.title,
                 .fill = [](World& world) { box_on_slope(world, pi / 9, Real(0.9) * std::tan(pi / 9)); },
                 .camera = view({-Real(0.2), 0, 0}, Real(0.9)),
                 .seconds = 1};
  slope.run = slopes;

  HardCase stopping;
  stopping.name = "stopping-distance";
  stopping.title = "stopping distance";
  stopping.stresses = "mu 0.2, 0.5, 0.8 from 3 and 10 m/s, along a tangent";
  stopping.criteria = {{"distance, off by", "%", Real(0.1)}};
  stopping.scene = {.name = stopping.title,
                    .fill = [](World& world) { sliding_box(world, Real(0.5), 3, 0); },
                    .camera = view({Real(0.6), 0, 0}, Real(0.9)),
                    .seconds = 1};
  stopping.run = stopping_distances;

  HardCase any;
  any.name = "headings";
  any.title = "12 headings";
  any.stresses = "friction must not know where the axes point";
  any.criteria = {{"distance, off by", "%", 1}, {"sideways, of the distance", "%", 1}};
  any.scene = {.name = any.title,
               .fill =
                   [](World& world) {
                     for (int i = 0; i < headings; ++i) {
                       sliding_box(world, Real(0.5), 5, 2 * pi * static_cast<Real>(i) / headings);
                       if (i > 0) world.bodies.erase(world.bodies.end() - 2);  // one ground will do
                       Body& last = world.bodies.back();
                       last.index = i + 1;
                       last.position += last.velocity.normalized();
                     }
                   },
               .camera = {{0, 13, 5}, {0, 0, Real(0.1)}},
               .seconds = 2};
  any.run = all_headings;

  HardCase heap;
  heap.name = "four-balls";
  heap.title = "a ball on three";
  heap.stresses = "the smallest heap, at 1.05 and 0.95 times the friction at which it rolls apart";
  heap.criteria = {{"sideways in 10 s, where it must stay", "mm", 1},
                   {"above the ground after 3 s, where it must fall", "mm", 10}};
  heap.scene = {.name = heap.title,
                .fill = [](World& world) { four_balls(world, Real(0.95)); },
                .camera = view({0, Real(0.3), 0}, Real(1.6)),
                .seconds = Real(1.5)};
  heap.run = smallest_heap;
  return {slope, stopping, any, heap};
}

}  // namespace pushback
