// Bodies, the door of the world, and motion without contacts.
#include <cmath>
#include <functional>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include "pushback/common/basics/input.h"
#include "pushback/common/basics/shortest_turn.h"
#include "pushback/common/bodies/random.h"
#include "pushback/common/world/forces.h"
#include "pushback/common/world/measure.h"
#include "pushback/common/world/step_solver.h"
#include "pushback/common/world/world.h"
#include "tests/support/call.h"
#include "tests/support/catch.h"
#include "tests/support/complaint.h"
#include "tests/support/yardstick.h"

using namespace pushback;

namespace {

constexpr Real infinity = std::numeric_limits<Real>::infinity();
constexpr Real not_a_number = std::numeric_limits<Real>::quiet_NaN();

/// Leaves the contacts alone.
struct NoSolver : StepSolver {
  void solve(World&, Real, int) override {}
};

/// Principal moments of inertia of a body of mass 1 by the midpoint rule: the mean of y^2 + z^2 and so on over a fine
/// grid of cells of which those count whose middle is inside.
Vec3 integrated_inertia(const Vec3& extents, const std::function<bool(const Vec3&)>& inside) {
  constexpr int cells = 160;
  using Sum = Eigen::Matrix<double, 3, 1>;
  Sum squares = Sum::Zero();
  double volume = 0;
  for (int i = 0; i < cells; ++i) {
    for (int j = 0; j < cells; ++j) {
      for (int k = 0; k < cells; ++k) {
        const Vec3 part =
            (Vec3(Real(i), Real(j), Real(k)) + Vec3::Constant(Real(0.5))) * (Real(2) / cells) - Vec3::Ones();
        const Vec3 p = part.cwiseProduct(extents);
        if (!inside(p)) continue;
        volume += 1;
        squares += p.cwiseAbs2().cast<double>();
      }
    }
  }
  return ((Sum::Constant(squares.sum()) - squares) / volume).cast<Real>();
}

Vec3 inertia_of(const Body& body) {
  return body.principal_inverse_inertia.cwiseInverse();
}

/// A box of 1 x 2 x 4 m that spins about its middle axis, and very little about another.
Body tumbling_box() {
  return box({Real(0.5), 1, 2}, 3).spinning({Real(0.1), 5, 0});
}

}  // namespace

TEST_CASE("inertia agrees with numeric integration over each shape") {
  const Real mass = 7;
  const auto require_moments = [&](const Body& body, const Vec3& extents,
                                   const std::function<bool(const Vec3&)>& inside) {
    const Vec3 integrated = mass * integrated_inertia(extents, inside);
    for (int i = 0; i < 3; ++i) REQUIRE(inertia_of(body)[i] == Approx(integrated[i]).epsilon(2e-3));
  };
  require_moments(sphere(Real(1.5), mass), Vec3::Constant(Real(1.5)),
                  [](const Vec3& p) { return p.norm() < Real(1.5); });
  require_moments(box({1, 2, 3}, mass), {1, 2, 3}, [](const Vec3&) { return true; });
  for (const Real half_length : {Real(0.01), Real(0.5), Real(3)}) {
    require_moments(capsule(1, half_length, mass), {1, half_length + 1, 1}, [&](const Vec3& p) {
      return (p - Vec3(0, std::clamp(p.y(), -half_length, half_length), 0)).norm() < 1;
    });
  }
}

TEST_CASE("the inverse inertia in world axes is R I^-1 R^T after every move") {
  World world;
  world.add(tumbling_box().at({0, 0, 0}));
  world.add(capsule(Real(0.3), 1, 2).turned(1, {1, 2, 3}).spinning({3, -2, 1}).at({10, 0, 0}));
  NoSolver none;
  for (int step = 0; step < 100; ++step) {
    world.step(none, Real(0.01));
    for (const Body& body : world.bodies) {
      REQUIRE(std::abs(body.orientation.norm() - 1) < 4 * eps);
      for (int i = 0; i < 3; ++i) {  // the body's axes are its eigenvectors
        const Vec3 axis = body.orientation * Vec3::Unit(i);
        const Vec3 product = body.inverse_inertia * axis;
        REQUIRE((product - body.principal_inverse_inertia[i] * axis).norm() < 100 * eps * product.norm());
      }
    }
  }
}

