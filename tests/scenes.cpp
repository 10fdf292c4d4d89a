/// The list of all scenes: each once.
#include "pushback/tools/catalogue/catalogue.h"

#include <map>

#include "pushback/common/world/measure.h"
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
