/// What a program does to World::bodies and World::joints by hand: it works, or it is refused by name before anything has moved.
#include "pushback/chapters/13_joints/ball_and_socket.h"
#include "pushback/chapters/14_joints_under_load/jointed_solver.h"
#include "pushback/common/world/measure.h"
#include "pushback/common/world/step.h"
#include "pushback/engine/islands/sleep.h"
#include "pushback/engine/presets.h"
#include "tests/support/catch.h"
#include "tests/support/complaint.h"
#include "tests/support/yardstick.h"

using namespace pushback;

namespace {

/// A stack of six, and a ball that bounces beside it, as a solver leaves them after half a second.
World played(StepSolver& solver) {
  World world;
  world.add(ground());
  for (int i = 0; i < 6; ++i)
    world.add(box({Real(0.2), Real(0.2), Real(0.2)}, 5).at({0, Real(0.2) + Real(0.4) * Real(i), 0}));
  world.add(sphere(Real(0.2), 5).at({3, 1, 0}).bouncy(Real(0.5)));
  for (int i = 0; i < 30; ++i) world.step(solver, h);
  return world;
}

template <class ContactSolver>
void refuses(const std::string& what, const std::function<void(World&)>& change) {
  ContactSolver solver;
  World world = played(solver);
  change(world);
  const std::uint64_t before = hash_of(world);
  const std::string said = complaint([&] { world.step(solver, h); });
  INFO(said);
  CHECK(said.find(what) != std::string::npos);
  CHECK(hash_of(world) == before);
}

void all_refuse(const std::string& what, const std::function<void(World&)>& change) {
  INFO(what);
  refuses<JointedSolver>(what, change);
  refuses<Fast>(what, change);
  refuses<Recommended>(what, change);
}

/// A box that has fallen asleep on a fixed slab, and a ball beside it.
struct Sleeping {
  World world;
  Recommended solver;
  Sleep sleep;
  int slab, sleeper, other;

  Sleeping() {
    slab = world.add(box({2, Real(0.5), 2}, 1).fixed().at({0, Real(-0.5), 0}));
    sleeper = world.add(box({Real(0.5), Real(0.5), Real(0.5)}, 100).at({0, Real(0.5), 0}));
    other = world.add(box({Real(0.5), Real(0.5), Real(0.5)}, 100).at({0, Real(1.5), 0}));
    step(120);
    REQUIRE(body().asleep);
  }
  void step(int times) {
    for (int i = 0; i < times; ++i) pushback::step(world, solver, h, solver.plan(h).sweeps, sleep);
  }
  Body& body() { return world.bodies[std::size_t(sleeper)]; }
};

}  // namespace

TEST_CASE("by hand: bodies that are put in or taken out of the vector are refused by name") {
  all_refuse("index of the body at place 8 of World::bodies is -1",
             [](World& world) { world.bodies.push_back(sphere(Real(0.2), 5)); });
  all_refuse("index of the body at place 3 of World::bodies is 4",
             [](World& world) { world.bodies.erase(world.bodies.begin() + 3); });
  all_refuse("index of the body at place 3 of World::bodies is 5", [](World& world) { world.bodies[3].index = 5; });
}

TEST_CASE("by hand: bodies that are taken off the end of the vector are gone, and what touched them is forgotten") {
  Recommended recommended;
  Fast fast;
  for (StepSolver* solver : std::initializer_list<StepSolver*>{&recommended, &fast}) {
    World world = played(*solver);
    world.bodies.resize(6);  // without the top of the stack
    for (int i = 0; i < 120; ++i) world.step(*solver, h);
    CHECK(world.bodies.back().position.y() == Approx(1.8).epsilon(0.01));
    world.bodies.clear();
    world.step(*solver, h);
    CHECK(world.contacts.empty());
  }
}

TEST_CASE("by hand: joints and forces that name no body of the world are refused by name") {
  all_refuse("a ball and socket holds body 9: of 8 bodies, the first is 0", [](World& world) {
    world.joints.push_back(ball_and_socket(world, 6, 7, {Real(1.5), 2, 0}));
    world.joints[0].b = 9;
  });
  all_refuse("a ball and socket joins body 6 to itself", [](World& world) {
    world.joints.push_back(ball_and_socket(world, 6, 7, {Real(1.5), 2, 0}));
    world.joints[0].b = 6;
  });
  all_refuse("a ball and socket holds body 7: of 8 bodies, the first is 0", [](World& world) {
    world.joints.push_back(ball_and_socket(world, 6, 7, {Real(1.5), 2, 0}));
    const Joint held = world.joints[0];
    world.remove(7);
    CHECK(world.joints.empty());
    world.joints.push_back(held);
  });
  all_refuse("a push acts on body -1", [](World& world) { world.forces.push_back({[](World&) {}, "a push", {-1}}); });
}

