/// What must stick sticks, and what slides gets as far as mu lets it; and what is guided by more than a plane: tiles that lie flush, a
/// table that turns, a groove, a hole, a ball below.
#include <cmath>

#include "pushback/common/world/measure.h"
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

constexpr Real four_radius = Real(0.2);  // m, the radius

/// One ball in the hollow of three that touch each other: the steepest heap that balls can make. The lines between the centres are
/// theta off the upright, sin(theta) = 1 / sqrt(3). What presses on a lower ball from above must meet its other two forces in the point on
/// the ground, and the line from there to the point of contact is theta / 2 off the normal, so the balls stay if and only if
///
///   mu > tan(theta / 2) = 0.318                      on the ground a quarter of it is enough
void four_balls(World& world, Real part_of_needed) {
  const Real mu = part_of_needed * std::tan(std::asin(1 / std::sqrt(Real(3))) / 2),
             out = 2 * four_radius / std::sqrt(Real(3));
  world.add(ground().rough(mu));
  for (int i = 0; i < 3; ++i) {
    const Real at = 2 * pi * static_cast<Real>(i) / 3;
    world.add(sphere(four_radius, 10).at({out * std::cos(at), four_radius, out * std::sin(at)}).rough(mu));
  }
  world.add(sphere(four_radius, 10).at({0, four_radius + 2 * four_radius * std::sqrt(Real(2) / 3), 0}).rough(mu));
}

std::vector<Real> smallest_heap(Trial& trial) {
  const auto after = [&](Real part, Real seconds) {
    Play play = trial.play([part](World& world) { four_balls(world, part); }, standing);
    const Stood stood = stand(play, seconds);
    return std::pair{stood.drift, play.world.bodies.back().position.y() - four_radius};
  };
  const Real stays = after(Real(1.05), 10).first, falls = after(Real(0.95), 3).second;
  return {1000 * stays, 1000 * falls};
}

// ---- guided ----------------------------------------------------------------------------------------------------------

constexpr Real tile = Real(0.5);  // m, its side

/// A floor of tiles whose tops lie flush at y = 0.
void tiles(World& world, Real mu) {
  for (int i = -2; i < 14; ++i)
    world.add(box({tile / 2, tile / 2, tile}, 1).fixed().at({tile * static_cast<Real>(i), -tile / 2, 0}).rough(mu));
}

constexpr Real tile_mu = Real(0.2), tile_speed = 4, ball_speed = 2, rolling_radius = Real(0.2);

void box_over_tiles(World& world) {
  tiles(world, tile_mu);
  world.add(box(Vec3::Constant(Real(0.2)), 10).at({0, Real(0.19999), 0}).moving({tile_speed, 0, 0}).rough(tile_mu));
}
void ball_over_tiles(World& world) {
  tiles(world, Real(0.5));
  world.add(sphere(rolling_radius, 10)
                .at({0, rolling_radius, 0})
                .moving({ball_speed, 0, 0})
                .spinning({0, 0, -ball_speed / rolling_radius}));
}

/// A box slides as far as on one plane, and a ball rolls on as if there were no edges.
std::vector<Real> over_tiles(Trial& trial) {
  Real hop = 0;
  const auto way = [&](const std::function<void(World&)>& fill, Real seconds) {
    Play play = trial.play(fill, standing);
    const Vec3 start = play.world.bodies.back().position;
    const auto risen = [&](const World& world) { return world.bodies.back().position.y() - start.y(); };
    hop = std::max(hop, play.largest(seconds, risen));
    return play.world.bodies.back().position.x() - start.x();
  };
  const Real slid = way(box_over_tiles, tile_speed / (tile_mu * World::g) + Real(0.5)),
             rolled = way(ball_over_tiles, 2);
  return {100 * std::abs(slid / discrete_distance(tile_mu, tile_speed, trial.substep()) - 1),
          1000 * std::abs(rolled - 2 * ball_speed), 1000 * hop};
}

constexpr Real table_turns = 2, table_mu = Real(0.5);  // rad/s

/// A box lies `out` (m) from the middle of a table, and turns with it.
void on_turntable(World& world, Real out) {
  const Vec3 turning{0, table_turns, 0}, at{out, Real(0.1), 0};
  world.add(box({2, Real(0.25), 2}, 1).fixed().at({0, Real(-0.25), 0}).spinning(turning).rough(table_mu));
  world.add(
      box({Real(0.2), Real(0.1), Real(0.2)}, 10).at(at).moving(turning.cross(at)).spinning(turning).rough(table_mu));
}

