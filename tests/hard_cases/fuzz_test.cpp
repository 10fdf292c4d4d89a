/// The books are kept beside the solver, not in it.
#include "pushback/tools/measure/hard_cases/fuzz.h"

#include <set>

#include "pushback/common/world/measure.h"
#include "pushback/engine/islands/island_solver.h"
#include "pushback/tools/measure/hard_cases/stages.h"
#include "tests/support/catch.h"

using namespace pushback;

TEST_CASE("fuzz: the solvers that keep books end in the same bits as the stages that they stand for") {
  for (const std::string& name : fuzzed_stages()) {
    for (std::uint64_t seed = 1; seed <= 4; ++seed) {
      const RandomScene scene = random_scene(seed);
      const FuzzResult finding = fuzz(scene, name);
      INFO(name << ", scene " << seed << " " << finding.broken);
      REQUIRE(finding.broken.empty());
      World world = scene.world;
      const Stepper step = stage_named(name).begin();
      for (int i = 0; i < finding.step; ++i) step.step(world, scene.dt);
      CHECK((finding.step == 60 || name == "00 naive"));
      CHECK(hash_of(world) == finding.hash);
    }
  }
}

TEST_CASE("fuzz: a solver that is not in the catalogue is refused") {
  CHECK_THROWS_AS(fuzz(random_scene(1), "06"), InvalidInput);
}

TEST_CASE("fuzz: Newton's method may leap far and come back, and momentum is kept") {
  for (const int substeps : {2, 4}) {
    const RandomScene scene = random_scene(1738);  // two bodies touch, 1,700 km from the origin
    World world = scene.world;
    IslandSolver solver;
    solver.contact_half_step.substeps = substeps;
    solver.contact_half_step.most_work = 1e7;  // with less it does not leap
    const Vec3 before = momentum(world);
    for (int i = 0; i < 60; ++i) world.step(solver, scene.dt);
    INFO(substeps << " substeps");
    CHECK((momentum(world) - before).norm() < Real(1e-12) * before.norm());
  }
}
