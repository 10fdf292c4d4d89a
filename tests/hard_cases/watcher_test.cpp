/// The watcher must see each thing that it is there for, and nothing where all is well.
#include <cmath>
#include <limits>

#include "pushback/chapters/07_warm_start/full_solver.h"
#include "pushback/tools/measure/hard_cases/stages.h"
#include "pushback/tools/measure/hard_cases/watcher.h"
#include "tests/support/catch.h"
#include "tests/support/yardstick.h"

using namespace pushback;

namespace {

constexpr Real small = Real(1e-6);  // of a whole: far above rounding, far below what an eye would see

void ball_on_ground(World& world) {
  world.add(ground());
  world.add(sphere(Real(0.5), 10).at({0, Real(0.498), 0}));
}

void ball_in_the_air(World& world) {
  world.add(sphere(Real(0.5), 10).at({0, 5, 0}).moving({1, 3, 0}).spinning({0, 2, 0}));
}

/// Two that will meet, off their centres, with nothing else there.
void two_in_free_space(World& world) {
  world.gravity.setZero();
  world.add(box({Real(0.5), Real(0.4), Real(0.3)}, 10).at({-1, 0, 0}).moving({2, 0, 0}).spinning({1, 2, 3}));
  world.add(sphere(Real(0.5), 30).at({Real(0.2), Real(0.3), 0}).moving({-1, 0, 0}));
}

/// What the watcher says once something is done to a world of which it had nothing to say for 30 steps.
std::string said_of(const std::function<void(World&)>& fill, const Allowance& allowance,
                    const std::function<void(World&)>& plant) {
  World world;
  fill(world);
  Watcher watcher(world, allowance);
  FullSolver solver;
  for (int step = 0; step < 30; ++step) {
    world.step(solver, h);
    watcher.look(world, h);
    INFO("step " << step);
    REQUIRE(watcher.broken() == "");
  }
  plant(world);
  watcher.look(world, h);
  return watcher.broken();
}

void speaks_of(const std::string& said, const std::string& what) {
  INFO("said: '" << said << "', should speak of '" << what << "'");
  CHECK(said.find(what) != std::string::npos);
}

const Allowance any{.energy = 1000, .overlap = 1};
const Allowance isolated{.energy = 1000, .overlap = 1, .isolated = true};

}  // namespace

TEST_CASE("watcher: a number that is not finite") {
  for (const Real bad : {std::numeric_limits<Real>::quiet_NaN(), std::numeric_limits<Real>::infinity()}) {
    for (const std::function<void(World&)>& spoil : std::vector<std::function<void(World&)>>{
             [bad](World& w) { w.bodies[1].position.z() = bad; }, [bad](World& w) { w.bodies[1].velocity.x() = bad; },
             [bad](World& w) { w.bodies[1].angular_velocity.y() = bad; },
             [bad](World& w) { w.bodies[1].orientation.w() = bad; },
             [bad](World& w) { w.contacts.at(0).impulse.y() = bad; }})
      speaks_of(said_of(ball_on_ground, any, spoil), "not finite");
  }
}

TEST_CASE("watcher: energy gained, as speed, as spin or as height") {
  // 30 steps of flight are behind it: one more of its own would change nothing.
  const auto after_a_step = [](const std::function<void(Body&)>& plant) {
    return [plant](World& world) {
      FullSolver solver;
      world.step(solver, h);
      plant(world.bodies[0]);
    };
  };
  CHECK(said_of(ball_in_the_air, {}, after_a_step([](Body&) {})) == "");
  speaks_of(said_of(ball_in_the_air, {}, after_a_step([](Body& b) { b.velocity.x() *= 1 + small; })), "J gained");
  speaks_of(said_of(ball_in_the_air, {}, after_a_step([](Body& b) { b.angular_velocity *= 1 + small; })), "J gained");
  speaks_of(said_of(ball_in_the_air, {}, after_a_step([](Body& b) { b.position.y() += small; })), "J gained");
  // What is allowed is allowed, and no more: 10 kg lifted by 1 mm are 98.1 mJ.
  const auto lift = after_a_step([](Body& b) { b.position.y() += Real(0.001); });
  CHECK(said_of(ball_in_the_air, {.energy = Real(0.0982)}, lift) == "");
  speaks_of(said_of(ball_in_the_air, {.energy = Real(0.0980)}, lift), "J gained");
}

