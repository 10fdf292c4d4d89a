// Other engines, in motions and in hard cases; built only with PUSHBACK_PEERS, once for each engine. What is ours is the conversion
// and the handing over, so it is looked at where an engine has hardly a way to be wrong.
#include <cmath>

#include "pushback/chapters/13_joints/hinge.h"
#include "pushback/chapters/15_limits_motors_springs/limits.h"
#include "pushback/chapters/15_limits_motors_springs/motor.h"
#include "pushback/chapters/19_accuracy_and_time/truth.h"
#include "pushback/common/world/measure.h"
#include "pushback/tools/measure/peers/peer.h"
#include "pushback/tools/measure/study/every_motion.h"
#include "pushback/tools/measure/study/relaxed_law.h"
#include "tests/support/call.h"
#include "tests/support/catch.h"
#include "tests/support/complaint.h"

using namespace pushback;

namespace {

constexpr Patience once{.at_least = 0, .at_most = 600};
constexpr int some_sweeps = 16;
constexpr Real dt = Real(1) / 60;
const std::string peer = PEER;

bool is_mujoco() {
  return peer == "mujoco";
}
/// What 2.2.2 lacks: surfaces that convey, and motors.
bool is_old_mujoco() {
  return peer_version().starts_with("MuJoCo 2");
}
bool is_bullet() {
  return peer.starts_with("bullet");
}
bool has_cones() {
  return peer != "ode" && !is_mujoco();
}

double error_of(const Method& method, const Motion& motion, int substeps) {
  return play(motion, motion.truth(motion.frames()), method, {.substeps = substeps, .sweeps = some_sweeps}, once).error;
}

/// A turned box and a ball beside it fall for 0.4 s, and are still above the ground.
Motion fall() {
  const auto fill = [](World& world) {
    world.add(ground());
    world.add(
        box({Real(0.1), Real(0.2), Real(0.3)}, 2).turned(Real(0.7), Vec3::UnitX()).at({0, 2, 0}).moving({1, 0, 2}));
    world.add(sphere(Real(0.3), 7).at({-2, 2, 0}).moving({0, 1, 0}));
  };
  const auto truth = [](int frames) {
    std::vector<Places> found;
    for (int frame = 1; frame <= frames; ++frame) {
      const double t = static_cast<double>(frame) / frames_per_second, y = 2 - truth::g * t * t / 2;
      found.push_back({{0, 0, 0}, {t, y, 2 * t}, {-2, y + t, 0}});
    }
    return found;
  };
  return {.name = "fall", .title = "a box and a ball fall", .fill = fill, .seconds = 0.4, .truth = truth};
}

/// Calls `check` for each setting in which this engine plays hard cases.
void under_each(const std::function<void(const PeerSetting&)>& check) {
  int settings = 0;
  for (const PeerSetting& setting : settings_of_peer()) {
    if (setting.engine != peer || setting.further) continue;
    ++settings;
    INFO(setting.name);
    check(setting);
  }
  CHECK(settings > 0);
}

/// A world under an engine.
struct Under {
  explicit Under(const PeerSetting& setting) : solver(begin_engine, setting) {}
  void step() { world.step(solver, dt); }
  void run(Real seconds) {
    for (long i = std::lround(seconds / dt); i > 0; --i) step();
  }
  /// What it says that it has not; else nothing.
  std::string lacks() {
    return complaint([this] { step(); });
  }

  World world;
  EngineSolver solver;
};

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

}  // namespace

TEST_CASE("What falls keeps its velocity and gets that of gravity: half a step late, and nothing else") {
  const Motion falling = fall();
  for (const Method& method : peer_methods()) {
    if (!method.plays(falling)) continue;
    INFO(method.name);
    for (const int substeps : {1, 4, 16}) {
      // v += h g, x += h v:   x errs by g h t / 2, by Runge and Kutta's method not at all. One way of Box3D makes its substeps of what are sweeps to others.
      const int divided = substeps * (method.name == "box3d-often" ? some_sweeps : 1);
      if (divided > 64) continue;  // a sum of 6,144 places in float is off by a quarter of what is looked for
      const double late =
          method.name == "mujoco-rk4" ? 0 : truth::g * falling.seconds / (2 * frames_per_second * divided);
      CHECK(error_of(method, falling, substeps) == Approx(late).margin(2e-5));  // margin: of float
    }
  }
}

