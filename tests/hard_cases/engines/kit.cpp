// Another engine as a solver, built only with PUSHBACK_PEERS, once for each engine: what is ours is the handing over, so it is looked
// at where an engine has hardly a way to be wrong.
#include <cmath>

#include "pushback/chapters/13_joints/hinge.h"
#include "pushback/chapters/15_limits_motors_springs/limits.h"
#include "pushback/chapters/15_limits_motors_springs/motor.h"
#include "pushback/common/world/forces.h"
#include "pushback/common/world/measure.h"
#include "pushback/common/world/situations.h"
#include "pushback/tools/measure/peers/engine_solver.h"
#include "pushback/tools/measure/peers/peer.h"
#include "tests/support/call.h"
#include "tests/support/catch.h"
#include "tests/support/complaint.h"

using namespace pushback;

namespace {

constexpr Real dt = Real(1) / 60;

/// Calls `check` for each setting of this engine.
void under_each(const std::function<void(const PeerSetting&)>& check) {
  int settings = 0;
  for (const PeerSetting& setting : settings_of_peer()) {
    if (setting.engine != PEER) continue;
    ++settings;
    INFO(setting.name);
    check(setting);
  }
  CHECK(settings > 0);
}

bool is_mujoco() {
  return std::string(PEER) == "mujoco";
}
bool is_bullet() {
  return std::string(PEER).starts_with("bullet");
}
/// Of those that are compiled from their source.
bool is_of_the_day() {
  return std::string(PEER) == "box3d" || std::string(PEER) == "jolt";
}

/// Of a step, whoever divides it.
int substeps_of(const PeerSetting& setting) {
  return setting.substeps * setting.own_substeps;
}

/// Of a number near `size`.
Real rounding(const PeerSetting& setting, Real size = 1) {
  return 1000 * setting.epsilon * size;
}

Body cube_of_corners(Real half, Real mass) {
  std::vector<Vec3> corners;
  for (int i = 0; i < 8; ++i)
    corners.emplace_back((i & 1) != 0 ? half : -half, (i & 2) != 0 ? half : -half, (i & 4) != 0 ? half : -half);
  return hull(corners, mass);
}

void run(World& world, EngineSolver& solver, Real seconds) {
  for (long i = std::lround(seconds / dt); i > 0; --i) world.step(solver, dt);
}

}  // namespace

TEST_CASE("units: what falls, whatever its shape, falls by the closed form of its substeps, and turns as it did") {
  under_each([](const PeerSetting& setting) {
    World world;
    world.gravity = {1, -5, 2};
    world.add(sphere(Real(0.3), 7).at({-4, 2, 0}).moving({0, 1, 0}).spinning({1, 2, 3}));
    world.add(box(Vec3::Constant(Real(0.2)), 2)
                  .turned(Real(0.7), Vec3::UnitX())
                  .at({0, 2, 0})
                  .moving({1, 0, 2})
                  .spinning({0, 3, 0}));
    world.add(capsule(Real(0.1), Real(0.4), 3).at({4, 2, 0}).spinning({0, 2, 0}));
    world.add(cube_of_corners(Real(0.3), 5).at({8, 2, 0}).moving({0, 0, -1}));
    const std::vector<Body> start = world.bodies;
    EngineSolver solver(begin_engine, setting);
    const Real t = Real(0.5), h = dt / static_cast<Real>(substeps_of(setting));
    REQUIRE(solver.plan(dt).all_substeps() == substeps_of(setting));
    Watcher watcher(world, {.epsilon = setting.epsilon});
    for (long i = std::lround(t / dt); i > 0; --i) {
      world.step(solver, dt);
      watcher.look(world, dt, solver.plan(dt).all_substeps());
    }
    CHECK(watcher.broken().empty());  // free flight keeps the energy that belongs to its substeps
    for (std::size_t i = 0; i < start.size(); ++i) {
      INFO(i);
      const Body &body = world.bodies[i], &began = start[i];
      // v += h g, x += h v
      CHECK((body.velocity - began.velocity - t * world.gravity).norm() < rounding(setting, 5));
      CHECK((body.position - began.position - t * began.velocity - t * (t + h) / 2 * world.gravity).norm() <
            rounding(setting, 10));
      CHECK((body.angular_velocity - began.angular_velocity).norm() < 10 * rounding(setting, 5));
      const Real angle = t * began.angular_velocity.norm();
      const Quat should =
          angle > 0 ? Quat(Eigen::AngleAxis<Real>(angle, began.angular_velocity.normalized())) * began.orientation
                    : began.orientation;
      CHECK(body.orientation.angularDistance(should) < Real(2e-3));  // engines turn by steps
    }
    CHECK(world.time == Approx(t));
  });
}