/// mu g = 4.9 m/s^2 holds what w^2 r pulls outward up to r = 1.23 m.
std::vector<Real> turntable(Trial& trial) {
  const auto out_after = [&](Real out, Real seconds) {
    const auto worked_on = [](const World& world) {
      return Allowance{.energy = standing(world).energy + kinetic_energy(world)};
    };
    Play play = trial.play([out](World& world) { on_turntable(world, out); }, worked_on);
    play.run(seconds);
    const Vec3& at = play.world.bodies[1].position;
    return std::hypot(at.x(), at.z());
  };
  const Real sticks = out_after(1, 10), slides = out_after(Real(1.4), 1);
  return {1000 * std::abs(sticks - 1), 1000 * std::max(Real(0), Real(1.45) - slides)};
}

constexpr Real groove_angle = 25 * pi / 180, groove_half = Real(0.2);  // rad, m

/// A cube on its edge in a groove of 90 degrees that leads downwards along x.
void in_groove(World& world, Real mu) {
  const Vec3 down{std::cos(groove_angle), -std::sin(groove_angle), 0},
      up{std::sin(groove_angle), std::cos(groove_angle), 0};
  const Vec3 left = (up - Vec3::UnitZ()) / std::sqrt(Real(2)), right = (up + Vec3::UnitZ()) / std::sqrt(Real(2));
  world.add(half_space(left).rough(mu));
  world.add(half_space(right).rough(mu));
  Mat3 axes;
  axes << down, right.cross(down), right;
  world.add(
      box(Vec3::Constant(groove_half), 10).oriented(Quat(axes)).at(groove_half * std::sqrt(Real(2)) * up).rough(mu));
}

/// Each side presses with m g cos / sqrt(2):   a = g (sin - sqrt(2) mu cos)
std::vector<Real> groove(Trial& trial) {
  const auto way = [&](Real mu, Real from, Real to) {
    Play play = trial.play([mu](World& world) { in_groove(world, mu); }, standing);
    play.run(from);
    const Vec3 start = play.world.bodies[2].position;
    play.run(to - from);
    return (play.world.bodies[2].position - start).norm();
  };
  constexpr Real mu = Real(0.2);
  const Real should = World::g * (std::sin(groove_angle) - std::sqrt(Real(2)) * mu * std::cos(groove_angle)) * 2 *
                      (2 + trial.substep()) / 2;
  return {100 * std::abs(way(mu, 0, 2) / should - 1), 1000 * way(Real(0.4), 1, 2)};
}

constexpr Real peg_half = Real(0.1), peg_half_length = Real(0.5), clearance = Real(0.001);  // m

/// A square peg over a square hole, wider by the clearance on each side, turned by half of what would still go in.
void peg_over_hole(World& world) {
  constexpr Real depth = 1, thick = Real(0.2), wide = peg_half + clearance;
  world.add(ground());
  for (const Real side : {Real(-1), Real(1)}) {
    world.add(box({thick, depth / 2, wide + 2 * thick}, 1).fixed().at({side * (wide + thick), depth / 2, 0}));
    world.add(box({wide, depth / 2, thick}, 1).fixed().at({0, depth / 2, side * (wide + thick)}));
  }
  world.add(box({peg_half, peg_half_length, peg_half}, 5)
                .turned(clearance / (2 * peg_half), Vec3::UnitY())
                .at({0, depth + peg_half_length + Real(0.01), 0}));
}

std::vector<Real> peg(Trial& trial) {
  Play play = trial.play(peg_over_hole, standing);
  play.run(3);
  return {1000 * (play.world.bodies.back().position.y() - peg_half_length), 1000 * play.watcher().deepest()};
}

constexpr Real lower = Real(0.12), upper = Real(0.035), heavy = Real(0.6), light = Real(0.06), comes_with = 4,
               both_e = Real(0.9);

/// Without gravity, so that no step falls differently: a ball comes down with a small one upon it, 2 mm behind.
void two_balls(World& world) {
  world.gravity.setZero();
  world.add(ground().bouncy(both_e));
  world.add(sphere(lower, heavy).at({0, lower + Real(0.3), 0}).moving({0, -comes_with, 0}).bouncy(both_e));
  world.add(
      sphere(upper, light).at({0, 2 * lower + upper + Real(0.302), 0}).moving({0, -comes_with, 0}).bouncy(both_e));
}

/// The large one leaves the ground with e v and meets the small one:   (M e (2 + e) - m) v / (M + m)
std::vector<Real> ball_on_ball(Trial& trial) {
  Play play = trial.play(two_balls, bouncing());
  play.run(Real(0.4));
  const Real should = comes_with * (heavy * both_e * (2 + both_e) - light) / (heavy + light);
  return {100 * std::abs(play.world.bodies[2].velocity.y() / should - 1)};
}

