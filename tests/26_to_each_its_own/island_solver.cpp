/// Chapter 26: each island by its own step. What is exact, what is kept, and what one island does to another: nothing.
#include "pushback/engine/islands/island_solver.h"

#include <bit>
#include <numeric>

#include "pushback/chapters/13_joints/ball_and_socket.h"
#include "pushback/chapters/15_limits_motors_springs/limits.h"
#include "pushback/chapters/24_half_step/study.h"
#include "pushback/chapters/26_to_each_its_own/scenes.h"
#include "pushback/common/bodies/random.h"
#include "pushback/common/world/measure.h"
#include "pushback/common/world/situations.h"
#include "tests/26_to_each_its_own/falling_heap.h"
#include "tests/support/catch.h"
#include "tests/support/complaint.h"
#include "tests/support/yardstick.h"

using namespace pushback;
using to_each_its_own_tests::falling_heap;

namespace {

/// The largest error of a motion of chapter 19, m.
Real error_by_island(const std::string& name) {
  const Motion& motion = motion_named(name);
  IslandSolver solver;
  solver.substep_solver.threshold = solver.contact_half_step.threshold = 0;
  return half_step_scenes::largest_error(motion, motion.truth(motion.frames()), solver);
}
/// Few contacts have half steps, many have not.
IslandSolver without_savings() {
  IslandSolver solver;
  solver.budget.at_first = solver.budget.fraction = 0;
  return solver;
}
auto bits(Real number) {
  return std::bit_cast<std::conditional_t<in_double, std::uint64_t, std::uint32_t>>(number);
}
/// Where a body is and how it moves, to the bit.
std::vector<std::uint64_t> state_of(const Body& body) {
  std::vector<std::uint64_t> found;
  for (const Vec3& v : {body.position, body.velocity, body.angular_velocity})
    for (int axis = 0; axis < 3; ++axis) found.push_back(bits(v[axis]));
  for (int i = 0; i < 4; ++i) found.push_back(bits(body.orientation.coeffs()[i]));
  return found;
}
/// The same of all bodies, and what contacts and joints bear.
std::vector<std::uint64_t> state_of(const World& world) {
  std::vector<std::uint64_t> found{hash_of(world), world.contacts.size()};
  for (const Contact& contact : world.contacts) {
    for (const std::uint32_t part : {contact.id.body_a, contact.id.body_b, contact.id.feature}) found.push_back(part);
    for (const Vec3& v : {contact.impulse, contact.last_impulse})
      for (int axis = 0; axis < 3; ++axis) found.push_back(bits(v[axis]));
  }
  for (const Joint& joint : world.joints)
    for (const Real impulse : joint.last_impulses) found.push_back(bits(impulse));
  return found;
}

/// One island, or one that comes apart, beside x = `at`.
struct Part {
  const char* name;
  void (*add)(World& world, Real at);
};
const Part parts[] = {
    {"a stack of ten",
     [](World& world, Real at) {
       for (int i = 0; i < 10; ++i)
         world.add(box(Vec3::Constant(Real(0.5)), 100).at({at, Real(0.5) + static_cast<Real>(i), 0}));
     }},
    {"a pendulum",
     [](World& world, Real at) {
       const int ball = world.add(sphere(Real(0.3), 10).at({at + 2, 5, 0}));
       world.joints.push_back(ball_and_socket(world, the_world, ball, {at, 5, 0}));
     }},
    {"a ball that bounces",
     [](World& world, Real at) { world.add(sphere(Real(0.5), 10).at({at, Real(0.8), 0}).bouncy(Real(0.8))); }},
    {"a box that slides",
     [](World& world, Real at) {
       world.add(box({Real(0.5), Real(0.2), Real(0.5)}, 100).at({at, Real(0.2), 0}).moving({2, 0, 1}));
     }},
    {"a chain that whips", [](World& world, Real at) { to_each_its_own_scenes::Chain{.pin = {at, 10, 0}}(world); }},
    {"a heavy box on a light one",
     [](World& world, Real at) {
       world.add(box(Vec3::Constant(Real(0.5)), 1).at({at, Real(0.5), 0}));
       world.add(box(Vec3::Constant(Real(0.5)), 100).at({at, Real(1.5), 0}));
     }},
    {"a pendulum that meets a wall",
     [](World& world, Real at) {
       world.add(box({Real(0.2), 1, 1}, 1).fixed().at({at + 1, 5, 0}));
       const int ball = world.add(sphere(Real(0.3), 10).at({at - 2, 6, 0}).bouncy(Real(0.6)));
       world.joints.push_back(ball_and_socket(world, the_world, ball, {at, 6, 0}));
     }},
    {"a bar with a limit", [](World& world, Real at) {  // by substeps
       const int bar = world.add(box({1, Real(0.1), Real(0.1)}, 10).at({at + 1, 5, 0}));
       world.joints.push_back(ball_and_socket(world, the_world, bar, {at, 5, 0}));
       world.joints.push_back(angle_limits(world, the_world, bar, Vec3::UnitZ(), Real(-0.5), Real(0.5)));
     }}};

}  // namespace

