/// Chapter 18: the joints of a step solved at once.
#include "pushback/engine/direct/direct_joints.h"
#include "pushback/chapters/04_slop/slop.h"
#include "pushback/chapters/12_soft_contacts/soft_contacts.h"
#include "pushback/chapters/13_joints/study.h"
#include "pushback/chapters/14_joints_under_load/structures.h"
#include "pushback/chapters/15_limits_motors_springs/ragdoll.h"
#include "pushback/chapters/15_limits_motors_springs/scenes.h"
#include "pushback/chapters/18_direct_joints/iterated.h"
#include "pushback/chapters/18_direct_joints/scenes.h"
#include "pushback/common/bodies/random.h"
#include "tests/support/catch.h"
#include "tests/support/joint_energy.h"
#include "tests/support/with_joints.h"
#include "tests/support/yardstick.h"

using namespace pushback;
using namespace pushback::direct_joints_scenes;
using namespace pushback::joints_scenes;
using namespace pushback::joints_under_load_scenes;
using namespace pushback::limits_motors_springs_scenes;

namespace {

using Swept = Solver<Joints>;
using AtOnce = Solver<DirectJoints>;

/// The largest |JV + b + gamma lambda| of the rows without limits, m/s.
template <class JointSolver>
Real largest_error(const JointSolver& solver) {
  Real largest = 0;
  for (const JointRow& row : solver.joint_rows())
    if (!has_limits(row)) largest = std::max(largest, std::abs(row.speed() + row.bias + row.softness * row.impulse));
  return largest;
}

/// How far the bodies of one are from moving as those of the other, of the fastest, m/s or rad/s.
Real apart(const World& one, const World& other) {
  Real largest = 0, fastest = 0;
  for (std::size_t i = 0; i < one.bodies.size(); ++i) {
    const Body &a = one.bodies[i], &b = other.bodies[i];
    largest = std::max({largest, (a.velocity - b.velocity).norm(), (a.angular_velocity - b.angular_velocity).norm()});
    fastest = std::max({fastest, b.velocity.norm(), b.angular_velocity.norm()});
  }
  return largest / fastest;
}

void knock_all(World& world, Random& random) {
  for (Body& body : world.bodies)
    if (body.movable()) body.moving(random.direction()).spinning(random.direction());
}

void four_bars(World& world) {
  world.add(box({Real(0.1), Real(0.5), Real(0.1)}, 1).at({0, Real(0.5), 0}));
  world.add(box({Real(0.5), Real(0.1), Real(0.1)}, 1).at({Real(0.5), 1, 0}));
  world.add(box({Real(0.1), Real(0.5), Real(0.1)}, 1).at({1, Real(0.5), Real(0.5)}));
  const auto pin = [&world](int a, int b, const Vec3& at) {
    world.joints.push_back(hinge(world, a, b, at, Vec3::UnitZ()));
  };
  pin(the_world, 0, {0, 0, 0});
  pin(0, 1, {0, 1, 0});
  pin(1, 2, {1, 1, 0});
  pin(2, the_world, {1, 0, 0});
}

}  // namespace

TEST_CASE("joints at once: fifty links and a thousand times the mass of one, after one solve") {
  Random random(1);
  World world;
  LoadedChain{50, 1000}(world);
  knock_all(world, random);
  world.begin_step(h);
  AtOnce solver;
  solver.solve(world, h, 0);
  CHECK(solver.matrix().solved_rows() == solver.joint_rows().size());
  const Real before = largest_error(solver);
  solver.solve(world, h, 1);
  INFO(largest_error(solver) << " of " << before);
  CHECK(before > Real(0.5));
  CHECK(largest_error(solver) <= (in_double ? Real(1e-10) : Real(1e-3)) * before);
}

