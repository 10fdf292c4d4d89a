/// Who rests is left out, and nobody sees it: islands, falling asleep, waking.
#include <fmt/format.h>

#include <memory>

#include "pushback/chapters/13_joints/distance.h"
#include "pushback/chapters/20_only_what_is_needed/dispatch.h"
#include "pushback/common/bodies/random.h"
#include "pushback/common/world/forces.h"
#include "pushback/common/world/measure.h"
#include "pushback/tools/catalogue/solvers.h"
#include "pushback/tools/measure/hard_cases/random_scene.h"
#include "tests/support/catch.h"
#include "tests/support/complaint.h"
#include "tests/support/with_joints.h"
#include "tests/support/yardstick.h"

using namespace pushback;

namespace {

constexpr Real not_a_number = std::numeric_limits<Real>::quiet_NaN();
using Bodies = std::vector<int>;

Body cube() {
  return box(Vec3::Constant(Real(0.5)), 100);
}

/// A world whose resting bodies sleep.
struct Dormitory {
  World world;
  OnlyWhatIsNeeded solver;

  explicit Dormitory(const World& start, const char* named = "07 warm start")
      : world(start), solver(solver_named(named).fitting(world, Sleep{})) {}
  Sleep& sleep() { return *solver.sleep; }
  std::vector<Bodies> islands() const {
    std::vector<Bodies> all = solver.sleep->asleep();
    std::sort(all.begin(), all.end());
    return all;
  }
  void step(int count = 1) {
    for (int i = 0; i < count; ++i) solver.step(world, h);
  }
  Bodies asleep() const {
    Bodies which;
    for (const Body& body : world.bodies) {
      if (body.asleep) which.push_back(body.index);
    }
    return which;
  }
  /// Throws if that takes more than a minute.
  void step_until_asleep(const Bodies& which) {
    for (int i = 0; i < 3600; ++i) {
      step();
      if (asleep() == which) return;
    }
    throw std::runtime_error("these do not fall asleep");
  }
};

/// Boxes 1, 2, 3 on each other, and 4, 5, 6 beside them, on one ground; 1 mm deep in what they lie on.
World two_piles() {
  World world;
  world.add(ground());
  for (const Real x : {Real(0), Real(1.5)}) {
    for (int i = 0; i < 3; ++i) world.add(cube().at({x, Real(0.499) + Real(0.999) * static_cast<Real>(i), 0}));
  }
  return world;
}
const Bodies first_pile{1, 2, 3}, second_pile{4, 5, 6}, both{1, 2, 3, 4, 5, 6};

Dormitory two_sleeping_piles() {
  Dormitory piles(two_piles());
  piles.step_until_asleep(both);
  return piles;
}

/// Bodies 1 to 4, from above, held up by body 0, which is immovable; 5 hangs beside them on a thread of its own.
Dormitory five_hanging_asleep() {
  World world;
  world.add(box(Vec3::Constant(Real(0.2)), 1).fixed().at({0, 5, 0}));
  for (int i = 1; i <= 4; ++i) {
    const Real y = 5 - Real(0.5) * static_cast<Real>(i);
    world.add(sphere(Real(0.1), 2).at({0, y, 0}));
    world.joints.push_back(ball_and_socket(world, i - 1, i, {0, y + Real(0.25), 0}));
  }
  world.add(sphere(Real(0.1), 2).at({0, 4, Real(0.5)}));
  world.joints.push_back(distance(world, 0, {0, 5, Real(0.5)}, 5, {0, 4, Real(0.5)}));
  Dormitory five(world);
  five.step_until_asleep({1, 2, 3, 4, 5});
  return five;
}
const Bodies beside{5}, all_five{1, 2, 3, 4, 5};

}  // namespace

