/// Limits, motors, pistons and springs of chapter 15: Jacobians, laws, bounds, and what is refused.
#include "pushback/chapters/07_warm_start/full_solver.h"
#include "pushback/chapters/15_limits_motors_springs/scenes.h"
#include "pushback/common/world/measure.h"
#include "tests/support/catch.h"
#include "tests/support/complaint.h"
#include "tests/support/joint_jacobian.h"
#include "tests/support/yardstick.h"

using namespace pushback;
using namespace pushback::limits_motors_springs_scenes;

namespace {

/// Two bodies somewhere, turned anyhow.
World two_anywhere(Random& random) {
  World world;
  world.gravity.setZero();
  world.add(random.moving_body(2));
  world.add(random.moving_body(3));
  return world;
}
/// What C is, also where it is not fed back but left to be reached: b = C / h.
Real c_of_limit(const Equation& row, Real dt) {
  return row.error + dt * row.bias;
}

/// Each of the twelve entries of J against C where the bodies have moved a little that way.
/// (8 (C(t) - C(-t)) - (C(2t) - C(-2t))) / 12t.
template <class C>
void check_twelve_directions(const Body& a, const Body& b, const Equation& row, const C& c) {
  const Real t = std::pow(eps, Real(0.2));
  for (int direction = 0; direction < 12; ++direction) {
    Body first = a, second = b;
    for (Body* body : {&first, &second}) body->moving(Vec3::Zero()).spinning(Vec3::Zero());
    Body& moved = direction < 6 ? first : second;
    (direction % 6 < 3 ? moved.velocity : moved.angular_velocity)[direction % 3] = 1;
    const auto at = [&](Real when) { return c(drifted(first, when), drifted(second, when)); };
    const Real rate = (8 * (at(t) - at(-t)) - (at(2 * t) - at(-2 * t))) / (12 * t);
    CAPTURE(direction);
    REQUIRE(std::abs(rate_of(row, first, second) - rate) < Real(2e-8) * std::max(Real(1), std::abs(rate)));
  }
}

/// A wheel of `inertia` kg m^2 on a hinge about z, body 0.
World a_wheel(Real inertia) {
  World world;
  world.gravity.setZero();
  world.add(sphere(1, inertia / Real(0.4)));
  world.joints.push_back(hinge(world, the_world, 0, Vec3::Zero(), Vec3::UnitZ()));
  return world;
}
Real turn_of(const Body& body) {
  return 2 * std::atan2(body.orientation.z(), body.orientation.w());
}

/// A chain of small balls with the inertia of large ones, so that none touches another: on hinges and sockets, with every
/// limit there is, thrown about.
World limited_chain(Random& random) {
  World world;
  world.gravity.setZero();
  Vec3 end = Vec3::Zero();
  for (int link = 0; link < 4; ++link) {
    const Vec3 next = end + random.direction(), axis = random.direction();
    const Real mass = random.between(1, 3);
    const Vec3 spin = random.vector(3);
    world.add(sphere(Real(0.05), mass).at((end + next) / 2).moving(random.vector(3)).spinning(spin));
    world.bodies.back().principal_inverse_inertia /= 100;
    world.bodies.back().refresh_inertia();
    const Real low = random.between(-1, 0), high = random.between(0, 1);
    if (link % 2 == 0) {
      world.joints.push_back(hinge(world, link - 1, link, end, axis));
      world.joints.push_back(angle_limits(world, link - 1, link, axis, low, high));
    } else {
      world.joints.push_back(ball_and_socket(world, link - 1, link, end));
      world.joints.push_back(cone_limit(world, link - 1, link, axis, axis, random.between(Real(0.2), 1)));
      world.joints.push_back(twist_limits(world, link - 1, link, axis, low, high));
    }
    end = next;
  }
  return world;
}
bool is_limit(const Joint& joint) {
  return joint.name.find("limit") != std::string::npos;
}

}  // namespace

