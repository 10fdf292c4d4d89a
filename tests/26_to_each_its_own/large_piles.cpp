/// Chapter 26: large islands that move are moved by Fast.
#include "pushback/chapters/13_joints/ball_and_socket.h"
#include "pushback/common/world/measure.h"
#include "pushback/common/world/situations.h"
#include "pushback/engine/presets.h"
#include "tests/support/call.h"
#include "tests/support/catch.h"
#include "tests/support/yardstick.h"

using namespace pushback;

namespace {

/// Boxes of 100 kg in `wide` columns along x that touch each other, `high` boxes high, which slide at `speed`.
World wall(int wide, int high, Real speed = 1) {
  World world;
  world.add(ground());
  for (int i = 0; i < wide * high; ++i)
    world.add(box(Vec3::Constant(Real(0.5)), 100)
                  .at({static_cast<Real>(i / high), Real(0.5) + static_cast<Real>(i % high), 0})
                  .moving({speed, 0, 0}));
  return world;
}
template <class Solver>
bool is_moved_by_fast(World world, Solver solver) {
  world.step(solver, h);
  bool all = true, any = false;
  for (const Body& body : world.bodies) {
    if (!body.movable()) continue;
    const bool fast = solver.classifier().is_moved_by_fast(body.index);
    all &= fast, any |= fast;
  }
  CHECK(all == any);  // they are one island
  return any;
}

}  // namespace

TEST_CASE("large piles: an island moves as in a world of its own under Fast, bit by bit") {
  World world = wall(12, 6), alone = world;
  const auto count = alone.bodies.size();
  world.add(box({Real(0.5), Real(0.1), Real(0.3)}, 10).at({-20, 9, 0}).spinning({3, 5, 1}));  // an island of its own
  world.add(box(Vec3::Constant(Real(0.5)), 10).at({-30, Real(0.5), 0}));
  IslandSolver solver;
  Fast fast;
  for (int i = 0; i < 60; ++i) {
    world.step(solver, h);
    alone.step(fast, h);
    REQUIRE(solver.classifier().is_moved_by_fast(1));
    CHECK(solver.step_of(int(count)) == StepType::flight);
    CHECK(solver.step_of(int(count) + 1) == StepType::half_steps);
    for (std::size_t body = 0; body < count; ++body) {
      REQUIRE(world.bodies[body].position == alone.bodies[body].position);
      REQUIRE(world.bodies[body].orientation.coeffs() == alone.bodies[body].orientation.coeffs());
      REQUIRE(world.bodies[body].velocity == alone.bodies[body].velocity);
    }
  }
}

TEST_CASE("large piles: Fast moves no island that is small, calm, too high, or has unequal masses or joints") {
  CHECK(is_moved_by_fast(wall(12, 6), IslandSolver()));
  CHECK_FALSE(is_moved_by_fast(wall(2, 6), IslandSolver()));      // few contacts
  CHECK_FALSE(is_moved_by_fast(wall(12, 6, 0), IslandSolver()));  // half steps hold it
  CHECK(is_moved_by_fast(wall(12, 20), IslandSolver()));
  CHECK_FALSE(is_moved_by_fast(wall(12, 21), IslandSolver()));
  World heavy = wall(12, 6);
  heavy.bodies.back().inverse_mass /= 29;
  CHECK(is_moved_by_fast(heavy, IslandSolver()));
  heavy.bodies.back().inverse_mass /= 2;
  CHECK_FALSE(is_moved_by_fast(heavy, IslandSolver()));
  World pinned = wall(12, 6);
  pinned.joints = {ball_and_socket(pinned, 1, 2, {0, 1, 0})};
  CHECK_FALSE(is_moved_by_fast(pinned, IslandSolver()));
  World pulled = wall(12, 6);
  pulled.forces = {{[](World&) {}, "wind"}};
  CHECK_FALSE(is_moved_by_fast(pulled, IslandSolver()));
  Recommended within;
  within.error = Real(1e-3);
  CHECK(is_moved_by_fast(wall(12, 6), Recommended()));
  CHECK_FALSE(is_moved_by_fast(wall(12, 6), within));
  CHECK_FALSE(is_moved_by_fast(wall(12, 6), Exact()));
}

TEST_CASE("large piles: one that is Fast's stays so until half of its contacts are gone") {
  World world = wall(12, 6);
  IslandSolver solver;
  world.step(solver, h);
  REQUIRE(solver.classifier().is_moved_by_fast(1));
  for (Body& body : world.bodies)
    if (body.position.x() > Real(3.5)) body.position.x() += 3 * static_cast<Real>(body.index);
  world.step(solver, h);
  CHECK(solver.classifier().contacts(1) < solver.limits.large_pile);
  CHECK(solver.classifier().is_moved_by_fast(1));
  CHECK_FALSE(is_moved_by_fast(world, IslandSolver()));
}

TEST_CASE("large piles: one that is Fast's may grow twice as high, also by bodies that join it") {
  World world = wall(12, 20);
  IslandSolver solver;
  world.step(solver, h);
  REQUIRE(solver.classifier().is_moved_by_fast(1));
  const Body& top = world.bodies[20];
  world.add(box(Vec3::Constant(Real(0.5)), 100).at(top.position + Vec3(0, 1, 0)).moving(top.velocity));
  CHECK_FALSE(is_moved_by_fast(world, IslandSolver()));
  world.step(solver, h);
  CHECK(solver.classifier().is_moved_by_fast(1));
}

TEST_CASE("large piles: a wall that slides comes to rest, on the path of its centre of mass") {
  World world = wall(40, 2, 2);
  IslandSolver solver;
  const Real mu = world.bodies[1].friction, path = 4 / (2 * mu * g);
  const auto centre = [&] {
    Real sum = 0;
    for (const Body& body : world.bodies) sum += body.movable() ? body.position.x() : 0;
    return sum / 80;
  };
  const Real from = centre();
  for (int i = 0; i < 180; ++i) world.step(solver, h);
  CHECK(centre() - from == Approx(path).epsilon(0.02));
  CHECK(kinetic_energy(world) < Real(1e-6));
}
