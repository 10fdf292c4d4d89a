/// Chapter 10: split impulse and non-linear Gauss-Seidel. They move bodies, and leave their velocities alone.
#include <Eigen/LU>
#include <numeric>

#include "pushback/chapters/10_position_correction/scenes.h"
#include "pushback/chapters/10_position_correction/study.h"
#include "pushback/chapters/20_only_what_is_needed/dispatch.h"
#include "pushback/common/bodies/random.h"
#include "pushback/common/world/any_solver.h"
#include "tests/support/catch.h"
#include "tests/support/complaint.h"
#include "tests/support/on_ground.h"

using namespace pushback;
using namespace pushback::baumgarte_scenes;
using namespace pushback::position_correction_scenes;

namespace {

/// Rounds that count for the law: those of split impulse only agree with each other.
template <class PushOut>
int parts_taken(const PushOut& solver) {
  return std::derived_from<PushOut, NonlinearGaussSeidel> ? solver.rounds : 1;
}
Real energy(const World& world) {
  return kinetic_energy(world) + potential_energy(world);
}
World free_pair(Random& random) {
  World world;
  world.gravity.setZero();
  for (const int side : {-1, 1}) {
    const Real mass = random.over_decades(1, 1000);
    const Vec3 velocity = random.vector(1), spin = random.vector(3);
    world.add(random.body(mass).at({static_cast<Real>(side) * Real(0.2), 0, 0}).moving(velocity).spinning(spin));
  }
  return world;
}
bool same_velocities(const std::vector<Body>& before, const std::vector<Body>& now) {
  for (std::size_t i = 0; i < before.size(); ++i) {
    if (before[i].velocity != now[i].velocity || before[i].angular_velocity != now[i].angular_velocity) return false;
  }
  return true;
}
/// World::step, taken apart before the correction.
template <class ContactSolver>
void step_without_correction(World& world, ContactSolver& solver) {
  world.begin_step(h);
  solver.solve(world, h, 10);
  world.move(h);
}

}  // namespace

#define BOTH_WAYS SplitImpulse, NonlinearGaussSeidel

TEMPLATE_TEST_CASE(
    "10: d_k = d_0 (1 - beta)^k, without gravity and with it, at any depth, and no speed, no kinetic energy", "",
    BOTH_WAYS) {
  for (const Real beta : {Real(0.05), Real(0.2), Real(0.5), Real(1)}) {
    for (const Real d0 : {Real(0.01), Real(0.06), Real(0.25)}) {  // Baumgarte throws from 68 mm on at 0.2, 2.7 mm at 1
      for (const Real gravity : {Real(0), g}) {
        World world;
        world.gravity = {0, -gravity, 0};
        Body& ball = ball_on_ground(world, d0);
        CorrectingSolver<Clamping, TestType> solver;
        solver.beta = beta;
        solver.most = 1;
        for (int k = 1; k <= 20; ++k) {
          world.step(solver, h, 1);
          const Real left = d0 * std::pow(1 - beta, static_cast<Real>(k * parts_taken(solver)));
          REQUIRE(std::abs(depth_of(ball) - left) <= 64 * eps);
          REQUIRE(std::abs(ball.velocity.y()) <= 8 * eps);  // what the row has stopped, and nothing that was pushed
          if (gravity == 0) REQUIRE(kinetic_energy(world) == 0);
          if (beta == 1) break;  // out: the next step would find it falling
        }
      }
    }
  }
}

TEMPLATE_TEST_CASE("10: with slop it comes up to the slop, and what is shallower is left where it is", "", BOTH_WAYS) {
  for (const Real slop : {Real(0.001), Real(0.005), Real(0.02)}) {
    for (const Real over : {Real(0.04), Real(0), -slop / 2}) {
      World world;
      Body& ball = ball_on_ground(world, slop + over);
      CorrectingSolver<Clamping, TestType, Slop> solver;
      solver.slop = slop;
      for (int k = 1; k <= 100; ++k) {
        world.step(solver, h, 1);
        const Real left =
            over > 0 ? over * std::pow(1 - solver.beta, static_cast<Real>(k * parts_taken(solver))) : over;
        REQUIRE(std::abs(depth_of(ball) - slop - left) <= 200 * eps);
      }
    }
  }
}

