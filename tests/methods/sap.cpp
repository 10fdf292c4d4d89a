/// SAP, the semi-analytic primal solver: closed forms of its regularisation, and of what its relaxed friction does.
#include "pushback/tools/methods/sap.h"

#include "pushback/chapters/07_warm_start/full_solver.h"
#include "pushback/common/world/measure.h"
#include "pushback/tools/measure/study/relaxed_law.h"
#include "tests/methods/played.h"
#include "tests/support/catch.h"
#include "tests/support/complaint.h"
#include "tests/support/on_ground.h"

using namespace pushback;

namespace {

constexpr Real tau_of_one = h / pi;           // of beta = 1
constexpr Real softness = 1 / (4 * pi * pi);  // R_n / w likewise
const Real of_corner =
    std::sqrt(1 + 2 * Real(5.5) * Real(5.5)) / 3;  // w m of a cube's corner: 1, and twice 1 + 6 |r|^2

/// w m of a ball so deep in the ground: 1 along the normal, 1 + 5/2 along a tangent; the contact lies in the middle of the overlap.
Real of_ball(Real depth) {
  const Real arm = 1 - depth / (2 * Real(0.3));
  return std::hypot(Real(1), std::sqrt(Real(2)) * (1 + Real(2.5) * arm * arm)) / 3;
}

void play(World& world, Sap& solver, int steps) {
  for (int i = 0; i < steps; ++i) world.step(solver, h);
}

}  // namespace

TEST_CASE("sap: a ball rests as deep as its spring says") {
  World world;
  const Body& ball = ball_on_ground(world, 0);
  Sap solver;
  play(world, solver, 120);
  CHECK(depth_of(ball) ==
        Approx(g * h * (h + tau_of_one) * softness * of_ball(depth_of(ball))).epsilon(in_double ? 1e-6 : 1e-2));
}

// A spring that cannot pull stops nobody whom it has pushed.
TEST_CASE("sap: on a slope below the angle of friction a box creeps, by R_t times its friction") {
  constexpr Real angle = Real(0.2);  // the rear corners bear less: all four stick where tan(angle) < mu / (1 + mu)
  World world;
  const Vec3 out(std::sin(angle), std::cos(angle), 0), down(std::cos(angle), -std::sin(angle), 0);
  world.add(half_space(out).rough(Real(0.4)));
  world.add(box(Vec3::Constant(Real(0.5)), 100).turned(-angle, Vec3::UnitZ()).at(Real(0.5) * out).rough(Real(0.4)));
  Sap solver;
  play(world, solver, 120);
  const Real creep = Sap::slip * of_corner * g * h * std::sin(angle) / 4;
  CHECK(world.bodies[1].velocity.dot(down) == Approx(creep).epsilon(0.01));
  for (const Contact& at : world.contacts) CHECK(at.state == ContactState::sticking);
}

TEST_CASE("sap: above the angle of friction it slides with g (sin - mu cos), and hovers at (h + tau) mu u_t") {
  if (!in_double) return;
  const double coarse = error_of<Sap>("incline", 4, 1), fine = error_of<Sap>("incline", 8, 1);
  CHECK(coarse < 0.006);
  CHECK(std::log2(coarse / fine) == Approx(1).margin(0.01));
  World world;
  any_motion_named("incline").begin(world);
  const Vec3 out = std::get<HalfSpace>(world.bodies[0].shape).normal;
  Sap solver;
  play(world, solver, 60);
  const Body& sliding = world.bodies[1];
  const Real before = sliding.velocity.norm();
  for (const Contact& at : world.contacts) CHECK(at.state == ContactState::sliding);
  play(world, solver, 1);
  const Real hovers = (h + tau_of_one) * Real(0.4) * before;
  CHECK(sliding.position.dot(out) - Real(0.25) == Approx(hovers).epsilon(0.02));
}

