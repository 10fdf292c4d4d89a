/// Chapter 27: what is known of an error, beside the truth; whether it is kept; and what that takes.
#include "pushback/engine/islands/island_solver.h"

#include "pushback/chapters/13_joints/ball_and_socket.h"
#include "pushback/chapters/15_limits_motors_springs/limits.h"
#include "pushback/chapters/24_half_step/top.h"
#include "pushback/chapters/25_moment_of_impact/scenes.h"
#include "pushback/chapters/26_to_each_its_own/scenes.h"
#include "pushback/common/world/measure.h"
#include "pushback/common/world/situations.h"
#include "pushback/engine/substeps/thread_pool.h"
#include "tests/27_which_error/played.h"
#include "tests/support/catch.h"
#include "tests/support/complaint.h"
#include "tests/support/yardstick.h"

using namespace pushback;
using namespace pushback::which_error_tests;
using to_each_its_own_scenes::Chain;

namespace {

World pendulum(Real angle) {
  World world;
  const Vec3 down(std::sin(angle), -std::cos(angle), 0);
  const int ball = world.add(sphere(Real(0.3), 10).at(2 * down));
  world.joints.push_back(ball_and_socket(world, the_world, ball, Vec3::Zero()));
  return world;
}
/// A plate that carries nine boxes and slides: 40 contacts.
World loaded_plate(Real speed, Real mu) {
  World world;
  world.add(ground().rough(mu));
  world.add(box({2, Real(0.1), 2}, 100).at({0, Real(0.1), 0}).moving({speed, 0, 0}).rough(mu));
  for (int i = 0; i < 9; ++i)
    world.add(box({Real(0.3), Real(0.2), Real(0.3)}, 10)
                  .at({static_cast<Real>(i % 3 - 1), Real(0.4), static_cast<Real>(i / 3 - 1)})
                  .moving({speed, 0, 0})
                  .rough(4));
  return world;
}
IslandSolver by_substeps_alone(Real error) {
  IslandSolver solver = within(error);
  solver.budget.at_first = solver.budget.fraction = 0;  // nobody can pay for half steps
  return solver;
}

}  // namespace

TEST_CASE("within an error: of the ten motions each error is kept, and what is known bounds what is off") {
  for (const Motion& motion : all_motions()) {
    const std::vector<Places> truth = motion.truth(motion.frames());
    World world;
    motion.begin(world);
    for (const Real error : {Real(1e-2), Real(1e-3), Real(1e-4), Real(1e-5)}) {
      const Fared fared = fare(world, error, truth);
      INFO(motion.name << " within " << error << " m: " << fared.off << " of it"
                       << (fared.said ? "" : ", not said to be"));
      CHECK(fared.off < Real(0.25));
    }
  }
}

TEST_CASE("within an error: an infinite one is chapter 26, to the bit") {
  World world;
  to_each_its_own_scenes::Yard{}(world);
  World by_island = world;
  IslandSolver solver;
  IslandSolver other;
  for (int i = 0; i < 120; ++i) {
    world.step(solver, h);
    by_island.step(other, h);
    REQUIRE(hash_of(world) == hash_of(by_island));
  }
}

TEST_CASE("within an error: the same bits with any number of threads") {
  const auto after = [](std::shared_ptr<Workers> pool) {
    World world;
    to_each_its_own_scenes::Yard{}(world);
    IslandSolver solver = within(Real(1e-4));
    solver.substep_solver.workers = std::move(pool);
    for (int i = 0; i < 90; ++i) world.step(solver, h);
    return hash_of(world);
  };
  const std::uint64_t alone = after(nullptr);
  for (const int threads : {2, 7}) CHECK(after(std::make_shared<ThreadPool>(threads, true)) == alone);
}

TEST_CASE("within an error: a chain that whips keeps its energy, has many substeps while it does, and few after it") {
  for (const Real error : {Real(1e-3), Real(1e-4)}) {
    World world;
    Chain{}(world);
    IslandSolver solver = within(error);
    Real mass = 0, worst = 0;
    for (const Body& body : world.bodies) mass += 1 / body.inverse_mass;
    int most = 0, least_since = 1000;
    for (int i = 0; i < 600; ++i) {
      const Real motion = kinetic_energy(world), before = motion + potential_energy(world);
      world.step(solver, h);
      const BodyError known = solver.error_of(0);
      REQUIRE(known.how == StepType::half_steps);
      CHECK(known.kept);
      const Real larger = std::max(kinetic_energy(world), motion);
      const Real off = std::abs(kinetic_energy(world) + potential_energy(world) - before);
      worst = std::max(worst, off / (larger + mass * (h * world.gravity).squaredNorm() / 2));
      const int half_steps = known.substeps * (known.order == 4 ? 5 : 1);
      most = std::max(most, half_steps);
      if (most >= 80) least_since = std::min(least_since, half_steps);
    }
    CHECK(worst < solver.energy);
    CHECK(most >= 80);
    CHECK(least_since <= 20);
  }
}