TEST_CASE("units: a force and a torque act for a step, by mass and inertia, and are over") {
  under_each([](const PeerSetting& setting) {
    World world;
    world.gravity.setZero();
    world.add(box({Real(0.1), Real(0.2), Real(0.3)}, 4).turned(Real(0.5), Vec3(1, 2, 3)));
    Body& body = world.bodies[0];
    body.force = {8, 0, -4};
    body.torque = {Real(0.01), Real(-0.02), Real(0.03)};
    const Vec3 turning = dt * body.inverse_inertia * body.torque;
    EngineSolver solver(begin_engine, setting);
    world.step(solver, dt);
    CHECK((body.velocity - dt * Vec3(2, 0, -1)).norm() < rounding(setting, Real(0.1)));
    CHECK((body.angular_velocity - turning).norm() < Real(1e-3) * turning.norm());  // it has turned within the step
    const Vec3 velocity = body.velocity;
    world.step(solver, dt);
    CHECK((body.velocity - velocity).norm() < rounding(setting, Real(0.1)));
    CHECK(body.force.isZero(0));
  });
}

TEST_CASE("friction of a pair is the geometric mean of its two") {
  under_each([](const PeerSetting& setting) {
    for (const auto& [below, above] :
         {std::pair(Real(0.1), Real(0.9)), std::pair(Real(0.9), Real(0.1)), std::pair(Real(0.3), Real(0.3))}) {
      World world;
      world.add(ground().rough(below));
      world.add(box({Real(0.3), Real(0.1), Real(0.3)}, 10).at({0, Real(0.0999), 0}).moving({4, 0, 0}).rough(above));
      EngineSolver solver(begin_engine, setting);
      run(world, solver, Real(0.5));
      // A product would leave 3.56 m/s, a larger one 0. MuJoCo's law lifts the box off at first, and brakes it by that much more.
      CHECK(4 - world.bodies[1].velocity.x() == Approx(Real(0.3) * World::g / 2).epsilon(is_mujoco() ? 0.3 : 0.1));
    }
  });
}

TEST_CASE("restitution of a pair is the larger of its two, where an engine bounces at all") {
  under_each([](const PeerSetting& setting) {
    for (const auto& [below, above] :
         {std::pair(Real(0), Real(0.8)), std::pair(Real(0.8), Real(0)), std::pair(Real(0.8), Real(0.8))}) {
      World world;
      world.gravity.setZero();
      world.add(ground().bouncy(below));
      world.add(sphere(Real(0.3), 2).at({0, 1, 0}).moving({0, -5, 0}).bouncy(above));
      EngineSolver solver(begin_engine, setting);
      if (is_mujoco()) {
        CHECK(contains(complaint([&] { world.step(solver, dt); }), "not possible: restitution"));
        continue;
      }
      run(world, solver, Real(0.5));
      CHECK(world.bodies[1].velocity.y() == Approx(4).epsilon(1e-3));
    }
  });
}