TEST_CASE("islands are those that a flood would find, through all that can move") {
  Random random(1);
  Islands islands;  // one for all: what was before must not matter
  int alone = 0, together = 0;
  for (int scene = 0; scene < 1000; ++scene) {
    World world;
    std::vector<Body>& bodies = world.bodies;
    bodies.assign(1 + random.below(40), cube());
    Bodies movable;
    for (std::size_t i = 0; i < bodies.size(); ++i) {
      bodies[i].index = int(i);
      if (random.below(4) == 0) bodies[i].fixed();
      else movable.push_back(int(i));
    }
    Contacts contacts(random.below(bodies.size() + 1));
    for (Contact& contact : contacts) {
      contact.id.body_a = static_cast<std::uint32_t>(random.below(bodies.size()));
      contact.id.body_b = static_cast<std::uint32_t>(random.below(bodies.size()));
    }
    islands.separate(movable, bodies.size());
    islands.join(contacts, world);

    Bodies lowest(bodies.size());
    std::iota(lowest.begin(), lowest.end(), 0);
    for (bool flows = true; flows;) {
      flows = false;
      for (const Contact& contact : contacts) {
        int &a = lowest[contact.id.body_a], &b = lowest[contact.id.body_b];
        const auto [one, other] = world.bodies_of(contact);
        if (!one.movable() || !other.movable() || a == b) continue;
        a = b = std::min(a, b);
        flows = true;
      }
    }
    for (const int i : movable) {
      REQUIRE(islands.island_of(i) == lowest[std::size_t(i)]);
      ++(lowest[std::size_t(i)] == i ? alone : together);
    }
  }
  CHECK(std::min(alone, together) > 1000);
}

TEST_CASE("who lies on the same ground is not joined by it; whom a force joins fall asleep and wake as one") {
  CHECK(two_sleeping_piles().islands() == std::vector<Bodies>{first_pile, second_pile});
  World world = two_piles();
  world.add(cube().fixed().at({5, 5, 5}));
  world.forces = {{[](World&) {}, "a rod", {7, 1, 4}}};
  Dormitory piles(world);
  piles.step_until_asleep(both);
  CHECK(piles.islands() == std::vector<Bodies>{both});
  piles.sleep().wake(piles.world, 3);
  CHECK(piles.asleep().empty());
}

TEST_CASE("who has kept its place for as long as it takes sleeps, and who has not does not") {
  World world;
  world.gravity.setZero();
  const Real fast_enough = 2 * Sleep{}.rest_distance / Sleep{}.time_to_sleep;
  world.add(sphere(1, 1));
  world.add(sphere(1, 1).at({5, 0, 0}).moving({fast_enough, 0, 0}));
  world.add(sphere(1, 1).at({10, 0, 0}).spinning({0, fast_enough, 0}));
  world.add(sphere(1, 1).at({15, 0, 0}).moving({fast_enough / 3, 0, 0}));
  Dormitory balls(world);
  balls.step(30);  // it is seen where it is at the end of the first
  CHECK(balls.asleep().empty());
  balls.step(2);
  CHECK(balls.asleep() == Bodies{0, 3});
  CHECK(balls.world.bodies[3].velocity.isZero(0));
  balls.step(300);
  CHECK(balls.asleep() == Bodies{0, 3});
}

TEST_CASE("nobody sleeps on what is moving, be it ever so slowly") {
  World world;
  world.add(box({1, 1, 1}, 1).fixed().at({0, -1, 0}).moving({Real(1e-4), 0, 0}));
  world.add(cube().at({0, Real(0.499), 0}));
  Dormitory platform(world);
  for (int i = 0; i < 300; ++i) {
    platform.step();
    REQUIRE(platform.asleep().empty());
  }
  CHECK(platform.world.bodies[1].position.x() == Approx(5 * Real(1e-4)).epsilon(Real(0.05)));
  platform.world.bodies[0].velocity.setZero();  // it has arrived
  platform.step(120);
  CHECK(platform.asleep() == Bodies{1});

  platform.world.bodies[0].velocity.x() = Real(1e-4);
  platform.step();
  CHECK(platform.asleep().empty());
}

TEST_CASE("who is hit wakes with all of its island, at the moment it is hit, and the pile beside it sleeps on") {
  Dormitory piles = two_sleeping_piles();
  const World before = piles.world;
  piles.world.add(box({Real(0.2), Real(0.1), Real(0.2)}, 20).at({Real(-0.2), Real(3.8), 0}).moving({0, -1, 0}));
  int steps = 0;
  while (piles.asleep() == both && steps < 120) {
    piles.step();
    ++steps;
    if (piles.asleep() == both) REQUIRE(piles.world.contacts.empty());
  }
  CHECK(steps > 10);  // it has to fall first
  CHECK(piles.asleep() == second_pile);
  CHECK(piles.world.bodies[3].velocity.norm() > 0);
  piles.step(30);
  CHECK(piles.asleep() == second_pile);
  for (const int i : second_pile) {
    const Body &was = before.bodies[std::size_t(i)], &is = piles.world.bodies[std::size_t(i)];
    CHECK(was.position == is.position);
    CHECK(was.orientation.coeffs() == is.orientation.coeffs());
  }
  piles.step_until_asleep({1, 2, 3, 4, 5, 6, 7});  // what hit them lies on them now
}

