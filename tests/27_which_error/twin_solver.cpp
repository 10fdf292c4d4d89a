/// Chapter 27: the reported error compared with the true one, whether the error is kept, and what a program may do between steps.
#include "pushback/engine/islands/twin_solver.h"

#include "pushback/chapters/13_joints/ball_and_socket.h"
#include "pushback/chapters/15_limits_motors_springs/limits.h"
#include "pushback/chapters/19_accuracy_and_time/truth.h"
#include "pushback/chapters/24_half_step/top.h"
#include "pushback/chapters/25_moment_of_impact/scenes.h"
#include "pushback/chapters/26_to_each_its_own/scenes.h"
#include "pushback/common/bodies/random.h"
#include "pushback/common/world/measure.h"
#include "pushback/engine/half_step/half_step.h"
#include "pushback/engine/substeps/thread_pool.h"
#include "tests/27_which_error/played.h"
#include "tests/support/catch.h"
#include "tests/support/complaint.h"

using namespace pushback;
using namespace pushback::which_error_tests;
using half_step_scenes::Top;
using moment_of_impact_scenes::PendulumAtWall;
using to_each_its_own_scenes::Chain;
using to_each_its_own_scenes::Yard;

namespace {

void hang(World& world, Real angle, Real x = 0) {
  const Vec3 pin(x, 0, 0);
  const int ball = world.add(sphere(Real(0.3), 10).at(pin + 2 * Vec3(std::sin(angle), -std::cos(angle), 0)));
  world.joints.push_back(ball_and_socket(world, the_world, ball, pin));
}
World pendulum(Real angle) {
  World world;
  hang(world, angle);
  return world;
}
World filled(const Change& fill) {
  World world;
  fill(world);
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
/// A rod or a board that tumbles, and bounces a few times in a second.
World thrown_bar(std::uint64_t seed) {
  Random random(seed);
  World world;
  world.add(ground());
  const Body bar = seed % 2 == 0 ? capsule(Real(0.1), Real(0.4), 10) : box({Real(0.5), Real(0.1), Real(0.2)}, 10);
  const Vec3 spin = random.vector(4), velocity = random.vector(1);
  const Real angle = random.between(0, 3);
  world.add(Body(bar).turned(angle, {1, 2, 3}).at({0, Real(1.2), 0}).moving(velocity).spinning(spin).bouncy(Real(0.5)));
  return world;
}
/// In 128 half steps in a step, which is far more than any error needs.
std::vector<Places> places_cut_at_impacts(const World& world, int steps, const Change& change = {}) {
  HalfStep solver = at_impacts(Impacts::sequential);
  solver.substeps = 128;
  solver.threshold = 0;
  return places_by(solver, world, steps, change);
}

}  // namespace

TEST_CASE("within an error: motions that are known keep each error, and none is further off than has been said") {
  const auto check = [](const std::string& name, const World& world, const std::vector<Places>& truth) {
    constexpr Real in_both = Real(1.1e-6);  // m: the ball that begins to roll is off by so much, in steps of any length
    for (const Real error : {Real(1e-2), Real(1e-3), Real(1e-4), Real(1e-5)}) {
      const Fared fared = fare(world, error, truth);
      INFO(name << " within " << error << " m: " << fared.off << " of it, and " << fared.beyond << " m beyond");
      CHECK(fared.kept_off < Real(0.25));
      CHECK(fared.beyond < in_both);
      CHECK((fared.kept || error < Real(2e-5)));  // the twin itself is not so exact
    }
  };
  for (const Motion& motion : all_motions())
    check(motion.name, filled([&](World& world) { motion.begin(world); }), motion.truth(motion.frames()));
  check("a pendulum at a wall", filled(PendulumAtWall{}), PendulumAtWall{}.truth(120));
  std::vector<Places> of_top;
  for (int i = 1; i <= 60; ++i) of_top.push_back({(Top::stem * Top{}.axis(static_cast<Real>(i) * h)).cast<double>()});
  check("a top", filled(Top{}), of_top);
}

TEST_CASE("within an error: an infinite one is chapter 26, to the bit") {
  World world = filled(Yard{}), by_island = world;
  Recommended solver;
  IslandSolver other;
  for (int i = 0; i < 120; ++i) {
    world.step(solver, h);
    by_island.step(other, h);
    REQUIRE(hash_of(world) == hash_of(by_island));
    REQUIRE(said_of(world, solver).position_error == 0);
  }
}

TEST_CASE("within an error: the same bits with any number of threads, and of copies of world and solver") {
  const auto after = [](std::shared_ptr<Workers> pool, int copied_after) {
    World world = filled(Yard{});
    Recommended solver = within(Real(1e-4));
    solver.substep_solver.workers = std::move(pool);
    for (int i = 0; i < copied_after; ++i) world.step(solver, h);
    World copy = world;
    Recommended its = solver;
    world.step(solver, h);  // which the copy must not feel
    for (int i = copied_after; i < 90; ++i) copy.step(its, h);
    return std::pair(hash_of(copy), said_of(copy, its).position_error);
  };
  const auto alone = after(nullptr, 0);
  CHECK(after(nullptr, 50) == alone);
  for (const int threads : {2, 7}) CHECK(after(std::make_shared<ThreadPool>(threads, true), 0) == alone);
}

TEST_CASE("within an error: what is said of bars that bounce, and of a pendulum, is up to 11 times their error") {
  const auto check = [](const World& world) {  // ((9 / 2)^2 - 1) / 2 = 9.6 where all steps have 9 half steps
    const Fared fared = fare(world, Real(1e-3), places_cut_at_impacts(world, 42));
    INFO("off by " << fared.last_off << ", said " << fared.last_said);
    CHECK(fared.kept);
    CHECK(fared.last_said > fared.last_off);
    CHECK(fared.last_said < 11 * fared.last_off);
  };
  check(pendulum(Real(0.5)));
  for (std::uint64_t seed = 0; seed < 24; ++seed) {
    INFO("seed " << seed);
    check(thrown_bar(seed));
  }
}

TEST_CASE("within an error: an error grows from impact to impact, and the twin sees it") {
  World world = thrown_bar(23);
  const std::vector<Places> truth = places_cut_at_impacts(world, 60);
  const Fared first = fare(world, Real(1e-3), {truth.begin(), truth.begin() + 30}),
              all = fare(world, Real(1e-3), truth);
  const Real grown = all.last_off / first.last_off;
  CHECK(grown > 10);
  CHECK(all.last_said / first.last_said == Approx(grown).epsilon(0.2));
}

TEST_CASE("within an error: a chain that whips is said to be lost, and keeps its energy nevertheless") {
  World world = filled(Chain{});
  Recommended solver = within(Real(1e-3));
  Real mass = 0;
  for (const Body& body : world.bodies) mass += 1 / body.inverse_mass;
  int first_lost = 0, fewest = 1000;
  for (int step = 1; step <= 300; ++step) {
    const Real kinetic = kinetic_energy(world), before = kinetic + potential_energy(world);
    world.step(solver, h);
    if (first_lost == 0 && !said_of(world, solver).kept) first_lost = step;
    if (first_lost > 0) fewest = std::min(fewest, solver.error_of(1).substeps);
    const Real all = std::max(kinetic, kinetic_energy(world)) + mass * (h * world.gravity).squaredNorm() / 2;
    CHECK(std::abs(kinetic_energy(world) + potential_energy(world) - before) < Real(1.01) * solver.energy * all);
  }
  CHECK(first_lost > 40);  // it whips in the 43rd step
  CHECK(first_lost < 60);
  CHECK(fewest > 9);  // half steps since then: twins that begin again do not begin with few
}

TEST_CASE("within an error: where many slide in substeps, their number gives what they are off, and what is said") {
  constexpr Real speed = 4, mu = Real(0.3);
  for (const Real error : {Real(1e-2), Real(1e-3), Real(1e-4)}) {
    World world = loaded_plate(speed, mu);
    Recommended solver = within(error);
    solver.budget.at_first = solver.budget.fraction = 0;  // nobody can pay for half steps
    bool kept = true;
    for (int i = 1; i <= 60; ++i) {
      world.step(solver, h);
      kept &= said_of(world, solver).kept;
      const BodyError known = solver.error_of(1);
      REQUIRE(known.step_type == StepType::substeps);
      const Real t = static_cast<Real>(i) * h, off = speed * t - mu * g * t * t / 2 - world.bodies[1].position.x();
      CHECK((off < error || !kept));
      if (i < 30) continue;
      CHECK(off == Approx(mu * g * h * t / 2 / known.substeps).epsilon(0.05));
      CHECK(known.position_error > off);
      CHECK(known.position_error < 2 * off);
    }
    CHECK(kept == (error > Real(5e-4)));
  }
}

TEST_CASE("within an error: what stops at any instant is off by no more than is said") {
  constexpr Real mu = Real(0.3);
  for (int i = 0; i < 100; ++i) {
    const Real speed = 1 + Real(0.0137) * static_cast<Real>(i);
    World world;
    world.add(ground().rough(mu));
    world.add(box({Real(0.5), Real(0.2), Real(0.5)}, 10).at({0, Real(0.2), 0}).moving({speed, 0, 0}).rough(mu));
    Recommended solver = within(Real(1e-3));
    for (int step = 0; step < 60; ++step) world.step(solver, h);
    const double way = truth::way_of_sliding(double(speed), double(mu * g), double(world.time));
    const Real off = std::abs(world.bodies[1].position.x() - static_cast<Real>(way)),
               said = solver.error_of(1).position_error;
    INFO(speed << " m/s: off by " << off << ", said " << said);
    CHECK(off <= said + point_rounding);
    CHECK(said < mu * g * h * h / 4);  // twice what a single half step in each step may be off by
  }
}

TEST_CASE("within an error: what is joined and meets something by substeps is not said to be kept") {
  // Impact and joints are solved one after the other, so the ball leaves wrongly. The limit is not reached, but asks for substeps.
  World world = filled(PendulumAtWall{});
  world.joints.push_back(angle_limits(world, the_world, 0, Vec3::UnitZ(), Real(-3), Real(3)));
  const Fared fared = fare(world, Real(3e-2), PendulumAtWall{}.truth(60));
  CHECK_FALSE(fared.kept);
  CHECK(fared.kept_off < 1);
}

TEST_CASE("within an error: whatever a program changes between two steps is changed in the twin") {
  const auto check = [](const char* what, const Change& change) {
    const World world = pendulum(Real(0.5));
    const Fared fared = fare(world, Real(1e-3), places_cut_at_impacts(world, 60, change), change);
    INFO(what << ": " << fared.off << " of 1 mm, and " << fared.beyond << " m beyond");
    CHECK(fared.kept);
    CHECK(fared.off < Real(0.25));
    CHECK(fared.beyond <= 0);
  };
  check("gravity", [](World& world) { world.gravity = {3, -5, 1}; });
  check("a force", [](World& world) { world.forces.push_back({[](World& w) { w.bodies[0].force.x() += 3; }}); });
  check("a force by hand", [](World& world) { world.bodies[0].force = Vec3(300, 0, 100); });
  check("a mass", [](World& world) { world.bodies[0].inverse_mass *= 2; });
  check("a velocity", [](World& world) { world.bodies[0].velocity *= Real(-0.5); });
  check("a body that hangs from it", [](World& world) {
    const Vec3 pin = world.bodies[0].position;
    const int lower = world.add(sphere(Real(0.3), 5).at(pin - Vec3::UnitY()));
    world.joints.push_back(ball_and_socket(world, 0, lower, pin));
  });
  check("a joint removed", [](World& world) { world.joints.pop_back(); });
  check("the body removed", [](World& world) { world.remove(0); });
}

TEST_CASE("within an error: a body that the program adds or sets has no error yet, and all others keep theirs") {
  World undisturbed = pendulum(1);
  hang(undisturbed, 1, 9);
  World world = undisturbed;
  Recommended solver = within(Real(1e-3)), other = solver;
  for (int i = 0; i < 40; ++i) {
    if (i == 20) {
      world.bodies[0].velocity *= Real(0.9);
      world.add(sphere(Real(0.3), 10).at({20, 0, 0}));
    }
    world.step(solver, h);
    undisturbed.step(other, h);
    CHECK(solver.error_of(1).position_error == Approx(other.error_of(1).position_error).epsilon(1e-6));
    if (i != 20) continue;
    CHECK(solver.error_of(0).position_error < other.error_of(0).position_error / 3);  // of one step
    CHECK(solver.error_of(2).position_error < point_rounding);
  }
  const Real before = solver.error_of(1).position_error;
  world.bodies[1].orientation = Quat(Eigen::AngleAxis<Real>(Real(0.1), Vec3::UnitY())) * world.bodies[1].orientation;
  world.step(solver, h);
  CHECK(solver.error_of(1).position_error < before / 3);
  solver.forget_errors();
  CHECK(said_of(world, solver).position_error == 0);
  world.step(solver, h);
  CHECK(said_of(world, solver).position_error < before / 3);
  CHECK(said_of(world, solver).position_error > 0);
}

TEST_CASE("within an error: with a body that is lost, all that it touches begin again, and nothing else") {
  World world = thrown_bar(1);
  world.bodies[0].at({0, Real(-0.5), 0});
  const Body board = box({3, Real(0.25), 3}, Real(1e8)).at({0, Real(-0.25), 0});  // moves by less than a micrometre
  const int below = world.add(board), beside = world.add(Body(board).at({20, Real(-0.25), 0}));
  Recommended solver = within(Real(1e-5));
  for (int i = 1; i <= 240; ++i) {
    world.step(solver, h);
    CHECK(solver.error_of(beside).kept);
    if (i != 120) continue;
    CHECK_FALSE(solver.error_of(1).kept);
    CHECK(solver.error_of(1).position_error > 10 * solver.error);
    CHECK_FALSE(solver.error_of(below).kept);
    CHECK(solver.error_of(below).position_error < solver.error);
  }
  CHECK(said_of(world, solver).kept);  // all rest
}

TEST_CASE("within an error: a twin whose places are no numbers begins again, and its world goes on") {
  World world = pendulum(1);
  world.forces.push_back({[calls = std::make_shared<int>(0)](World& its) {  // the first call is for the twin
    if ((*calls)++ == 0) its.bodies[0].force.x() = std::numeric_limits<Real>::quiet_NaN();
  }});
  Recommended solver = within(Real(1e-3));
  for (int i = 0; i < 3; ++i) {
    world.step(solver, h);
    CHECK_FALSE(solver.error_of(0).kept);
  }
}

TEST_CASE("within an error: a solver that steps two worlds in turn knows what is wrong in one step") {
  World worlds[] = {pendulum(1), pendulum(Real(-0.5))};
  Recommended solver = within(Real(1e-3));
  for (int i = 0; i < 60; ++i)
    for (World& world : worlds) {
      world.step(solver, h);
      CHECK(said_of(world, solver).kept);
      CHECK(said_of(world, solver).position_error < Real(1e-5));
    }
  CHECK(farthest(places_of(worlds[0]), places_cut_at_impacts(pendulum(1), 60).back()) < Real(1e-4));
}

TEST_CASE("within an error: what does not move by itself has no error, and carries what does") {
  World world;
  Recommended solver = within(Real(1e-4));
  world.step(solver, h);  // without any body
  CHECK(world.time == h);
  CHECK(solver.error_of(0).step_type == StepType::none);
  const Vec3 speed(Real(0.5), Real(0.2), 0), load(0, Real(0.3), 0);
  const int lift = world.add(box({1, Real(0.1), 1}, 1).fixed());
  const int parcel = world.add(box({Real(0.2), Real(0.2), Real(0.2)}, 10).at(load).moving(speed));
  for (int i = 1; i <= 60; ++i) {
    const Vec3 to = static_cast<Real>(i) * h * speed + std::max(0, i - 30) * h * speed.y() * Vec3::UnitY();
    world.bodies[std::size_t(lift)].moved_to(to, Quat::Identity(), h);
    world.step(solver, h);
    CHECK(solver.error_of(lift).step_type == StepType::none);
    CHECK(solver.error_of(lift).position_error == 0);
    CHECK(said_of(world, solver).kept);
    CHECK((world.bodies[std::size_t(parcel)].position - to - load).norm() < Real(1e-6));
  }
}

TEST_CASE("within an error: steps may have any length") {
  Random random(3);
  for (const auto& [shortest, longest] : {std::pair(h / 4, h / 4), {2 * h, 2 * h}, {h / 8, 3 * h}}) {
    World world = pendulum(Real(0.5)), truth = world;
    Recommended solver = within(Real(1e-2));
    HalfStep half_step;
    half_step.substeps = 512;
    while (world.time < 1) {
      const Real dt = random.between(shortest, longest);
      world.step(solver, dt);
      truth.step(half_step, dt);
      CHECK(solver.error_of(0).kept);
    }
    const Real off = farthest(places_of(world), places_of(truth)), said = solver.error_of(0).position_error;
    INFO("off by " << off << ", said " << said);
    CHECK(said > off);
    CHECK(said < 11 * off);
  }
}

TEST_CASE("within an error: settings that cannot be used are named, and nothing has changed") {
  const auto refused = [](const std::string& said, const std::function<void(TwinSolver&)>& change) {
    World world = loaded_plate(4, Real(0.3));
    Recommended solver = within(Real(1e-3));
    change(solver);
    const std::uint64_t before = hash_of(world);
    const std::string words = complaint([&] { world.step(solver, h); });
    INFO(words);
    CHECK(words.starts_with(said));
    CHECK(hash_of(world) == before);
    CHECK(world.time == 0);
  };
  refused("error is 0: a length above 0", [](TwinSolver& s) { s.error = 0; });
  refused("error is -1: a length above 0", [](TwinSolver& s) { s.error = -1; });
  refused("error is nan: a length above 0", [](TwinSolver& s) { s.error = std::numeric_limits<Real>::quiet_NaN(); });
  refused("energy is 0", [](TwinSolver& s) { s.energy = 0; });
}

TEST_CASE("given half steps that the bodies cannot be moved by are named, and nothing has changed") {
  const auto refused = [](const std::string& said, const std::function<void(GivenSteps&)>& change) {
    World world = loaded_plate(4, Real(0.3));
    IslandSolver solver;
    solver.given = {.of_body = std::vector<int>(world.bodies.size(), 5),
                    .most_of_many = 2,
                    .substeps = 40,
                    .tolerance = Real(1e-7),
                    .threshold = 0};
    World moved = world;
    CHECK(complaint([&] { moved.step(solver, h); }).empty());
    change(solver.given);
    const std::uint64_t before = hash_of(world);
    const std::string words = complaint([&] { world.step(solver, h); });
    INFO(words);
    CHECK(words.starts_with(said));
    CHECK(hash_of(world) == before);
  };
  refused("given.of_body has 10 numbers: one for each of 11 bodies",
          [](GivenSteps& given) { given.of_body.pop_back(); });
  refused("given.of_body is 0", [](GivenSteps& given) { given.of_body[3] = 0; });
  refused("given.most_of_many is 0", [](GivenSteps& given) { given.most_of_many = 0; });
  refused("given.substeps is 0", [](GivenSteps& given) { given.substeps = 0; });
  refused("given.tolerance is 0", [](GivenSteps& given) { given.tolerance = 0; });
  refused("given.threshold is -1", [](GivenSteps& given) { given.threshold = -1; });
}