TEST_CASE("joints at once: the speeds are those that sweeps go to") {
  Random random(2);
  for (int i = 0; i < 5; ++i) {
    World one;
    LoadedChain{6, 20}(one);
    knock_all(one, random);
    World other = one;
    Swept swept;
    AtOnce at_once;
    one.step(at_once, h, 1);
    other.step(swept, h, 20000);
    CHECK(apart(one, other) < (in_double ? Real(1e-11) : Real(1e-3)));
  }
}

TEST_CASE("joints at once: what rows that feed nothing back do to the energy is -|dV|^2 / 2, in masses, in one sweep") {
  Random random(4);
  for (const Real ratio : {Real(1), Real(1000)}) {
    World world = crooked_chain(20, random, ratio);
    AtOnce solver;
    solver.beta = 0;
    world.step(solver, h, 1);
    for (int step = 0; step < 20; ++step) {
      const EnergyOfAStep found = energy_of_a_step(world, solver, h, 1);
      INFO(ratio << ": " << found.off << " of " << found.energy);
      REQUIRE(found.off < (in_double ? Real(1e-10) : Real(1e-3)) * (std::abs(found.energy) + found.lost));
    }
  }
}

TEST_CASE("joints at once: what is off comes back as C_0 (1 - beta)^k all along a chain, for every beta up to 1") {
  for (const Real beta : {Real(0.2), Real(0.9), Real(1)}) {
    World world;
    world.gravity.setZero();
    Vec3 at = Vec3::Zero();
    for (int i = 0; i < 12; ++i) {
      const Vec3 next = at - Vec3(0, 1, 0);
      world.add(sphere(Real(0.1), i == 11 ? 1000 : 1).at(next));
      world.joints.push_back(distance(world, i - 1, at, i, next, i % 3 == 0 ? Real(0.9) : Real(1.05)));
      at = next;
    }
    auto solver = with_joint_beta<AtOnce>(beta);
    const Real before = largest_joint_error(world);
    for (int k = 1; k <= 100; ++k) {
      world.step(solver, h, 1);
      REQUIRE(largest_joint_error(world) ==
              Approx(before * std::pow(1 - beta, k)).margin(in_double ? Real(1e-11) : Real(1e-4)));
    }
  }
}

TEST_CASE("joints at once: four bars say three things twice, and those rows are left out, and hold") {
  World one;
  four_bars(one);
  one.bodies[1].moving({2, Real(0.3), Real(0.5)}).spinning({1, 2, 3});
  World other = one;
  AtOnce at_once;
  Swept swept;
  one.step(at_once, h, 1);
  CHECK(at_once.joint_rows().size() == 20);
  CHECK(at_once.matrix().solved_rows() == 17);
  CHECK(largest_error(at_once) < (in_double ? Real(1e-11) : Real(1e-3)));  // of all twenty
  other.step(swept, h, 20000);
  CHECK(apart(one, other) < (in_double ? Real(1e-10) : Real(1e-3)));
  Real off = 0, off_swept = 0;  // and on for five seconds, through the places where all bars are in line
  for (int step = 0; step < 300; ++step) {
    one.step(at_once, h, 1);
    other.step(swept, h, 1000);
    off = std::max(off, largest_joint_error(one));
    off_swept = std::max(off_swept, largest_joint_error(other));
    REQUIRE(at_once.matrix().solved_rows() == 17);
  }
  INFO(off << " m, swept " << off_swept << " m");
  CHECK(off < Real(1.01) * off_swept);
  CHECK((one.bodies[1].position - other.bodies[1].position).norm() < Real(0.01));
}

TEST_CASE("joints at once: with contacts the two take turns, and come to what sweeps come to") {
  World world;
  struck_chain(world);
  Solver<Clamping, Baumgarte, Slop, DirectJoints> at_once;
  for (int step = 0; world.contacts.empty() || step < 20; ++step) {
    REQUIRE(step < 120);
    world.step(at_once, h, 10);
  }
  World one = world, other = world;
  Solver<Joints, Clamping, Baumgarte, Slop> swept;
  one.step(at_once, h, 200);
  other.step(swept, h, 20000);
  CHECK(!one.contacts.empty());
  CHECK(apart(one, other) < (in_double ? Real(1e-9) : Real(1e-3)));
  CHECK(largest_error(at_once) < (in_double ? Real(1e-10) : Real(1e-3)));
}