TEST_CASE("by island: the ten motions are as exact as the steps that they call for") {
  CHECK(error_by_island("bounce") < (in_double ? 1e-12 : 1e-3));
  CHECK(error_by_island("incline") < (in_double ? 1e-11 : 1e-3));
  CHECK(error_by_island("sliding") < (in_double ? 1e-5 : 1e-3));
  CHECK(error_by_island("rolling") < (in_double ? 1.1e-6 : 1e-3));
  CHECK(error_by_island("pendulum") < (in_double ? 6e-5 : 1e-3));
  CHECK(error_by_island("heavy-on-light") < (in_double ? 1e-12 : 1e-3));
  CHECK(error_by_island("chain") < (in_double ? 3e-4 : 1e-3));
  CHECK(error_by_island("break") < (in_double ? 1e-9 : 1e-2));
  for (const char* name : {"stack-10", "pyramid-10"}) CHECK(error_by_island(name) < (in_double ? 1e-12 : 1e-3));
}

TEST_CASE("by island: the page's two lines") {
  World world;
  world.add(ground());
  world.add(sphere(Real(0.5), 1).at({0, 5, 0}));
  IslandSolver solver;
  world.step(solver, 1.0 / 60);
  CHECK(solver.step_of(0) == StepType::none);
  CHECK(solver.step_of(1) == StepType::flight);
  CHECK(solver.step_of(2) == StepType::none);
}

TEST_CASE("by island: what flies is on its parabola, and keeps its angular momentum and the energy of its spin") {
  World world;
  const Vec3 from{1, 2, 3}, thrown{3, 9, -2};
  world.add(box({1, Real(0.5), Real(0.2)}, 10).at(from).moving(thrown).spinning({1, 4, 2}));
  const Vec3 spin = spin_momentum(world.bodies[0]);
  const auto energy_of_spin = [&] { return world.bodies[0].angular_velocity.dot(spin_momentum(world.bodies[0])) / 2; };
  const Real begin = energy_of_spin();
  Real off = 0;
  IslandSolver solver;
  for (int i = 1; i <= 180; ++i) {
    world.step(solver, h);
    REQUIRE(solver.step_of(0) == StepType::flight);
    const Real t = static_cast<Real>(i) * h;
    const Body& body = world.bodies[0];
    CHECK((body.position - (from + t * thrown + t * t / 2 * world.gravity)).norm() < 1000 * eps * 60);
    CHECK((body.velocity - (thrown + t * world.gravity)).norm() < 1000 * eps * 30);
    CHECK((spin_momentum(body) - spin).norm() < 1000 * eps * spin.norm());
    off = std::max(off, std::abs(energy_of_spin() / begin - 1));
  }
  CHECK(off < 1e-3);  // of the turn's second order, and it does not grow
}