TEST_CASE(
    "within an error: where many slide, what is known of a step is h / 2 dv, and of all steps what they are off") {
  constexpr Real speed = 4, mu = Real(0.3);
  for (const Real error : {Real(1e-2), Real(1e-3), Real(1e-4)}) {
    World world = loaded_plate(speed, mu);
    IslandSolver solver = by_substeps_alone(error);
    Real largest = 0;
    bool said = true;
    for (int i = 1; i <= 60; ++i) {
      const int substeps = std::max(1, solver.error_of(1).substeps);
      world.step(solver, h);
      const BodyError known = solver.error_of(1);
      REQUIRE(known.how == StepType::substeps);
      const Real t = static_cast<Real>(i) * h, off = speed * t - mu * g * t * t / 2 - world.bodies[1].position.x();
      if (i > 30 && known.substeps == substeps)
        CHECK(known.step == Approx(mu * g * h * h / 2 / substeps).epsilon(0.01));
      largest = std::max(largest, std::abs(off));
      said &= known.kept;
      if (i == 60)
        CHECK(std::abs(known.place - sunken(world, [](int body) { return body == 1; }) - off) < Real(0.3) * off);
    }
    INFO(error << ": " << largest);
    CHECK(largest < 3 * error);
    CHECK((said || largest > error / 2));
    CHECK((largest <= error || !said));
  }
}

TEST_CASE("within an error: a stack on springs has sunk by the sum of its depths, what hangs or flies by nothing") {
  const auto all = [](int) { return true; };
  for (const int boxes : {1, 3, 10}) {
    World world;
    stack(world, boxes);
    WideSolver<Real> springs;
    springs.spring.hertz = 30;
    for (int i = 0; i < 600; ++i) world.step(springs, h);
    const Real top = static_cast<Real>(boxes) - Real(0.5) - world.bodies.back().position.y();
    CHECK(sunken(world, all) == Approx(top).epsilon(0.01));
    CHECK(sunken(world, [](int body) { return body == 1; }) ==
          Approx(1 - Real(0.5) - world.bodies[1].position.y()).epsilon(0.01));
  }
  World world = pendulum(1);
  world.add(sphere(Real(0.5), 1).at({9, 9, 0}));
  WideSolver<Real> springs;
  world.step(springs, h);
  CHECK(sunken(world, all) == 0);
}

TEST_CASE("within an error: what two carry unequally has sunk by the mean of both, each by its part of the load") {
  World world;  // two weights on a board that lies on two supports: of the load the left one has 3/4
  world.add(ground());
  for (const Real x : {Real(-1), Real(1)}) world.add(box({Real(0.1), Real(0.5), Real(0.5)}, 10).at({x, Real(0.5), 0}));
  world.add(box({Real(1.2), Real(0.1), Real(0.5)}, Real(0.1)).at({0, Real(1.1), 0}));
  world.add(box({Real(0.1), Real(0.1), Real(0.1)}, 100).at({Real(-0.5), Real(1.3), 0}));
  WideSolver<Real> springs;
  springs.spring.hertz = 30;
  for (int i = 0; i < 600; ++i) world.step(springs, h);
  const auto sunk = [&](int body, Real from) { return from - world.body(body).position.y(); };
  CHECK(sunk(1, Real(0.5)) > 2 * sunk(2, Real(0.5)));
  const Real left = sunk(1, Real(0.5)), right = sunk(2, Real(0.5)),
             board = sunken(world, [](int body) { return body == 3; });
  CHECK(board > (3 * left + right) / 4);
  CHECK(sunken(world, [](int body) { return body == 4; }) == Approx(sunk(4, Real(1.3))).epsilon(0.1));
}

