/// Simultaneous impacts, solved until no row changes a speed any more.
#include <numeric>

#include "pushback/chapters/12_soft_contacts/steady_solver.h"
#include "pushback/common/bodies/random.h"
#include "pushback/common/world/measure.h"
#include "tests/support/catch.h"
#include "tests/support/substeps.h"
#include "tests/support/yardstick.h"

using namespace pushback;

namespace {

constexpr Real v = 5;                                    // of the impact, m/s
constexpr Real near = (in_double ? Real(1e-5) : 1) * v;  // floats do not get to the solver's precision
constexpr Real ball_radius = Real(0.3);

using Simultaneous = Solver<Clamping, Baumgarte, Slop, SimultaneousImpacts, Friction, ScaledWarmStart>;

/// Equal balls that touch, along x; the first comes.
World row_of_five() {
  World world;
  world.gravity.setZero();
  for (int i = 0; i < 5; ++i)
    world.add(sphere(ball_radius, 10)
                  .at({static_cast<Real>(i) * 2 * ball_radius, 0, 0})
                  .moving({i == 0 ? v : 0, 0, 0})
                  .bouncy(1));
  return world;
}

/// The largest difference from -3, 2, 2, 2, 2 m/s: all leave together, and the first comes back.
Real off(const World& world) {
  Real most = 0;
  for (const Body& body : world.bodies) {
    const Real should = body.index == 0 ? -3 : 2;
    most = std::max(most, std::abs(body.velocity.x() - should));
  }
  return most;
}

/// Fifteen balls in a triangle, all touching, and one that comes from the side of a corner; a fence all around.
World billiards() {
  World world;
  world.gravity.setZero();
  const auto ball = [](Real x, Real z) { return sphere(ball_radius, 10).at({x, 0, z}).bouncy(1).rough(0); };
  for (int row = 0; row < 5; ++row) {
    for (int i = 0; i <= row; ++i)
      world.add(ball(static_cast<Real>(row) * ball_radius * std::sqrt(Real(3)),
                     static_cast<Real>(2 * i - row) * ball_radius));
  }
  world.add(ball(Real(-1.2) * ball_radius, Real(1.55) * ball_radius).moving({v, 0, 0}));
  for (const int side : {-1, 1}) {
    world.add(box({Real(0.2), 1, 5}, 1).fixed().at({static_cast<Real>(side) * 4, 0, 0}).bouncy(1).rough(0));
    world.add(box({5, 1, Real(0.2)}, 1).fixed().at({0, 0, static_cast<Real>(side) * 4}).bouncy(1).rough(0));
  }
  return world;
}

}  // namespace

TEST_CASE("09: simultaneous, a row of five leaves with -3, 2, 2, 2, 2, whatever the step") {
  for (const Real dt : {h, h / 32, Real(1e-5)}) {
    for (const int sweeps : {1, 10}) {
      World world = row_of_five();
      Simultaneous solver;
      world.step(solver, dt, sweeps);
      INFO("dt " << dt << ", " << sweeps << " sweeps: off by " << off(world) << " m/s");
      CHECK(off(world) <= near);
      for (int step = 0; step < 30; ++step) world.step(solver, dt, sweeps);
      INFO("30 steps later: off by " << off(world) << " m/s");
      CHECK(off(world) <= near);
    }
  }
}

// Where nothing but what bounces, or lies without moving, is touched. A slow approach that may not bounce takes some energy
// (0.02 % with the default threshold), and so would a contact that opens on its own.
TEST_CASE("09: simultaneous, all energy of balls with e = 1 is conserved, while they break and as they bounce on") {
  World world = billiards();
  Solver<Clamping, SimultaneousImpacts> solver;
  solver.threshold = 0;
  solver.precision = in_double ? Real(1e-12) : Real(1e-6);
  const Real start = kinetic_energy(world);
  int touched = 0;
  for (int step = 0; step < 600; ++step) {
    world.step(solver, h, 1);
    touched += static_cast<int>(world.contacts.size());
    INFO("step " << step << ": " << kinetic_energy(world) / start - 1 << " of the energy");
    REQUIRE(std::abs(kinetic_energy(world) / start - 1) <= (in_double ? Real(1e-9) : Real(1e-4)));
  }
  CHECK(touched > 100);
}

TEST_CASE("09: simultaneous, it does not matter in which order the bodies were added") {
  Random random(1);
  World first = billiards();
  Simultaneous solver;
  first.step(solver, h, 1);
  REQUIRE(first.contacts.size() > 30);
  for (int i = 0; i < 20; ++i) {
    const World fresh = billiards();
    std::vector<std::size_t> order(fresh.bodies.size());
    std::iota(order.begin(), order.end(), 0);
    random.shuffle(order);
    World world;
    world.gravity.setZero();
    for (const std::size_t k : order) world.add(fresh.bodies[k]);
    Simultaneous other;
    world.step(other, h, 1);
    for (std::size_t k = 0; k < order.size(); ++k)
      REQUIRE((world.bodies[k].velocity - first.bodies[order[k]].velocity).norm() <= near);
  }
}

TEST_CASE(
    "09: simultaneous impacts end after their most rounds, and without any are RestitutionFromSurface to the bit") {
  World world = row_of_five();
  Simultaneous never_content;
  never_content.precision = 0;
  world.step(never_content, h, 1);
  CHECK(off(world) <= near);

  World few = row_of_five(), from_surface = row_of_five();
  Simultaneous without_rounds;
  without_rounds.most_rounds = 0;
  Solver<Clamping, Baumgarte, Slop, RestitutionFromSurface, Friction, ScaledWarmStart> sweeps_only;
  few.step(without_rounds, h, 3);
  from_surface.step(sweeps_only, h, 3);
  for (std::size_t i = 0; i < 5; ++i) CHECK(few.bodies[i].velocity == from_surface.bodies[i].velocity);
  CHECK(off(few) > Real(0.1));
}