TEMPLATE_TEST_CASE("10: no contact asks for more than the cap in a step", "", BOTH_WAYS) {
  World world;
  Body& ball = ball_on_ground(world, Real(0.25));
  CorrectingSolver<Clamping, TestType> solver;
  solver.beta = 1;
  solver.most = Real(0.04);
  for (int k = 1; k <= 8; ++k) {
    world.step(solver, h, 1);
    CHECK(std::abs(depth_of(ball) - std::max(Real(0), Real(0.25) - static_cast<Real>(k) * solver.most)) <= 64 * eps);
    if (depth_of(ball) <= 0) break;
  }
}

// A ball on the ground, which has all of the impulse, and 60 mm deep in a slope. Out of that it goes, off the ground.
TEMPLATE_TEST_CASE("10: a correction never pulls: what others lift off is let go", "", BOTH_WAYS) {
  const Real deep = WeightlessBall{}.depth;
  World world;
  ball_on_ground(world, Real(0.003));
  const Vec3 slope = Vec3(1, 1, 0).normalized(), place = world.bodies[1].position;
  world.add(half_space(slope).at(place - (Real(0.3) - deep) * slope));
  CorrectingSolver<Clamping, TestType, Slop> solver;
  step_without_correction(world, solver);
  REQUIRE(world.contacts.size() == 2);
  REQUIRE(world.contacts[0].impulse.norm() > 1);
  solver.after_move(world, h);
  const Real undone = 1 - std::pow(1 - solver.beta, static_cast<Real>(parts_taken(solver)));
  const Vec3 shift = world.bodies[1].position - place;
  CHECK((shift - undone * (deep - solver.slop) * slope).norm() <= 64 * eps);
}

TEMPLATE_TEST_CASE("10: a box comes up with the energy that lifting takes, and none that moves it", "", BOTH_WAYS) {
  for (const Real beta : {Real(0.1), Real(0.2), Real(0.4)}) {
    World world;
    very_deep_box(world);
    const Real before = energy(world);
    With<TestType> solver;
    solver.beta = beta;
    Real fastest = 0;
    for (int step = 0; step < 300; ++step) {
      world.step(solver, h, 50);
      fastest = std::max(fastest, kinetic_energy(world));
    }
    CHECK(energy(world) - before == Approx(100 * g * (very_deep - solver.slop)).epsilon(in_double ? 1e-6 : 1e-3));
    CHECK(fastest < (in_double ? Real(1e-9) : Real(1e-4)));  // J; Baumgarte: 432
  }
}

TEMPLATE_TEST_CASE("10: the centre of mass of a free pair stays, and velocities keep every bit", "", BOTH_WAYS) {
  Random random(11);
  for (int i = 0; i < 200; ++i) {
    World world = free_pair(random);
    With<TestType> solver;
    solver.most = 1;
    step_without_correction(world, solver);
    const std::vector<Body> before = world.bodies;
    solver.after_move(world, h);
    REQUIRE(same_velocities(before, world.bodies));
    Vec3 moved = Vec3::Zero();
    Real all = 0;
    for (std::size_t k = 0; k < 2; ++k) {
      moved += (world.bodies[k].position - before[k].position) / before[k].inverse_mass;
      all += 1 / before[k].inverse_mass;
      REQUIRE(std::abs(world.bodies[k].orientation.norm() - 1) <= 4 * eps);
      Body turned = world.bodies[k];
      turned.refresh_inertia();
      REQUIRE(turned.inverse_inertia == world.bodies[k].inverse_inertia);
    }
    REQUIRE(moved.norm() <= 64 * eps * all);
    REQUIRE((world.bodies[0].position != before[0].position) == (deepest_overlap(world) > solver.slop));
  }
}