TEST_CASE("every Jacobian is the derivative of its C in all twelve directions, on the joint and off it") {
  Random random(2);
  int swung = 0;
  for (int i = 0; i < 200; ++i) {
    const World world = two_anywhere(random);
    const Vec3 axis = random.direction(), other = random.direction(), tilted = (axis + other / 2).normalized();
    const Real at = random.between(-1, 1), low = random.between(-1, 0), high = random.between(0, 1);
    const Real off = i % 2 == 0 ? 0 : random.between(Real(-0.7), Real(0.7));
    Body a = world.bodies[0], b = world.bodies[1];
    const Vec3 p_a = random.direction(), p_b = p_a + 6 * random.direction();
    std::vector<Joint> joints{angle_limits(world, 0, 1, axis, low, high), twist_limits(world, 0, 1, axis, low, high),
                              motor_to_angle(
                                  world, 0, 1, axis, [](Real) { return Real(0.2); }, 1),
                              piston(world, 0, p_a, 1, p_b, [](Real) { return Real(4); })};
    const Joint cone = cone_limit(world, 0, 1, axis, tilted, random.between(Real(0.2), 2));
    b.turned(at, axis).turned(off, other);
    if (off == 0) {
      CHECK(std::abs(HingeAngle(world, 0, 1, axis).of(a, b).value - at) < Real(1e-13));
      CHECK(std::abs(TwistAngle(world, 0, 1, axis).of(a, b).value - at) < Real(1e-13));
    }
    const Vec3 s = a.orientation * (world.bodies[0].orientation.conjugate() * axis),
               u = b.orientation * (world.bodies[1].orientation.conjugate() * tilted);
    if (s.cross(u).norm() > Real(0.1)) {  // a kink is at 0 and at pi
      joints.push_back(cone);
      ++swung;
    }
    for (const Joint& joint : joints) {
      const Equations now = asked_by(joint, a, b);
      for (std::size_t row = 0; row < now.size(); ++row) {
        CAPTURE(joint.name, row, off);
        check_twelve_directions(a, b, now[row], [&](const Body& p, const Body& q) {
          const Equation there = asked_by(joint, p, q)[row];
          return joint.driven ? there.error : c_of_limit(there, h);
        });
      }
    }
  }
  CHECK(swung > 150);
}

TEST_CASE("a wound rope's row is the derivative of what is left of it, however wheel and load are turned and moved") {
  Random random(3);
  for (int i = 0; i < 200; ++i) {
    const World world = two_anywhere(random);
    const Body &wheel = world.bodies[0], &load = world.bodies[1];
    const Vec3 centre = wheel.position + random.vector(Real(0.3)), axis = random.direction();
    const Tangents across = tangents_of(axis);
    const Real far = random.between(1, 3), aside = random.between(-1, 1);  // also out of the wheel's plane
    const Joint rope =
        wound_rope(world, 0, centre, axis, Real(0.4), i % 2 == 0 ? Winding::forwards : Winding::backwards, 1,
                   centre + far * across.tangent1 + aside * axis);
    const Equation now = asked_by(rope, wheel, load)[0];
    CHECK(std::abs(c_of_limit(now, h)) < Real(1e-14));  // taut as it was made
    check_twelve_directions(wheel, load, now,
                            [&](const Body& p, const Body& q) { return c_of_limit(asked_by(rope, p, q)[0], h); });
  }
}

TEST_CASE("what the clock brings is the mean of -f' over the step") {
  const World world = a_wheel(1);
  const auto f = [](Real t) { return std::sin(3 * t); };
  const Real t = Real(0.7), mean = -(f(t + h) - f(t)) / h;
  const Joint motor = motor_to_angle(world, the_world, 0, Vec3::UnitZ(), f, 7);
  const Equation row = asked_by(motor, body_of(world, the_world), world.bodies[0], {t, h})[0];
  CHECK(std::abs(row.bias - mean) < Real(1e-12));
  CHECK(std::abs(row.error + f(t)) < Real(1e-14));
  CHECK(row.lo == -7);
  CHECK(row.hi == 7);
  CHECK(motor.driven);
  const auto length = [&](Real when) { return 2 + f(when); };
  const Joint rod = piston(world, the_world, {0, 3, 0}, 0, {0, 1, 0}, length);
  const Equation pushed = asked_by(rod, body_of(world, the_world), world.bodies[0], {t, h})[0];
  CHECK(std::abs(pushed.bias - mean) < Real(1e-12));
  CHECK(std::abs(pushed.error + f(t)) < Real(1e-14));
  CHECK(rod.driven);
}

