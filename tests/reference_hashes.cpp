/// The same source does the same thing whatever built it: 600 steps of each scene under each stage end in the states whose
/// hashes stand in reference_hashes.txt, by g++ and by clang++, optimised or not, with sanitizers or without.
/// PUSHBACK_STORE_HASHES=1 writes that file anew.
#include <fmt/format.h>

#include <map>
#include <thread>

#include "pushback/common/bodies/random.h"
#include "pushback/common/world/measure.h"
#include "pushback/common/world/situations.h"
#include "pushback/tools/measure/hard_cases/random_scene.h"
#include "pushback/tools/measure/hard_cases/stages.h"
#include "tests/support/catch.h"
#include "tests/support/stored_hashes.h"

using namespace pushback;

namespace {

constexpr int steps = 600;

void heap(World& world) {
  Random random(7);
  world.add(ground());
  for (int i = 0; i < 15; ++i) {
    Body body = random.body(10);
    world.add(body.at({random.between(-1, 1), 1 + static_cast<Real>(i) * Real(0.7), random.between(-1, 1)}));
  }
}

/// Free, each about its middle axis and a little beside it; and two that meet.
void spinning(World& world) {
  world.gravity.setZero();
  for (int i = 0; i < 5; ++i) {
    const Real faster = static_cast<Real>(i + 1);
    world.add(box({1, Real(0.5), Real(0.2)}, 10).at({4 * faster, 0, 0}).spinning({Real(0.01), faster, 0}));
  }
  world.add(capsule(Real(0.2), 1, 5).at({-6, 0, 0}).moving({4, 0, 0}).spinning({0, 0, 7}));
}

/// A needle, a plate and a lump in turn, each of other points.
void hulls(World& world) {
  Random random(11);
  world.add(ground());
  for (int i = 0; i < 9; ++i) {
    const Vec3 size = i % 3 == 0 ? Vec3(1, Real(0.1), Real(0.1)) : i % 3 == 1 ? Vec3(1, Real(0.1), 1) : Vec3(1, 1, 1);
    std::vector<Vec3> points(8);
    for (Vec3& point : points) point = size.cwiseProduct(random.vector(Real(0.5)));
    Body body = hull(points, 10).at({random.between(-1, 1), 1 + static_cast<Real>(i) * Real(0.8), 0});
    world.add(body.bouncy(i % 2 == 0 ? 0 : Real(0.5)));
  }
}

struct Named {
  const char* name;
  void (*fill)(World&);
};
const Named scenes[] = {{"stack", [](World& world) { stack(world, 10); }},
                        {"pyramid", [](World& world) { pyramid(world, 5); }},
                        {"heap", heap},
                        {"hulls", hulls},
                        {"spinning", spinning},
                        {"random 3", [](World& world) { world = random_scene(3).world; }}};

std::uint64_t hash_after(const Named& scene, const Stage& stage) {
  World world;
  scene.fill(world);
  const Stepper step = stage.begin();
  try {
    for (int i = 0; i < steps; ++i) step.step(world, Real(1) / 60);
  } catch (const std::exception&) {
    return 0;  // no longer finite: naive solvers may do that, but then all builds do
  }
  return hash_of(world);
}

/// By "scene, stage".
std::map<std::string, std::string> all_hashes() {
  std::map<std::string, std::string> hashes;
  for (const Named& scene : scenes) {
    for (const Stage& stage : stages()) {
      hashes[fmt::format("{}, {}", scene.name, stage.name)] = fmt::format("{:016x}", hash_after(scene, stage));
    }
  }
  return hashes;
}

}  // namespace

#ifndef PUSHBACK_FLOAT
TEST_CASE("600 steps end in the same bits in every build", "[slow]") {
  check_stored("tests/reference_hashes.txt", all_hashes());
}
#endif

TEST_CASE("two worlds stepped by two threads at once go as they do one after the other", "[slow]") {
  for (const char* name : {"07 warm start", "12 soft contacts", "all together"}) {
    const Stage& stage = stage_named(name);
    const std::uint64_t alone[2] = {hash_after(scenes[1], stage), hash_after(scenes[2], stage)};
    std::uint64_t together[2] = {};
    std::thread first([&] { together[0] = hash_after(scenes[1], stage); });
    std::thread second([&] { together[1] = hash_after(scenes[2], stage); });
    first.join();
    second.join();
    CHECK(together[0] == alone[0]);
    CHECK(together[1] == alone[1]);
  }
}