TEST_CASE("an immovable body that comes to touch wakes, and while it is still, it does not") {
  World world = two_piles();
  world.add(box(Vec3::Constant(Real(0.25)), 1).fixed().at({Real(-1), Real(0.5), 0}));
  Dormitory piles(world);
  piles.step_until_asleep(both);
  piles.world.bodies[7].velocity = {Real(0.5), 0, 0};
  int steps = 0;
  for (; piles.asleep() == both && steps < 120; ++steps) piles.step();
  CHECK(steps == Approx(30).margin(2));  // 0.25 m at 0.5 m/s
  CHECK(piles.asleep() == second_pile);
  piles.world.bodies[7].velocity.setZero();  // stuck in the box; which it pushes out, and then does not wake any more
  piles.step_until_asleep(both);
}

TEST_CASE("a changed gravity wakes all, and so does a force that is added or taken away") {
  Dormitory piles = two_sleeping_piles();
  piles.world.gravity.x() = Real(0.1);
  piles.step();
  CHECK(piles.asleep().empty());
  piles.step_until_asleep(both);
  piles.world.forces.push_back(drag(1, 1));
  piles.step();
  CHECK(piles.asleep().empty());
  piles.step_until_asleep(both);
  piles.world.forces = {{[](World&) {}, "wind"}};  // it acts on all, so that nobody sleeps
  piles.step(120);
  CHECK(piles.asleep().empty());
  piles.world.forces.clear();
  piles.step_until_asleep(both);
}

TEST_CASE("joints that come or go wake all") {
  Dormitory five = five_hanging_asleep();
  five.world.joints.push_back(distance(five.world, 4, {0, 3, 0}, 5, {0, 4, Real(0.5)}));
  five.step();
  CHECK(five.asleep().empty());
  five.step_until_asleep(all_five);
  CHECK(five.islands() == std::vector<Bodies>{all_five});
  five.world.joints.erase(five.world.joints.begin());
  five.step();
  CHECK(five.asleep().empty());
  CHECK(five.world.bodies[1].velocity.y() < Real(-0.05));  // it falls
}

TEST_CASE("a joint that is driven keeps awake what it holds, and wakes it when its motion begins") {
  Dormitory five = five_hanging_asleep();
  five.world.joints[2].driven = true;  // the same joint: nothing moves yet
  five.step();
  CHECK(five.asleep() == beside);
  five.step(120);
  CHECK(five.asleep() == beside);
  five.world.joints[2].driven = false;
  five.step_until_asleep(all_five);
}

TEST_CASE("a spring that holds as it held lets sleep, and so does drag, and two of them on one body too") {
  World world = two_piles();
  world.forces = {spring(3, {0, 4, 0}, 50), drag(3, 10), spring(3, {Real(0.1), 3, 0}, 20), spring(6, {1, 4, 0}, 30)};
  Dormitory piles(world);
  piles.step_until_asleep(both);
  const std::uint64_t before = hash_of(piles.world);
  piles.step(200);
  CHECK(piles.asleep() == both);
  CHECK(hash_of(piles.world) == before);
}

TEST_CASE("a spring that starts to pull wakes the island that it pulls at, with all the forces on it") {
  World world;
  world.add(ground());
  world.add(sphere(Real(0.5), 10).at({0, Real(0.499), 0}));
  world.add(sphere(Real(0.5), 10).at({2, Real(0.499), 0}));
  world.add(sphere(Real(0.5), 10).at({4, Real(0.499), 0}));
  const auto pull = std::make_shared<Real>(Real(0));
  constexpr Real press = 30;  // N
  world.forces = {{[](World& w) { w.bodies[1].force.y() -= press; }, "a weight", {1, 2}},
                  {[pull](World& w) { w.bodies[2].force.y() -= *pull; }, "a spring", {2}},
                  {[](World& w) { w.bodies[3].force.y() -= press; }, "a weight", {3}}};
  Dormitory balls(world);
  balls.step_until_asleep({1, 2, 3});
  balls.step(100);
  CHECK(balls.asleep() == Bodies{1, 2, 3});
  *pull = 5;
  balls.step();
  CHECK(balls.asleep() == Bodies{3});
  REQUIRE(balls.world.contacts.size() == 2);
  const Real fall = -balls.world.gravity.y();
  CHECK(balls.world.contacts[0].impulse.y() ==
        Approx(h * (10 * fall + press)));  // what pressed it down is there at once
  CHECK(balls.world.contacts[1].impulse.y() == Approx(h * (10 * fall + 5)));
  CHECK(balls.world.bodies[3].force.isZero(0));
}