TEST_CASE("a limit lets through what does not reach it, stops what does exactly there, and lets it go again") {
  World world = a_wheel(2);
  world.joints.push_back(angle_limits(world, the_world, 0, Vec3::UnitZ(), -1, Real(0.5)));
  world.bodies[0].spinning({0, 0, 2});
  Solver<Joints, Clamping> solver;
  for (int step = 1; step <= 14; ++step) {  // 14 steps of 2/60 rad are 0.467
    world.step(solver, h);
    CHECK(world.bodies[0].angular_velocity.z() == 2);
  }
  world.step(solver, h);
  CHECK(std::abs(turn_of(world.bodies[0]) - Real(0.5)) < Real(1e-3));  // the turn of a step is a little less than h w
  for (int step = 0; step < 100; ++step) world.step(solver, h);
  CHECK(std::abs(turn_of(world.bodies[0]) - Real(0.5)) < Real(1e-12));
  world.bodies[0].spinning({0, 0, Real(-0.5)});
  world.step(solver, h);
  CHECK(world.bodies[0].angular_velocity.z() == Real(-0.5));  // it does not suck
  CHECK(solver.joint_rows().back().impulse == 0);
}

TEST_CASE("limits may be wider than half a turn, and lie anywhere: angles are seen from their middle") {
  World world = a_wheel(2);
  world.joints.push_back(angle_limits(world, the_world, 0, Vec3::UnitZ(), Real(-0.1), 5));
  Solver<Joints, Clamping> solver;
  Real turned = 0;
  for (const Real end : {Real(5), Real(-0.1)}) {
    world.bodies[0].spinning({0, 0, end > 0 ? Real(2) : Real(-2)});
    for (int step = 0; step < 240; ++step) {
      world.step(solver, h);
      turned += 2 * std::atan(h * world.bodies[0].angular_velocity.z() / 2);
    }
    CHECK(std::abs(turned - end) < Real(1e-12));
  }
}

TEST_CASE("limits push and never pull, whatever moves, and are kept") {
  Random random(4);
  Real beyond = 0, largest_impulse = 0;
  for (int i = 0; i < 30; ++i) {
    World world = limited_chain(random);
    world.gravity = {0, -g, 0};
    JointedSolver solver;
    for (int step = 0; step < 400; ++step) {
      world.step(solver, h / 2, 30);
      for (const Row& row : solver.joint_rows()) {
        if (!is_limit(world.joints[row.owner])) continue;
        REQUIRE(row.impulse >= 0);
        largest_impulse = std::max(largest_impulse, row.impulse);
      }
      for (const Joint& joint : world.joints) {
        if (!is_limit(joint)) continue;
        for (const Equation& row : asked_by(joint, body_of(world, joint.a), body_of(world, joint.b), {0, h / 2}))
          beyond = std::max(beyond, -c_of_limit(row, h / 2));
      }
    }
  }
  CAPTURE(beyond, largest_impulse);
  CHECK(largest_impulse > 1);
  CHECK(beyond < Real(0.1));
}

TEST_CASE("limits never add energy, at any number of sweeps, as long as nothing is fed back") {
  // Each row that starts from nothing changes the energy by -lambda b - lambda^2 K / 2 or less, and lambda b >= 0. The links
  // are balls, so that turning changes no energy.
  Random random(5);
  Real lost = 0;
  for (int i = 0; i < 60; ++i) {
    World world = limited_chain(random);
    Solver<Joints, Clamping> solver;
    solver.beta = 0;
    Real before = kinetic_energy(world);
    const Real start = before;
    for (int step = 0; step < 100; ++step) {
      world.step(solver, h, 1 + i % 5);
      const Real after = kinetic_energy(world);
      REQUIRE(after <= before * (1 + Real(1e-13)));
      before = after;
    }
    lost = std::max(lost, 1 - before / start);
  }
  CHECK(lost > Real(0.1));
}