TEST_CASE("A pinned ball swings as the truth does, the closer the smaller the step") {
  for (const Method& method : peer_methods()) {
    INFO(method.name);
    // Jolt moves the joint's bodies once more after each step, and is late by more; so it is as WebAssembly.
    // So is a pin that is a constraint of MuJoCo's, since version 3.
    const double first_order = method.name.starts_with("jolt")   ? 0.04
                               : method.name == "mujoco-connect" ? 0.023
                                                                 : 0.013;  // m
    for (const int substeps : {1, 4, 16})
      CHECK(error_of(method, motion_named("pendulum"), substeps) < first_order / substeps);
  }
}

TEST_CASE("MuJoCo's hard contacts lift a sliding body off, and it is off by what the relaxed law says") {
  for (const Method& method : peer_methods()) {
    if (method.name != "mujoco") continue;
    for (const char* name : {"sliding", "rolling"}) {
      for (const int substeps : {4, 16, 64}) {
        INFO(name << ", " << substeps << " substeps");
        const Motion& motion = motion_named(name);
        CHECK(error_of(method, motion, substeps) == Approx(hop_of(motion)->error).epsilon(0.08 / substeps + 0.002));
      }
    }
  }
}

TEST_CASE("A box is carried by a belt where an engine has belts, and the others do not play it") {
  const Motion& belt = any_motion_named("conveyor");
  for (const Method& method : peer_methods()) {
    INFO(method.name);
    CHECK(method.plays(belt) != (is_old_mujoco() || method.name == "mujoco-bounce" || method.name == "mujoco-connect"));
    if (!method.plays(belt)) continue;
    if (is_mujoco()) {  // which lifts it off, by Euler's method
      if (method.name == "mujoco-rk4") CHECK(error_of(method, belt, 16) < 0.01);
      continue;
    }
    // ODE's pyramid on fixed axes has a limit of its own. In double Bullet turns its pyramid by what slips where nothing does: rounding.
    const double each = method.name.starts_with("bullet-double") ? 0.09 : 0.03;
    for (const int substeps : {4, 16})
      CHECK(error_of(method, belt, substeps) < (method.name == "ode" ? 0.21 : each / substeps));
  }
}

TEST_CASE("Hard cases: what falls, whatever its shape, falls by the closed form of its substeps, and turns as it did") {
  under_each([](const PeerSetting& setting) {
    Under under(setting);
    World& world = under.world;
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
    const int substeps = setting.substeps * setting.own_substeps;
    REQUIRE(under.solver.plan(dt).all_substeps() == substeps);
    const Real t = Real(0.5), h = dt / static_cast<Real>(substeps);
    Watcher watcher(world, {.epsilon = setting.epsilon});
    for (long i = std::lround(t / dt); i > 0; --i) {
      under.step();
      watcher.look(world, dt, substeps);
    }
    CHECK(watcher.broken().empty());  // free flight keeps the energy that belongs to its substeps
    for (std::size_t i = 0; i < start.size(); ++i) {
      INFO(i);
      const Body &body = world.bodies[i], &began = start[i];
      const Vec3 falls = t * began.velocity + t * (t + h) / 2 * world.gravity;  // v += h g, x += h v
      CHECK((body.velocity - began.velocity - t * world.gravity).norm() < rounding(setting, 5));
      CHECK((body.position - began.position - falls).norm() < rounding(setting, 10));
      CHECK((body.angular_velocity - began.angular_velocity).norm() < 10 * rounding(setting, 5));
      const Real angle = t * began.angular_velocity.norm();
      const Quat turn(Eigen::AngleAxis<Real>(angle, angle > 0 ? began.angular_velocity.normalized() : Vec3::UnitX()));
      CHECK(body.orientation.angularDistance(turn * began.orientation) < Real(2e-3));  // engines turn by steps
    }
    CHECK(world.time == Approx(t));
  });
}

