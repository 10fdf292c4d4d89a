/// Every row that is solved is counted, once: against counts by hand, one effect at a time.
#include <fmt/format.h>

#include "pushback/chapters/01_velocity_constraint/rows_solved.h"
#include "pushback/chapters/06_friction/by_weight.h"
#include "pushback/chapters/08_friction_cone/scaled_back.h"
#include "pushback/chapters/09_impacts/sequential.h"
#include "pushback/chapters/10_position_correction/nonlinear_gauss_seidel.h"
#include "pushback/chapters/10_position_correction/split_impulse.h"
#include "pushback/chapters/13_joints/ball_and_socket.h"
#include "pushback/chapters/14_joints_under_load/steady_joints.h"
#include "tests/support/catch.h"

using namespace pushback;

namespace {

constexpr Real dt = Real(1) / 60;

/// Of one step of `sweeps` sweeps.
template <class ContactSolver>
std::size_t counted(World world, int sweeps, ContactSolver solver = {}) {
  const std::size_t before = rows_solved;
  world.step(solver, dt, sweeps);
  return rows_solved - before;
}

/// Four contacts, 2 cm deep.
World box_on_ground(Real friction) {
  World world;
  world.add(ground().rough(friction));
  world.add(box(Vec3::Constant(Real(0.5)), 1).at({0, Real(0.48), 0}).rough(friction));
  return world;
}

/// Three rows.
World pendulum() {
  World world;
  world.add(sphere(Real(0.2), 10).at({1, 0, 0}));
  world.joints = {ball_and_socket(world, the_world, 0, {0, 0, 0})};
  return world;
}

/// Equal balls that touch in a row, and the first one comes with 3 m/s: a contact less than balls.
World row_of(int balls) {
  World world;
  world.gravity.setZero();
  for (int i = 0; i < balls; ++i)
    world.add(sphere(Real(0.5), 1).at({Real(0.999999) * static_cast<Real>(i), 0, 0}).bouncy(1).rough(0));
  world.bodies[0].velocity = {3, 0, 0};
  return world;
}

/// The same impact in numbers alone: neighbours n share a ball, K = 2, J_i M^-1 J_j = -1. All normals once, then again until
/// no row changes a speed by more than 1e-6 of the bounce: how many rows that solves in a step of so many sweeps.
std::size_t solved_in_numbers(int contacts, int sweeps) {
  std::vector<double> impulse(static_cast<std::size_t>(contacts) + 2), approach = impulse, bounce = impulse;
  approach[1] = -3;
  bounce[1] = 3;
  std::size_t solved = 0;
  const auto sweep = [&] {
    double change = 0;
    for (std::size_t i = 1; i <= static_cast<std::size_t>(contacts); ++i, ++solved) {
      const double speed = approach[i] + 2 * impulse[i] - impulse[i - 1] - impulse[i + 1];
      const double total = std::max(0.0, impulse[i] - (speed - bounce[i]) / 2);
      change = std::max(change, 2 * std::abs(total - impulse[i]));
      impulse[i] = total;
    }
    return change;
  };
  for (int i = 0; i < sweeps; ++i) {
    sweep();
    while (sweep() > 3e-6) {
    }
  }
  return solved;
}

}  // namespace

TEST_CASE("a row for each normal, two more for each contact that rubs, in every sweep") {
  for (const int sweeps : {0, 1, 7}) {
    const auto n = static_cast<std::size_t>(sweeps);
    INFO(sweeps);
    CHECK(counted<Solver<Clamping>>(box_on_ground(Real(0.5)), sweeps) == 4 * n);
    CHECK(counted<Solver<Clamping, Friction>>(box_on_ground(0), sweeps) == 4 * n);
    CHECK(counted<Solver<Clamping, Friction>>(box_on_ground(Real(0.5)), sweeps) == 12 * n);
    CHECK(counted<Solver<Clamping, FrictionByWeight>>(box_on_ground(Real(0.5)), sweeps) == 12 * n);
    CHECK(counted<Solver<Clamping, FrictionCone>>(box_on_ground(Real(0.5)), sweeps) == 12 * n);
    CHECK(counted<Solver<Clamping, FrictionScaledBack>>(box_on_ground(Real(0.5)), sweeps) == 12 * n);
    CHECK(counted<FullSolver>(box_on_ground(Real(0.5)), sweeps) == 12 * n);
  }
}

TEST_CASE("first guesses are no solves: the second step counts what the first one did") {
  World world = box_on_ground(Real(0.5));
  FullSolver solver;
  for (int step = 0; step < 3; ++step) {
    const std::size_t before = rows_solved;
    world.step(solver, dt, 5);
    CHECK(rows_solved - before == 12 * 5);
  }
}

TEST_CASE("joints: three rows a pin and sweep, in each of its passes, and as often again to close gaps") {
  CHECK(counted<Solver<Joints>>(pendulum(), 7) == 3 * 7);
  CHECK(counted<Solver<WarmJoints>>(pendulum(), 7) == 3 * 7);
  CHECK(counted<Solver<SplitJoints>>(pendulum(), 7) == 2 * 3 * 7);
  Solver<SplitJoints> five;
  five.passes = 5;
  CHECK(counted(pendulum(), 7, five) == 2 * 5 * 3 * 7);
  CHECK(counted<Solver<SteadyJoints>>(pendulum(), 1) == 2 * 20 * 3);
}

TEST_CASE("what relaxes sweeps once more, joints in all their passes") {
  CHECK(counted<RelaxingSolver<Clamping, SoftContacts, WarmStart>>(box_on_ground(0), 7) == 4 * (7 + 1));
  CHECK(counted<RelaxingSolver<Clamping, SoftContacts, FrictionCone, WarmStart>>(box_on_ground(1), 7) == 12 * (7 + 1));
  CHECK(counted<SteadyJointedSolver>(pendulum(), 7) == 3 * 20 * (2 * 7 + 1));
}

TEST_CASE("simultaneous impacts: as many rounds as the same impact takes in numbers alone") {
  CHECK(counted<Solver<Clamping, SimultaneousImpacts>>(row_of(2), 1) == 2);  // solved by the sweep, and seen to be
  for (const int balls : {2, 3, 5, 8}) {
    for (const int sweeps : {1, 3}) {
      INFO(balls << " balls, " << sweeps << " sweeps");
      CHECK(counted<Solver<Clamping, SimultaneousImpacts>>(row_of(balls), sweeps) ==
            solved_in_numbers(balls - 1, sweeps));
    }
  }
  World still = row_of(5);
  still.bodies[0].velocity.setZero();
  CHECK(counted<Solver<Clamping, SimultaneousImpacts>>(still, 3) == 4 * 3);
}

TEST_CASE("sequential impacts: one for each ball that passes its speed on, then the sweeps") {
  CHECK(counted<Solver<Clamping, SequentialImpacts>>(row_of(5), 0) == 4);
  CHECK(counted<Solver<Clamping, SequentialImpacts>>(row_of(5), 3) == 4 + 4 * 3);
}

TEST_CASE("positions: each contact in each round, where anything overlaps") {
  CHECK(counted<CorrectingSolver<Clamping, SplitImpulse>>(box_on_ground(1), 7) == 4 * (7 + 10));
  CHECK(counted<CorrectingSolver<Clamping, NonlinearGaussSeidel>>(box_on_ground(1), 7) == 4 * (7 + 3));
  CHECK(counted<CorrectingSolver<Clamping, Restitution, SplitImpulse>>(row_of(2), 7) ==
        1 * 7);  // they part by themselves
}
