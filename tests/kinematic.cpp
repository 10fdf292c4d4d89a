// Bodies that are moved by hand, and conveyors: what they carry obeys closed forms, whatever solver there is.

#include "pushback/common/bodies/random.h"
#include "pushback/engine/substeps/wide_solver.h"
#include "pushback/tools/catalogue/solvers.h"
#include "tests/support/catch.h"
#include "tests/support/complaint.h"
#include "tests/support/yardstick.h"

using namespace pushback;

namespace {

struct Tried {
  std::string name;
  AnySolver solver;
  int sweeps;  // in a substep
  Real exact;  // relative rounding of its impulses, once what it carries has come to rest on it
  int substeps = solver.plan(h).all_substeps();

  void step(World& world) { world.step(solver, h, sweeps); }
};

/// Those that find contacts in each substep, and those that find them once in a step; one whose rows are floats.
std::vector<Tried> tried() {
  const Real rounding = in_double ? Real(1e-9) : Real(1e-3);
  std::vector<Tried> all = {{"08 friction cone", solver_named("08 friction cone").solver, 50, rounding}};
  for (const char* name :
       {"11 substeps", "12 soft contacts", "21 detected once", "22 wide", "26 by island", "all together"})
    all.push_back({name, solver_named(name).solver, 1, rounding});
  all.push_back({"22 wide, of floats", WideSolver<float>{}, 1, Real(1e-3)});
  return all;
}

/// N, upwards, on all that lies on something.
Real pressed(const World& world) {
  Real impulse = 0;
  for (const Contact& contact : world.contacts) impulse += contact.impulse.y();
  return impulse / h;
}

Body platform(const Vec3& half_extents = {8, Real(0.25), 2}) {
  return box(half_extents, 1).fixed().at({0, -half_extents.y(), 0});  // its top is the plane y = 0
}

/// m, and sine of half an angle: so near does a body get to where it is to be in one step.
constexpr Real arrives = in_double ? Real(1e-12) : Real(1e-4);

constexpr Real mu = Real(0.5), half = Real(0.1), mass = 10;
Body parcel() {
  return box({2 * half, half, 2 * half}, mass).at({0, half, 0});
}

}  // namespace

TEST_CASE("moved by hand: one step takes the body to the place and into the turn, in all substeps together") {
  Random random(1);
  for (Tried& by : tried()) {
    INFO(by.name);
    World world;
    world.add(box({1, 2, 3}, 1).fixed());
    world.add(sphere(1, 1).at({0, 100, 0}));
    for (int i = 0; i < 100; ++i) {
      Body& body = world.bodies[0];
      const Vec3 where = body.position + random.vector(1);
      const Vec3 axis = random.direction();
      const Quat by_turn(Eigen::AngleAxis<Real>(random.between(0, Real(3)), axis));
      const Quat to = by_turn * body.orientation;
      body.moved_to(where, Quat(i % 2 == 0 ? to.coeffs() : -to.coeffs()), h);  // the same orientation
      const Vec3 velocity = body.velocity;
      by.step(world);
      REQUIRE((body.position - where).norm() < arrives);
      REQUIRE((body.orientation.conjugate() * to).vec().norm() < arrives);
      REQUIRE(body.velocity == velocity);
    }
    world.bodies[0].moved_to(world.bodies[0].position, world.bodies[0].orientation, h);
    CHECK(world.bodies[0].velocity.isZero(0));
    CHECK(world.bodies[0].angular_velocity.norm() < arrives);
  }
}

TEST_CASE("moved by hand: what cannot be done is refused by name") {
  const Vec3 zero = Vec3::Zero();
  const Quat none = Quat::Identity();
  const auto said = [&](Body body, const Vec3& where, const Quat& to, Real dt) {
    return complaint([&] { body.moved_to(where, to, dt); });
  };
  const Body fixed = sphere(1, 1).fixed();
  const Real nan = std::numeric_limits<Real>::quiet_NaN();
  CHECK(said(sphere(1, 1), zero, none, h) ==
        "body to move by hand can move by itself: an immovable one that does not convey is needed");
  CHECK(said(Body(fixed).conveying({1, 0, 0}), zero, none, h) ==
        "body to move by hand conveys: an immovable one that does not convey is needed");
  CHECK(said(fixed, {nan, 0, 0}, none, h) == "place to move to is (nan, 0, 0): three finite numbers are needed");
  CHECK(said(fixed, zero, Quat(0, 0, 0, 0), h) ==
        "length of the orientation quaternion is 0: a finite number above 0 is needed");
  CHECK(said(fixed, zero, none, 0) == "dt is 0: a finite number above 0 is needed");
  CHECK(said(fixed, zero, Quat(0, 0, 1, 0), h).empty());  // half a turn
  CHECK(complaint([nan] { sphere(1, 1).conveying({nan, 0, 0}); }) ==
        "surface velocity is (nan, 0, 0): three finite numbers are needed");
  World world;
  CHECK(complaint([&] { world.add(sphere(1, 1).conveying({1, 0, 0})); }) ==
        "inverse mass of a body that conveys is 1: it must be 0, only an immovable body conveys");
  CHECK(world.bodies.empty());
}