TEST_CASE("margins: each shape comes to rest on the ground at its own height, to what the engine's margin says") {
  under_each([](const PeerSetting& setting) {
    struct Standing {
      const char* name;
      Body body;
      Real height;
    };
    for (const auto& [name, body, height] :
         std::vector<Standing>{{"sphere", sphere(Real(0.3), 10), Real(0.3)},
                               {"box", box({Real(0.4), Real(0.2), Real(0.3)}, 10), Real(0.2)},
                               {"capsule", capsule(Real(0.2), Real(0.3), 10).turned(pi / 2, Vec3::UnitX()), Real(0.2)},
                               {"hull", cube_of_corners(Real(0.3), 10), Real(0.3)}}) {
      INFO(name);
      World world;
      world.add(ground());
      Body put = body;
      world.add(put.at({0, height + Real(0.001), 0}));
      EngineSolver solver(begin_engine, setting);
      run(world, solver, 3);
      const Real above = world.bodies[1].position.y() - height;
      INFO(1000 * above << " mm");
      // Bullet keeps 40 mm around a hull as it comes.
      const bool hull_in_margin = is_bullet() && !setting.tuned && std::string(name) == "hull";
      CHECK(above == Approx(hull_in_margin ? Real(0.04) : 0).margin(is_mujoco() && !setting.tuned ? 0.006 : 0.002));
      CHECK(largest_speed(world) < Real(0.005));
    }
  });
}

TEST_CASE("what is changed between steps is handed over: a velocity, a place, a body more") {
  under_each([](const PeerSetting& setting) {
    World world;
    world.gravity.setZero();
    world.add(sphere(Real(0.3), 1));
    EngineSolver solver(begin_engine, setting);
    world.step(solver, dt);
    world.bodies[0].velocity = {3, 0, 0};
    world.bodies[0].position = {0, 7, 0};
    world.step(solver, dt);
    CHECK((world.bodies[0].position - Vec3(3 * dt, 7, 0)).norm() < rounding(setting, 7));
    world.add(box(Vec3::Constant(Real(0.5)), 5).at({9, 0, 0}).moving({0, 6, 0}));
    world.gravity = {0, 0, -6};
    run(world, solver, 1);
    CHECK(world.bodies[1].position.y() == Approx(6).epsilon(1e-4));
    CHECK(world.bodies[0].velocity.z() == Approx(-6).epsilon(1e-4));
    world.bodies[1].inverse_mass = 0;
    world.bodies[1].principal_inverse_inertia.setZero();
    world.bodies[1].velocity.setZero();
    const Vec3 there = world.bodies[1].position;
    run(world, solver, 1);
    CHECK(world.bodies[1].position == there);
  });
}

TEST_CASE("a driven body goes where its velocity says, and takes along what lies on it") {
  under_each([](const PeerSetting& setting) {
    World world;
    const int lift = world.add(box({1, Real(0.1), 1}, 1).fixed().at({0, Real(-0.1), 0}));
    world.add(box(Vec3::Constant(Real(0.3)), 10).at({0, Real(0.2999), 0}));
    EngineSolver solver(begin_engine, setting);
    run(world, solver, Real(0.5));
    const Real before = world.bodies[1].position.y();
    world.bodies[static_cast<std::size_t>(lift)].velocity = {0, Real(0.1), 0};
    run(world, solver, 1);
    CHECK(world.bodies[0].position.y() == Approx(0).margin(1e-12));
    CHECK(world.bodies[1].position.y() - before == Approx(0.1).margin(0.01));
    world.bodies[static_cast<std::size_t>(lift)].velocity.setZero();
    run(world, solver, 1);
    CHECK(world.bodies[1].position.y() - before == Approx(0.1).margin(0.01));
    CHECK(largest_speed(world) < Real(0.01));
  });
}