TEST_CASE("Hard cases: a force and a torque act for a step, by mass and inertia, and are over") {
  under_each([](const PeerSetting& setting) {
    Under under(setting);
    under.world.gravity.setZero();
    under.world.add(box({Real(0.1), Real(0.2), Real(0.3)}, 4).turned(Real(0.5), Vec3(1, 2, 3)));
    Body& body = under.world.bodies[0];
    body.force = {8, 0, -4};
    body.torque = {Real(0.01), Real(-0.02), Real(0.03)};
    const Vec3 turning = dt * body.inverse_inertia * body.torque;
    under.step();
    CHECK((body.velocity - dt * Vec3(2, 0, -1)).norm() < rounding(setting, Real(0.1)));
    CHECK((body.angular_velocity - turning).norm() < Real(1e-3) * turning.norm());  // it has turned within the step
    const Vec3 velocity = body.velocity;
    under.step();
    CHECK((body.velocity - velocity).norm() < rounding(setting, Real(0.1)));
    CHECK(body.force.isZero(0));
  });
}

TEST_CASE("Hard cases: a pair has the geometric mean of its frictions, and the larger restitution, where it bounces") {
  under_each([](const PeerSetting& setting) {
    for (const auto& [below, above] : {std::pair(Real(0.1), Real(0.9)), {Real(0.9), Real(0.1)}}) {
      Under under(setting);
      under.world.add(ground().rough(below));
      under.world.add(
          box({Real(0.3), Real(0.1), Real(0.3)}, 10).at({0, Real(0.0999), 0}).moving({4, 0, 0}).rough(above));
      under.run(Real(0.5));
      // A product would leave 3.56 m/s, a larger one 0. MuJoCo's law lifts the box off at first, and brakes it by that much more.
      const Real braked = 4 - under.world.bodies[1].velocity.x();
      CHECK(braked == Approx(Real(0.3) * World::g / 2).epsilon(is_mujoco() ? 0.3 : 0.1));
    }
    for (const auto& [below, above] : {std::pair(Real(0), Real(0.8)), {Real(0.8), Real(0)}, {Real(0.8), Real(0.8)}}) {
      Under under(setting);
      under.world.gravity.setZero();
      under.world.add(ground().bouncy(below));
      under.world.add(sphere(Real(0.3), 2).at({0, 1, 0}).moving({0, -5, 0}).bouncy(above));
      if (is_mujoco()) {
        CHECK(contains(under.lacks(), "not possible: restitution"));
        continue;
      }
      under.run(Real(0.5));
      CHECK(under.world.bodies[1].velocity.y() == Approx(4).epsilon(1e-3));
    }
  });
}

TEST_CASE("Hard cases: each shape comes to rest on the ground at its own height, to what the engine's margin says") {
  under_each([](const PeerSetting& setting) {
    for (const auto& [body, height] : {std::pair(sphere(Real(0.3), 10), Real(0.3)),
                                       {box({Real(0.4), Real(0.2), Real(0.3)}, 10), Real(0.2)},
                                       {capsule(Real(0.2), Real(0.3), 10).turned(pi / 2, Vec3::UnitX()), Real(0.2)},
                                       {cube_of_corners(Real(0.3), 10), Real(0.3)}}) {
      Under under(setting);
      under.world.add(ground());
      under.world.add(Body(body).at({0, height + Real(0.001), 0}));
      under.run(3);
      const Real above = under.world.bodies[1].position.y() - height;
      INFO("shape " << body.shape.index() << ": " << 1000 * above << " mm");
      // Bullet keeps 40 mm around a hull as it comes.
      const bool hull_in_margin = is_bullet() && !setting.tuned && std::holds_alternative<Hull>(body.shape);
      CHECK(above == Approx(hull_in_margin ? Real(0.04) : 0).margin(is_mujoco() && !setting.tuned ? 0.006 : 0.002));
      CHECK(largest_speed(under.world) < Real(0.005));
    }
  });
}

TEST_CASE("Hard cases: with continuous detection what is fast does not pass through what is thin") {
  under_each([](const PeerSetting& setting) {
    if (!setting.has("continuous") && !setting.has("bullets") && !setting.has("cast")) return;
    Under under(setting);
    under.world.gravity.setZero();
    under.world.add(box({Real(0.005), 1, 1}, 50));
    under.world.add(sphere(Real(0.05), Real(0.01)).at({Real(-3.3), 0, 0}).moving({200, 0, 0}));
    under.run(Real(0.5));
    CHECK(under.world.bodies[1].position.x() < under.world.bodies[0].position.x());
  });
}