TEST_CASE("watcher: a contact that pulls") {
  const auto pull = [](World& world) { world.contacts.at(0).last_impulse = -small * world.contacts[0].normal; };
  speaks_of(said_of(ball_on_ground, any, pull), "pulls");
}

TEST_CASE("watcher: friction above mu times what presses, along each tangent") {
  for (const Real part : {Real(1) - small, Real(1) + small}) {
    for (const int axis : {0, 1, 2, 3}) {
      const auto rub = [part, axis](World& world) {
        Contact& contact = world.contacts.at(0);
        const Tangents tangents = tangents_of(contact.normal);
        const Vec3 way = (axis < 2 ? 1 : -1) * (axis % 2 == 0 ? tangents.tangent1 : tangents.tangent2);
        contact.last_impulse = contact.normal + part * contact.friction * way;
      };
      if (part < 1) CHECK(said_of(ball_on_ground, any, rub) == "");
      else speaks_of(said_of(ball_on_ground, any, rub), "friction");
    }
  }
}

TEST_CASE("watcher: momentum and angular momentum lost where nothing is there to take them") {
  CHECK(said_of(two_in_free_space, isolated, [](World&) {}) == "");
  // Towards the origin: angular momentum does not notice.
  speaks_of(
      said_of(two_in_free_space, isolated, [](World& w) { w.bodies[1].velocity -= small * w.bodies[1].position; }),
      "momentum changed");
  speaks_of(said_of(two_in_free_space, isolated, [](World& w) { w.bodies[0].angular_velocity *= 1 - small; }),
            "angular momentum changed");
  // Momentum is kept where two shift apart sideways, angular momentum is not.
  speaks_of(said_of(two_in_free_space, isolated, [](World& w) { w.bodies[0].position.y() += small; }),
            "angular momentum changed");
  // Where it is not isolated, the ground may take both.
  CHECK(said_of(two_in_free_space, any, [](World& w) { w.bodies[1].velocity *= 1 - small; }) == "");
}

TEST_CASE("watcher: what is joined to something immovable gives momentum away, and what is driven is given energy") {
  const auto joined = [](int a, bool driven) {
    return [=](World& world) {
      world.bodies[0].position.y() += 1;
      world.bodies.back().velocity *= Real(0.5);
      world.joints.push_back({.name = "a string", .a = a, .b = 0, .ask = {}, .driven = driven});
    };
  };
  CHECK(said_of(two_in_free_space, isolated, joined(the_world, false)) == "");
  speaks_of(said_of(two_in_free_space, isolated, joined(1, false)), "momentum changed");
  CHECK(said_of(ball_in_the_air, {}, joined(the_world, true)) == "");
  speaks_of(said_of(ball_in_the_air, {}, joined(the_world, false)), "J gained");
}

TEST_CASE("watcher: an overlap deeper than allowed") {
  const Allowance allowance{.energy = 1000, .overlap = Real(0.05)};
  const auto sink = [](Real depth) { return [depth](World& world) { world.contacts.at(0).depth = depth; }; };
  CHECK(said_of(ball_on_ground, allowance, sink(Real(0.05))) == "");
  speaks_of(said_of(ball_on_ground, allowance, sink(Real(0.05) + small)), "of overlap");
}

TEST_CASE("stages: a ball at rest is held by the same sum, though its contact is given twice") {
  for (const std::string name : {"07 warm start", "11 substeps", "12 soft contacts"}) {
    const Stage& stage = stage_named(name);
    World world;
    ball_on_ground(world);
    const Stepper step = stage.begin(GivenContacts::twice);
    for (int i = 0; i < 60; ++i) step.step(world, h);
    INFO(name);
    REQUIRE(world.contacts.size() == 1);
    const Real weight = 10 * World::g * h;
    CHECK(world.contacts[0].impulse.y() == Approx(weight).epsilon(Real(1e-3)));
    CHECK(world.contacts[0].last_impulse.y() * static_cast<Real>(stage.substeps(h)) ==
          Approx(weight).epsilon(Real(1e-3)));
    CHECK(std::abs(world.bodies[1].velocity.y()) < Real(1e-6));
  }
}