TEST_CASE("by island: an island moves in the same bits whatever other islands there are, in whatever order") {
  constexpr int steps = 120;
  const auto place = [](std::size_t part) { return 20 * static_cast<Real>(part); };
  std::vector<std::vector<std::vector<std::uint64_t>>> alone;  // of each part, each body
  for (std::size_t i = 0; i < std::size(parts); ++i) {
    World world;
    world.add(ground());
    parts[i].add(world, place(i));
    IslandSolver solver;
    for (int step = 0; step < steps; ++step) world.step(solver, h);
    auto& states = alone.emplace_back();
    for (std::size_t body = 1; body < world.bodies.size(); ++body) states.push_back(state_of(world.bodies[body]));
  }
  Random random(26);
  std::vector<std::size_t> order(std::size(parts));
  std::iota(order.begin(), order.end(), 0);
  for (int round = 0; round < 4; ++round) {
    World world;
    world.add(ground());
    std::vector<std::size_t> begins;
    const std::size_t count = round == 0 ? order.size() : 2 + random.below(std::size(parts) - 1);
    for (std::size_t k = 0; k < count; ++k) {
      begins.push_back(world.bodies.size());
      parts[order[k]].add(world, place(order[k]));
    }
    IslandSolver solver;
    for (int step = 0; step < steps; ++step) world.step(solver, h);
    for (std::size_t k = 0; k < count; ++k)
      for (std::size_t body = 0; body < alone[order[k]].size(); ++body) {
        INFO(parts[order[k]].name << " in round " << round << ", its body " << body);
        CHECK(state_of(world.bodies[begins[k] + body]) == alone[order[k]][body]);
      }
    random.shuffle(order);
  }
}

TEST_CASE("by island: two that meet become one, and part again, with momentum and angular momentum kept") {
  World world;
  world.gravity.setZero();
  world.add(box(Vec3::Constant(Real(0.5)), 1).at({-2, 0, 0}).moving({2, 0, 0}).bouncy(Real(0.5)));
  world.add(box(Vec3::Constant(Real(0.5)), 3).at({2, Real(0.3), Real(0.1)}).moving({-2, 0, 0}).bouncy(Real(0.5)));
  const Vec3 p = momentum(world), l = angular_momentum(world);
  const Real before = kinetic_energy(world);
  IslandSolver solver;
  std::vector<StepType> seen;
  for (int i = 0; i < 120; ++i) {
    world.step(solver, h);
    CHECK(solver.step_of(0) == solver.step_of(1));
    if (seen.empty() || seen.back() != solver.step_of(0)) seen.push_back(solver.step_of(0));
  }
  CHECK(seen == std::vector{StepType::flight, StepType::half_steps, StepType::flight});
  CHECK((momentum(world) - p).norm() < 1000 * eps);
  CHECK((angular_momentum(world) - l).norm() < 10000 * eps);
  CHECK(kinetic_energy(world) < before);
}

TEST_CASE("by island: one that bounces comes upon another within the step, and does not pass through it") {
  World world;
  world.gravity.setZero();
  world.add(box({Real(0.5), 2, 2}, 1).fixed().at({Real(-0.5), 0, 0}).rough(0));
  world.add(sphere(Real(0.1), 1).at({Real(0.11), 0, 0}).moving({-6, 0, 0}).bouncy(1).rough(0));
  world.add(sphere(Real(0.1), 1).at({Real(0.34), 0, 0}).moving({-6, 0, 0}).bouncy(1).rough(0));  // beyond the margin
  IslandSolver solver;
  for (int i = 0; i < 10; ++i) {
    world.step(solver, h);
    CHECK(world.bodies[2].position.x() - world.bodies[1].position.x() > Real(0.2) - 100 * eps);
  }
  // Equal balls pass on their velocities. So centres are where they would be if both went through each other, the second's less by
  // a diameter: 10 h 6 = 1 m of way, of which 0.01 and 0.04 lead to the wall, where a centre is at 0.1.
  CHECK(world.bodies[1].position.x() == Approx(Real(0.1) + 1 - Real(0.04)).epsilon(1e-6));
  CHECK(world.bodies[2].position.x() == Approx(Real(0.1) + 1 - Real(0.01) + Real(0.2)).epsilon(1e-6));
  for (const int ball : {1, 2}) CHECK(world.bodies[std::size_t(ball)].velocity.x() == Approx(6).epsilon(1e-6));
}

