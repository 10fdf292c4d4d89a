/// Every row that is solved is counted, once: against counts by hand, one effect at a time.

#include "pushback/chapters/01_velocity_constraint/rows_solved.h"
#include "pushback/chapters/08_friction_cone/friction_cone.h"
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

}  // namespace

TEST_CASE("a row for each normal, two more for each contact that rubs, in every sweep") {
  for (const int sweeps : {0, 1, 7}) {
    const auto n = static_cast<std::size_t>(sweeps);
    INFO(sweeps);
    CHECK(counted<Solver<Clamping>>(box_on_ground(Real(0.5)), sweeps) == 4 * n);
    CHECK(counted<Solver<Clamping, Friction>>(box_on_ground(0), sweeps) == 4 * n);
    CHECK(counted<Solver<Clamping, Friction>>(box_on_ground(Real(0.5)), sweeps) == 12 * n);
    CHECK(counted<Solver<Clamping, FrictionCone>>(box_on_ground(Real(0.5)), sweeps) == 12 * n);
  }
}

TEST_CASE("joints: three rows a pin and sweep, in each of its passes, and as often again to close gaps") {
  CHECK(counted<Solver<Joints>>(pendulum(), 7) == 3 * 7);
  CHECK(counted<Solver<SplitJoints>>(pendulum(), 7) == 2 * 3 * 7);
  Solver<SplitJoints> five;
  five.passes = 5;
  CHECK(counted(pendulum(), 7, five) == 2 * 5 * 3 * 7);
  CHECK(counted<Solver<SteadyJoints>>(pendulum(), 1) == 2 * 20 * 3);
}