// Displacements made by pushes at one point add up to no turn about any point: sum of x_i x m dx_i + I dtheta_i = 0.
// Split impulse pushes the bodies as they were found, the other way pushes them as they have moved meanwhile.
TEMPLATE_TEST_CASE("10: a correction turns a free pair as a whole by nothing", "", BOTH_WAYS) {
  Random random(12);
  int corrected = 0;
  for (int i = 0; i < 200; ++i) {
    World world = free_pair(random);
    CorrectingSolver<Clamping, TestType> solver;
    solver.rounds = 1;
    world.find_contacts();
    // More than one contact: the second would find arms and inertias of its own.
    constexpr bool as_moved = std::is_same_v<TestType, NonlinearGaussSeidel>;
    if (as_moved && world.contacts.size() > 1) world.contacts.resize(1);
    solver.solve(world, h, 0);
    const std::vector<Body> found = world.bodies;
    world.move(h);
    const std::vector<Body> before = world.bodies;
    solver.after_move(world, h);
    Vec3 turned = Vec3::Zero();
    Real size = 0;
    for (std::size_t k = 0; k < 2; ++k) {
      const Body &old = before[k], &now = world.bodies[k], &pushed = as_moved ? old : found[k];
      const Quat turn = now.orientation * old.orientation.conjugate();
      const Vec3 angle = 2 * turn.vec() / turn.w();
      const Vec3 shift = (now.position - old.position) / old.inverse_mass;
      turned += pushed.position.cross(shift) + pushed.inverse_inertia.inverse() * angle;
      size += 1 / old.inverse_mass;
      corrected += shift.isZero(0) ? 0 : 1;
    }
    REQUIRE(turned.norm() <= 1000 * eps * size);
  }
  CHECK(corrected > 200);
}

TEMPLATE_TEST_CASE("10: born inside each other, boxes part slowly, keep unit orientations, and come to rest", "",
                   BOTH_WAYS) {
  for (const Real beta : {Real(0.2), Real(1)}) {
    World world;
    boxes_in_each_other(world);
    With<TestType> solver;
    solver.beta = beta;
    Real most = 0;
    for (int step = 0; step < 240; ++step) {
      step_without_correction(world, solver);
      const std::vector<Body> before = world.bodies;
      solver.after_move(world, h);
      REQUIRE(same_velocities(before, world.bodies));
      most = std::max(most, kinetic_energy(world));
      for (const Body& body : world.bodies) REQUIRE(std::abs(body.orientation.norm() - 1) <= 4 * eps);
      REQUIRE(world.bodies[0].position == before[0].position);  // the ground
    }
    CHECK(most < 5);  // J; Baumgarte: more than 10,000
    CHECK(kinetic_energy(world) < Real(1e-3));
    CHECK(deepest_overlap(world) < solver.slop * Real(1.1));
  }
}

// Baumgarte's push-out is a speed, and a stack that it pushes in every step never comes to rest. Where a chaotic motion
// stands after ten seconds says little: the mean over seven beta.
TEST_CASE(
    "10: a stack of ten that is pushed out of the ground in every step trembles a third as much as with Baumgarte") {
  const auto mean = [](const Curve& curve) {
    return std::accumulate(curve.y.begin(), curve.y.end(), Real(0)) / static_cast<Real>(curve.y.size());
  };
  const Real baumgarte = mean(jitter_curve<Baumgarte>("", 0, 10, h, {}));
  CHECK(mean(jitter_curve<SplitImpulse>("", 0, 10, h, {})) < baumgarte / 3);
  CHECK(mean(jitter_curve<NonlinearGaussSeidel>("", 0, 10, h, {})) < baumgarte / 3);
}

// C is reckoned along the normal that was found, at points carried along. What collision would find after it is the same up
// to the square of the turn.
TEST_CASE("10: enough rounds leave no overlap that collision would find") {
  for (const Real angle : {Real(0.05), Real(0.3), Real(0.7)}) {
    World world;
    world.gravity.setZero();
    world.add(ground());
    world.add(
        box({Real(0.5), Real(0.3), Real(0.4)}, 100).turned(angle, Vec3(1, 0, 2).normalized()).at({0, Real(0.3), 0}));
    world.find_contacts();
    const Real before = deepest_overlap(world);
    REQUIRE(before > Real(0.01));
    CorrectingSolver<Clamping, NonlinearGaussSeidel> solver;
    solver.rounds = 200;
    solver.most = 10;
    solver.solve(world, h, 0);
    solver.after_move(world, h);
    world.find_contacts();
    CHECK(deepest_overlap(world) < before / 100);
  }
}

