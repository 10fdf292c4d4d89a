/// Contacts push and never pull.
#include "pushback/chapters/02_clamping/clamping.h"
#include "tests/support/catch.h"
#include "tests/support/on_ground.h"

using namespace pushback;

namespace {

/// The column of chapters/02_clamping/scenes.h: fastest way up after its flat landing.
template <class ContactSolver>
Real rebound_of_column(int sweeps) {
  World world;
  world.add(ground());
  world.add(box({Real(0.25), Real(0.8), Real(0.25)}, 100).at({0, Real(1.3), 0}));
  ContactSolver solver;
  Real fastest = 0;
  for (int step = 0; step < 72; ++step) {
    world.step(solver, h, sweeps);
    fastest = std::max(fastest, world.bodies[1].velocity.y());
  }
  return fastest;
}

}  // namespace

TEST_CASE("02: clamping each correction leaves a rebound, clamping their sum does not") {
  for (const int sweeps : {10, 50, 200}) {
    const Real each = rebound_of_column<Solver<ClampingEachCorrection>>(sweeps);
    const Real sum = rebound_of_column<Solver<Clamping>>(sweeps);
    INFO(sweeps << " sweeps: each correction " << each << " m/s, their sum " << sum << " m/s");
    CHECK(each > Real(0.1));  // however many sweeps: what was pushed too far is never taken back
    CHECK(sum < each / 5);
    if (sweeps == 200) CHECK(sum < tiny);
  }
}

TEST_CASE("02: a contact lets go of what leaves") {
  World world;
  Body& ball = ball_on_ground(world, Real(0.01)).moving({0, 5, 0});
  Solver<Clamping> solver;
  world.step(solver, h, one_sweep);
  CHECK(ball.velocity.y() == 5 - h * g);
  CHECK(world.contacts[0].impulse.isZero(0));
}