/// One of each heading, on one ground.
void to_all_sides(World& world) {
  for (int i = 0; i < headings; ++i) {
    sliding_box(world, Real(0.5), 5, 2 * pi * static_cast<Real>(i) / headings);
    if (i > 0) world.bodies.erase(world.bodies.end() - 2);
    Body& last = world.bodies.back();
    last.index = i + 1;
    last.position += last.velocity.normalized();
  }
}

}  // namespace

std::vector<HardCase> friction_cases() {
  const auto slope = [](World& world) { box_on_slope(world, pi / 9, Real(0.9) * std::tan(pi / 9)); };
  return {
      {.name = "slopes",
       .title = "35 slopes",
       .stresses = "5 angles, mu from 0.1 to 2 times the tangent: sticks or slides, and no creeping",
       .criteria = {{"creep in the last second, where it must stick", "mm/s", Real(0.1)},
                    {"distance where it slides, off by", "%", Real(0.1)}},
       .scene = seen(slope, view({-Real(0.2), 0, 0}, Real(0.9)), 1),
       .run = slopes},
      {.name = "stopping-distance",
       .title = "stopping distance",
       .stresses = "mu 0.2, 0.5, 0.8 from 3 and 10 m/s, along a tangent",
       .criteria = {{"distance, off by", "%", Real(0.1)}},
       .scene = seen([](World& world) { sliding_box(world, Real(0.5), 3, 0); }, view({Real(0.6), 0, 0}, Real(0.9)), 1),
       .run = stopping_distances},
      {.name = "headings",
       .title = "12 headings",
       .stresses = "friction must not know where the axes point",
       .criteria = {{"distance, off by", "%", 1}, {"sideways, of the distance", "%", 1}},
       .scene = seen(to_all_sides, {{0, 13, 5}, {0, 0, Real(0.1)}}, 2),
       .run = all_headings},
      {.name = "four-balls",
       .title = "a ball on three",
       .stresses = "the smallest heap, at 1.05 and 0.95 times the friction at which it rolls apart",
       .criteria = {{"sideways in 10 s, where it must stay", "mm", 1},
                    {"above the ground after 3 s, where it must fall", "mm", 10}},
       .scene =
           seen([](World& world) { four_balls(world, Real(0.95)); }, view({0, Real(0.3), 0}, Real(1.6)), Real(1.5)),
       .run = smallest_heap}};
}

std::vector<HardCase> guided_cases() {
  return {
      {.name = "flush-tiles",
       .title = "over flush tiles",
       .stresses = "a box slides and a ball rolls over tiles: no edge between two of them may be felt",
       .criteria = {{"the box's way, off by", "%", 1}, {"the ball's way in 2 s, off by", "mm", 1}, {"hop", "mm", 1}},
       .scene = seen(box_over_tiles, view({2, 0, 0}, 3), 2),
       .run = over_tiles},
      {.name = "turntable",
       .title = "a table that turns",
       .stresses = "friction bends the way of a box: what is late in each step adds up outwards",
       .criteria = {{"outwards after 10 s, where it must stick", "mm", 1},
                    {"not slid by 50 mm after 1 s, where it must slide", "mm", 0}},
       .scene = seen([](World& world) { on_turntable(world, 1); }, {{0, 3, 4}, {0, 0, 0}}, 4),
       .run = turntable},
      {.name = "groove",
       .title = "cube in a groove",
       .stresses = "two planes share a load, and each rubs by its own: sqrt(2) mu in all",
       .criteria = {{"distance where it slides, off by", "%", 1},
                    {"creep in the last second, where it must stick", "mm/s", 1}},
       .scene = seen([](World& world) { in_groove(world, Real(0.2)); }, view({1, -Real(0.3), 0}, 2), 1),
       .run = groove},
      {.name = "peg",
       .title = "peg in a hole",
       .stresses = "eight contacts of opposite normals, 1 mm apart, and a meter to go",
       .criteria = {{"above the bottom after 3 s", "mm", 10}, {"deepest overlap", "mm", 10}},
       .scene = seen(peg_over_hole, view({0, 1, 0}, 3), 2),
       .run = peg},
      {.name = "two-balls",
       .title = "a small ball on a large one",
       .stresses = "two impacts in one step: the small one leaves with 2.3 times the speed it came with",
       .criteria = {{"speed of the small one, off by", "%", 1}},
       .scene = seen(two_balls, view({0, Real(0.3), 0}, 1), Real(0.4)),
       .run = ball_on_ball}};
}

}  // namespace pushback