TEMPLATE_TEST_CASE("10: a bounce is neither higher nor lower for the correction: what leaves by itself is not pushed",
                   "", BOTH_WAYS) {
  World corrected, bare;
  dropped_ball(1)(corrected);
  dropped_ball(1)(bare);
  With<TestType> solver;
  Solver<Clamping, Slop, Restitution, Friction, WarmStart> without;
  for (int step = 0; step < 600; ++step) {
    corrected.step(solver, h, 10);
    bare.step(without, h, 10);
    REQUIRE(hash_of(corrected) == hash_of(bare));
  }
}

TEMPLATE_TEST_CASE("10: with e = 0 what lands deep stays down", "", BOTH_WAYS) {
  World world;
  dropped_ball(0)(world);
  With<TestType> solver;
  solver.beta = 1;
  bool landed = false;
  for (int step = 0; step < 120; ++step) {
    world.step(solver, h, 10);
    landed = landed || !world.contacts.empty();
    if (landed) REQUIRE(std::abs(world.bodies[1].velocity.y()) <= 64 * eps);
  }
  CHECK(landed);
}

template <class E>
concept FitsAnySolver = !std::is_base_of_v<RequiredHook, E>;  // what Solver asserts

TEST_CASE("10: what corrects does not compile in a solver that would not call it") {
  STATIC_REQUIRE(FitsAnySolver<Baumgarte>);
  STATIC_REQUIRE_FALSE(FitsAnySolver<SplitImpulse>);
  STATIC_REQUIRE_FALSE(FitsAnySolver<NonlinearGaussSeidel>);
}

TEMPLATE_TEST_CASE("10: where nothing is too deep, the bits are those of a solver without", "", BOTH_WAYS) {
  World corrected, bare;
  stack(corrected, 3);
  stack(bare, 3);
  With<TestType> solver;
  Solver<Clamping, Slop, Restitution, Friction, WarmStart> without;
  for (int step = 0; step < 300; ++step) {
    corrected.step(solver, h, 30);
    bare.step(without, h, 30);
    REQUIRE(deepest_overlap(bare) < solver.slop);
    REQUIRE(hash_of(corrected) == hash_of(bare));
  }
}

static_assert(std::same_as<Only<With<SplitImpulse>, Questions<NeedsContacts>>,
                           CorrectingSolver<Clamping, SplitImpulse, Slop, WarmStart>>);
TEMPLATE_TEST_CASE("10: a solver chosen for the scene corrects as well, and so does one with sleep", "", BOTH_WAYS) {
  World plain, fitted, awake;
  for (World* world : {&plain, &fitted, &awake}) boxes_in_each_other(*world);
  const AnySolver solver = With<TestType>{};  // chosen as a whole: see the assertions above
  AnySolver its = solver;
  OnlyWhatIsNeeded only(fitted, solver), with_sleep(awake, solver, Sleep{});
  for (int step = 0; step < 20; ++step) {
    plain.step(its, h, 10);
    only.step(fitted, h, 10);
    with_sleep.step(awake, h, 10);
    REQUIRE(hash_of(plain) == hash_of(fitted));
    REQUIRE(hash_of(plain) == hash_of(awake));
  }
}

TEMPLATE_TEST_CASE("10: a beta, a cap or a number of rounds that cannot be is refused by name, and nobody has moved",
                   "", BOTH_WAYS) {
  constexpr Real nan = std::numeric_limits<Real>::quiet_NaN(), infinity = std::numeric_limits<Real>::infinity();
  const auto refused = [](const std::string& name, const std::string& value, const auto& spoil) {
    World world;
    const Vec3 place = ball_on_ground(world, Real(0.1)).position;
    CorrectingSolver<Clamping, TestType> solver;
    spoil(solver);
    const std::string message = complaint([&] { world.step(solver, h, 10); });
    INFO(message);
    CHECK(message.find(name) != std::string::npos);
    CHECK(message.find(value) != std::string::npos);
    CHECK(world.bodies[1].position == place);
  };
  refused("beta", "-0.1", [](auto& solver) { solver.beta = Real(-0.1); });
  refused("beta", "1.5", [](auto& solver) { solver.beta = Real(1.5); });
  refused("beta", "nan", [](auto& solver) { solver.beta = nan; });
  refused("most", "-1", [](auto& solver) { solver.most = -1; });
  refused("most", "inf", [](auto& solver) { solver.most = infinity; });
  refused("most", "nan", [](auto& solver) { solver.most = nan; });
  refused("rounds", "-1", [](auto& solver) { solver.rounds = -1; });
}