TEST_CASE(
    "joints at once: all limits of a man who falls down the stairs, of motors and springs, are kept by one sweep") {
  const auto play = [](const std::string& name, const std::function<void(World&)>& fill) {
    World world;
    fill(world);
    AtOnce solver;
    std::size_t at_a_limit = 0;
    for (int step = 0; step < 90; ++step, world.step(solver, h, 1)) {
      World before_it_moves = world;  // which turns an angular velocity
      before_it_moves.begin_step(h);
      solver.solve(before_it_moves, h, 1);
      for (const JointRow& row : solver.joint_rows()) {
        INFO(name << ", step " << step << ": " << row.impulse << " of " << row.lo << " to " << row.hi);
        REQUIRE(row.error() < (in_double ? Real(1e-9) : Real(1e-2)));
        REQUIRE((row.lo <= row.impulse && row.impulse <= row.hi));
        at_a_limit += has_limits(row) && std::abs(row.impulse) > 0;
      }
    }
    INFO(name);
    CHECK(at_a_limit > 0);
  };
  play("a man", [](World& world) { down_the_stairs(world); });
  play("motors too weak for what they turn", [](World& world) { pointers(world, follow_torque / 10); });
  play("winches", TwoWinches{});
  play("a stop", [](World& world) {
    bar_and_stop(world);
    world.joints.push_back(stop_of_bar(world));
  });
}

TEST_CASE("joints at once: a pass that relaxes solves the rows as they are by then") {
  World world;
  struck_chain(world);
  RelaxingSolver<Clamping, SoftContacts, WarmStart, DirectJoints> solver;
  for (int step = 0; step < 60; ++step) {
    world.step(solver, h, 4);
    REQUIRE(largest_error(solver) < (in_double ? Real(1e-10) : Real(1e-3)));
    for (const Row& row : solver.joint_rows()) REQUIRE(row.bias == 0);
  }
  CHECK(largest_joint_error(world) < Real(0.05));
}

TEST_CASE("A lambda + q is JV + b of the bodies: what sweeps leave, and the direct solve") {
  constexpr bool in_float = std::is_same_v<Real, float>;
  const LoadedChain chain;
  IteratedProblem problem = iterated(chain, h);
  CHECK(problem.matrix.rows() == 3 * (chain.links + 1));
  REQUIRE(problem.methods.size() == 2);
  Vector swept = Vector::Zero(problem.matrix.rows()), direct = swept;
  CHECK(problem.residual(swept) == 1);
  double before = 1;
  for (int k = 1; k <= 30; ++k) {
    CHECK(problem.methods[0].iterate(swept));
    if (k != 1 && k != 8 && k != 30) continue;
    World world;
    chain(world);
    world.begin_step(h);
    Solver<Joints> solver;
    solver.solve(world, h, 0);
    const auto largest = [&solver] {
      Real most = 0;
      for (const JointRow& row : solver.joint_rows()) most = std::max(most, std::abs(row.speed() + row.bias));
      return static_cast<double>(most);
    };
    const double at_first = largest();
    World again;
    chain(again);
    again.begin_step(h);
    solver.solve(again, h, k);
    CHECK(problem.residual(swept) == Approx(largest() / at_first).epsilon(in_float ? 1e-3 : 1e-9));
    CHECK(problem.residual(swept) < before);
    before = problem.residual(swept);
  }
  CHECK(problem.methods[1].iterate(direct));
  CHECK(problem.residual(direct) < (in_float ? 1e-3 : 1e-10));
  const Vector after_one = direct;
  CHECK_FALSE(problem.methods[1].iterate(direct));
  CHECK(direct == after_one);
  CHECK((swept - direct).norm() > 0.1 * direct.norm());
}