TEST_CASE("a ball and socket: the pendulum keeps its length, and falls by its height") {
  constexpr Real radius =
      Real(0.5);  // one that is hardly heavier to turn than a point takes more iterations than engines make
  under_each([](const PeerSetting& setting) {
    World world;
    world.add(sphere(radius, 3).at({1, 0, 0}));
    world.joints.push_back(ball_and_socket(world, the_world, 0, Vec3::Zero()));
    EngineSolver solver(begin_engine, setting);
    Real longest = 0, shortest = 2, fastest = 0;
    for (int i = 0; i < 60; ++i) {
      world.step(solver, dt);
      const Real length = world.bodies[0].position.norm();
      longest = std::max(longest, length), shortest = std::min(shortest, length);
      fastest = std::max(fastest, largest_speed(world));
    }
    CHECK(longest < Real(1.03));
    CHECK(shortest > Real(0.97));
    CHECK(fastest == Approx(std::sqrt(2 * World::g / (1 + Real(0.4) * radius * radius))).epsilon(0.06));
    CHECK(world.bodies[0].position.z() == Approx(0).margin(1e-4));
  });
}

TEST_CASE("a hinge turns about its axis alone, and the two that it joins do not touch") {
  under_each([](const PeerSetting& setting) {
    World world;
    const int post = world.add(box({Real(0.2), Real(0.5), Real(0.2)}, 1).fixed().at({0, Real(-0.4), 0}));
    // It overlaps the post, and its weight pulls along z as well.
    const int plank = world.add(box({Real(0.5), Real(0.05), Real(0.2)}, 5).at({Real(0.5), Real(0.05), 0}));
    world.gravity = {0, -5, 5};
    world.joints.push_back(hinge(world, post, plank, {0, Real(0.05), 0}, Vec3::UnitZ()));
    EngineSolver solver(begin_engine, setting);
    Real off = 0, turned = 0;
    for (int i = 0; i < 60; ++i) {
      world.step(solver, dt);
      const Body& body = world.bodies[1];
      off = std::max(off, Real((body.orientation * Vec3::UnitZ()).cross(Vec3::UnitZ()).norm()));
      turned = std::max(turned, -std::asin(std::clamp((body.orientation * Vec3::UnitX()).y(), Real(-1), Real(1))));
    }
    CHECK(off < Real(0.03));
    CHECK(turned > Real(1.3));  // through the post: down, where it would have been stopped
  });
}

TEST_CASE("a hinge's limits, a cone and a twist: held, or said not to be had") {
  const auto limited = [](int which) {
    World world;
    world.gravity.setZero();
    world.add(box(Vec3::Constant(Real(0.2)), 1).fixed());
    world.add(box({Real(0.1), Real(0.4), Real(0.15)}, 2).at({0, Real(-0.7), 0}));
    const Vec3 anchor(0, Real(-0.25), 0);
    if (which == 0) {
      world.joints.push_back(hinge(world, 0, 1, anchor, Vec3::UnitZ()));
      world.joints.push_back(angle_limits(world, 0, 1, Vec3::UnitZ(), Real(-0.3), Real(0.9)));
    } else {
      world.joints.push_back(ball_and_socket(world, 0, 1, anchor));
      if (which == 1) world.joints.push_back(cone_limit(world, 0, 1, -Vec3::UnitY(), -Vec3::UnitY(), Real(0.6)));
      else world.joints.push_back(twist_limits(world, 0, 1, -Vec3::UnitY(), Real(-0.4), Real(0.4)));
    }
    return world;
  };
  under_each([&](const PeerSetting& setting) {
    for (const int which : {0, 1, 2}) {
      for (const Real side : {Real(-1), Real(1)}) {
        INFO(which << " to " << side);
        World world = limited(which);
        const Vec3 axis = which == 2 ? Vec3::UnitY() : Vec3::UnitZ();
        Body& body = world.bodies[1];
        EngineSolver solver(begin_engine, setting);
        if (is_mujoco() || (!is_bullet() && !is_of_the_day() && which > 0)) {
          CHECK(contains(complaint([&] { world.step(solver, dt); }), "not possible: "));
          continue;
        }
        Real farthest = 0;
        for (int i = 0; i < 60; ++i) {
          body.torque = side * (which == 2 ? Real(0.2) : 2) * axis;
          world.step(solver, dt);
          const Quat& q = body.orientation;
          farthest = std::max(farthest, side * 2 * std::atan2(q.vec().dot(axis), q.w()));
        }
        const Real limit = which == 0 ? (side < 0 ? Real(0.3) : Real(0.9)) : which == 1 ? Real(0.6) : Real(0.4);
        CHECK(farthest == Approx(limit).margin(0.1));
      }
    }
  });
}