// As h -> 0, too: v = mu v_t of an instant. relaxed_law.h derives it; it holds of every convex relaxation.
TEST_CASE("sap: a body that is sent along the ground hops by the closed form of the relaxed law") {
  for (const std::string name : {"sliding", "rolling"}) {
    INFO(name);
    const Motion& motion = any_motion_named(name);
    const Hop hop = hop_of(motion).value();
    World world;
    motion.begin(world);
    Sap solver;
    solver.period = Real(0.01);
    world.step(solver, Real(1e-4));
    CHECK(static_cast<double>(world.bodies.back().velocity.y()) == Approx(hop.speed).epsilon(0.01));
    // With beta = 1 the spring takes a part: 1 + k mu^2 becomes 1 + k mu^2 + m (R_n + mu^2 R_t) / contacts.
    const Body& body = world.bodies.back();
    const bool is_ball = std::holds_alternative<Sphere>(body.shape);
    const double mu = static_cast<double>(body.friction), rigid = 1 + (is_ball ? 3.5 : 1) * mu * mu;
    const double w_m = static_cast<double>(is_ball ? of_ball(0) : of_corner) / (is_ball ? 1 : 4);
    const double part = rigid / (rigid + w_m * (static_cast<double>(softness) + mu * mu * 1e-3));
    if (in_double) CHECK(error_of<Sap>(name, 64, 1) == Approx(hop.error * part * part).epsilon(0.005));
  }
}

TEST_CASE("sap, lagged: friction is mu times the normal impulse of the step before, and nothing hops") {
  World world;
  world.add(ground().rough(Real(0.5)));
  world.add(box(Vec3::Constant(Real(0.5)), 100).at({0, Real(0.5), 0}).moving({4, 0, 1}).rough(Real(0.5)));
  SapLagged solver;
  for (int i = 0; i < 30; ++i) {
    const Contacts before = world.contacts;
    world.step(solver, h);
    for (std::size_t k = 0; k < 4; ++k) {
      const Vec3& impulse = world.contacts.at(k).impulse;
      const Real bound = before.empty() ? 0 : Real(0.5) * before[k].impulse.y();
      CHECK(std::hypot(impulse.x(), impulse.z()) == Approx(bound).epsilon(1e-3).margin(in_double ? 1e-9 : 1e-3));
    }
    CHECK(world.bodies[1].velocity.y() < Real(1e-3));
  }
}

// docs/methods.md sets these beside what the authors' scripts give: https://github.com/erwincoumans/contact_models.
TEST_CASE("methods: a particle of Horak and Trinkle hovers under a relaxed cone, and is turned by a pyramid") {
  if (!in_double) return;
  const auto place = [](auto solver, bool steady) {
    World world;
    world.add(ground().rough(Real(0.3)));
    world.add(
        sphere(Real(0.05), Real(0.2)).moving({steady ? Real(0.2) : 0, 0, 0}).at({0, Real(0.05), 0}).rough(Real(0.3)));
    world.bodies[1].principal_inverse_inertia.setConstant(Real(1e-6));  // it hardly turns
    world.forces.push_back({[steady](World& now) {
      Body& ball = now.bodies[1];
      ball.force += steady ? Vec3(Real(0.06) * g + 5 * (Real(0.2) - ball.velocity.x()), 0, 0) : Vec3(-1, 0, Real(0.8));
    }});
    for (int i = 0; i < 50; ++i) world.step(solver, Real(0.01), 10);
    return world.bodies[1].position;
  };
  CHECK(place(Sap(), true).y() - Real(0.05) == Approx(0.000772).epsilon(0.01));
  CHECK(std::abs(place(SapLagged(), true).y() - Real(0.05)) < Real(2e-5));
  const auto angle = [](const Vec3& at) { return std::atan2(at.z(), -at.x()) * 180 / pi; };
  CHECK(angle(place(FullSolver(), false)) == Approx(27.197).epsilon(1e-4));
  CHECK(angle(place(SapLagged(), false)) == Approx(38.660).epsilon(1e-4));
}