TEST_CASE("a hinge or a socket that was broken beyond its limits comes back, from any side, and nothing is NaN") {
  for (const Real angle : {Real(1e-9), Real(0.3), Real(1.5), Real(3.1), pi, Real(-3.1), Real(-1.5)}) {
    for (int which = 0; which < 3; ++which) {
      World world;
      world.gravity.setZero();
      world.add(sphere(Real(0.5), 3));
      const Vec3 z = Vec3::UnitZ();
      world.joints.push_back(which == 0 ? hinge(world, the_world, 0, Vec3::Zero(), z)
                                        : ball_and_socket(world, the_world, 0, Vec3::Zero()));
      world.joints.push_back(which == 0   ? angle_limits(world, the_world, 0, z, Real(-0.2), Real(0.2))
                             : which == 1 ? cone_limit(world, the_world, 0, z, z, Real(0.2))
                                          : twist_limits(world, the_world, 0, z, Real(-0.2), Real(0.2)));
      world.bodies[0].turned(angle, which == 1 ? Vec3::UnitX() : z);
      if (which == 2) world.bodies[0].turned(pi, Vec3::UnitX());  // where a twist is not known
      JointedSolver solver;
      for (int step = 0; step < 300; ++step) world.step(solver, h);
      CAPTURE(angle, which);
      for (const Equation& row : asked_by(world.joints[1], body_of(world, the_world), world.bodies[0]))
        CHECK(c_of_limit(row, h) > Real(-1e-3));
      CHECK(world.bodies[0].orientation.coeffs().allFinite());
    }
  }
}

TEST_CASE("a motor reaches its speed by its torque, and its impulse is h times it until then") {
  const Real inertia = 5, torque = 5, speed = 2;
  World world = a_wheel(inertia);
  world.joints.push_back(motor_at_speed(world, the_world, 0, Vec3::UnitZ(), speed, torque));
  JointedSolver solver;
  for (int step = 1; step <= 200; ++step) {
    world.step(solver, h);
    const Real gained = static_cast<Real>(step) * h * torque / inertia;
    CHECK(std::abs(world.bodies[0].angular_velocity.z() - std::min(gained, speed)) < Real(1e-12));
    if (gained < speed - h) CHECK(solver.joint_rows().back().impulse == h * torque);
  }
}

TEST_CASE("a brake holds a load just below its torque, and slips at exactly its torque just above") {
  const Real radius = Real(0.25), mass = 2, load = mass * g * radius;
  for (const Real part : {Real(1.001), Real(0.999)}) {
    World world;
    const int wheel = wheel_at(world, {0, 3, 0}, radius, 10);
    hang(world, wheel, radius, 1, mass, Real(1.4), 0);
    const Real torque = part * load;
    world.joints.push_back(motor_at_speed(world, the_world, wheel, Vec3::UnitZ(), 0, torque));
    JointedSolver solver;
    for (int step = 0; step < 120; ++step) {
      world.step(solver, h, 100);
      const Real impulse = solver.joint_rows().back().impulse;
      if (part > 1) CHECK(std::abs(impulse - h * load) < Real(1e-6));
      if (part < 1) CHECK(impulse == h * torque);
    }
    const Real inertia = inertia_of_disc(world.bodies[0]);
    const Real sinks = part > 1 ? 0 : radius * (load - torque) / (inertia + mass * radius * radius);
    CHECK(std::abs(-world.bodies[1].velocity.y() - 120 * h * sinks) < Real(1e-6));
  }
}

TEST_CASE("theta follows sin t as long as the torque suffices: to what the sweeps leave, not to what the step is") {
  for (const Real dt : {h, 3 * h}) {
    World world = a_wheel(9);
    world.bodies[0].spinning({0, 0, 1});
    world.joints.push_back(motor_to_angle(world, the_world, 0, Vec3::UnitZ(), [](Real t) { return std::sin(t); }, 10));
    JointedSolver solver;
    Real worst = 0, hardest = 0;
    for (Real t = dt; t < 10; t += dt) {
      world.step(solver, dt);
      worst = std::max(worst, std::abs(turn_of(world.bodies[0]) - std::sin(world.time)));
      hardest = std::max(hardest, std::abs(solver.joint_rows().back().impulse) / dt);
    }
    CAPTURE(dt, worst, hardest);
    // A step turns by 2 atan(h w / 2), h^3 w^3 / 12 less than h w; each leaves the part 1 - beta of what the last one left.
    CHECK(worst < dt * dt * dt / 12 / Real(0.2) * Real(1.1));
    CHECK(std::abs(hardest - 9) < Real(0.1));
  }
}