TEST_CASE("who is told to wakes with its island, and who lies on something, when that is told to") {
  World world = two_piles();
  world.add(box({1, 1, 1}, 1).fixed().at({10, -1, 0}));
  world.add(cube().at({10, Real(0.499), 0}));  // not on the ground, which it does not reach
  world.bodies[7].position.y() += 5;
  world.bodies[8].position.y() += 5;
  Dormitory piles(world);
  const Bodies all{1, 2, 3, 4, 5, 6, 8};
  piles.step_until_asleep(all);

  piles.sleep().wake(piles.world, 2);
  CHECK(piles.asleep() == Bodies{4, 5, 6, 8});
  piles.step();
  CHECK(piles.asleep() == Bodies{4, 5, 6, 8});
  piles.sleep().wake(piles.world, 2);  // once more: nothing to be done
  piles.step_until_asleep(all);
  piles.sleep().wake(piles.world, 0);
  CHECK(piles.asleep() == Bodies{8});
  piles.step_until_asleep(all);
  piles.world.bodies[7].position.y() -= 1;  // pulled away from below it
  piles.sleep().wake(piles.world, 7);
  CHECK(piles.asleep() == both);
  piles.step(30);
  CHECK(piles.world.bodies[8].position.y() < Real(5.4));
  piles.step_until_asleep(all);
  CHECK(piles.world.bodies[8].position.y() == Approx(Real(4.495)).margin(Real(0.006)));
  piles.sleep().wake_all(piles.world);
  CHECK(piles.asleep().empty());
}

TEST_CASE("what is woken does not jump: it goes on with the impulses that held it") {
  // Forgetful: it does not know what a contact or a joint bore before it fell asleep.
  struct Forgetful : JointedSolver {
    std::size_t had = 0;
    void solve(World& world, Real dt, int sweeps) override {
      if (had == 0) world.contacts_before.clear();
      had = world.contacts.size();
      JointedSolver::solve(world, dt, sweeps);
    }
  };
  const auto speed_of_the_woken = [](bool pile, bool forget, const std::function<void(World&, Sleep&)>& wake) {
    World world;
    if (pile) stack(world, 5, Real(-0.001));
    else hanging_chain(world, 8);
    OnlyWhatIsNeeded solver(world, forget ? AnySolver(Forgetful{}) : solver_named("07 warm start").solver, Sleep{});
    for (int i = 0; i < 3600 && !world.bodies[1].asleep; ++i) solver.step(world, h);
    for (int i = 0; i < 600; ++i) solver.step(world, h);
    REQUIRE(solver.sleep->asleep().size() == 1);
    if (forget)
      for (Joint& joint : world.joints) joint.last_impulses.clear();
    wake(world, *solver.sleep);
    solver.step(world, h);
    REQUIRE(solver.sleep->asleep().empty());
    Real fastest = 0;
    for (std::size_t i = 1; i <= 5; ++i) fastest = std::max(fastest, world.bodies[i].velocity.norm());
    return fastest;
  };
  const auto told_to = [](World& world, Sleep& sleep) { sleep.wake(world, 1); };
  const auto touched = [](World& world, Sleep&) {
    world.add(sphere(Real(0.1), Real(0.001)).at({Real(-0.599), Real(0.5), 0}));
  };
  for (const auto& [pile, wake] :
       {std::pair<bool, std::function<void(World&, Sleep&)>>{true, told_to}, {true, touched}, {false, told_to}}) {
    const Real with = speed_of_the_woken(pile, false, wake), without = speed_of_the_woken(pile, true, wake);
    CAPTURE(pile, with, without);
    CHECK(with < Real(1e-3));
    CHECK(without > Real(1e-2));
  }
}