/// A wheel of I = 0.04 kg m^2 on a post, on one so heavy that it hardly moves, or on the world: w = T t / I up to the speed, and back to rest by a torque against it.
TEST_CASE("a motor: as fast as it is to turn, with no more than its torque, to either side, or said not to be had") {
  constexpr Real torque = Real(0.02), speed = Real(0.3);
  under_each([&](const PeerSetting& setting) {
    for (const std::string holder : {"a post", "a heavy body", "the world"}) {
      for (const Real side : {Real(-1), Real(1)}) {
        for (const Real axis_of_hinge : {Real(-1), Real(1)}) {
          INFO(holder << ", to " << side << ", hinge about " << axis_of_hinge);
          World world;
          world.gravity.setZero();
          const int post = world.add(box(Vec3::Constant(Real(0.5)), Real(1e5)).at({0, 0, -1}));
          if (holder == "a post") world.bodies.back().fixed();
          const int wheel = world.add(sphere(Real(0.1), 10));
          const int on = holder == "the world" ? the_world : post;
          world.joints.push_back(hinge(world, on, wheel, Vec3::Zero(), axis_of_hinge * Vec3::UnitZ()));
          world.joints.push_back(motor_at_speed(world, on, wheel, Vec3::UnitZ(), side * speed, torque));
          EngineSolver solver(begin_engine, setting);
          if (is_mujoco()) {
            CHECK(contains(complaint([&] { world.step(solver, dt); }), "not possible: a motor"));
            continue;
          }
          for (int i = 0; i < 30; ++i) world.step(solver, dt);
          CHECK(side * world.bodies[1].angular_velocity.z() == Approx(torque * 30 * dt / Real(0.04)).epsilon(0.02));
          for (int i = 0; i < 30; ++i) world.step(solver, dt);
          CHECK(side * world.bodies[1].angular_velocity.z() == Approx(speed).epsilon(0.02));
        }
      }
    }
  });
}

TEST_CASE("what an engine is not handed is said: a skin, a conveyor, groups, a joint of another kind, contacts") {
  under_each([](const PeerSetting& setting) {
    const auto said = [&](const std::function<void(World&)>& change) {
      World world;
      world.add(sphere(1, 1));
      world.add(box(Vec3::Constant(1), 1).at({9, 0, 0}));
      change(world);
      EngineSolver solver(begin_engine, setting);
      return complaint([&] { world.step(solver, dt); });
    };
    CHECK(contains(said([](World& world) { world.bodies[0].skin = Real(0.1); }), "not possible: a skin"));
    CHECK(contains(said([](World& world) { world.bodies[0].touching(2); }), "not possible: groups"));
    CHECK(contains(said([](World& world) {
                     Body belt = box(Vec3::Constant(1), 1).fixed().at({0, 9, 0});
                     world.add(belt.conveying({1, 0, 0}));
                   }),
                   "not possible: a conveyor"));
    CHECK(contains(said([](World& world) { world.joints.push_back({"a spring", 0, 1, [](auto&&...) {}}); }),
                   "not possible: a spring"));
    World world;
    EngineSolver solver(begin_engine, setting);
    CHECK(contains(complaint([&] { solver.solve(world, dt, 1); }), "not possible: contacts"));
  });
}