TEST_CASE("Hard cases: what is changed between steps is handed over: a velocity, a place, a body more") {
  under_each([](const PeerSetting& setting) {
    Under under(setting);
    World& world = under.world;
    world.gravity.setZero();
    world.add(sphere(Real(0.3), 1));
    under.step();
    world.bodies[0].velocity = {3, 0, 0};
    world.bodies[0].position = {0, 7, 0};
    under.step();
    CHECK((world.bodies[0].position - Vec3(3 * dt, 7, 0)).norm() < rounding(setting, 7));
    world.add(box(Vec3::Constant(Real(0.5)), 5).at({9, 0, 0}).moving({0, 6, 0}));
    world.gravity = {0, 0, -6};
    under.run(1);
    CHECK(world.bodies[1].position.y() == Approx(6).epsilon(1e-4));
    CHECK(world.bodies[0].velocity.z() == Approx(-6).epsilon(1e-4));
    world.bodies[1].fixed();
    world.bodies[1].velocity.setZero();
    const Vec3 there = world.bodies[1].position;
    under.run(1);
    CHECK(world.bodies[1].position == there);
  });
}

TEST_CASE("Hard cases: a driven body goes where its velocity says, and takes along what lies on it") {
  under_each([](const PeerSetting& setting) {
    Under under(setting);
    std::vector<Body>& bodies = under.world.bodies;
    under.world.add(box({1, Real(0.1), 1}, 1).fixed().at({0, Real(-0.1), 0}));
    under.world.add(box(Vec3::Constant(Real(0.3)), 10).at({0, Real(0.2999), 0}));
    under.run(Real(0.5));
    const Real before = bodies[1].position.y();
    for (const Real speed : {Real(0.1), Real(0)}) {
      bodies[0].velocity = {0, speed, 0};
      under.run(1);
      CHECK(bodies[0].position.y() == Approx(0).margin(1e-12));
      CHECK(bodies[1].position.y() - before == Approx(0.1).margin(0.01));
    }
    CHECK(largest_speed(under.world) < Real(0.01));
  });
}

TEST_CASE("Hard cases: a hinge turns about its axis alone, and the two that it joins do not touch") {
  under_each([](const PeerSetting& setting) {
    Under under(setting);
    World& world = under.world;
    const int post = world.add(box({Real(0.2), Real(0.5), Real(0.2)}, 1).fixed().at({0, Real(-0.4), 0}));
    // It overlaps the post, and its weight pulls along z as well.
    const int plank = world.add(box({Real(0.5), Real(0.05), Real(0.2)}, 5).at({Real(0.5), Real(0.05), 0}));
    world.gravity = {0, -5, 5};
    world.joints.push_back(hinge(world, post, plank, {0, Real(0.05), 0}, Vec3::UnitZ()));
    Real off = 0, turned = 0;
    for (int i = 0; i < 60; ++i) {
      under.step();
      const Quat& q = world.bodies[1].orientation;
      off = std::max(off, Real((q * Vec3::UnitZ()).cross(Vec3::UnitZ()).norm()));
      turned = std::max(turned, -std::asin(std::clamp((q * Vec3::UnitX()).y(), Real(-1), Real(1))));
    }
    CHECK(off < Real(0.03));
    CHECK(turned > Real(1.3));  // through the post: down, where it would have been stopped
  });
}