TEST_CASE("by island: joints come back in their order, with what they bore") {
  World world;  // two times a ball below a ball, at rest; the joints in no order
  const Real masses[] = {1, 20, 3, 7};
  for (const int body : {0, 1, 2, 3})
    world.add(
        sphere(Real(0.1), masses[body]).at({body < 2 ? Real(0) : Real(5), body % 2 == 0 ? Real(-1) : Real(-2), 0}));
  const auto join = [&world](const char* name, int a, int b, const Vec3& anchor) {
    world.joints.push_back(ball_and_socket(world, a, b, anchor));
    world.joints.back().name = name;
  };
  join("first, lower", 0, 1, {0, -1, 0});
  join("second, upper", the_world, 2, {5, 0, 0});
  join("second, lower", 2, 3, {5, -1, 0});
  join("first, upper", the_world, 0, {0, 0, 0});
  IslandSolver solver;
  for (int i = 0; i < 3; ++i) world.step(solver, h);
  const auto check = [&world](std::size_t place, const char* name, int a, int b, Real mass) {
    const Joint& joint = world.joints[place];
    CHECK(joint.name == name);
    CHECK(joint.a == a);
    CHECK(joint.b == b);
    REQUIRE(joint.impulses.size() == 3);
    CHECK(joint.impulses[1] == Approx(mass * g * h).epsilon(1e-5));
    CHECK(joint.last_impulses[1] == Approx(mass * g * world.dt_before).epsilon(1e-5));
  };
  check(0, "first, lower", 0, 1, 20);
  check(1, "second, upper", the_world, 2, 10);
  check(2, "second, lower", 2, 3, 7);
  check(3, "first, upper", the_world, 0, 21);
}

TEST_CASE("by island: what many alone has to move is moved as by many alone, to the bit") {
  const auto compare = [](const std::function<void(World&)>& fill) {
    World by_island, by_many;
    fill(by_island);
    fill(by_many);
    IslandSolver solver = without_savings();
    solver.limits.most_detections = 1;  // as `many` alone
    WideSolver<Real> many;
    for (int i = 0; i < 60; ++i) {
      by_island.step(solver, h);
      by_many.step(many, h);
      REQUIRE(state_of(by_island) == state_of(by_many));
    }
  };
  compare([](World& world) { stack(world, 10); });
  compare([](World& world) { pyramid(world, 5); });
  compare([](World& world) {
    pyramid(world, 4);
    const int bar = world.add(box({1, Real(0.1), Real(0.1)}, 10).at({21, 5, 0}));
    world.joints = {ball_and_socket(world, the_world, bar, {20, 5, 0}),
                    angle_limits(world, the_world, bar, Vec3::UnitZ(), Real(-0.5), Real(0.5))};
  });
}

TEST_CASE("by island: contacts are detected again where bodies tumble, so a heap that falls overlaps less") {
  const auto deepest = [](int most_detections) {
    World world = falling_heap();
    IslandSolver solver;
    solver.limits.most_detections = most_detections;
    Real most = 0;
    for (int i = 0; i < 120; ++i) {
      world.step(solver, h);
      World seen = world;
      seen.find_contacts();
      for (const Contact& contact : seen.contacts) most = std::max(most, contact.depth);
    }
    return most;
  };
  const Real once = deepest(1), again = deepest(4);
  UNSCOPED_INFO("mm, detected once and again: " << 1000 * once << ", " << 1000 * again);
  CHECK(again < once / 2);
  CHECK(again < Real(0.03));
}

