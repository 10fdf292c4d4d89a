/// Scenes from outside: they are read, physics holds in them, and what is judged is what happens.
#include <filesystem>

#include "pushback/common/world/measure.h"
#include "pushback/engine/presets.h"
#include "pushback/tools/measure/hard_cases/watcher.h"
#include "pushback/tools/measure/outside/report.h"
#include "tests/support/catch.h"
#include "tests/support/complaint.h"

using namespace pushback;
using namespace pushback::outside;

namespace {

Stage stage_of(AnySolver solver) {
  return {{"it", "", std::move(solver), {}}};
}

OutsideScene beginning(const std::string& name, Real seconds) {
  OutsideScene scene = scene_named(name);
  scene.seconds = seconds;
  return scene;
}

/// Solves nothing, and makes all that moves a little faster.
struct Quickening : StepSolver {
  void solve(World& world, Real, int) override {
    for (Body& body : world.bodies)
      if (body.movable()) body.velocity *= Real(1.01);
  }
};

/// Solves nothing, and turns all that moves as a drum about the axis z turns.
struct Carrying : StepSolver {
  Vec3 turn = Vec3(0, 0, 25 * pi / 180);  // rad/s
  void solve(World& world, Real, int) override {
    for (Body& body : world.bodies)
      if (body.movable()) body.moving(turn.cross(body.position)).spinning(turn);
  }
};

}  // namespace

TEST_CASE("outside: every scene is read, and begins with finite numbers and bodies that move") {
  for (const OutsideScene& scene : outside_scenes()) {
    INFO(scene.name);
    const World world = begin(scene);
    CHECK(finite(world));
    CHECK(kinetic_energy(world) == 0);
    Real thinnest = 1e9;
    for (const Body& body : world.bodies) {
      if (!body.movable()) continue;
      if (const auto* box = std::get_if<Box>(&body.shape)) thinnest = std::min(thinnest, box->half_extents.minCoeff());
      if (const auto* ball = std::get_if<Sphere>(&body.shape)) thinnest = std::min(thinnest, ball->radius);
      if (const auto* capsule = std::get_if<Capsule>(&body.shape)) thinnest = std::min(thinnest, capsule->radius);
    }
    if (thinnest < 1e9) CHECK(scene.half_thickness == Approx(thinnest));
    CHECK(look_at(scene, world)(world) >= 0);
  }
  CHECK(outside_scenes().size() >= 17);
  CHECK(complaint([] { scene_named("nothing"); }).find("sphere_in_slot") != std::string::npos);
}

TEST_CASE("outside: a plate and its balls gain as much momentum as pushing and friction give them") {
  const OutsideScene scene = scene_named("balls_on_pushed_plate");
  World world = begin(scene);
  Recommended solver;
  for (int step = 0; step < 60; ++step) world.step(solver, Real(1) / 60);
  const Vec3 along(Real(0.5), 0, Real(-0.866025403784439));
  const Vec3 due = (150 - Real(0.4) * 35 * World::g) * along;  // kg m/s after a second
  CHECK((momentum(world) - due).norm() < Real(0.01) * due.norm());
}

TEST_CASE("outside: no energy comes from nowhere, and a solver that makes some is found out") {
  for (const char* name : {"humanoid", "heavy_on_light", "lifted_sphere"}) {
    INFO(name);
    const Played fast = play(beginning(name, Real(0.4)), stage_of(Fast{}));
    CHECK(fast.broken.empty());
    CHECK(fast.gained < 1);
    CHECK(fast.overlap_worst >= fast.overlap_median);
  }
  CHECK(play(beginning("heavy_on_light", 1), stage_of(Quickening{})).gained > 5);
}

TEST_CASE("outside: what a drum does is no gain, and that it turns is no overlap") {
  CHECK(play(beginning("drum_with_paddles", 3), stage_of(Carrying{})).gained < Real(0.1));
  const Played drum = play(beginning("drum_with_paddles", 3), stage_of(Fast{}));
  CHECK(drum.passed(scene_named("drum_with_paddles")));
}

TEST_CASE("outside: results are read as they were written, and lines that are none are refused") {
  const std::vector<Played> all{
      {.scene = "kapla", .solver = "Recommended, 1 mm", .number = 0.25, .broken = "not finite"},
      {.scene = "kapla", .solver = "Bullet", .number = 0.1}};
  const std::string text = text_of(all);
  CHECK(text_of(read_lines(text)) == text);
  CHECK(complaint([&] { read_lines(text + "kapla,Bullet,1\n"); }).find("10 fields are needed") != std::string::npos);
  CHECK(complaint([&] { read_lines(text + "castle,Bullet,1,1,1,1,1,1,1,\n"); }).find("castle") != std::string::npos);
}

TEST_CASE("outside: scenes in which ours lose come first") {
  const std::vector<Played> all{{.scene = "666", .solver = "ours", .number = 0.1},
                                {.scene = "kapla", .solver = "ours", .number = 1},
                                {.scene = "666", .solver = "theirs", .number = 0.1},
                                {.scene = "kapla", .solver = "theirs", .number = 0.1}};
  const std::string text = tables(all, {"ours"});
  CHECK(text.find("102 planks") < text.find("216 balls"));
  CHECK(text.find("✗ 1 m | ✓ 0.1 m") != std::string::npos);
}