TEST_CASE("Hard cases: a hinge's limits, a cone and a twist: held, or said not to be had") {
  enum { angle, cone, twist };
  under_each([](const PeerSetting& setting) {
    for (const int which : {angle, cone, twist}) {
      for (const Real side : {Real(-1), Real(1)}) {
        INFO(which << " to " << side);
        Under under(setting);
        World& world = under.world;
        world.gravity.setZero();
        world.add(box(Vec3::Constant(Real(0.2)), 1).fixed());
        world.add(box({Real(0.1), Real(0.4), Real(0.15)}, 2).at({0, Real(-0.7), 0}));
        const Vec3 anchor(0, Real(-0.25), 0), down = -Vec3::UnitY(),
                                              axis = which == twist ? Vec3::UnitY() : Vec3::UnitZ();
        world.joints.push_back(which == angle ? hinge(world, 0, 1, anchor, axis)
                                              : ball_and_socket(world, 0, 1, anchor));
        world.joints.push_back(which == angle  ? angle_limits(world, 0, 1, axis, Real(-0.3), Real(0.9))
                               : which == cone ? cone_limit(world, 0, 1, down, down, Real(0.6))
                                               : twist_limits(world, 0, 1, down, Real(-0.4), Real(0.4)));
        if (!has_cones() && which != angle) {
          CHECK(contains(under.lacks(), "not possible: "));
          continue;
        }
        Real farthest = 0;
        for (int i = 0; i < 60; ++i) {
          world.bodies[1].torque = side * (which == twist ? Real(0.2) : 2) * axis;
          under.step();
          const Quat& q = world.bodies[1].orientation;
          farthest = std::max(farthest, side * 2 * std::atan2(q.vec().dot(axis), q.w()));
        }
        const Real limit = which == cone ? Real(0.6) : which == twist ? Real(0.4) : side < 0 ? Real(0.3) : Real(0.9);
        CHECK(farthest == Approx(limit).margin(0.1));
      }
    }
  });
}

/// A wheel of I = 0.04 kg m^2 on a post, on one so heavy that it hardly moves, or on the world: w = T t / I up to the speed.
TEST_CASE("Hard cases: a motor: as fast as it is to turn, with no more than its torque, or said not to be had") {
  constexpr Real torque = Real(0.02), speed = Real(0.3);
  under_each([&](const PeerSetting& setting) {
    for (const std::string holder : {"a post", "a heavy body", "the world"}) {
      for (const auto& [side, axis_of_hinge] :
           {std::pair(Real(1), Real(1)), {Real(1), Real(-1)}, {Real(-1), Real(1)}, {Real(-1), Real(-1)}}) {
        INFO(holder << ", to " << side << ", hinge about " << axis_of_hinge);
        Under under(setting);
        World& world = under.world;
        world.gravity.setZero();
        const int post = world.add(box(Vec3::Constant(Real(0.5)), Real(1e5)).at({0, 0, -1}));
        if (holder == "a post") world.bodies.back().fixed();
        const int wheel = world.add(sphere(Real(0.1), 10)), on = holder == "the world" ? the_world : post;
        world.joints.push_back(hinge(world, on, wheel, Vec3::Zero(), axis_of_hinge * Vec3::UnitZ()));
        world.joints.push_back(motor_at_speed(world, on, wheel, Vec3::UnitZ(), side * speed, torque));
        if (is_old_mujoco()) {
          CHECK(contains(under.lacks(), "not possible: a motor"));
          continue;
        }
        under.run(Real(0.5));
        CHECK(side * world.bodies[1].angular_velocity.z() == Approx(torque * Real(0.5) / Real(0.04)).epsilon(0.02));
        under.run(Real(0.5));
        CHECK(side * world.bodies[1].angular_velocity.z() == Approx(speed).epsilon(0.02));
      }
    }
  });
}

TEST_CASE("Hard cases: what an engine is not handed is said: a skin, a conveyor, groups, another joint, contacts") {
  under_each([](const PeerSetting& setting) {
    const auto said = [&](const std::function<void(World&)>& change) {
      Under under(setting);
      under.world.add(sphere(1, 1));
      under.world.add(box(Vec3::Constant(1), 1).at({9, 0, 0}));
      change(under.world);
      return under.lacks();
    };
    CHECK(contains(said([](World& world) { world.bodies[0].skin = Real(0.1); }), "not possible: a skin"));
    CHECK(contains(said([](World& world) { world.bodies[0].touching(2); }), "not possible: groups"));
    CHECK(
        contains(said([](World& world) { world.bodies[1].fixed().conveying({1, 0, 0}); }), "not possible: a conveyor"));
    CHECK(contains(said([](World& world) { world.joints.push_back({"a spring", 0, 1, [](auto&&...) {}}); }),
                   "not possible: a spring"));
    Under under(setting);
    CHECK(contains(complaint([&] { under.solver.solve(under.world, dt, 1); }), "not possible: contacts"));
  });
}