TEST_CASE("the work of a winch's motor is the energy that it gives") {
  World world;
  winch(world, 0, light_load);
  const auto energy = [&] { return kinetic_energy(world) + potential_energy(world); };
  const Real start = energy();
  Real by_motor = 0, by_others = 0;
  JointedSolver solver;
  for (int step = 0; step < 120; ++step) {
    world.step(solver, h, 100);
    for (const Row& row : solver.joint_rows()) {
      const Real after = row.speed();
      Body first = *row.a, second = *row.b;
      for (Body* body : {&first, &second}) body->moving(body->velocity_before).spinning(body->angular_velocity_before);
      Row before = row;
      before.a = &first;
      before.b = &second;
      const Real work = row.impulse * (before.speed() + after) / 2;
      (world.joints[row.owner].driven ? by_motor : by_others) += work;
    }
  }
  const Real v = world.bodies[1].velocity.y();
  const Real turn = 2 * std::atan(h * winch_speed / 2);  // of a step, as World::move has it; the rope follows the angle
  CHECK(std::abs(v - turn * winch_radius / h) < Real(1e-6));
  // By its mean speeds, gravity does m g h v / 2 less than the heights say: symplectic Euler moves by the later speed.
  CHECK(std::abs(energy() - start - by_motor - by_others - light_load * g * h * v / 2) < Real(1e-8));
  CHECK(by_motor > 13);
  CHECK(std::abs(by_others) <
        light_load * g * 2 * (winch_speed * winch_radius - v));  // the rope, as long as it was slow
}

TEST_CASE("a piston is as long as it is told, and no stronger than it is said to be") {
  World world;
  world.gravity.setZero();
  world.add(sphere(Real(0.1), 2).at({2, 0, 0}));
  const auto length = [](Real t) { return 2 + Real(0.5) * std::sin(4 * t); };
  world.joints.push_back(piston(world, the_world, Vec3::Zero(), 0, {2, 0, 0}, length));
  Solver<Joints, Clamping> solver;
  for (int step = 0; step < 200; ++step) {
    world.step(solver, h);
    REQUIRE(std::abs(world.bodies[0].position.x() - length(world.time)) < Real(1e-13));
  }
  world.joints = {piston(world, the_world, Vec3::Zero(), 0, world.bodies[0].position, [](Real) { return 9; }, 3)};
  const Real before = world.bodies[0].velocity.x();
  world.step(solver, h);
  CHECK(std::abs(world.bodies[0].velocity.x() - before - h * 3 / 2) < Real(1e-13));
}

TEST_CASE("a pumped swing grows as Mathieu's equation says") {
  const Real pump = Real(0.02);
  World world;
  pumped_swing(world, pump);
  JointedSolver solver;
  Real reach = 0;
  const Real seconds = 40;
  for (int step = 0; step < static_cast<int>(seconds * 240); ++step) {
    world.step(solver, Real(1) / 240);
    if (world.time > seconds - 3) reach = std::max(reach, std::abs(angle_of_swing(world)));
  }
  const Real grown = std::exp(Real(0.75) * pump * swing_frequency * (seconds - Real(1.5)));
  CAPTURE(reach / swing_start, grown);
  CHECK(std::abs(reach / swing_start / grown - 1) < Real(0.1));
}