TEST_CASE("an immovable body has neither inverse mass nor inverse inertia, and stays") {
  World world;
  world.add(box({1, 1, 1}, 1).fixed());
  world.add(ground());
  NoSolver none;
  for (int step = 0; step < 10; ++step) world.step(none, Real(0.1));
  for (const Body& body : world.bodies) {
    REQUIRE(!body.movable());
    REQUIRE(body.inverse_inertia.isZero(0));
    REQUIRE(body.position.isZero(0));
    REQUIRE(body.velocity.isZero(0));
  }
}

TEST_CASE("the builders refuse lengths and masses that are not finite numbers above 0") {
  for (const Real bad : {Real(0), Real(-1), infinity, not_a_number}) {
    const std::string number = fmt::format("{}", bad);
    INFO(number);
    const auto refused = [&](const std::string& what, const std::function<void()>& act) {
      const std::string message = complaint(act);
      INFO(message);
      REQUIRE(contains(message, what));
      REQUIRE(contains(message, number));
    };
    refused("radius", [&] { sphere(bad, 1); });
    refused("mass", [&] { sphere(1, bad); });
    refused("half-extent", [&] { box({bad, 1, 1}, 1); });
    refused("half-extent", [&] { box({1, bad, 1}, 1); });
    refused("half-extent", [&] { box({1, 1, bad}, 1); });
    refused("mass", [&] { box({1, 1, 1}, bad); });
    refused("radius", [&] { capsule(bad, 1, 1); });
    refused("half-length", [&] { capsule(1, bad, 1); });
    refused("mass", [&] { capsule(1, 1, bad); });
    if (bad != -1) refused("normal", [&] { half_space(Vec3(0, bad, 0)); });
  }
  REQUIRE(contains(complaint([] { sphere(1, 1).turned(not_a_number, Vec3::UnitX()); }), "angle"));
  REQUIRE(contains(complaint([] { sphere(1, 1).turned(1, Vec3::Zero()); }), "axis"));
}

TEST_CASE("the world refuses a body with a number that cannot be simulated, and names the number") {
  struct Case {
    std::string names;
    std::function<void(Body&)> spoil;
  };
  const std::vector<Case> cases = {
      {"position is (nan", [](Body& b) { b.position.x() = not_a_number; }},
      {"position is (0, inf", [](Body& b) { b.position.y() = infinity; }},
      {"angular velocity is (", [](Body& b) { b.angular_velocity.z() = not_a_number; }},
      {"velocity is (", [](Body& b) { b.velocity.z() = -infinity; }},
      {"force is (", [](Body& b) { b.force.x() = not_a_number; }},
      {"torque is (", [](Body& b) { b.torque.x() = not_a_number; }},
      {"orientation", [](Body& b) { b.orientation.x() = not_a_number; }},
      {"orientation quaternion is 0", [](Body& b) { b.orientation.coeffs().setZero(); }},
      {"inverse mass is -1", [](Body& b) { b.inverse_mass = -1; }},
      {"inverse inertia is -2", [](Body& b) { b.principal_inverse_inertia.y() = -2; }},
      {"friction is -0.5", [](Body& b) { b.friction = Real(-0.5); }},
      {"restitution is 1.5", [](Body& b) { b.restitution = Real(1.5); }},
      {"radius is -1", [](Body& b) { b.shape = Sphere{-1}; }},
      {"half-extent of a box is -2", [](Body& b) { b.shape = Box{{1, -2, 1}}; }},
      {"half-length of a capsule is 0", [](Body& b) { b.shape = Capsule{1, 0}; }},
      {"normal of a half-space is 0", [](Body& b) { b.shape = HalfSpace{{0, 0, 0}}; }},
      {"inverse mass of a half-space", [](Body& b) { b.shape = HalfSpace{{0, 1, 0}}; }},
  };
  for (const Case& bad : cases) {
    World world;
    Body body = sphere(1, 1);
    bad.spoil(body);
    const std::string message = complaint([&] { world.add(body); });
    INFO("wanted: " << bad.names << ", message: " << message);
    REQUIRE(contains(message, bad.names));
    REQUIRE(world.bodies.empty());
  }
}

