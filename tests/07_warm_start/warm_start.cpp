/// What is remembered, and for whom; and what chapter 07's page says of its scenes, over a minute and from many starts.
#include "pushback/chapters/07_warm_start/full_solver.h"

#include <algorithm>
#include <functional>

#include "pushback/common/bodies/random.h"
#include "pushback/common/world/measure.h"
#include "tests/support/catch.h"
#include "tests/support/on_ground.h"

using namespace pushback;

namespace {

using Cold = Solver<Clamping, Baumgarte, Slop, Restitution, Friction>;

struct Minute {
  Real fell_after = -1;    ///< s, until a body was 2 m from where it began; -1: it stands
  Real farthest = 0;       ///< m, at any time
  Real last_speed = 0;     ///< m/s, the largest in the last second
  Real energy_gained = 0;  ///< J, the most over what it began with
};

/// A minute of a scene whose bodies begin up to 1 um off their places, in a way that `seed` decides. Ends where it falls.
template <class ContactSolver>
Minute minute_of(const std::function<void(World&)>& fill, Real dt, int sweeps, std::uint64_t seed) {
  World world;
  fill(world);
  Random random(seed);
  for (Body& body : world.bodies)
    if (body.movable()) body.position += random.vector(Real(1e-6));
  const World start = world;
  const Real before = potential_energy(world);
  ContactSolver solver;
  Minute seen;
  const int steps = static_cast<int>(std::lround(60 / dt));
  for (int step = 1; step <= steps; ++step) {
    world.step(solver, dt, sweeps);
    for (std::size_t i = 0; i < world.bodies.size(); ++i)
      seen.farthest = std::max(seen.farthest, (world.bodies[i].position - start.bodies[i].position).norm());
    seen.energy_gained = std::max(seen.energy_gained, kinetic_energy(world) + potential_energy(world) - before);
    if (static_cast<Real>(steps - step) * dt < 1) seen.last_speed = std::max(seen.last_speed, largest_speed(world));
    if (seen.farthest > 2) {
      seen.fell_after = static_cast<Real>(step) * dt;
      break;
    }
  }
  return seen;
}

/// Mean of the largest error of a row in the last second of five, m/s.
template <class ContactSolver>
Real residual_of_stack(int boxes, int sweeps) {
  World world;
  stack(world, boxes);
  ContactSolver solver;
  Real sum = 0;
  for (int step = 0; step < 300; ++step) {
    world.step(solver, h, sweeps);
    if (step >= 240) sum += largest_error(solver) / 60;
  }
  return sum;
}

}  // namespace

TEST_CASE("07: in steps of 1/120 s both piles fall cold and stand for a minute warm, from each of many starts",
          "[checked]") {
  struct Pile {
    std::string name;
    std::function<void(World&)> fill;
    int sweeps;
    std::uint64_t starts;
  };
  for (const Pile& pile : {Pile{"ten boxes", [](World& world) { stack(world, 10); }, 5, 30},
                           Pile{"a pyramid", [](World& world) { pyramid(world, 10); }, 2, 8}}) {
    for (std::uint64_t seed = 1; seed <= pile.starts; ++seed) {
      const Minute cold = minute_of<Cold>(pile.fill, h / 2, pile.sweeps, seed);
      const Minute warm = minute_of<FullSolver>(pile.fill, h / 2, pile.sweeps, seed);
      INFO(pile.name << ", start " << seed << ": cold falls after " << cold.fell_after << " s; warm is "
                     << warm.farthest << " m off at the most, " << warm.last_speed
                     << " m/s fast in the last second, gains " << warm.energy_gained << " J");
      CHECK(cold.fell_after > 0);
      CHECK(warm.fell_after < 0);
      CHECK(warm.farthest < Real(0.1));
      CHECK(warm.last_speed < Real(0.01));
      CHECK(warm.energy_gained == 0);
    }
  }
}

TEST_CASE("07: started warm, the same residual in fewer sweeps") {
  std::vector<Real> cold, warm;
  for (const int sweeps : {3, 5, 10, 20, 40}) {
    cold.push_back(residual_of_stack<Cold>(5, sweeps));
    warm.push_back(residual_of_stack<FullSolver>(5, sweeps));
    INFO("5 boxes, " << sweeps << " sweeps: cold " << cold.back() << " m/s, warm " << warm.back() << " m/s");
    CHECK(warm.back() < cold.back() / 50);
  }
  CHECK(warm.front() < cold.back());  // 3 warm sweeps are worth more than 40 cold ones
  for (const int sweeps : {10, 20, 40}) {
    const Real ten_cold = residual_of_stack<Cold>(10, sweeps), ten_warm = residual_of_stack<FullSolver>(10, sweeps);
    INFO("10 boxes, " << sweeps << " sweeps: cold " << ten_cold << " m/s, warm " << ten_warm << " m/s");
    CHECK(ten_warm < ten_cold / 5);
  }
}

TEST_CASE("07: the first guess is scaled by dt_new / dt_old") {
  World world;
  Body& ball = ball_on_ground(world, Real(0.002));
  FullSolver solver;
  world.step(solver, h, one_sweep);
  // No sweeps at all from here on: what is left is the first guess, and it holds the ball through any change of step.
  for (const Real dt : {h, h / 4, h / 2, h * 2, h / 7, h}) {
    world.step(solver, dt, 0);
    REQUIRE(world.contacts.at(0).impulse.y() == Approx(10 * g * dt).epsilon(64 * eps));
    REQUIRE(std::abs(ball.velocity.y()) <= 64 * eps);
    REQUIRE(world.contacts[0].state != ContactState::fresh);
  }

  // A pile at rest does not notice either: its speeds stay what they are in steady steps.
  World pile;
  stack(pile, 5);
  FullSolver steady;
  for (int step = 0; step < 600; ++step) pile.step(steady, h, 20);
  const Real quiet = largest_speed(pile);
  for (const Real dt : {h / 4, h, h / 2, h}) {
    pile.step(steady, dt, 20);
    INFO("largest speed " << largest_speed(pile) << " m/s after " << quiet);
    CHECK(largest_speed(pile) < 10 * quiet);  // unscaled it would be some g h, 0.1 m/s
  }
}

TEST_CASE("07: the impulse of each contact goes to the same contact, though others come and go") {
  // Three balls of different mass. The middle one leaves and returns; the outer ones keep what is theirs.
  World world;
  world.add(ground());
  for (int i = 0; i < 3; ++i)
    world.add(sphere(Real(0.3), static_cast<Real>(10 * (i + 1))).at({static_cast<Real>(i), Real(0.298), 0}));
  FullSolver solver;
  world.step(solver, h, one_sweep);
  world.bodies[2].at({1, 1, 0});
  world.step(solver, h, 0);
  REQUIRE(world.contacts.size() == 2);
  CHECK(world.contacts[0].impulse.y() == Approx(10 * g * h).epsilon(64 * eps));
  CHECK(world.contacts[1].impulse.y() == Approx(30 * g * h).epsilon(64 * eps));
  world.bodies[2].at({1, Real(0.298), 0}).moving(Vec3::Zero());
  world.step(solver, h, 0);
  REQUIRE(world.contacts.size() == 3);
  CHECK(world.contacts[0].impulse.y() == Approx(10 * g * h).epsilon(64 * eps));
  CHECK(world.contacts[1].impulse.isZero(0));
  CHECK(world.contacts[2].impulse.y() == Approx(30 * g * h).epsilon(64 * eps));
}
