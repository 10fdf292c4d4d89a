/// The overlap that is left.
#include "pushback/chapters/04_slop/slop.h"
#include "tests/support/catch.h"
#include "tests/support/on_ground.h"

using namespace pushback;

TEST_CASE("04: deeper than the slop comes up to the slop, at the same rate") {
  for (const Real slop : {Real(0.001), Real(0.005), Real(0.02)}) {
    for (const bool contact : {false, true}) {
      const Real beta = Real(0.2), d0 = slop + Real(0.04);  // within g h^2 / beta^2: a contact follows too
      World world;
      ball_on_ground(world, d0);
      Solver<Baumgarte, Slop> equality;
      Solver<Clamping, Baumgarte, Slop> pushing;
      equality.slop = pushing.slop = slop;
      Real over = d0 - slop;
      for (int k = 1; k <= 200; ++k) {
        if (contact) world.step(pushing, h, one_sweep);
        else world.step(equality, h, one_sweep);
        over *= 1 - beta;
        REQUIRE(std::abs(depth_of(world.bodies[1]) - slop - over) <= tiny * over + 200 * eps);
      }
      CHECK(std::abs(depth_of(world.bodies[1]) - slop) <= 200 * eps);
    }
  }
}

TEST_CASE("04: shallower than the slop is left where it is, and without slop it is not") {
  for (const Real part : {Real(0), Real(0.2), Real(0.9), Real(1)}) {
    World world;
    Solver<Clamping, Baumgarte, Slop> solver;
    ball_on_ground(world, part * solver.slop);
    for (int k = 0; k < 600; ++k) {
      world.step(solver, h, one_sweep);
      REQUIRE(world.contacts.size() == 1);  // not lost for a single step
    }
    CHECK(std::abs(depth_of(world.bodies[1]) - part * solver.slop) <= 600 * eps);
  }
  World world;
  Solver<Clamping, Baumgarte> without;
  ball_on_ground(world, Real(0.0045));
  for (int k = 0; k < 600; ++k) world.step(without, h, one_sweep);
  CHECK(depth_of(world.bodies[1]) < Real(1e-5));
}
