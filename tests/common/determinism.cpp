/// The same program on the same machine does the same thing twice, to the last bit.
#include "pushback/chapters/00_naive_impulses/naive.h"
#include "pushback/chapters/07_warm_start/full_solver.h"
#include "pushback/chapters/11_substeps/substeps.h"
#include "pushback/common/bodies/random.h"
#include "pushback/common/experiment/experiment.h"
#include "pushback/common/world/measure.h"
#include "pushback/common/world/situations.h"
#include "tests/support/catch.h"
#include "tests/support/yardstick.h"

using namespace pushback;

namespace {

constexpr int steps = 600;

/// A pyramid, and a pile of everything that falls onto it.
void pyramid_under_fire(World& world) {
  Random random(5);
  pyramid(world, 6);
  for (int i = 0; i < 25; ++i) {
    const Real mass = random.over_decades(1, 100);
    Body body = random.body(mass);
    Vec3 place = random.vector(2);
    place.y() = 8 + static_cast<Real>(i) * Real(0.5);
    body.at(place).moving(random.vector(3)).spinning(random.vector(3));
    const Real mu = random.between(0, 1), e = random.between(0, Real(0.6));
    world.add(body.rough(mu).bouncy(e));
  }
}

/// The hash after every step.
template <class ContactSolver>
std::vector<std::uint64_t> history(World& world, ContactSolver& solver) {
  std::vector<std::uint64_t> hashes;
  for (int step = 0; step < steps; ++step) {
    world.step(solver, h, 10);
    hashes.push_back(hash_of(world));
  }
  return hashes;
}

std::vector<std::uint64_t> fresh_history() {
  World world;
  pyramid_under_fire(world);
  FullSolver solver;
  return history(world, solver);
}

}  // namespace

TEST_CASE("nothing depends on where in memory the bodies are") {
  World elsewhere;
  elsewhere.bodies.reserve(1000);
  pyramid_under_fire(elsewhere);
  FullSolver solver;
  CHECK(history(elsewhere, solver) == fresh_history());

  // The bodies move house in every step, and the world with them.
  World world;
  pyramid_under_fire(world);
  FullSolver moving_house;
  std::vector<std::uint64_t> hashes;
  std::vector<std::vector<Body>> kept;  // so that the old place is not handed out again
  for (int step = 0; step < steps; ++step) {
    world.step(moving_house, h, 10);
    hashes.push_back(hash_of(world));
    std::vector<Body> copy = world.bodies;
    kept.push_back(std::move(world.bodies));
    if (kept.size() > 3) kept.erase(kept.begin());
    world.bodies = std::move(copy);
  }
  CHECK(hashes == fresh_history());
}