TEST_CASE("a lift: a box on it presses with m (g + a), and where the lift falls faster than g, with nothing") {
  for (Tried& by : tried()) {
    const bool detects_once = by.solver.plan(h).detections == 1;
    for (const Real a : {Real(2), Real(-3), -g - 1}) {
      INFO(by.name << ", a = " << a);
      const Real force = std::max(Real(0), mass * (g + a));
      World world;
      world.add(platform());
      world.add(parcel());
      Real v_before = 0;  // m/s, as the last 60 steps begin
      for (int i = 1; i <= 120; ++i) {
        const Real t = Real(i) * h;
        world.bodies[0].moved_to({0, Real(-0.25) + a * t * t / 2, 0}, Quat::Identity(), h);
        by.step(world);
        if (i == 60) v_before = world.bodies[1].velocity.y();
        if (i > 60 && detects_once) CHECK(std::abs(pressed(world) - force) < by.exact * mass * g);
      }
      // The lift's speed changes from step to step, so one that brakes lets the box fly for some substeps. Where contacts are
      // detected in each of them, those of a flight are lost, and steps differ: then the mean is exact.
      const Real mean = mass * ((world.bodies[1].velocity.y() - v_before) / (60 * h) + g);
      CHECK(std::abs(mean - force) < std::max(by.exact, Real(1e-4)) * mass * g);
    }
  }
}

TEST_CASE("a turntable: a box on it slides outwards just if w^2 r > mu g") {
  for (Tried& by : tried()) {
    if (by.substeps == 1) continue;  // x += h v along the tangent adds w^2 h^2 / 2 to r in each step: see below
    for (const Real share : {Real(0.95), Real(1.05)}) {
      INFO(by.name << ", " << share << " of the speed");
      const Real r = 2, w = share * std::sqrt(mu * g / r);
      World world;
      world.add(platform({4, Real(0.25), 4}).spinning({0, w, 0}));
      world.add(parcel().at({r, half, 0}).moving({0, 0, -w * r}).spinning({0, w, 0}));
      for (int i = 0; i < 300; ++i) by.step(world);
      const Vec3& x = world.bodies[1].position;
      const Real grown = std::hypot(x.x(), x.z()) / r - 1, by_step = w * w * h / Real(by.substeps) * (300 * h) / 2;
      if (share < 1) CHECK(grown < Real(1.5) * by_step);
      else CHECK(grown > 20 * by_step);
    }
  }
}

TEST_CASE("a conveyor: a box that is put on it slips v^2 / (2 mu g) and then rides at v") {
  for (Tried& by : tried()) {
    INFO(by.name);
    const Real v = 2, substep = h / Real(by.substeps);
    World world;
    world.add(platform().conveying({v, 0, 0}));
    world.add(parcel());
    const Body belt = world.bodies[0];
    for (int i = 0; i < 120; ++i) by.step(world);
    // In steps of h the speed is mu g h, 2 mu g h, ... at the ends of steps, in which it counts.
    Real slip = 0;
    for (Real speed = mu * g * substep; speed < v; speed += mu * g * substep) slip += (v - speed) * substep;
    const Real slipped = v * 120 * h - world.bodies[1].position.x();
    const bool half_steps = by.name == "26 by island";  // of second order: what is in a step counts as it is
    CHECK(std::abs(slipped - (half_steps ? v * v / (2 * mu * g) : slip)) < Real(half_steps ? 2e-4 : 1e-3) * slip);
    CHECK(std::abs(slip - v * v / (2 * mu * g)) < v * substep);
    CHECK(std::abs(world.bodies[1].velocity.x() - v) < by.exact);
    CHECK(world.bodies[0].position == belt.position);
    CHECK(world.bodies[0].orientation.coeffs() == belt.orientation.coeffs());
    CHECK(world.bodies[0].velocity == belt.velocity);
  }
}

TEST_CASE("a conveyor on a slope takes a box up at v if tan a < mu, and lets it slide at g (sin a - mu cos a) if not") {
  for (Tried& by : tried()) {
    for (const Real slope : {Real(0.3), Real(0.7)}) {
      INFO(by.name << ", tan a = " << slope);
      const Real a = std::atan(slope), v = 1;
      const Vec3 up(std::cos(a), std::sin(a), 0), n(-std::sin(a), std::cos(a), 0);
      World world;
      world.add(platform().turned(a, Vec3::UnitZ()).at(Real(-0.25) * n).conveying(v * up));
      world.add(parcel().turned(a, Vec3::UnitZ()).at(half * n));
      const auto along = [&] { return world.bodies[1].velocity.dot(up); };
      for (int i = 0; i < 60; ++i) by.step(world);
      const Real at_first = along();
      for (int i = 0; i < 60; ++i) by.step(world);
      if (slope < mu) CHECK(std::abs(along() - v) < std::max(by.exact, Real(1e-6)));
      else
        CHECK((along() - at_first) / (60 * h) ==
              Approx(-g * (std::sin(a) - mu * std::cos(a))).epsilon(std::max(by.exact, Real(1e-6))));
    }
  }
}

TEST_CASE(
    "a conveyor round a curve: its surface turns about its centre, or another point, and so does what lies there") {
  for (const Vec3& centre : {Vec3(0, 0, 0), Vec3(1, 0, Real(-0.5))})
    for (Tried& by : tried()) {
      if (by.substeps == 1) continue;
      INFO(by.name << ", " << centre.transpose());
      const Real r = 2, w = Real(0.8);
      World world;
      Body belt = platform({4, Real(0.25), 4});
      belt.position += centre;
      world.add(belt.conveying(Vec3(0, w, 0).cross(centre)).spinning({0, w, 0}));
      world.add(parcel().at({r, half, 0}).moving({0, 0, -w * r}).spinning({0, w, 0}));
      for (int i = 0; i < 180; ++i) by.step(world);
      const Vec3& x = world.bodies[1].position;
      const Real by_step = w * w * h / Real(by.substeps) * (180 * h) / 2;
      CHECK(std::abs(std::hypot(x.x(), x.z()) / r - 1) < Real(1.5) * by_step);
      CHECK(std::atan2(-x.z(), x.x()) == Approx(w * 180 * h).margin(1e-3));
      CHECK(world.bodies[0].orientation.coeffs() == Quat::Identity().coeffs());
    }
}