TEST_CASE("a spring follows the implicit recurrence to rounding, and its closed form to the order of the step") {
  const Real c0 = Real(0.6), w = 2 * pi;
  for (const Real zeta : {Real(0), Real(0.1), Real(1), Real(5)}) {
    Real last_error = 0;
    for (const int steps : {240, 480, 960}) {
      const Real dt = 1 / static_cast<Real>(steps);
      World world;
      world.gravity.setZero();
      world.add(sphere(Real(0.2), 3).at({2, 0, 0}));
      world.joints.push_back(soft(distance(world, the_world, Vec3::Zero(), 0, {2, 0, 0}, 2 - c0), Spring{1, zeta}));
      JointedSolver solver;
      Real x = c0, v = 0;
      for (int step = 0; step < steps; ++step) {
        world.step(solver, dt);
        v = (v - dt * w * w * x) / (1 + 2 * zeta * w * dt + dt * dt * w * w);  // -w^2 (x + h v) - 2 zeta w v
        x += dt * v;
        REQUIRE(std::abs(world.bodies[0].position.x() - (2 - c0) - x) < Real(1e-12));
      }
      const Real error = std::abs(x - let_go(c0, w, zeta, 1));
      if (last_error > 0 && zeta != 1) CHECK(std::abs(last_error / error - 2) < Real(0.15));
      if (last_error > 0 && zeta == 1) CHECK(last_error / error > Real(1.9));
      last_error = error;
    }
  }
}

TEST_CASE("a spring under a load rests where its force is the load's, and one that turns feels the inertia") {
  World world;
  world.add(sphere(Real(0.2), 3).at({0, -1, 0}));
  world.joints.push_back(soft(distance(world, the_world, Vec3::Zero(), 0, {0, -1, 0}), Spring{2, 1}));
  JointedSolver solver;
  for (int step = 0; step < 600; ++step) world.step(solver, h);
  CHECK(std::abs(-world.bodies[0].position.y() - 1 - g / (16 * pi * pi)) < Real(1e-12));

  World turning_world = a_wheel(7);
  turning_world.joints.push_back(torsion_spring(turning_world, the_world, 0, Vec3::UnitZ(), Spring{1, Real(0.2)}));
  turning_world.bodies[0].turned(Real(0.5), Vec3::UnitZ());
  const Real w = 2 * pi;
  Real x = Real(0.5), v = 0;
  for (int step = 0; step < 100; ++step) {
    turning_world.step(solver, h);
    v = (v - h * w * w * x) / (1 + 2 * Real(0.2) * w * h + h * h * w * w);
    x += 2 * std::atan(h * v / 2);  // the turn of a step
    REQUIRE(std::abs(turn_of(turning_world.bodies[0]) - x) < Real(1e-12));
  }
}

TEST_CASE("a rope on a wheel is counted over whole turns, gives the same answer twice, and only pulls") {
  World world;
  const Real radius = Real(0.1);
  const int wheel = wheel_at(world, {0, 3, 0}, radius, 10);
  hang(world, wheel, radius, 1, 1, 2, 0);
  world.joints.push_back(motor_at_speed(world, the_world, wheel, Vec3::UnitZ(), 4, 100));
  const Real start = world.bodies[1].position.y();
  JointedSolver solver;
  Real turned = 0;
  for (int step = 0; step < 240; ++step) {
    world.step(solver, h, 50);
    turned += 2 * std::atan(h * world.bodies[0].angular_velocity.z() / 2);
    const Equation once = asked_by(world.joints[1], world.bodies[0], world.bodies[1])[0],
                   again = asked_by(world.joints[1], world.bodies[0], world.bodies[1])[0];
    REQUIRE(once.error == again.error);
    REQUIRE(once.bias == again.bias);
  }
  CHECK(turned > 5 * pi);
  CHECK(std::abs(world.bodies[1].position.y() - start - radius * turned) < Real(1e-4));

  world.joints.pop_back();
  world.bodies[1].moving({0, 3, 0});  // thrown up: the rope is slack
  for (Joint& joint : world.joints) joint.impulses.clear();
  const Real spin = world.bodies[0].angular_velocity.z();
  world.step(solver, h);
  CHECK(solver.joint_rows().back().impulse == 0);
  CHECK(std::abs(world.bodies[0].angular_velocity.z() - spin) < Real(1e-12));
}

