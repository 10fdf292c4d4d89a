/// Chapter 18: joints solved at once, beside contacts and in substeps.
#include "pushback/engine/direct/direct_tree_joints.h"

#include "pushback/chapters/12_soft_contacts/steady_solver.h"
#include "pushback/chapters/13_joints/distance.h"
#include "pushback/chapters/13_joints/hinge.h"
#include "pushback/chapters/13_joints/study.h"
#include "pushback/chapters/15_limits_motors_springs/limits.h"
#include "pushback/chapters/15_limits_motors_springs/motor.h"
#include "pushback/common/world/forces.h"
#include "pushback/common/world/measure.h"
#include "tests/support/catch.h"
#include "tests/support/substeps.h"
#include "tests/support/yardstick.h"

using namespace pushback;
using namespace pushback::joints_scenes;

namespace {

template <class JointEffect>
using With = RelaxingSolver<JointEffect, Clamping, SoftContacts, SimultaneousImpacts, FrictionCone, ScaledWarmStart>;

/// Planks on hinges between two posts, and a load of `ratio` of them; the air is thick.
void loaded_bridge(World& world, Real ratio) {
  constexpr int planks = 6;
  constexpr Real length = Real(0.5), sag = Real(0.1);
  const auto corner = [](int i) {
    const Real x = static_cast<Real>(i) - Real(planks) / 2;
    return Vec3(length * x, sag * x * x / 3, 0);
  };
  const auto post = [&](const Vec3& end, Real side) {
    return world.add(box({Real(0.25), 1, Real(0.6)}, 1).fixed().at(end + Vec3(Real(0.25) * side, -1, 0)));
  };
  int before = post(corner(0), -1);
  const int last = post(corner(planks), 1);
  for (int i = 0; i < planks; ++i) {
    const Vec3 along = corner(i + 1) - corner(i);
    const int plank = world.add(box({along.norm() / 2, Real(0.04), Real(0.5)}, 1)
                                    .turned(std::atan2(along.y(), along.x()), Vec3::UnitZ())
                                    .at((corner(i) + corner(i + 1)) / 2));
    world.joints.push_back(hinge(world, before, plank, corner(i), Vec3::UnitZ()));
    world.forces.push_back(drag(plank, 4));
    before = plank;
  }
  world.joints.push_back(hinge(world, before, last, corner(planks), Vec3::UnitZ()));
  const int load = world.add(box(Vec3::Constant(Real(0.3)), ratio).at({0, Real(0.36), 0}));
  world.forces.push_back(drag(load, 4 * ratio));
}

template <class JointEffect>
Real speed_at_rest(Real ratio) {
  World world;
  loaded_bridge(world, ratio);
  With<JointEffect> solver;
  Real fastest = 0;
  for (int step = 0; step < 720; ++step) {
    substeps(world, solver, h, 8, 1);
    if (step >= 660) fastest = std::max(fastest, largest_speed(world));
  }
  return fastest;
}

/// A ball on a rod without mass, let go from the horizontal: of the energy that the fall sets free, what `seconds` take.
template <class JointEffect>
Real lost_by_a_pendulum(int in_a_step, Real seconds) {
  World world;
  world.add(sphere(Real(0.1), 1).at({1, 0, 0}));
  world.joints.push_back(ball_and_socket(world, the_world, 0, {0, 0, 0}));
  const auto energy = [&world] { return kinetic_energy(world) + potential_energy(world); };
  const Real before = energy();
  With<JointEffect> solver;
  for (int step = 0; step < static_cast<int>(std::lround(seconds / h)); ++step)
    substeps(world, solver, h, in_a_step, 1);
  return (before - energy()) / g;
}

}  // namespace

TEST_CASE("split direct joints: what stands on jointed planks comes to rest, for contacts do not answer the push") {
  for (const Real ratio : {Real(1), Real(10), Real(100)}) {
    const Real split = speed_at_rest<SplitDirectJoints>(ratio), pushed = speed_at_rest<DirectJoints>(ratio);
    INFO(ratio << ": " << split << " m/s, with the push among the contacts " << pushed << " m/s");
    CHECK(split < (in_double ? Real(1e-4) : Real(1e-3)));
    if (ratio == 100) CHECK(pushed > 10 * split);
  }
}

TEST_CASE("split direct joints: what swings loses a tenth of what each substep's turn would take") {
  // A substep turns v by w h, and projects it: w^2 h T a second. A pendulum let go from the horizontal has a mean w^2 T of
  // 2 g / (3 L) m g L. The push, which is not taken back, turns with it and makes up for it.
  for (const int in_a_step : {4, 8, 16}) {
    const Real substep = h / static_cast<Real>(in_a_step), seconds = 5;
    const Real by_turning = 2 * g / 3 * substep * seconds;
    const Real lost = lost_by_a_pendulum<SplitDirectJoints>(in_a_step, seconds);
    INFO(in_a_step << ": " << lost << " of " << by_turning);
    CHECK(std::abs(lost) < Real(0.1) * by_turning);
  }
}

TEST_CASE(
    "trees directly: a cloth moves as it is swept, a chain as it is solved at once, and a joint that is cut turns one "
    "into the other") {
  World ring;  // of balls on the ground
  ring.add(ground());
  constexpr int balls = 6;
  const auto place = [](int i) {
    return Vec3(std::cos(2 * pi * static_cast<Real>(i) / balls), Real(2),
                std::sin(2 * pi * static_cast<Real>(i) / balls));
  };
  for (int i = 0; i < balls; ++i) ring.add(sphere(Real(0.1), 1).at(place(i)).moving({0, Real(i % 3), 1}));
  for (int i = 0; i < balls; ++i)
    ring.joints.push_back(distance(ring, 1 + i, place(i), 1 + (i + 1) % balls, place((i + 1) % balls)));
  With<DirectTreeJoints> shared;
  for (const bool cut : {false, true}) {
    if (cut) ring.joints.pop_back();
    World other = ring;
    With<SteadyJoints> sweeping;
    With<SplitDirectJoints> solving;
    for (int step = 0; step < 30; ++step) {
      substeps(ring, shared, h, 4, 1);
      if (cut) substeps(other, solving, h, 4, 1);
      else substeps(other, sweeping, h, 4, 1);
      for (std::size_t i = 0; i < ring.bodies.size(); ++i) REQUIRE(ring.bodies[i].position == other.bodies[i].position);
    }
  }
}

TEST_CASE(
    "split direct joints: a motor that drives a door against its stop gives way, whichever of the two is asked first") {
  for (const bool motor_first : {false, true}) {
    World world;
    world.gravity.setZero();
    world.add(box({Real(0.5), 1, Real(0.02)}, 30).at({Real(0.5), 0, 0}));
    world.joints.push_back(hinge(world, the_world, 0, Vec3::Zero(), Vec3::UnitY()));
    world.joints.push_back(angle_limits(world, the_world, 0, Vec3::UnitY(), Real(-0.5), Real(0.2)));
    world.joints.push_back(motor_at_speed(world, the_world, 0, Vec3::UnitY(), 1, 100));
    if (motor_first) std::swap(world.joints[1], world.joints[2]);
    Solver<SplitDirectJoints> solver;
    for (int step = 0; step < 120; ++step) world.step(solver, Real(1) / 60, 1);
    const Vec3 along = world.bodies[0].orientation * Vec3::UnitX();
    INFO("the motor first: " << motor_first);
    CHECK(std::abs(std::atan2(-along.z(), along.x()) - Real(0.2)) < Real(1e-3));
    CHECK(world.bodies[0].angular_velocity.norm() < Real(1e-3));
  }
}