// f = mu N v / sqrt(v^2 + e^2)
TEST_CASE("sap, lagged: on a slope a box creeps with the speed of its regularised friction") {
  World world;
  world.gravity = g * Vec3(std::sin(Real(0.2)), -std::cos(Real(0.2)), 0);
  world.add(ground().rough(Real(0.4)));
  world.add(box(Vec3::Constant(Real(0.5)), 100).at({0, Real(0.5), 0}).rough(Real(0.4)));
  SapLagged solver;
  play(world, solver, 240);
  const Real part = std::tan(Real(0.2)) / Real(0.4), e = static_cast<Real>(Sap::slow);
  CHECK(world.bodies[1].velocity.x() == Approx(e * part / std::sqrt(1 - part * part)).epsilon(0.01));
}

// m u_n = r - m c,  m u_t = m s - k mu r,  u_n = mu u_t, with k = 7/2
TEST_CASE("sap: nothing bounces straight back, but what arrives aslant is thrown off") {
  const auto thrown = [](Real c, Real s) {
    World world;
    world.gravity.setZero();
    const Body& ball = ball_on_ground(world, 0).bouncy(1).moving({s, -c, 0}).rough(Real(0.5));
    world.bodies[0].rough(Real(0.5));
    Sap solver;
    solver.period = Real(0.01);
    world.step(solver, h);
    return ball.velocity.y();
  };
  CHECK(std::abs(thrown(3, 0)) < Real(1e-3));
  CHECK(thrown(3, 3) < Real(1e-3));  // friction stops it: s < k mu c
  CHECK(thrown(1, 5) == Approx((0.5 * 5 - 3.5 * 0.25) / (1 + 3.5 * 0.25)).epsilon(1e-3));
}

TEST_CASE("sap: what rests is off by the depth of its springs, of the order of the squared step") {
  if (!in_double) return;
  for (const std::string name : {"stack-10", "heavy-on-light"}) {
    INFO(name);
    const double coarse = error_of<Sap>(name, 4, 1), fine = error_of<Sap>(name, 16, 1);
    CHECK(coarse < 0.0011);
    CHECK(std::log2(coarse / fine) / 2 == Approx(2).margin(0.3));
  }
}

TEST_CASE("sap: a joint's bounds, its speed and its softness are kept") {
  const auto speed_after = [](const Equation& equation) {
    World world;
    world.gravity.setZero();
    world.add(sphere(Real(0.5), 10));
    world.add(sphere(Real(0.5), 10).fixed().at({9, 0, 0}));
    const auto any = [](const Body&, const Body&, const TimeStep&, Equations& equations) { equations.emplace_back(); };
    world.joints.push_back({"between what nothing moves", the_world, 1, any});
    world.joints.push_back(
        {"a row", the_world, 0,
         [=](const Body&, const Body&, const TimeStep&, Equations& equations) { equations.push_back(equation); }});
    Sap solver;
    world.step(solver, h);
    CHECK(world.joints[1].impulses.at(0) == Approx(10 * world.bodies[0].velocity.x()).epsilon(1e-5));
    return world.bodies[0].velocity.x();
  };
  const Jacobian x{.n = Vec3::UnitX()};
  CHECK(speed_after({.jacobian = x, .bias = -3}) == Approx(3 / (1 + softness)).epsilon(1e-5));
  CHECK(speed_after({.jacobian = x, .bias = -3, .hi = 60}) == Approx(60 * h / 10).epsilon(1e-5));
  CHECK(speed_after({.jacobian = x, .bias = 3, .lo = -60}) == Approx(-60 * h / 10).epsilon(1e-5));
  CHECK(speed_after({.jacobian = x, .bias = -3, .softness = Real(0.5)}) == Approx(3 / (1 + 10 * 0.5)).epsilon(1e-5));
  CHECK(speed_after({.jacobian = x, .error = Real(-0.1)}) ==
        Approx(0.1 / (h + tau_of_one) / (1 + softness)).epsilon(1e-5));
}

TEST_CASE("sap: a period that cannot be is refused by name") {
  World world;
  ball_on_ground(world, 0);
  Sap solver;
  solver.period = 0;
  CHECK(complaint([&] { world.step(solver, h); }).find("period of contacts is 0") != std::string::npos);
}
