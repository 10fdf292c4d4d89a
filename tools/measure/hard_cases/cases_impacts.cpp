/// How high it bounces, and what an impact leaves in a row and in a crowd; dominoes, bodies born inside each other, projectiles at
/// 500 m/s, what is thinner than the way of a step; a small ball that rides on a large one.
#include <cmath>

#include "pushback/chapters/25_moment_of_impact/scenes.h"
#include "pushback/common/bodies/random.h"
#include "pushback/common/world/measure.h"
#include "pushback/tools/measure/hard_cases/standing.h"

namespace pushback {

namespace {

// ---- bounces ---------------------------------------------------------------------------------------------------------

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

std::vector<Real> back_after_a_second(Trial& trial) {
  Play play = trial.play(there_and_back);
  const Body start = play.world.bodies[1];
  play.run(1);
  const Body& ball = play.world.bodies[1];
  return {1000 * (ball.position - start.position).norm(), 1000 * (ball.velocity + start.velocity).norm()};
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

std::vector<Real> crowds(Trial& trial) {
  const auto change = [&](const std::function<void(World&)>& fill, bool isolated) {
    Play play = trial.play(fill, bouncing({.overlap = Real(0.3), .isolated = isolated}));
    const Real before = kinetic_energy(play.world);
    return 100 * play.largest(10, [&](const World& world) { return std::abs(kinetic_energy(world) / before - 1); });
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
  const auto run = [speeds](Trial& trial) -> std::vector<Real> {
    Play play = trial.play(row_of_five, bouncing({.overlap = Real(0.3), .isolated = true}));
    play.run(Real(0.5));
    Real off = 0;
    for (std::size_t i = 0; i < speeds.size(); ++i)
      off = std::max(off, (play.world.bodies[i].velocity - Vec3(speeds[i], 0, 0)).norm());
    return {1000 * off};
  };
  return {.name = name,
          .title = title,
          .stresses = stresses,
          .criteria = {{"speed of a ball, off by", "mm/s", 50}},  // a hundredth of the impact
          .scene = seen(row_of_five, view({Real(1.7), 0, 0}, Real(2.6)), Real(0.25)),
          .run = run};
}

// ---- impacts ---------------------------------------------------------------------------------------------------------

constexpr int dominoes = 12;  // a row
constexpr Real half_thick = Real(0.1), half_tall = Real(0.5);

/// Two rows, 2 m apart. The first of each is pushed over its foot: w^2 I / 2 is four times what tips it.
void double_domino(World& world) {
  world.add(ground());
  for (const Real z : {Real(-1), Real(1)}) {
    for (int i = 0; i < dominoes; ++i) {
      const Vec3 centre{Real(0.6) * static_cast<Real>(i), half_tall, z};
      Body& domino =
          world.bodies[static_cast<std::size_t>(world.add(box({half_thick, half_tall, Real(0.3)}, 10).at(centre)))];
      if (i == 0)
        domino.spinning({0, 0, Real(-1.5)}).moving(Vec3(0, 0, Real(-1.5)).cross(Vec3(-half_thick, half_tall, 0)));
    }
  }
}

std::vector<Real> fall_of_dominoes(Trial& trial) {
  Play play = trial.play(double_domino, standing);
  Real standing_still = 0;
  const Real highest = play.largest(6, [](const World& world) {
    Real height = 0;
    for (const Body& body : world.bodies) height = std::max(height, body.position.y());
    return height;
  });
  for (const Body& body : play.world.bodies) {
    if (body.movable() && std::abs((body.orientation * Vec3::UnitY()).y()) > std::cos(pi / 6)) ++standing_still;
  }
  return {standing_still, 1000 * (highest - half_tall), 1000 * largest_speed(play.world)};
}

constexpr Real fastest_exit = 3;  // m/s, the push-out limit

/// Three pairs without gravity, far from each other, each body halfway inside the other.
void born_in_each_other(World& world) {
  world.gravity.setZero();
  world.add(sphere(Real(0.5), 10).at({-3, 0, 0}));
  world.add(sphere(Real(0.5), 10).at({Real(-2.5), 0, 0}));
  world.add(box(Vec3::Constant(Real(0.5)), 10).at({0, 0, 0}));
  world.add(box(Vec3::Constant(Real(0.5)), 100).at({Real(0.2), Real(0.5), Real(0.1)}));
  world.add(capsule(Real(0.3), Real(0.5), 10).at({3, 0, 0}));
  world.add(box(Vec3::Constant(Real(0.5)), 10).turned(Real(0.4), Vec3::UnitX()).at({Real(3.4), Real(0.2), 0}));
}

void born_in_the_ground(World& world) {
  world.add(ground());
  world.add(box(Vec3::Constant(Real(0.5)), 100).at({0, 0, 0}));
}

std::vector<Real> born_deep(Trial& trial) {
  Real fastest = 0, left = 0;
  const auto let_out = [&](const std::function<void(World&)>& fill, bool isolated) {
    Play play = trial.play(fill, [&](const World& world) {
      Allowance allowance{.overlap = 1, .isolated = isolated};  // every body may leave as fast as the limit says
      for (const Body& body : world.bodies)
        allowance.energy += body.movable() ? fastest_exit * fastest_exit / (2 * body.inverse_mass) : 0;
      if (!isolated)
        allowance.energy += standing(world).energy + Real(0.5) * 100 * world.gravity.norm();  // and is lifted
      return allowance;
    });
    play.run(5, frame, [&](const World& world) {
      for (std::size_t i = 0; i + 1 < world.bodies.size(); i += 2) {
        const Body &a = world.bodies[i], &b = world.bodies[i + 1];
        const Vec3 away = a.movable() ? Vec3((b.position - a.position).normalized()) : Vec3::UnitY();
        fastest = std::max(fastest, (b.velocity - a.velocity).dot(away));
      }
    });
    left = std::max(left, deepest_overlap(play.world));
  };
  let_out(born_in_each_other, true);
  let_out(born_in_the_ground, false);
  return {fastest, 1000 * left};
}

/// Two boxes lie in the ground: the first less deep than the slop, the second twice as deep.
void around_the_slop(World& world) {
  world.add(ground());
  world.add(box(Vec3::Constant(Real(0.5)), 100).at({-1, Real(0.5) - Real(0.8) * slop, 0}));
  world.add(box(Vec3::Constant(Real(0.5)), 100).at({1, Real(0.5) - 2 * slop, 0}));
}

std::vector<Real> left_alone(Trial& trial) {
  // Allowed is what lifts both to the surface, and by a millimetre more.
  Play play = trial.play(around_the_slop, [](const World& world) {
    Allowance allowance = standing(world);
    allowance.energy += Real(2.8) * slop * 100 * world.gravity.norm();
    return allowance;
  });
  const Real shallow = play.world.bodies[1].position.y();
  play.run(2);
  const Real moved = play.world.bodies[1].position.y() - shallow;
  const Real depth = Real(0.5) - play.world.bodies[2].position.y();
  return {1000 * std::abs(moved), 1000 * std::abs(depth - slop)};
}

constexpr Real projectile_speed = 500;

/// Comes from the left, and is found half inside the third box after one step of 1/60 s.
void shot_at_a_stack(World& world) {
  stack(world, 5);
  world.add(
      sphere(Real(0.1), 1).at({Real(-0.5) - projectile_speed / 60, Real(2.6), 0}).moving({projectile_speed, 0, 0}));
}

/// In free space and elastic: two at once, each off the centre of a box at rest, found 5 cm inside it.
void shots_at_a_box(World& world) {
  world.gravity.setZero();
  world.add(box(Vec3::Constant(Real(0.5)), 10).at({0, 0, 0}));
  constexpr Real before = Real(0.45) + projectile_speed / 60;
  world.add(
      sphere(Real(0.1), 1).at({-before, Real(0.3), Real(0.1)}).moving({projectile_speed, 0, 0}).bouncy(1).rough(0));
  world.add(
      sphere(Real(0.1), 1).at({Real(0.2), -before, Real(0.3)}).moving({0, projectile_speed, 0}).bouncy(1).rough(0));
}

/// `speed_left`, %: what a hit cannot leave the projectiles. The stack takes all but a hundredth, and then they fall 3 m;
/// from the box they bounce off with three quarters.
HardCase shot(HardCase what, Real speed_left, bool isolated) {
  what.criteria = {{"greatest speed, of the projectile's", "%", Real(100.1)},
                   {"projectiles' speed after 2 s, of what it was", "%", speed_left},
                   {"energy gained", "%", Real(0.1)}};
  what.run = [fill = what.scene.fill, isolated](Trial& trial) -> std::vector<Real> {
    Play play =
        trial.play(fill, bouncing({.overlap = 1, .isolated = isolated}));  // found as deep as it flies in a step
    const Real start = kinetic_energy(play.world), fastest = play.largest(2, largest_speed);
    Real left = 0;
    for (const Body& body : play.world.bodies) {
      if (std::holds_alternative<Sphere>(body.shape)) left = std::max(left, body.velocity.norm());
    }
    return {100 * fastest / projectile_speed, 100 * left / projectile_speed,
            100 * play.watcher().energy_gained() / start};
  };
  return what;
}

/// Chapter 25's bullet, 10 mm in diameter, and its sheet of 1 mm.
constexpr moment_of_impact_scenes::Bullet bullet{.speed = projectile_speed, .e = Real(0.5)};

void bullet_from(World& world, Real further) {
  bullet(world);
  world.bodies[1].position.x() -= further;
}

/// From seven distances, a seventh of a step's way apart: in no step, and in no substep, may it be found in the sheet by luck.
std::vector<Real> bullet_and_sheet(Trial& trial) {
  constexpr int distances = 7;
  Real beyond = 0, off = 0;
  for (int i = 0; i < distances; ++i) {
    const Real further = static_cast<Real>(i) / distances * bullet.speed * frame;
    Play play = trial.play([further](World& world) { bullet_from(world, further); }, bouncing());
    beyond = std::max(beyond, play.largest(3 * frame, [](const World& world) { return world.bodies[1].position.x(); }));
    const Vec3 leaves{-bullet.e * bullet.speed, 0, 0};
    off = std::max(off, (play.world.bodies[1].velocity - leaves).norm() / leaves.norm());
  }
  return {1000 * beyond, 100 * off};
}

using moment_of_impact_scenes::SpinningRod;

/// Chapter 25's rod, 1 m long and 40 mm thick, beside its wall of 1 mm: a step of 1/60 s turns its end by 83 to 330 mm.
std::vector<Real> rod_and_wall(Trial& trial) {
  Real beyond = 0, off = 0, lost = 0;
  for (const Real spin : {Real(10), Real(20), Real(30), Real(40)}) {
    const SpinningRod rod{.spin = spin};
    Play play = trial.play(rod, bouncing());
    const Real energy = kinetic_energy(play.world);
    beyond = std::max(beyond, play.largest(Real(0.3), SpinningRod::beyond));
    const Vec3 leaves = rod.truth(rod.meets() + 1).position;  // m in 1 s
    off = std::max(off, (play.world.bodies[1].velocity - leaves).norm() / leaves.norm());
    lost = std::max(lost, std::abs(kinetic_energy(play.world) / energy - 1));
  }
  return {1000 * beyond, 100 * off, 100 * lost};
}

// ---- a small ball rides on a large one -------------------------------------------------------------------------------

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

std::vector<HardCase> bounce_cases() {
  const auto three = [](World& world) {
    world.add(ground().rough(0));
    for (const Real e : {Real(0.5), Real(0.9), Real(1)}) {
      const Real x = static_cast<Real>(world.bodies.size()) - 2;
      world.add(sphere(ball_radius, 10).at({x, 2 + ball_radius, 0}).bouncy(e).rough(0));
    }
  };
  return {{.name = "bounces",
           .title = "three bounces",
           .stresses = "a bounce detected late is detected deep and fast: the apex e^2k h0 shows both errors",
           .criteria = {{"apexes with e = 0.5, off by", "%", 1},
                        {"apexes with e = 0.9, off by", "%", 1},
                        {"apexes with e = 1, off by", "%", 1}},
           .scene = seen(three, view({0, Real(1.2), 0}, Real(2.8)), Real(1.28)),
           .run = bounces},
          {.name = "there-and-back",
           .title = "elastic, there and back",
           .stresses = "e = 1 without gravity: the same way back, and nothing lost",
           .criteria = {{"place after a second, off by", "mm", Real(0.01)}, {"speed, off by", "mm/s", Real(0.1)}},
           .scene = seen(there_and_back, view({0, Real(0.7), 0}, Real(1.6)), Real(0.45)),
           .run = back_after_a_second},
          {.name = "elastic-49",
           .title = "7 x 7 elastic balls",
           .stresses = "hundreds of elastic impacts: energy must neither leak nor come in",
           .criteria = {{"energy between walls, off by", "%", 1}, {"energy in free space, off by", "%", 1}},
           .scene = seen(crowd_between_walls, {{0, 0, 18}, {0, 0, 0}}, 2),
           .run = crowds},
          row_case("row-sequential", "five balls, sequential", "the impact is passed on: 0, 0, 0, 0, 5 m/s",
                   {0, 0, 0, 0, 5}),
          row_case("row-simultaneous", "five balls, simultaneous", "every contact bounces: -3, 2, 2, 2, 2 m/s",
                   {-3, 2, 2, 2, 2})};
}

std::vector<HardCase> impact_cases() {
  return {
      {.name = "double-domino",
       .title = "double domino",
       .stresses = "edges that strike faces and slide: all must fall, and none fly",
       .criteria = {{"still upright after 6 s", "", 0},
                    {"highest rise of a centre", "mm", 15},  // over its edge: 9.9
                    {"speed after 6 s", "mm/s", 1}},
       .scene = seen(double_domino, view({Real(3.3), Real(0.3), 0}, Real(4.4)), Real(1.5)),
       .run = fall_of_dominoes},
      {.name = "born-deep",
       .title = "born inside each other",
       .stresses = "overlap that no motion made: it must go, but not as an explosion",
       .criteria = {{"fastest exit", "m/s", fastest_exit}, {"overlap after 5 s", "mm", 6}},  // the slop and 1 mm
       .scene = seen(born_in_each_other, view({Real(0.2), 0, 0}, Real(4.6)), 0),
       .run = born_deep},
      {.name = "slop",
       .title = "around the slop",
       .stresses = "what is less deep is left alone, what is deeper comes up to it and no further",
       .criteria = {{"4 mm deep: moved", "mm", Real(0.1)}, {"10 mm deep: from the slop", "mm", Real(0.1)}},
       .scene = seen(around_the_slop, view({0, Real(0.5), 0}, Real(2.5)), 2),
       .run = left_alone},
      shot({.name = "impact-500-stack",
            .title = "500 m/s into a stack",
            .stresses = "in one step, 8 m: detected deep inside",
            .scene = seen(shot_at_a_stack, view({0, Real(2.5), 0}, Real(5.6)), Real(0.25))},
           5, false),
      shot({.name = "impact-500-free",
            .title = "500 m/s off the centre",
            .stresses = "elastic and deep: spin, speed and energy at once",
            .scene = seen(shots_at_a_box, {{Real(-2.5), Real(-1.5), 3}, {0, 0, 0}}, frame)},
           90, true),
      {.name = "bullet",
       .title = "a bullet at a thin sheet",
       .stresses = "10 mm at 500 m/s, e = 0.5: 8 m in a step, so before the sheet and then behind it",
       .criteria = {{"centre beyond the sheet's middle", "mm", 0}, {"velocity after it, off by", "%", 1}},
       .scene = seen(bullet, {{Real(-0.03), Real(0.02), Real(0.2)}, {Real(-0.03), 0, 0}}, frame),
       .run = bullet_and_sheet},
      {.name = "spinning-rod",
       .title = "a rod spins at a thin wall",
       .stresses = "its middle stands still, and its end goes through in a step; elastic, at four speeds",
       .criteria = {{"end beyond the wall's face", "mm", 6},  // the slop and 1 mm
                    {"velocity of its middle after it, off by", "%", 1},
                    {"energy after it, off by", "%", 1}},
       .scene = seen(SpinningRod{.spin = 10}, {{Real(-0.05), Real(0.3), Real(2.9)}, {Real(-0.05), 0, 0}}, Real(0.1)),
       .run = rod_and_wall}};
}

std::vector<HardCase> ball_cases() {
  return {{.name = "basketball",
           .title = "tennis ball on a basketball",
           .stresses = "two impacts within half a millisecond, and the order of them makes five times the height",
           .criteria = {{"apex of the tennis ball, off by", "%", 1}, {"energy gained", "%", Real(0.1)}},
           .scene = seen(tennis_on_basketball, view({0, Real(0.8), 0}, Real(1.8)), 0),
           .run = how_high}};
}

}  // namespace pushback