TEST_CASE("by island: the end of a rod that spins meets what its middle never comes near, at its instant") {
  const auto energy_after = [](Real spin) {
    World world;
    world.gravity.setZero();
    world.add(box({Real(1.5), Real(0.05), Real(0.05)}, 10).spinning({0, 0, spin}).bouncy(1).rough(0));
    world.add(sphere(Real(0.1), 10).at({0, Real(1.45), 0}).bouncy(1).rough(0));
    const Real before = kinetic_energy(world);
    IslandSolver solver;
    while (world.bodies[1].velocity == Vec3::Zero() && world.time < 1) world.step(solver, h);
    CHECK(world.bodies[1].velocity.norm() > spin / 2);
    return kinetic_energy(world) / before;
  };
  for (const Real spin : {Real(10), Real(25), Real(60)}) CHECK(energy_after(spin) == Approx(1).epsilon(1e-6));
}

TEST_CASE("by island: settings that cannot be used are named, and nothing has changed") {
  const auto refused = [](const std::string& said, const std::function<void(IslandSolver&)>& change) {
    World world;
    stack(world, 2);
    world.bodies[1].velocity = {1, 0, 0};
    IslandSolver solver;
    change(solver);
    const auto before = state_of(world);
    const std::string words = complaint([&] { world.step(solver, h); });
    INFO(words);
    CHECK(words.starts_with(said));
    CHECK(state_of(world) == before);
  };
  refused("most is -1: a whole number, 0 or more", [](IslandSolver& s) { s.limits.most = -1; });
  refused("most_kept is 7: no less than most", [](IslandSolver& s) { s.limits.most_kept = 7; });
  refused("most_single_contacts is 3: no less than most", [](IslandSolver& s) { s.limits.most_single_contacts = 3; });
  refused("most_detections is 0", [](IslandSolver& s) { s.limits.most_detections = 0; });
  refused("fast_turn is 0", [](IslandSolver& s) { s.limits.fast_turn = 0; });
  refused("most_work is 0", [](IslandSolver& s) { s.contact_half_step.most_work = 0; });
  refused("energy is 0", [](IslandSolver& s) { s.energy = 0; });
  refused("energy is nan", [](IslandSolver& s) { s.energy = std::numeric_limits<Real>::quiet_NaN(); });
  refused("most_half_steps is 3: no less than joint_half_step.substeps",
          [](IslandSolver& s) { s.most_half_steps = 3; });
  refused("substeps is 0", [](IslandSolver& s) { s.contact_half_step.substeps = 0; });
  refused("tolerance", [](IslandSolver& s) { s.joint_half_step.tolerance = 0; });
  refused("margin is -1", [](IslandSolver& s) { s.substep_solver.margin = -1; });
  for (const auto& [name, setting] :
       {std::pair<std::string, double WorkBudgetSettings::*>{"per_contact", &WorkBudgetSettings::per_contact},
        {"fraction", &WorkBudgetSettings::fraction},
        {"at_first", &WorkBudgetSettings::at_first},
        {"most", &WorkBudgetSettings::most},
        {"at_once", &WorkBudgetSettings::at_once}})
    for (const double value : {-1.0, std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()})
      refused("budget." + name + " is " + fmt::format("{}: a finite number", value),
              [=, setting = setting](IslandSolver& s) { s.budget.*setting = value; });
}

TEST_CASE("by island: the contacts of islands whose bodies take turns in the world ascend by their ids") {
  for (const int stacks : {1, 2, 5, 8}) {
    CAPTURE(stacks);
    World world;
    world.add(ground());
    for (int level = 0; level < 3; ++level)
      for (int stack = 0; stack < stacks; ++stack)
        world.add(box({Real(0.5), Real(0.5), Real(0.5)}, 1).at({Real(3 * stack), Real(level) + Real(0.5), 0}));
    IslandSolver solver;
    for (int i = 0; i < 3; ++i) {
      world.step(solver, h);
      REQUIRE(world.contacts.size() == std::size_t(12 * stacks));
      CHECK(std::is_sorted(world.contacts.begin(), world.contacts.end(),
                           [](const Contact& first, const Contact& second) { return first.id < second.id; }));
    }
    for (int stack = 0; stack < stacks; ++stack) CHECK(solver.step_of(1 + stack) == StepType::half_steps);
  }
}