TEST_CASE("the world normalises what only lacks the length 1") {
  World world;
  Body body = box({1, 1, 1}, 1);
  body.orientation.coeffs() *= 3;
  world.add(body);
  REQUIRE(world.bodies[0].orientation.norm() == Approx(1));
  Body plane = ground();
  plane.shape = HalfSpace{{0, 5, 0}};
  world.add(plane);
  REQUIRE(std::get<HalfSpace>(world.bodies[1].shape).normal.norm() == Approx(1));
}

TEST_CASE("a step that cannot be taken is refused before anything moves") {
  World world;
  world.add(sphere(1, 1).at({0, 10, 0}).moving({1, 0, 0}));
  NoSolver none;
  const std::uint64_t before = hash_of(world);
  for (const Real bad : {Real(0), Real(-0.01), Real(1.5), Real(1e6), infinity, not_a_number}) {
    REQUIRE(complaint([&] { world.step(none, bad); }) ==
            fmt::format("dt is {}: a number above 0 and up to 1 s is needed", bad));
  }
  REQUIRE(contains(complaint([&] { world.step(none, Real(0.01), -1); }), "sweeps is -1"));
  REQUIRE(hash_of(world) == before);
  REQUIRE(complaint([&] { world.step(none, Real(0.01), 0); }).empty());

  const World good = world;
  const auto refused = [&](const std::string& what, const std::function<void(World&)>& spoil) {
    World spoiled = good;
    spoil(spoiled);
    const std::uint64_t spoiled_hash = hash_of(spoiled);
    const std::string message = complaint([&] { spoiled.step(none, Real(0.01)); });
    INFO("wanted: " << what << ", message: " << message);
    REQUIRE(contains(message, what));
    REQUIRE(hash_of(spoiled) == spoiled_hash);
  };
  refused("gravity", [](World& w) { w.gravity.y() = not_a_number; });
  refused("position", [](World& w) { w.bodies[0].position.x() = not_a_number; });
  refused("velocity", [](World& w) { w.bodies[0].velocity.x() = infinity; });
  refused("angular velocity", [](World& w) { w.bodies[0].angular_velocity.x() = not_a_number; });
  refused("orientation", [](World& w) { w.bodies[0].orientation.x() = not_a_number; });
}

TEST_CASE("free fall follows the closed form of symplectic Euler") {
  World world;
  const Real v0 = 3, x0 = 20;
  world.add(sphere(1, 2).at({0, x0, 0}).moving({1, v0, 0}));
  NoSolver none;
  for (int n = 1; n <= 100; ++n) {
    world.step(none, h);
    const Real steps = Real(n);
    REQUIRE(world.bodies[0].velocity.y() == Approx(v0 - steps * h * g));
    REQUIRE(world.bodies[0].position.y() == Approx(x0 + steps * h * v0 - g * h * h * steps * (steps + 1) / 2));
    REQUIRE(world.bodies[0].position.x() == Approx(steps * h));
  }
}

TEST_CASE("a spring swings with the period 2 pi sqrt(m/k), short by O(h^2)") {
  const Real mass = 2, stiffness = 50;
  const Real period = 2 * pi * std::sqrt(mass / stiffness);
  const auto measured_period = [&](Real dt) {
    World world;
    world.gravity.setZero();
    const int body = world.add(sphere(Real(0.1), mass).at({3, 0, 0}));
    world.forces.push_back(spring(body, {2, 0, 0}, stiffness));
    NoSolver none;
    Real first = -1, last = -1, before = 1;
    int passes = 0;
    for (int n = 1; passes < 11; ++n) {  // times at which it passes the anchor on the way down, between two steps
      world.step(none, dt);
      const Real now = world.bodies[0].position.x() - 2;
      if (before > 0 && now <= 0) {
        last = dt * (Real(n) - now / (now - before));
        if (passes++ == 0) first = last;
      }
      before = now;
    }
    return (last - first) / 10;
  };
  // Symplectic Euler turns by 2 asin(w dt / 2) a step instead of w dt: the period is short by (w dt)^2 / 24 of it.
  const Real w = std::sqrt(stiffness / mass);
  for (const Real dt : {Real(0.02), Real(0.01)}) {
    const Real exact = pi * dt / std::asin(w * dt / 2);
    INFO("dt " << dt << ": " << measured_period(dt) << ", true period " << period);
    REQUIRE(measured_period(dt) == Approx(exact).epsilon(1e-4));
    REQUIRE(std::abs(measured_period(dt) - period) < period * (w * dt) * (w * dt) / 20);
  }
}

