/// The list of all scenes: complete, each once, and each one that a solver can step.
#include "pushback/tools/catalogue/catalogue.h"

#include <map>

#include "pushback/chapters/14_joints_under_load/jointed_solver.h"
#include "pushback/common/world/measure.h"
#include "pushback/tools/measure/hard_cases/finite.h"
#include "tests/support/catch.h"

using namespace pushback;

TEST_CASE("no two scenes are the same world, and each is the same whenever it is filled") {
  // The sunken boxes differ by gravity alone; what falls alone, by its shape.
  std::map<std::tuple<std::uint64_t, Real, std::size_t>, std::string> first;
  for (const NamedScene& scene : all_scenes()) {
    World world, again;
    scene.fill(world);
    scene.fill(again);
    CHECK(hash_of(world) == hash_of(again));
    const auto [before, added] =
        first.emplace(std::tuple(hash_of(world), world.gravity.y(), world.bodies.back().shape.index()), scene.name);
    INFO(scene.name << " is " << before->second);
    CHECK(added);
  }
}

TEST_CASE("the full solver, with joints, steps every scene for a second, and all stays finite") {
  for (const NamedScene& scene : all_scenes()) {
    INFO(scene.name);
    World world;
    scene.fill(world);
    JointedSolver solver;
    bool touched = false;
    for (int step = 0; step < 60; ++step) {
      world.step(solver, Real(1) / 60, 10);
      REQUIRE(finite(world));
      touched = touched || !world.contacts.empty();
    }
    CHECK((touched || !world.joints.empty()));  // a scene without either asks a solver for nothing
  }
}
