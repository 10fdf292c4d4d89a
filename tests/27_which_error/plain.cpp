/// Chapter 27: the plain form of the estimate and its controller, compared with the engine's and with a pendulum's true error.
#include "pushback/chapters/27_which_error/plain.h"

#include "pushback/chapters/13_joints/distance.h"
#include "pushback/engine/islands/estimate.h"
#include "pushback/engine/islands/island_solver.h"
#include "tests/27_which_error/played.h"
#include "tests/support/catch.h"
#include "tests/support/yardstick.h"

using namespace pushback;

namespace {

plain_24::Bob released_at(Real angle) {
  return {{std::sin(angle), -std::cos(angle), 0}, Vec3::Zero(), 1};
}
const Vec3 gravity(0, -g, 0);

/// m: what an estimate estimates.
Real distance_in_half_a_second(const plain_24::Bob& one, const plain_24::Bob& other) {
  return (one.x - other.x).norm() + (one.v - other.v).norm() / 2;
}

}  // namespace

TEST_CASE("plain controller: each of its decisions is the engine's") {
  constexpr Real none = std::numeric_limits<Real>::infinity();
  const plain_27::Bounds bounds;
  for (const int order : {1, 2, 4}) {
    CHECK(plain_27::off_by(3, 1, order) == 2 / parts_of_difference(order));
    CHECK(plain_27::off_by(1, 3, order) == 2 / parts_of_difference(order));
    for (int substeps = bounds.least; substeps <= bounds.most; substeps *= 2)
      for (const Real before : {none, Real(8), Real(2), Real(0.5)})
        for (Real off = Real(0.01); off < 10; off *= Real(1.07)) {
          CAPTURE(order, substeps, before, off);
          const Worth now = worth(off, before);
          const bool again = now == Worth::more && 2 * substeps <= bounds.most;
          const bool fewer = !again && fewer_will_do(off, order) && substeps > bounds.least;
          const plain_27::Verdict verdict = plain_27::judge_try({substeps, off, before, order}, bounds);
          CHECK(verdict.stands == !again);
          CHECK(verdict.kept == (now == Worth::kept));
          CHECK(verdict.substeps == (again ? 2 * substeps : fewer ? substeps / 2 : substeps));
        }
  }
}

TEST_CASE("plain controller: the estimate of each step is its true error, within the bounds that the page names") {
  if (!in_double) return;
  for (const Real degrees : {Real(10), Real(60), Real(120), Real(170)})
    for (const Real error : {Real(1e-2), Real(1e-3), Real(1e-4), Real(1e-5)}) {
      CAPTURE(degrees, error);
      plain_24::Bob bob = released_at(degrees * pi / 180);
      Real estimates = 0, truths = 0;
      for (int step = 0, substeps = 2; step < 600; ++step) {
        const plain_27::Step done = plain_27::controlled_step(bob, gravity, h, error, substeps, {});
        const plain_24::Bob fine = plain_27::advanced(bob, gravity, h, 64 * done.substeps);
        const Real truth = distance_in_half_a_second(done.bob, fine);
        REQUIRE(std::abs(done.estimate - truth) < Real(0.01) * error * h);
        if (degrees < 90) REQUIRE(done.estimate / truth == Approx(Real(1.0015)).margin(0.0015));
        REQUIRE((!done.kept || truth < Real(1.01) * error * h));
        estimates += done.estimate;
        truths += truth;
        bob = done.bob;
        substeps = done.next;
      }
      CHECK(estimates / truths == Approx(Real(1.002)).margin(0.002));
    }
}

TEST_CASE("plain controller: the engine takes the same pendulum in the same substeps, with the same estimates") {
  if (!in_double) return;
  for (const Real error : {Real(1e-2), Real(1e-3), Real(3e-4)}) {
    CAPTURE(error);
    plain_24::Bob bob = released_at(pi / 3);
    World world;
    world.add(sphere(Real(0.1), 1).at(bob.x));
    world.joints.push_back(distance(world, the_world, Vec3::Zero(), 0, bob.x));
    IslandSolver solver = which_error_tests::within(error);
    solver.check_every = 1;
    solver.energy = 1;  // so that the position error decides, and not the energy error
    solver.joint_half_step.tolerance = Real(1e-13);
    const plain_27::Bounds bounds{2, 8};  // beyond 8 half steps the engine composes steps of fourth order
    for (int step = 0, substeps = 2; step < 600; ++step) {
      const plain_27::Step done = plain_27::controlled_step(bob, gravity, h, error, substeps, bounds);
      world.step(solver, h);
      const BodyError known = solver.error_of(0);
      REQUIRE(done.substeps == known.substeps);
      REQUIRE(done.kept == known.kept);
      REQUIRE(done.estimate == Approx(known.step).epsilon(1e-7));
      REQUIRE((world.bodies[0].position - done.bob.x).norm() < Real(1e-12));
      bob = done.bob;
      substeps = done.next;
    }
  }
}