TEST_CASE(
    "by hand: numbers that are not finite, and an orientation that is none, are refused by the name of the body") {
  const Real nan = std::numeric_limits<Real>::quiet_NaN(), inf = std::numeric_limits<Real>::infinity();
  all_refuse("force of body 3 is (0, nan, 0)", [nan](World& world) { world.bodies[3].force.y() = nan; });
  all_refuse("torque of body 7 is (inf, 0, 0)", [inf](World& world) { world.bodies[7].torque.x() = inf; });
  all_refuse("velocity of body 3 is (nan", [nan](World& world) { world.bodies[3].velocity.x() = nan; });
  all_refuse("length of the orientation of body 2 is 2", [](World& world) { world.bodies[2].orientation.w() = 2; });
  all_refuse("length of the orientation of body 2 is nan",
             [nan](World& world) { world.bodies[2].orientation.x() = nan; });
}

TEST_CASE("by hand: an orientation of unit length is taken, and the inertia follows") {
  World turned_before;
  turned_before.add(box({1, Real(0.5), Real(0.25)}, 10).turned(Real(0.5), {1, 2, 3}));
  const Quat turn = turned_before.bodies[0].orientation;
  const auto spun = [&](StepSolver& solver, bool by_hand) {
    World world;
    world.gravity.setZero();
    world.add(by_hand ? box({1, Real(0.5), Real(0.25)}, 10) : turned_before.bodies[0]);
    world.bodies[0].orientation = turn;
    world.bodies[0].torque = {1, 0, 0};
    world.step(solver, h);
    return hash_of(world);
  };
  JointedSolver full;
  Recommended recommended;
  Fast fast;
  for (StepSolver* solver : std::initializer_list<StepSolver*>{&full, &recommended, &fast})
    CHECK(spun(*solver, true) == spun(*solver, false));
}

TEST_CASE("by hand: a body is removed from a stack under every preset, and the rest goes on") {
  const auto remove = [](StepSolver& solver) {
    World world = played(solver);
    world.remove(3);
    CHECK(complaint([&] { world.remove(3); }) == "body to remove is 3: the index of a body in the world is needed");
    CHECK(complaint([&] { world.remove(-1); }) == "body to remove is -1: the index of a body in the world is needed");
    CHECK(complaint([&] { world.remove(8); }) == "body to remove is 8: the index of a body in the world is needed");
    for (int i = 0; i < 120; ++i) world.step(solver, h);
    CHECK(world.bodies[2].position.y() == Approx(0.6).epsilon(0.01));
    CHECK(world.bodies[4].position.y() == Approx(1.0).epsilon(0.01));  // down by one
    CHECK(world.bodies[6].position.y() == Approx(1.8).epsilon(0.01));
  };
  JointedSolver full;
  Recommended recommended;
  Fast fast;
  for (StepSolver* solver : std::initializer_list<StepSolver*>{&full, &recommended, &fast}) remove(*solver);
}

TEST_CASE("by hand: a sleeper wakes if it is given a velocity, a force, a torque, another place or another turn") {
  const std::pair<const char*, std::function<void(Body&)>> changes[] = {
      {"velocity", [](Body& body) { body.velocity = {0, 5, 0}; }},
      {"angular velocity", [](Body& body) { body.angular_velocity = {0, 5, 0}; }},
      {"force", [](Body& body) { body.force = {3000, 0, 0}; }},
      {"torque", [](Body& body) { body.torque = {0, 3000, 0}; }},
      {"position", [](Body& body) { body.position.y() += Real(0.001); }},
      {"orientation", [](Body& body) { body.turned(Real(0.1), Vec3::UnitY()); }}};
  for (const auto& [what, change] : changes) {
    INFO(what);
    Sleeping scene;
    change(scene.body());
    scene.step(1);
    CHECK_FALSE(scene.body().asleep);
  }
  Sleeping scene;
  scene.world.bodies[std::size_t(scene.other)].position = {10, 10, 0};  // it falls beside the slab
  scene.body().velocity = {0, 5, 0};
  for (int i = 0; i < 30; ++i) {
    scene.step(1);
    CHECK(scene.body().velocity.y() == Approx(5 - g * h * Real(i + 1)).margin(1e-9));
  }
}

TEST_CASE("by hand: what lies on a support wakes when that is removed or moved, and falls") {
  for (const bool removed : {true, false}) {
    Sleeping scene;
    if (removed) scene.world.remove(scene.slab);
    else scene.world.bodies[std::size_t(scene.slab)].at({100, 0, 0});
    scene.step(30);
    CHECK_FALSE(scene.body().asleep);
    CHECK(scene.body().position.y() < 0);
  }
  Sleeping scene;  // the lower of two sleepers
  scene.world.remove(scene.sleeper);
  scene.step(60);
  CHECK(scene.world.bodies[std::size_t(scene.other)].position.y() == Approx(0.5).epsilon(0.01));
  scene.step(120);
  CHECK(scene.world.bodies[std::size_t(scene.other)].asleep);
}
