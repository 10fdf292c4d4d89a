/// How high it bounces, and what an impact leaves in a row and in a crowd.
#include <cmath>

#include "pushback/common/bodies/random.h"
#include "pushback/common/world/measure.h"
#include "pushback/tools/measure/hard_cases/cases.h"
#include "pushback/tools/measure/hard_cases/standing.h"

namespace pushback {

namespace {

constexpr Real ball_radius = Real(0.3);

void ball_over_ground(World& world, Real drop, Real e) {
  world.add(ground().rough(0));
  world.add(sphere(ball_radius, 10).at({0, ball_radius + drop, 0}).bouncy(e).rough(0));
}

/// The first three apexes, m above where it touches. Between two bounces the places lie on a parabola whose top is
/// y + (v - g h / 2)^2 / (2 g), whether a step ends there or not.
std::vector<Real> apexes(Trial& trial, Real drop, Real e) {
  // Nothing may be gained: with e = 1, a bounce found late keeps the watcher's sum to rounding.
  Play play = trial.play([=](World& world) { ball_over_ground(world, drop, e); });
  const Real g = -play.world.gravity.y();
  std::vector<Real> found;
  Real before = 0;
  play.run(6, frame, [&](const World& world) {
    const Body& ball = world.bodies[1];
    const Real v = ball.velocity.y(), middle = v - g * trial.substep() / 2;
    if (before > 0 && v <= 0) found.push_back(ball.position.y() + middle * middle / (2 * g) - ball_radius);
    before = v;
  });
  return found;
}

std::vector<Real> bounces(Trial& trial) {
  constexpr Real drop = 2;
  std::vector<Real> numbers;
  for (const Real e : {Real(0.5), Real(0.9), Real(1)}) {
    const std::vector<Real> found = apexes(trial, drop, e);
    Real off = found.size() < 3 ? 1 : 0, should = drop;
    for (std::size_t k = 0; k < std::min<std::size_t>(3, found.size()); ++k) {
      should *= e * e;
      off = std::max(off, std::abs(found[k] / should - 1));
    }
    numbers.push_back(100 * off);
  }
  return numbers;
}

/// No gravity, 5 m from the ground but for a micrometre, 10 m/s towards it: touches just before its 30th step ends,
/// whichever substeps that is made of, and is back after the 60th.
void there_and_back(World& world) {
  world.gravity.setZero();
  ball_over_ground(world, 5 - Real(1e-6), 1);
  world.bodies[1].moving({0, -10, 0});
}

constexpr int per_side = 7;

/// Balls of 49 different velocities, none of which touches another yet.
void crowd(World& world, Real inward) {
  world.gravity.setZero();
  Random random(49);
  for (int i = 0; i < per_side * per_side; ++i) {
    const int column = i % per_side - per_side / 2, row = i / per_side - per_side / 2;
    const Vec3 place{static_cast<Real>(column), static_cast<Real>(row), 0};
    Vec3 velocity = random.vector(3) - inward * place;
    velocity.z() = 0;
    world.add(sphere(ball_radius, 10).at(place).moving(velocity).bouncy(1).rough(0));
  }
}

void crowd_between_walls(World& world) {
  crowd(world, 0);
  for (const Real at : {Real(-4.5), Real(4.5)}) {
    world.add(box({Real(0.5), 5, Real(0.5)}, 1).fixed().at({at, 0, 0}).rough(0));
    world.add(box({4, Real(0.5), Real(0.5)}, 1).fixed().at({0, at, 0}).rough(0));
  }
}

/// What may be gained where nothing may: a thousandth, for bounces that ten sweeps leave not quite solved.
Allowance elastic(const World& world) {
  return {.energy = kinetic_energy(world) / 1000, .overlap = Real(0.3), .isolated = true};
}

std::vector<Real> crowds(Trial& trial) {
  const auto change = [&](const std::function<void(World&)>& fill, bool isolated) {
    Play play = trial.play(fill, [&](const World& world) {
      Allowance allowance = elastic(world);
      allowance.isolated = isolated;
      return allowance;
    });
    const Real before = kinetic_energy(play.world);
    Real most = 0;
    play.run(10, frame,
             [&](const World& world) { most = std::max(most, std::abs(kinetic_energy(world) / before - 1)); });
    return 100 * most;
  };
  return {change(crowd_between_walls, false), change([](World& world) { crowd(world, 2); }, true)};
}

/// The first of five equal balls that touch comes in with 5 m/s.
void row_of_five(World& world) {
  world.gravity.setZero();
  for (int i = 0; i < 5; ++i) {
    const Real x = static_cast<Real>(i) * 2 * ball_radius;
    world.add(sphere(ball_radius, 10).at({x, 0, 0}).moving({i == 0 ? Real(5) : 0, 0, 0}).bouncy(1).rough(0));
  }
}

/// How far the row is from these speeds, mm/s.
HardCase row_case(const std::string& name, const std::string& title, const std::string& stresses,
                  const std::vector<Real>& speeds) {
  HardCase c;
  c.name = name;
  c.title = title;
  c.stresses = stresses;
  c.criteria = {{"speed of a ball, off by", "mm/s", 50}};  // a hundredth of the impact
  c.scene = {.name = title, .fill = row_of_five, .camera = view({Real(1.7), 0, 0}, Real(2.6)), .seconds = Real(0.25)};
  c.run = [speeds](Trial& trial) -> std::vector<Real> {
    Play play = trial.play(row_of_five, elastic);
    play.run(Real(0.5));
    Real off = 0;
    for (std::size_t i = 0; i < speeds.size(); ++i)
      off = std::max(off, (play.world.bodies[i].velocity - Vec3(speeds[i], 0, 0)).norm());
    return {1000 * off};
  };
  return c;
}

}  // namespace

std::vector<HardCase> bounce_cases() {
  HardCase bounce;
  bounce.name = "bounces";
  bounce.title = "three bounces";
  bounce.stresses = "a bounce detected late is detected deep and fast: the apex e^2k h0 shows both errors";
  bounce.criteria = {{"apexes with e = 0.5, off by", "%", 1},
                     {"apexes with e = 0.9, off by", "%", 1},
                     {"apexes with e = 1, off by", "%", 1}};
  bounce.scene = {.name = bounce.title,
                  .fill =
                      [](World& world) {
                        world.add(ground().rough(0));
                        for (const Real e : {Real(0.5), Real(0.9), Real(1)})
                          world.add(sphere(ball_radius, 10)
                                        .at({static_cast<Real>(world.bodies.size()) - 2, 2 + ball_radius, 0})
                                        .bouncy(e)
                                        .rough(0));
                      },
                  .camera = view({0, Real(1.2), 0}, Real(2.8)),
                  .seconds = Real(1.28)};
  bounce.run = bounces;

  HardCase back;
  back.name = "there-and-back";
  back.title = "elastic, there and back";
  back.stresses = "e = 1 without gravity: the same way back, and nothing lost";
  back.criteria = {{"place after a second, off by", "mm", Real(0.01)}, {"speed, off by", "mm/s", Real(0.1)}};
  back.scene = {
      .name = back.title, .fill = there_and_back, .camera = view({0, Real(0.7), 0}, Real(1.6)), .seconds = Real(0.45)};
  back.run = [](Trial& trial) -> std::vector<Real> {
    Play play = trial.play(there_and_back);
    const Body start = play.world.bodies[1];
    play.run(1);
    const Body& ball = play.world.bodies[1];
    return {1000 * (ball.position - start.position).norm(), 1000 * (ball.velocity + start.velocity).norm()};
  };

  HardCase many;
  many.name = "elastic-49";
  many.title = "7 x 7 elastic balls";
  many.stresses = "hundreds of elastic impacts: energy must neither leak nor come in";
  many.criteria = {{"energy between walls, off by", "%", 1}, {"energy in free space, off by", "%", 1}};
  many.scene = {.name = many.title, .fill = crowd_between_walls, .camera = {{0, 0, 18}, {0, 0, 0}}, .seconds = 2};
  many.run = crowds;

  return {bounce, back, many,
          row_case("row-sequential", "five balls, sequential", "the impact is passed on: 0, 0, 0, 0, 5 m/s",
                   {0, 0, 0, 0, 5}),
          row_case("row-simultaneous", "five balls, simultaneous", "every contact bounces: -3, 2, 2, 2, 2 m/s",
                   {-3, 2, 2, 2, 2})};
}

}  // namespace pushback