TEST_CASE("within an error: no step in which something bounces is said to be kept, by half steps or by substeps") {
  for (const bool piled : {false, true}) {  // beside a pile that many contacts leave to substeps
    World world;
    world.add(ground());
    const int ball = world.add(capsule(Real(0.25), Real(0.5), 30).turned(1, {1, 2, 3}).at({0, 2, 0}).bouncy(Real(0.8)));
    for (int i = 0; piled && i < 12; ++i)
      world.add(box({Real(0.3), Real(0.3), Real(0.3)}, 10).turned(Real(i), {1, 2, 3}).at({0, 3 + Real(i), 0}));
    IslandSolver solver;
    solver.error = Real(1e-3);
    int bounces = 0;
    for (int step = 0; step < 120; ++step) {
      const World before = world;
      world.step(solver, h);
      for (const Contact& contact : world.contacts) {
        const bool touches = contact.id.body_a == std::uint32_t(ball) || contact.id.body_b == std::uint32_t(ball);
        if (!touches || contact.impulse.isZero(0) || separating_speed(before, contact) > Real(-0.2)) continue;
        ++bounces;
        CHECK_FALSE(solver.error_of(ball).kept);
      }
    }
    CHECK(bounces > 1);
  }
}

TEST_CASE("within an error: settings that cannot be used are named, and nothing has changed") {
  const auto refused = [](const std::string& said, const std::function<void(IslandSolver&)>& change) {
    World world = loaded_plate(4, Real(0.3));
    IslandSolver solver = within(Real(1e-3));
    change(solver);
    const std::uint64_t before = hash_of(world);
    const std::string words = complaint([&] { world.step(solver, h); });
    INFO(words);
    CHECK(words.starts_with(said));
    CHECK(hash_of(world) == before);
    CHECK(world.time == 0);
  };
  refused("error is 0: a length above 0", [](IslandSolver& s) { s.error = 0; });
  refused("error is nan: a length above 0", [](IslandSolver& s) { s.error = std::numeric_limits<Real>::quiet_NaN(); });
  refused("check_every is 0: a whole number, 1 or more", [](IslandSolver& s) { s.check_every = 0; });
  refused("most_substeps is 2: 4 or more", [](IslandSolver& s) { s.most_substeps = 2; });
  refused("energy is 0", [](IslandSolver& s) { s.energy = 0; });
}

TEST_CASE("What is joined and meets something by substeps is not said to be kept") {
  // A rod and a ball, pinned, meet a wall: impact and joints are solved one after the other, and the ball leaves wrongly. It has
  // substeps because of a limit, which it does not reach.
  const moment_of_impact_scenes::PendulumAtWall pendulum;
  World world;
  pendulum(world);
  world.joints.push_back(angle_limits(world, the_world, 0, Vec3::UnitZ(), Real(-3), Real(3)));
  const std::vector<Places> truth = pendulum.truth(60);
  IslandSolver solver;
  solver.error = Real(3e-2);
  solver.substep_solver.threshold = 0;
  int unkept = 0;
  for (std::size_t i = 0; i < truth.size(); ++i) {
    world.step(solver, Real(1) / 60, 1);
    unkept += solver.error_of(1).kept ? 0 : 1;
    const Real off = (world.bodies[1].position - truth[i][1].cast<Real>()).norm();
    INFO("step " << i << ", off by " << off);
    if (unkept == 0) REQUIRE(off < solver.error);
  }
  CHECK(unkept >= 1);
  CHECK(unkept <= 4);  // it meets the wall twice, and not in every step
}

TEST_CASE(
    "within an error: a double pendulum that meets a wall is where it should be, although nothing is claimed for its "
    "bounces") {
  const moment_of_impact_scenes::PendulumAtWall pendulum;
  const std::vector<Places> truth = pendulum.truth(120);
  World world;
  pendulum(world);
  for (const Real error : {Real(1e-2), Real(1e-3), Real(1e-4), Real(1e-5)}) {
    const Fared fared = fare(world, error, truth);
    INFO("within " << error << " m: " << fared.off << " of it");
    CHECK(fared.off < Real(0.25));
    CHECK_FALSE(fared.said);
  }
}

TEST_CASE("A step that half steps divide by themselves is not compared with one of as many parts: the top") {
  const half_step_scenes::Top top;
  for (const Real error : {Real(1e-3), Real(1e-4), Real(1e-5)}) {
    World world;
    top(world);
    IslandSolver solver;
    solver.error = error;
    Real off = 0;
    for (int i = 1; i <= 60; ++i) {
      world.step(solver, Real(1) / 60, 1);
      const Real t = static_cast<Real>(i) / 60;
      off = std::max(off, (world.bodies[0].position - half_step_scenes::Top::stem * top.axis(t)).norm());
    }
    INFO("within " << error << ": off by " << off << ", known " << solver.error_of(0).place);
    CHECK(off < error);
  }
}
