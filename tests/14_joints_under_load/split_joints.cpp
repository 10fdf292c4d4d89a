/// Joints with a split impulse: the push closes gaps, leaves no speed, and is not remembered.
#include "pushback/chapters/14_joints_under_load/split_joints.h"

#include "pushback/chapters/12_soft_contacts/soft_contacts.h"
#include "pushback/chapters/13_joints/ball_and_socket.h"
#include "pushback/common/world/measure.h"
#include "tests/support/catch.h"
#include "tests/support/substeps.h"
#include "tests/support/yardstick.h"

using namespace pushback;

namespace {

using Warm = RelaxingSolver<WarmJoints, Clamping, SoftContacts>;
using Split = RelaxingSolver<SplitJoints, Clamping, SoftContacts>;

/// Balls of 1 kg, one below the other, and one of 100 kg at the end.
World loaded_chain() {
  World world;
  for (int i = 0; i < 6; ++i) {
    const Real y = -Real(0.5) * static_cast<Real>(i);
    const int ball = world.add(sphere(Real(0.1), i == 5 ? 100 : 1).at({0, y - Real(0.25), 0}));
    world.joints.push_back(ball_and_socket(world, i == 0 ? the_world : ball - 1, ball, {0, y, 0}));
  }
  return world;
}

/// J, the most that ten seconds in substeps have above the start.
template <class ContactSolver>
Real most_gained() {
  World world = loaded_chain();
  ContactSolver solver;
  const Real start = kinetic_energy(world) + potential_energy(world);
  Real gained = 0;
  for (int i = 0; i < 600; ++i) {
    substeps(world, solver, h, 32);
    gained = std::max(gained, kinetic_energy(world) + potential_energy(world) - start);
  }
  return gained;
}

}  // namespace

TEST_CASE("a gap closes by 1 - beta a step, and nothing has a speed after it") {
  World world;
  world.gravity.setZero();
  world.add(sphere(Real(0.1), 1));
  world.add(sphere(Real(0.1), 3));
  world.joints = {ball_and_socket(world, 0, 1, {0, 0, 0})};
  world.bodies[1].position = {Real(0.1), 0, Real(-0.2)};
  Split solver;
  Vec3 gap = world.bodies[1].position;
  for (int i = 0; i < 20; ++i) {
    world.step(solver, h, 1);
    gap *= 1 - solver.SplitJoints::beta;
    CHECK((world.bodies[1].position - world.bodies[0].position - gap).norm() < Real(1e-14));
    CHECK(largest_speed(world) < Real(1e-14));
  }
}

TEST_CASE("where nothing relaxes the push is a speed, and the next step does not start from it") {
  World world;
  world.gravity.setZero();
  world.add(sphere(Real(0.1), 1));
  world.joints = {ball_and_socket(world, the_world, 0, {0, 0, 0})};
  world.bodies[0].position = {Real(0.1), 0, 0};
  Solver<SplitJoints> solver;
  world.step(solver, h, 1);
  CHECK(world.bodies[0].velocity.x() == Approx(-solver.SplitJoints::beta * Real(0.1) / h));
  world.bodies[0].velocity.setZero();
  world.joints[0].ask = [](const Body&, const Body&, const TimeStep&, Equations& equations) {
    for (int axis = 0; axis < 3; ++axis) equations.push_back({.jacobian = {.n = Vec3::Unit(axis)}});
  };
  world.step(solver, h, 0);
  CHECK(world.bodies[0].velocity.norm() < Real(1e-14));
}

TEST_CASE("a chain with a heavy load hangs, where a warm start that remembers the push gains energy") {
  CHECK(most_gained<Warm>() > 1000);
  CHECK(most_gained<Split>() < Real(1e-6));
}
