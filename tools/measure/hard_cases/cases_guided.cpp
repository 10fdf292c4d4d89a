/// What is guided by more than a plane: tiles that lie flush, a table that turns, a groove, a hole; and a ball upon a ball.
#include <cmath>

#include "pushback/common/world/measure.h"
#include "pushback/tools/measure/hard_cases/cases.h"
#include "pushback/tools/measure/hard_cases/sliding.h"
#include "pushback/tools/measure/hard_cases/standing.h"

namespace pushback {

namespace {

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
    play.run(seconds, frame,
             [&](const World& world) { hop = std::max(hop, world.bodies.back().position.y() - start.y()); });
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
    Play play = trial.play([out](World& world) { on_turntable(world, out); },
                           [](const World& world) {  // the table does work
                             Allowance allowance = standing(world);
                             allowance.energy += kinetic_energy(world);
                             return allowance;
                           });
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
  Play play =
      trial.play(two_balls, [](const World& world) { return Allowance{.energy = kinetic_energy(world) / 1000}; });
  play.run(Real(0.4));
  const Real should = comes_with * (heavy * both_e * (2 + both_e) - light) / (heavy + light);
  return {100 * std::abs(play.world.bodies[2].velocity.y() / should - 1)};
}

}  // namespace

std::vector<HardCase> guided_cases() {
  HardCase flush;
  flush.name = "flush-tiles";
  flush.title = "over flush tiles";
  flush.stresses = "a box slides and a ball rolls over tiles: no edge between two of them may be felt";
  flush.criteria = {{"the box's way, off by", "%", 1}, {"the ball's way in 2 s, off by", "mm", 1}, {"hop", "mm", 1}};
  flush.scene = {.name = flush.title, .fill = box_over_tiles, .camera = view({2, 0, 0}, 3), .seconds = 2};
  flush.run = over_tiles;

  HardCase turns;
  turns.name = "turntable";
  turns.title = "a table that turns";
  turns.stresses = "friction bends the way of a box: what is late in each step adds up outwards";
  turns.criteria = {{"outwards after 10 s, where it must stick", "mm", 1},
                    {"not slid by 50 mm after 1 s, where it must slide", "mm", 0}};
  turns.scene = {.name = turns.title,
                 .fill = [](World& world) { on_turntable(world, 1); },
                 .camera = {{0, 3, 4}, {0, 0, 0}},
                 .seconds = 4};
  turns.run = turntable;

  HardCase vee;
  vee.name = "groove";
  vee.title = "cube in a groove";
  vee.stresses = "two planes share a load, and each rubs by its own: sqrt(2) mu in all";
  vee.criteria = {{"distance where it slides, off by", "%", 1},
                  {"creep in the last second, where it must stick", "mm/s", 1}};
  vee.scene = {.name = vee.title,
               .fill = [](World& world) { in_groove(world, Real(0.2)); },
               .camera = view({1, -Real(0.3), 0}, 2),
               .seconds = 1};
  vee.run = groove;

  HardCase hole;
  hole.name = "peg";
  hole.title = "peg in a hole";
  hole.stresses = "eight contacts of opposite normals, 1 mm apart, and a meter to go";
  hole.criteria = {{"above the bottom after 3 s", "mm", 10}, {"deepest overlap", "mm", 10}};
  hole.scene = {.name = hole.title, .fill = peg_over_hole, .camera = view({0, 1, 0}, 3), .seconds = 2};
  hole.run = peg;

  HardCase balls;
  balls.name = "two-balls";
  balls.title = "a small ball on a large one";
  balls.stresses = "two impacts in one step: the small one leaves with 2.3 times the speed it came with";
  balls.criteria = {{"speed of the small one, off by", "%", 1}};
  balls.scene = {.name = balls.title, .fill = two_balls, .camera = view({0, Real(0.3), 0}, 1), .seconds = Real(0.4)};
  balls.run = ball_on_ball;
  return {flush, turns, vee, hole, balls};
}

}  // namespace pushback
