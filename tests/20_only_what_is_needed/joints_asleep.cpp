/// Joined bodies rest together: one island, which joints put to sleep no sooner, and wake as a whole.
#include "pushback/chapters/13_joints/distance.h"
#include "pushback/chapters/20_only_what_is_needed/dispatch.h"
#include "pushback/common/world/measure.h"
#include "tests/support/catch.h"
#include "tests/support/with_joints.h"
#include "tests/support/yardstick.h"

using namespace pushback;

namespace {

constexpr Real slop = Real(0.005);  // m: so far apart may be what sleeps and what does not
using Bodies = std::vector<int>;

/// A world whose resting bodies sleep, and the same without sleep.
struct Pair {
  World world, unslept;
  JointedSolver full;
  OnlyWhatIsNeeded solver;

  explicit Pair(const World& before_it) : world(before_it), unslept(before_it), solver(world, full, Sleep{}) {}
  Sleep& sleep() { return *solver.sleep; }
  void step(int count = 1) {
    for (int i = 0; i < count; ++i) {
      solver.step(world, h);
      unslept.step(full, h);
    }
  }
  void change(const std::function<void(World&)>& how) {
    how(world);
    how(unslept);
  }
  Bodies asleep() const {
    Bodies which;
    for (const Body& body : world.bodies) {
      if (body.asleep) which.push_back(body.index);
    }
    return which;
  }
  /// Steps until then; false if that takes more than a minute.
  bool falls_asleep(const Bodies& which) {
    for (int i = 0; i < 3600 && asleep() != which; ++i) step();
    return asleep() == which;
  }
  std::vector<Bodies> islands() const {
    std::vector<Bodies> all = solver.sleep->asleep();
    std::sort(all.begin(), all.end());
    return all;
  }
  Real apart() const {
    Real most = 0;
    for (std::size_t i = 0; i < world.bodies.size(); ++i)
      most = std::max(most, (world.bodies[i].position - unslept.bodies[i].position).norm());
    return most;
  }
};

/// Bodies 1 to 4, from above, held up by body 0, which is immovable; 5 hangs beside them on a thread of its own.
World five_hanging() {
  World world;
  world.add(box(Vec3::Constant(Real(0.2)), 1).fixed().at({0, 5, 0}));
  for (int i = 1; i <= 4; ++i) {
    const Real y = 5 - Real(0.5) * static_cast<Real>(i);
    world.add(sphere(Real(0.1), 2).at({0, y, 0}));
    world.joints.push_back(ball_and_socket(world, i - 1, i, {0, y + Real(0.25), 0}));
  }
  world.add(sphere(Real(0.1), 2).at({0, 4, Real(0.5)}));
  world.joints.push_back(distance(world, 0, {0, 5, Real(0.5)}, 5, {0, 4, Real(0.5)}));
  return world;
}
const Bodies hanging{1, 2, 3, 4}, beside{5}, all_five{1, 2, 3, 4, 5};

Pair sleeping_five() {
  Pair pair(five_hanging());
  REQUIRE(pair.falls_asleep(all_five));
  return pair;
}

}  // namespace

// ---- islands -----------------------------------------------------------------------------------------------------------

TEST_CASE("who hangs on the same immovable body, or on the world, is not joined by it") {
  Pair pair = sleeping_five();
  CHECK(pair.islands() == std::vector<Bodies>{hanging, beside});
  pair.change([](World& world) {  // both lengths held by the world instead
    world.joints[0] = ball_and_socket(world, the_world, 1, {0, Real(4.75), 0});
    world.joints[4] = distance(world, the_world, {0, 5, Real(0.5)}, 5, {0, 4, Real(0.5)});
    world.joints.push_back(distance(world, the_world, {0, 6, Real(0.5)}, 5, {0, 4, Real(0.5)}));
  });
  pair.step();
  CHECK(pair.asleep().empty());
  REQUIRE(pair.falls_asleep(all_five));
  CHECK(pair.islands() == std::vector<Bodies>{hanging, beside});
}

// ---- asleep ------------------------------------------------------------------------------------------------------------

