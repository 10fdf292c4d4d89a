/// One on the other: many bodies at rest, each carried by the next.
#include <fmt/format.h>

#include "pushback/tools/measure/hard_cases/cases.h"
#include "pushback/tools/measure/hard_cases/standing.h"

namespace pushback {

namespace {

HardCase stack_of(int count, Real drift_limit) {
  const Real height = static_cast<Real>(count);
  HardCase c = must_stand({.name = fmt::format("stack-{}", count),
                           .title = fmt::format("stack of {}", count),
                           .stresses = "every contact carries what is above it: convergence, warm starting, ids",
                           .fill = [count](World& world) { stack(world, count); },
                           .camera = view({0, height / 2, 0}, height + 1),
                           .drift_limit = drift_limit});
  c.starts = many_starts;
  return c;
}

HardCase pyramid_of_20() {
  HardCase c;
  c.name = "pyramid-20";
  c.title = "pyramid of base 20";
  c.stresses = "210 boxes, each on two and under two: loads that spread and go back";
  c.criteria = {{"drift after 10 s", "mm", 5},
                {"deeper than the slop", "mm", 1},
                {"speed in the last second", "mm/s", 1},
                {"kinetic energy in the last second", "mJ", 10}};  // all boxes at 1 mm/s
  c.scene = {.name = c.title,
             .fill = [](World& world) { pyramid(world, 20); },
             .camera = view({0, Real(9.5), 0}, 21),
             .seconds = 10};
  c.run = [fill = c.scene.fill](Trial& trial) -> std::vector<Real> {
    Play play = trial.play(fill, standing);
    const Stood s = stand(play, 10);
    return {1000 * s.drift, 1000 * s.beyond, 1000 * s.jitter, 1000 * s.kinetic};
  };
  return c;
}

/// Boxes of 1 m, one on the other, from below.
void stack_weighing(World& world, const std::vector<Real>& masses) {
  world.add(ground());
  for (const Real mass : masses) {
    world.add(box(Vec3::Constant(Real(0.5)), mass).at({0, static_cast<Real>(world.bodies.size()) - Real(0.5), 0}));
  }
}

HardCase heavy_on_light(int ratio) {
  return must_stand({.name = fmt::format("heavy-{}", ratio),
                     .title = fmt::format("1 : {}, heavy on light", ratio),
                     .stresses = "a sweep passes on 1 / (1 + ratio) of what the lower contact has to learn",
                     .fill = [ratio](World& world) { stack_weighing(world, {100, static_cast<Real>(100 * ratio)}); },
                     .camera = view({0, 1, 0}, Real(2.6)),
                     .beyond_limit = ratio > 100 ? 5 : Real(1)});
}

HardCase densities() {
  HardCase c;
  c.name = "densities-1-1-100";
  c.title = "densities 1, 1, 100";
  c.stresses = "warm starting under a large ratio: it must not pump energy in";
  c.criteria = {{"drift after 10 s", "mm", 1},
                {"deeper than the slop", "mm", 1},
                {"speed in the last second", "mm/s", 1},
                {"energy gained", "J", 1}};  // lifts the three by 0.01 mm
  c.scene = {.name = c.title,
             .fill = [](World& world) { stack_weighing(world, {100, 100, 10000}); },
             .camera = view({0, Real(1.5), 0}, Real(3.6)),
             .seconds = 10};
  c.run = [fill = c.scene.fill](Trial& trial) -> std::vector<Real> {
    Play play = trial.play(fill, standing);
    const Stood s = stand(play, 10);
    return {1000 * s.drift, 1000 * s.beyond, 1000 * s.jitter, play.watcher().energy_gained()};
  };
  return c;
}

}  // namespace

std::vector<HardCase> stack_cases() {
  return {stack_of(10, 1),    stack_of(20, 1),     stack_of(40, 5),      pyramid_of_20(), heavy_on_light(1),
          heavy_on_light(10), heavy_on_light(100), heavy_on_light(1000), densities()};
}

}  // namespace pushback