TEST_CASE("drag slows a body by the factor 1 - c h / m a step") {
  World world;
  world.gravity.setZero();
  const Real mass = 4, c = 3, dt = Real(0.05);
  const int body = world.add(sphere(1, mass).moving({10, -20, 5}));
  world.forces.push_back(drag(body, c));
  NoSolver none;
  for (int n = 1; n <= 60; ++n) {
    world.step(none, dt);
    const Real factor = std::pow(1 - c * dt / mass, Real(n));
    REQUIRE(world.bodies[0].velocity.x() == Approx(10 * factor));
    REQUIRE(world.bodies[0].velocity.y() == Approx(-20 * factor));
  }
  REQUIRE(complaint([] { drag(0, -1); }).size() > 0);
  REQUIRE(complaint([] { spring(0, Vec3::Zero(), -1); }).size() > 0);
}

TEST_CASE("a box spun about its middle axis keeps momentum and energy, and flips as often as a much finer motion") {
  const auto flips = [](Real dt, int steps, bool examine) {
    World world;
    world.gravity.setZero();
    world.add(tumbling_box());
    const Vec3 momentum = angular_momentum(world);
    const Real energy = kinetic_energy(world);
    NoSolver none;
    int count = 0;
    bool upright = true;
    Real worst_momentum = 0, worst_energy = 0;
    for (int i = 0; i < steps; ++i) {
      world.step(none, dt, 0);
      worst_momentum = std::max(worst_momentum, (angular_momentum(world) - momentum).norm() / momentum.norm());
      worst_energy = std::max(worst_energy, std::abs(kinetic_energy(world) - energy) / energy);
      const Real along = (world.bodies[0].orientation * Vec3::UnitY()).y();
      if (upright ? along < Real(-0.5) : along > Real(0.5)) {
        upright = !upright;
        ++count;
      }
    }
    if (examine) {
      INFO("momentum off by " << worst_momentum << ", energy by " << worst_energy);
      REQUIRE(worst_momentum <= (sizeof(Real) == 8 ? Real(1e-12) : Real(2e-3)));
      REQUIRE(worst_energy <= (sizeof(Real) == 8 ? Real(1e-12) : Real(2e-3)));
    }
    return count;
  };
  const int coarse = flips(Real(1) / 240, 2400, true);  // 10 s
  const int fine = flips(Real(1) / 9600, 96000, false);
  REQUIRE(fine >= 3);
  REQUIRE(coarse == fine);
}

TEST_CASE("a box spun about its long or its short axis does not flip") {
  for (const int axis : {0, 2}) {
    World world;
    world.gravity.setZero();
    Vec3 spin = Vec3::Constant(Real(0.01));
    spin[axis] = 5;
    world.add(box({Real(0.5), 1, 2}, 3).spinning(spin));
    NoSolver none;
    for (int i = 0; i < 600; ++i) {
      world.step(none, Real(1) / 60, 0);
      REQUIRE((world.bodies[0].orientation * Vec3::Unit(axis))[axis] > Real(0.99));
    }
  }
}

TEST_CASE("the shortest turn takes one direction to another, about an axis perpendicular to both") {
  constexpr Real rounding = in_double ? Real(1e-7) : Real(2e-3);  // the root of eps, of opposite ones
  Random random(3);
  for (int i = 0; i < 100; ++i) {
    const Vec3 from = random.direction(), other = random.direction();
    for (const Vec3& to : {other, from, Vec3(-from)}) {
      const Quat turn = shortest_turn(2 * from, to);
      REQUIRE(std::abs(turn.norm() - 1) < rounding);
      REQUIRE((turn * from - to).norm() < rounding);
      REQUIRE(std::abs(turn.vec().dot(from)) < rounding);
    }
  }
}