TEST_CASE("a rope between a free wheel and a load keeps momentum and angular momentum") {
  World world;
  world.gravity.setZero();
  const int wheel = world.add(disc(Real(0.5), Real(0.1), 4).spinning({0, 0, 6}));
  const int load = world.add(box(Vec3::Constant(Real(0.2)), 2).at({Real(0.6), -2, Real(0.1)}).moving({1, -1, 0}));
  world.joints.push_back(wound_rope(world, wheel, Vec3::Zero(), Vec3::UnitZ(), Real(0.5), Winding::forwards, load,
                                    {Real(0.6), Real(-1.8), Real(0.1)}));
  const Vec3 p = momentum(world), l = angular_momentum(world);
  JointedSolver solver;
  Real pulled = 0;
  for (int step = 0; step < 60; ++step) {
    world.step(solver, h);
    pulled += solver.joint_rows().back().impulse;
  }
  CHECK(pulled > 1);
  CHECK((momentum(world) - p).norm() < Real(1e-12));
  CHECK((angular_momentum(world) - l).norm() < Real(1e-12));
}

TEST_CASE("limits, motors, springs and ropes that cannot be are refused, by name") {
  World world;
  world.add(sphere(Real(0.5), 1));
  world.add(sphere(Real(0.5), 1).at({2, 0, 0}));
  const Real nan = std::numeric_limits<Real>::quiet_NaN();
  const Vec3 z = Vec3::UnitZ(), o = Vec3::Zero(), p{2, 0, 0};
  const auto one = [](Real) { return Real(1); };
  const auto rope = [&](Real radius, const Vec3& to) {
    return [&world, radius, to, z, o] { wound_rope(world, 0, o, z, radius, Winding::forwards, 1, to); };
  };
  const std::vector<std::pair<std::string, std::function<void()>>> refused{
      {"limits of angle limits are 0.5 and -0.5: the lower one", [&] { angle_limits(world, 0, 1, z, 0.5, -0.5); }},
      {"limits of twist limits are -4 and 4: they have to be less than", [&] { twist_limits(world, 0, 1, z, -4, 4); }},
      {"lower limit of angle limits is nan", [&] { angle_limits(world, 0, 1, z, nan, 1); }},
      {"length of the axis of angle limits is 0", [&] { angle_limits(world, 0, 1, o, 0, 1); }},
      {"axis of twist limits is (nan, 0, 0)", [&] { twist_limits(world, 0, 1, {nan, 0, 0}, 0, 1); }},
      {"angle of a cone limit is 0", [&] { cone_limit(world, 0, 1, z, z, 0); }},
      {"angle of a cone limit is 4: a number from", [&] { cone_limit(world, 0, 1, z, z, 4); }},
      {"a cone limit joins body 0 to itself", [&] { cone_limit(world, 0, 0, z, z, 1); }},
      {"torque of a motor is -5", [&] { motor_at_speed(world, 0, 1, z, 2, -5); }},
      {"speed of a motor is nan", [&] { motor_at_speed(world, 0, 1, z, nan, 5); }},
      {"torque of a motor is nan", [&] { motor_to_angle(world, 0, 1, z, one, nan); }},
      {"a motor has no angle to reach: a function of time", [&] { motor_to_angle(world, 0, 1, z, {}, 1); }},
      {"a piston has no length: a function of time", [&] { piston(world, 0, o, 1, p, {}); }},
      {"length of a piston is -1", [&] { piston(world, 0, o, 1, p, [](Real) { return Real(-1); }); }},
      {"force of a piston is -3: 0 or more", [&] { piston(world, 0, o, 1, p, one, -3); }},
      {"hertz of a distance with a spring is 0", [&] { soft(distance(world, 0, o, 1, p), {0, 1}); }},
      {"damping ratio of a torsion with a spring is -1", [&] { torsion_spring(world, 0, 1, z, {1, -1}); }},
      {"radius of a wound rope is 0", rope(0, p)},
      {"a wound rope of radius 3 hangs from a point inside of the wheel", rope(3, p)},
      {"point of a wound rope is (0, nan, 0)", rope(1, {0, nan, 0})}};
  for (const auto& [said, act] : refused) {
    INFO(said);
    CHECK(complaint(act).starts_with(said));
  }

  world.joints.push_back(motor_to_angle(world, the_world, 0, z, [&](Real t) { return t > Real(0.05) ? nan : t; }, 1));
  JointedSolver solver;
  CHECK(complaint([&] {
          for (int step = 0; step < 10; ++step) world.step(solver, h);
        }) == "angle that a motor is to reach is nan: a finite number is needed");
}