namespace {

/// Where sleepers may be, m from where they are without sleep: the slop.
constexpr Real visible = Real(0.005);

/// Plays a scene with sleep and without, side by side. Returns whether all sleep in the end.
bool compare(const World& start, const char* named, Real seconds) {
  World unslept = start;
  AnySolver full = solver_named(named).solver;
  Dormitory slept(start, named);
  bool nobody_yet = true;
  for (long i = 1; i <= std::lround(seconds / h); ++i) {
    unslept.step(full, h);
    slept.step();
    nobody_yet = nobody_yet && slept.asleep().empty();
    if (nobody_yet) REQUIRE(hash_of(slept.world) == hash_of(unslept));
    if (i % std::lround(10 / h) != 0) continue;  // at 10 s, 20 s, ...
    for (const int body : slept.asleep())
      CHECK((slept.world.body(body).position - unslept.body(body).position).norm() <= visible);
  }
  const bool all_sleep = std::all_of(slept.world.bodies.begin(), slept.world.bodies.end(),
                                     [](const Body& body) { return body.asleep || !body.movable(); });
  if (all_sleep) CHECK(kinetic_energy(slept.world) == 0);
  return all_sleep;
}

}  // namespace

TEST_CASE("whoever sleeps is where it would be without, within the slop, and until the first sleeps, to the bit") {
  int at_rest = 0;
  for (const NamedScene& scene : all_scenes_and_joints()) {
    INFO(scene.name);
    World world;
    scene.fill(world);
    at_rest += compare(world, "07 warm start", 20) ? 1 : 0;
  }
  CHECK(at_rest >= 17);
}

TEST_CASE("random heaps: a sleeper stays to the bit, knows its island, and touches nobody who is awake") {
  int slept = 0, woken = 0;
  for (std::uint64_t seed = 1; seed <= 400; ++seed) {
    const RandomScene scene = random_scene(seed);
    if (scene.dt != h) continue;
    INFO("seed " << seed);
    Dormitory heap(scene.world);
    const World& world = heap.world;
    World before;
    for (int i = 0; i < 300; ++i) {
      before = world;
      if (!complaint([&] { heap.step(); }).empty()) break;  // no longer finite, as without sleep
      for (std::size_t k = 0; k < world.bodies.size(); ++k) {
        const Body &was = before.bodies[k], &is = world.bodies[k];
        slept += !was.asleep && is.asleep;
        woken += was.asleep && !is.asleep;
        if (!is.asleep) continue;
        REQUIRE((is.velocity.isZero(0) && is.angular_velocity.isZero(0)));
        if (was.asleep) REQUIRE((is.position == was.position && is.orientation.coeffs() == was.orientation.coeffs()));
      }
      for (const Contact& contact : world.contacts) {
        const auto [a, b] = world.bodies_of(contact);
        if (a.movable() && b.movable()) REQUIRE(a.asleep == b.asleep);
      }
      std::vector<int> listed(world.bodies.size(), 0);
      for (const Bodies& island : heap.islands()) {
        REQUIRE(std::is_sorted(island.begin(), island.end()));
        for (const int k : island) ++listed[std::size_t(k)];
      }
      for (std::size_t k = 0; k < listed.size(); ++k) REQUIRE(listed[k] == int(world.bodies[k].asleep));
    }
  }
  CAPTURE(slept, woken);
  CHECK(slept > 300);
  CHECK(woken > 10);
}

TEST_CASE("sleep: a body that is not there is named, whether it is lost, acted on, or to be woken") {
  Dormitory lost = two_sleeping_piles();
  lost.world.bodies.pop_back();
  const std::uint64_t before = hash_of(lost.world);
  CHECK(complaint([&] { lost.step(); }).find("lost a body") != std::string::npos);
  CHECK(hash_of(lost.world) == before);
  Dormitory piles = two_sleeping_piles();
  for (const int body : {-1, 7}) {
    CHECK(complaint([&] { piles.sleep().wake(piles.world, body); }) ==
          fmt::format("body to wake is {}: a whole number from 0 to 6 is needed", body));
    CHECK(piles.asleep() == both);
  }
  for (const int body : {-1, 7}) {
    const std::string expected = fmt::format("a rod acts on body {}: of 7 bodies, the first is 0", body);
    piles.world.forces = {{[](World&) {}, "a rod", {1, body}}};
    CHECK(complaint([&] { piles.step(); }) == expected);
    piles.world.forces.back().bodies = {1};
    piles.step();
    piles.world.forces.back().bodies = {body};  // as many forces as before
    CHECK(complaint([&] { piles.step(); }) == expected);
    piles.world.forces.clear();
    piles.step();
  }
}