TEST_CASE("a chain that was let go sideways swings as without sleep, and sleeps in the end") {
  World before_it;
  hanging_chain(before_it);
  before_it.forces.push_back({[](World& world) {  // so that it comes to rest within a test
                                for (int i = 1; i <= 8; ++i) {
                                  Body& body = world.bodies[std::size_t(i)];
                                  body.force -= 2 * body.velocity;
                                  body.torque -= Real(0.02) * body.angular_velocity;
                                }
                              },
                              "thick air",
                              {1, 2, 3, 4, 5, 6, 7, 8}});
  before_it.bodies[8].velocity = {5, 0, 1};
  Pair pair(before_it);
  for (int i = 0; i < 3600 && pair.asleep().empty(); ++i) {
    REQUIRE(hash_of(pair.world) == hash_of(pair.unslept));
    pair.step();
  }
  CHECK(pair.asleep().size() == 8);
  CHECK(pair.world.time > 2);
  pair.step(1200);
  CHECK(pair.apart() < slop);
}

// ---- waking ------------------------------------------------------------------------------------------------------------

TEST_CASE("a ball thrown at one link wakes the chain, and nobody else") {
  Pair pair = sleeping_five();
  pair.change([](World& world) { world.add(sphere(Real(0.1), 1).at({-1, Real(3.5), 0}).moving({6, 0, 0})); });
  bool struck = false;
  for (int i = 0; i < 30 && !struck; ++i) {
    pair.step();
    struck = !pair.world.contacts.empty();
    CHECK(pair.asleep() == (struck ? beside : all_five));
  }
  CHECK(struck);
}

TEST_CASE("joints that come or go wake all") {
  Pair pair = sleeping_five();
  pair.change([](World& world) { world.joints.push_back(distance(world, 4, {0, 3, 0}, 5, {0, 4, Real(0.5)})); });
  pair.step();
  CHECK(pair.asleep().empty());
  REQUIRE(pair.falls_asleep(all_five));
  CHECK(pair.islands() == std::vector<Bodies>{all_five});
  pair.change([](World& world) { world.joints.erase(world.joints.begin()); });
  pair.step();
  CHECK(pair.asleep().empty());
  CHECK(pair.world.bodies[1].velocity.y() < Real(-0.05));  // it falls
}

TEST_CASE("what hangs on an immovable body that moves wakes with it, and rests once that does") {
  Pair pair = sleeping_five();
  pair.change([](World& world) { world.bodies[0].velocity = {Real(1e-4), 0, 0}; });  // slower than any rest
  pair.step();
  CHECK(pair.asleep().empty());
  pair.step(120);
  CHECK(pair.asleep().empty());
  CHECK(pair.world.bodies[4].position.x() > Real(1e-4));
  CHECK(pair.apart() < Real(1e-12));
  pair.change([](World& world) { world.bodies[0].velocity.setZero(); });
  CHECK(pair.falls_asleep(all_five));
}

TEST_CASE("a joint that is driven keeps awake what it holds, and wakes it when its motion begins") {
  World world;
  cranked(world);
  Pair pair(world);
  for (int i = 0; i < 300; ++i) {
    pair.step();
    REQUIRE(pair.asleep().empty());
  }
  CHECK(pair.apart() == 0);

  Pair hung = sleeping_five();
  hung.world.joints[2].driven = true;  // the same joint: nothing moves yet
  hung.step();
  CHECK(hung.asleep() == beside);
  hung.step(120);
  CHECK(hung.asleep() == beside);
  hung.world.joints[2].driven = false;
  CHECK(hung.falls_asleep(all_five));
}

TEST_CASE("a woken chain starts from what its joints bore when it fell asleep") {
  const auto speed_of_the_woken = [](bool forget) {
    World before_it;
    hanging_chain(before_it, 8);
    JointedSolver full;
    World world = before_it;
    Sleep sleep;
    const auto step = [&] { pushback::step(world, full, h, 10, sleep); };
    while (!world.bodies[1].asleep && world.time < 60) step();
    for (int i = 0; i < 600; ++i) step();
    if (forget)
      for (Joint& joint : world.joints) joint.last_impulses.clear();
    sleep.wake(world, 1);
    step();
    return largest_speed(world);
  };
  const Real with = speed_of_the_woken(false), without = speed_of_the_woken(true);
  CAPTURE(with, without);
  CHECK(with < Real(1e-3));
  CHECK(without > Real(1e-2));
}
