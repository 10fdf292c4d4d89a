/// Impacts: dominoes, bodies born inside each other, projectiles at 500 m/s, and what is thinner than the way of a step.
#include <cmath>

#include "pushback/chapters/25_moment_of_impact/scenes.h"
#include "pushback/common/world/measure.h"
#include "pushback/tools/measure/hard_cases/cases.h"
#include "pushback/tools/measure/hard_cases/standing.h"

namespace pushback {

namespace {

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
  Real highest = 0, standing_still = 0;
  play.run(6, frame, [&](const World& world) {
    for (const Body& body : world.bodies) highest = std::max(highest, body.position.y());
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
HardCase shot(const std::string& name, const std::string& title, const std::string& stresses,
              const std::function<void(World&)>& fill, const Camera& camera, Real seconds, Real speed_left,
              bool isolated) {
  HardCase c;
  c.name = name;
  c.title = title;
  c.stresses = stresses;
  c.criteria = {{"greatest speed, of the projectile's", "%", Real(100.1)},
                {"projectiles' speed after 2 s, of what it was", "%", speed_left},
                {"energy gained", "%", Real(0.1)}};
  c.scene = {.name = title, .fill = fill, .camera = camera, .seconds = seconds};
  c.run = [=](Trial& trial) -> std::vector<Real> {
    // Found as deep as it flies in a step. Nothing may be gained; a thousandth is for bounces not quite solved.
    Play play = trial.play(fill, [&](const World& world) {
      return Allowance{.energy = kinetic_energy(world) / 1000, .overlap = 1, .isolated = isolated};
    });
    const Real start = kinetic_energy(play.world);
    Real fastest = 0;
    play.run(2, frame, [&](const World& world) { fastest = std::max(fastest, largest_speed(world)); });
    Real left = 0;
    for (const Body& body : play.world.bodies) {
      if (std::holds_alternative<Sphere>(body.shape)) left = std::max(left, body.velocity.norm());
    }
    return {100 * fastest / projectile_speed, 100 * left / projectile_speed,
            100 * play.watcher().energy_gained() / start};
  };
  return c;
}

/// Nothing may be gained; a thousandth is for a bounce not quite solved.
Allowance bouncing(const World& world) {
  return {.energy = kinetic_energy(world) / 1000};
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
    Play play = trial.play([further](World& world) { bullet_from(world, further); }, bouncing);
    play.run(3 * frame, frame,
             [&beyond](const World& world) { beyond = std::max(beyond, world.bodies[1].position.x()); });
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
    Play play = trial.play(rod, bouncing);
    const Real energy = kinetic_energy(play.world);
    play.run(Real(0.3), frame,
             [&beyond](const World& world) { beyond = std::max(beyond, SpinningRod::beyond(world)); });
    const Vec3 leaves = rod.truth(rod.meets() + 1).position;  // m in 1 s
    off = std::max(off, (play.world.bodies[1].velocity - leaves).norm() / leaves.norm());
    lost = std::max(lost, std::abs(kinetic_energy(play.world) / energy - 1));
  }
  return {1000 * beyond, 100 * off, 100 * lost};
}

}  // namespace

std::vector<HardCase> impact_cases() {
  HardCase domino;
  domino.name = "double-domino";
  domino.title = "double domino";
  domino.stresses = "edges that strike faces and slide: all must fall, and none fly";
  domino.criteria = {{"still upright after 6 s", "", 0},
                     {"highest rise of a centre", "mm", 15},  // over its edge: 9.9
                     {"speed after 6 s", "mm/s", 1}};
  domino.scene = {.name = domino.title,
                  .fill = double_domino,
                  .camera = view({Real(3.3), Real(0.3), 0}, Real(4.4)),
                  .seconds = Real(1.5)};
  domino.run = fall_of_dominoes;

  HardCase deep;
  deep.name = "born-deep";
  deep.title = "born inside each other";
  deep.stresses = "overlap that no motion made: it must go, but not as an explosion";
  deep.criteria = {{"fastest exit", "m/s", fastest_exit}, {"overlap after 5 s", "mm", 6}};  // the slop and 1 mm
  deep.scene = {
      .name = deep.title, .fill = born_in_each_other, .camera = view({Real(0.2), 0, 0}, Real(4.6)), .seconds = 0};
  deep.run = born_deep;

  HardCase margin;
  margin.name = "slop";
  margin.title = "around the slop";
  margin.stresses = "what is less deep is left alone, what is deeper comes up to it and no further";
  margin.criteria = {{"4 mm deep: moved", "mm", Real(0.1)}, {"10 mm deep: from the slop", "mm", Real(0.1)}};
  margin.scene = {
      .name = margin.title, .fill = around_the_slop, .camera = view({0, Real(0.5), 0}, Real(2.5)), .seconds = 2};
  margin.run = left_alone;

  HardCase thin;
  thin.name = "bullet";
  thin.title = "a bullet at a thin sheet";
  thin.stresses = "10 mm at 500 m/s, e = 0.5: 8 m in a step, so before the sheet and then behind it";
  thin.criteria = {{"centre beyond the sheet's middle", "mm", 0}, {"velocity after it, off by", "%", 1}};
  thin.scene = {.name = thin.title,
                .fill = bullet,
                .camera = {{Real(-0.03), Real(0.02), Real(0.2)}, {Real(-0.03), 0, 0}},
                .seconds = frame};
  thin.run = bullet_and_sheet;

  HardCase rod;
  rod.name = "spinning-rod";
  rod.title = "a rod spins at a thin wall";
  rod.stresses = "its middle stands still, and its end goes through in a step; elastic, at four speeds";
  rod.criteria = {{"end beyond the wall's face", "mm", 6},  // the slop and 1 mm
                  {"velocity of its middle after it, off by", "%", 1},
                  {"energy after it, off by", "%", 1}};
  rod.scene = {.name = rod.title,
               .fill = SpinningRod{.spin = 10},
               .camera = {{Real(-0.05), Real(0.3), Real(2.9)}, {Real(-0.05), 0, 0}},
               .seconds = Real(0.1)};
  rod.run = rod_and_wall;

  return {domino,
          deep,
          margin,
          shot("impact-500-stack", "500 m/s into a stack", "in one step, 8 m: detected deep inside", shot_at_a_stack,
               view({0, Real(2.5), 0}, Real(5.6)), Real(0.25), 5, false),
          shot("impact-500-free", "500 m/s off the centre", "elastic and deep: spin, speed and energy at once",
               shots_at_a_box, {{Real(-2.5), Real(-1.5), 3}, {0, 0, 0}}, frame, 90, true),
          thin,
          rod};
}

}  // namespace pushback