TEST_CASE("sleep: what cannot be simulated is refused, and nothing has moved") {
  Dormitory piles = two_sleeping_piles();
  piles.world.add(sphere(Real(0.2), 1).at({0, 5, 0}));
  piles.world.add(box({1, 1, 1}, 1).fixed().at({20, 0, 0}));
  piles.step();
  const auto refused = [&piles](const char* named) {
    const std::uint64_t before = hash_of(piles.world);
    const std::string said = complaint([&] { piles.step(); });
    INFO(named << ": " << said);
    CHECK(said.find(named) != std::string::npos);
    CHECK(hash_of(piles.world) == before);
    CHECK(piles.asleep() == both);
  };
  const auto with = [&refused](Real& value, Real wrong, const char* named) {
    const Real right = value;
    value = wrong;
    refused(named);
    value = right;
  };
  with(piles.world.bodies[7].position.x(), not_a_number, "position");
  with(piles.world.bodies[8].velocity.x(), not_a_number, "velocity");  // immovable, and to be moved
  with(piles.world.bodies[0].velocity.x(), not_a_number, "velocity");  // the ground
  with(piles.world.gravity.x(), not_a_number, "gravity");
  for (const Real wrong : {Real(-1), not_a_number, std::numeric_limits<Real>::infinity()}) {
    with(piles.sleep().time_to_sleep, wrong, "time to fall asleep");
    with(piles.sleep().rest_distance, wrong, "place of a sleeper");
  }
  CHECK(complaint([&] { piles.solver.step(piles.world, 0); }).find("dt") != std::string::npos);
  CHECK(complaint([&] { piles.solver.step(piles.world, h, -1); }).find("sweeps") != std::string::npos);

  // Put on one who sleeps, it is found when that one is to wake; and nobody of its island has woken by half.
  piles.world.bodies[3].position.x() = not_a_number;
  CHECK(complaint([&] { piles.sleep().wake(piles.world, 1); }).find("position") != std::string::npos);
  CHECK(piles.asleep() == both);
  piles.world.bodies[3].position.x() = 0;
  piles.step();
  CHECK(complaint([&] { piles.sleep().wake(piles.world, 1); }).empty());
  CHECK(piles.asleep() == second_pile);
}

TEST_CASE("sleep: who may not touch a pile wakes nobody in it, however deep he is in it, and who may does") {
  for (const bool may : {false, true}) {
    Dormitory dormitory(two_piles());
    for (std::size_t i = 1; i <= 6; ++i) dormitory.world.bodies[i].in_groups(2);
    dormitory.step_until_asleep({1, 2, 3, 4, 5, 6});
    dormitory.world.add(sphere(Real(0.3), 10).at({-1, Real(0.5), 0}).moving({2, 0, 0}).rough(0).touching(may ? 3 : 1));
    bool woke = false;
    for (int i = 0; i < 60; ++i) {
      dormitory.step();
      woke = woke || dormitory.asleep().size() < 6;
    }
    CHECK(woke == may);
    CHECK((std::abs(dormitory.world.bodies[7].position.x() - 1) < Real(0.01)) == !may);  // straight through it
  }
}

TEST_CASE(
    "sleep: on a conveyor that runs nobody sleeps, even where he is held up, and on one that stands only until it "
    "starts") {
  World world;
  world.add(box({5, 1, 1}, 1).fixed().at({0, -1, 0}));
  world.add(cube().at({0, Real(0.499), 0}));
  world.add(box({Real(0.1), 1, 1}, 1).fixed().at({Real(0.6), 1, 0}));  // he cannot get on
  Dormitory dormitory(world);
  dormitory.step_until_asleep({1});
  dormitory.world.bodies[0].conveying({1, 0, 0});
  dormitory.step(120);
  CHECK(dormitory.asleep().empty());
  CHECK(dormitory.world.bodies[1].position.x() < Real(0.01));
  CHECK(dormitory.world.bodies[0].position == Vec3(0, -1, 0));
  dormitory.world.bodies[0].conveying(Vec3::Zero());
  dormitory.step_until_asleep({1});
  dormitory.world.bodies[0].conveying({-1, 0, 0});
  dormitory.step(60);
  CHECK(dormitory.world.bodies[1].position.x() < Real(-0.5));
}
