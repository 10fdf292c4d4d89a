/// What must stick sticks, and what slides gets as far as mu lets it.
#include <cmath>

#include "pushback/tools/hard_cases/cases.h"
#include "pushback/tools/hard_cases/sliding.h"
#include "pushback/tools/hard_cases/standing.h"

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
  return {slope, stopping, any};
}

}  // namespace pushback
