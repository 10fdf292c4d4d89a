/// Chapter 13 in motion: what beads, rods and pendulums do against closed forms.
#include "pushback/chapters/13_joints/study.h"
#include "pushback/chapters/14_joints_under_load/scenes.h"
#include "pushback/chapters/14_joints_under_load/structures.h"
#include "pushback/common/bodies/random.h"
#include "pushback/common/world/measure.h"
#include "tests/support/catch.h"
#include "tests/support/yardstick.h"

using namespace pushback;
using namespace pushback::joints_scenes;

namespace {

using Rigid = Solver<Joints>;

Real energy(const World& world) {
  return kinetic_energy(world) + potential_energy(world);
}

}  // namespace

TEST_CASE("13: a bead that is not fed back leaves a ring outwards, r'^2 = r^2 + h^2 v^2, and keeps r v") {
  Random random(1);
  for (int i = 0; i < 50; ++i) {
    World world;
    world.gravity.setZero();
    const Real radius = random.between(Real(0.5), 2), speed = random.between(1, 5), angle = random.between(0, 6);
    const int bead = world.add(sphere(Real(0.1), random.between(1, 10))
                                   .at(radius * Vec3(std::cos(angle), std::sin(angle), 0))
                                   .moving(speed * Vec3(-std::sin(angle), std::cos(angle), 0)));
    world.joints.push_back(bead_on(world, ellipse(0, 0, radius, radius), bead));
    auto solver = with_joint_beta<Rigid>(0);
    const Body& body = world.bodies[0];
    for (int step = 0; step < 200; ++step) {
      const Real before = body.position.squaredNorm();
      world.step(solver, h, 1);
      REQUIRE(body.position.squaredNorm() == Approx(before + h * h * body.velocity.squaredNorm()).epsilon(16 * eps));
      // The speed belongs to the place where the row was made, one step of it back.
      const Real moment = (body.position - h * body.velocity).cross(body.velocity).norm();
      REQUIRE(moment == Approx(radius * speed).epsilon(2000 * eps));
    }
  }
}

TEST_CASE("13: beads on wires never win energy where nothing is fed back, and lose m |dV|^2 / 2 in a step") {
  World world;
  beads_on_wires(world);
  auto solver = with_joint_beta<Rigid>(0);
  for (int step = 0; step < 300; ++step) {
    const Real before = energy(world);
    world.step(solver, h, 1);
    REQUIRE(world.contacts.empty());
    Real lost = 0;
    for (const Body& bead : world.bodies) lost += (bead.velocity - bead.velocity_before).squaredNorm() / 2;  // 1 kg
    REQUIRE(std::abs(energy(world) - before + lost) <= 1000 * eps * (100 + lost));  // J: m v^2 / 2 of some m/s
    REQUIRE(energy(world) < before);
    for (const Row& row : solver.joint_rows()) REQUIRE(std::abs(row.impulse * row.speed()) <= 1000 * eps);  // no work
  }
}

TEST_CASE("13: what is fed back wins energy, and keeps beads on their wires") {
  World world;
  beads_on_wires(world);
  auto solver = with_joint_beta<Rigid>(Real(0.2));
  Real most = 0, farthest = 0;
  for (int step = 0; step < 300; ++step) {
    const Real before = energy(world);
    world.step(solver, h, 1);
    most = std::max(most, energy(world) - before);
    farthest = std::max(farthest, largest_joint_error(world));
  }
  CHECK(most > Real(0.01));
  CHECK(farthest < Real(0.05));
}

TEST_CASE("13: a distance that is off comes to its length as C_0 (1 - beta)^k") {
  for (const Real beta : {Real(0.1), Real(0.2), Real(0.5)}) {
    World world;
    world.gravity.setZero();
    world.add(sphere(Real(0.1), 1).at({0, 0, 0}));
    world.add(sphere(Real(0.1), 3).at({0, 0, 2}));
    world.joints.push_back(distance(world, 0, world.bodies[0].position, 1, world.bodies[1].position, Real(1.5)));
    auto solver = with_joint_beta<Rigid>(beta);
    for (int k = 1; k <= 60; ++k) {
      world.step(solver, h, 1);
      REQUIRE(largest_joint_error(world) == Approx(std::pow(1 - beta, k) / 2).margin(64 * eps));
    }
  }
}

TEST_CASE("13: a ball on a rod and a plank on a hinge swing in 4 sqrt(L / g) K(sin(theta / 2)), to the second order") {
  const Real ball = Pendulums{}.period(rod_length), plank = Pendulums{}.period(length_of_plank());
  const auto errors = [&](Real steps) {
    const Periods measured = measured_periods(1 / steps, Real(0.2));
    return std::pair(std::abs(measured.ball / ball - 1), std::abs(measured.plank / plank - 1));
  };
  const auto coarse = errors(480), fine = errors(960);
  if (in_double) {  // 3e-5: the rounding of float is of that size
    CHECK(fine.first < Real(2.5e-5));
    CHECK(fine.second < Real(2.5e-5));
    CHECK(coarse.first / fine.first > Real(3.5));  // 4, as the step goes to 0
    CHECK(coarse.second / fine.second > Real(3.5));
  } else {
    CHECK(fine.first < Real(1e-3));
    CHECK(fine.second < Real(1e-3));
  }
}
