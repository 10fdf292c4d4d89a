/// The study's motions that are of no chapter: their truth, and solvers that come to the same, or let go as they must.
#include <cmath>
#include <random>

#include "pushback/chapters/08_friction_cone/friction_cone.h"
#include "pushback/chapters/13_joints/ball_and_socket.h"
#include "pushback/chapters/19_accuracy_and_time/truth.h"
#include "pushback/engine/half_step/half_step.h"
#include "pushback/tools/measure/study/every_motion.h"
#include "pushback/tools/measure/study/further_motions.h"
#include "pushback/tools/measure/study/ours.h"
#include "tests/support/catch.h"

using namespace pushback;
using namespace pushback::further;
using Eigen::Vector3d;

namespace {

constexpr double frame = 1.0 / frames_per_second;

/// m, the farthest that any body was from its true place in any frame.
template <class ContactSolver>
double error_of(const std::string& name, ContactSolver solver, int substeps, int sweeps = 4) {
  if constexpr (requires { solver.threshold; }) solver.threshold = 0;  // bounces are compared at every speed
  const Motion& motion = any_motion_named(name);
  return play(motion, motion.truth(motion.frames()), {.name = "", .title = "", .begin = by_ours(solver)},
              {.substeps = substeps, .sweeps = sweeps}, {.at_least = 0, .at_most = 600})
      .error;
}

/// One step a substep, its impact at the end of it: the error is of first order, between `least` and `most` a substep.
void is_of_first_order(const std::string& name, const std::vector<int>& substeps, double least, double most,
                       int sweeps = 4) {
  for (const int n : substeps) {
    INFO(name << " in " << n << " substeps");
    const double error = error_of(name, Solver<Clamping, Baumgarte, Restitution, FrictionCone>(), n, sweeps);
    CHECK(error < most / n);
    CHECK(error > least / n);
  }
}

struct Random {
  std::mt19937 engine;
  explicit Random(unsigned seed) : engine(seed) {}
  double between(double low, double high) { return std::uniform_real_distribution<double>(low, high)(engine); }
  Vector3d any(double most) {
    const double x = between(-most, most), y = between(-most, most);
    return {x, y, between(-most, most)};
  }
};

}  // namespace

TEST_CASE("gaps: cut at impacts it is exact, and with the impact at the end of a substep of first order") {
  CHECK(error_of("gaps", at_impacts(), 1) < 1e-12);
  is_of_first_order("gaps", {1, 4, 16, 64, 256}, 0.01, 0.1);
}

TEST_CASE("superball: cut at impacts it is exact, and a friction pyramid never gets there") {
  CHECK(error_of("superball", at_impacts(), 1) < 1e-11);
  is_of_first_order("superball", {16, 64, 256, 1024}, 0.1, 1);
  const auto pyramid = [](int substeps) {
    return error_of("superball", Solver<Clamping, Baumgarte, Restitution, Friction>(), substeps);
  };
  CHECK(pyramid(256) > 0.15);
  CHECK(pyramid(256) == Approx(pyramid(1024)).epsilon(0.01));
}

TEST_CASE("conveyor: half steps have it right, and a friction pyramid never gets there") {
  CHECK(error_of("conveyor", at_impacts(), 1) < 1e-4);
  CHECK(error_of("conveyor", at_impacts(), 64) < 1e-8);
  is_of_first_order("conveyor", {1, 4, 16, 64}, 0.02, 0.03, 16);
  CHECK(error_of("conveyor", Solver<Clamping, Baumgarte, Restitution, Friction>(), 64, 16) > 0.2);
}

namespace {

World begun(const Grasp& tongs) {
  World world;
  tongs(world);
  for (const Pin& pin : tongs.pins()) world.joints.push_back(ball_and_socket(world, pin.a, pin.b, pin.anchor));
  return world;
}

/// Tongs of random measures that do not jam at the friction that they need.
Grasp random_tongs(unsigned seed) {
  Random random(seed);
  return {.height = random.between(0.3, 0.6),
          .out = random.between(0.05, 0.18),
          .load = random.between(2, 6),
          .jaw = random.between(6, 12)};
}

/// m, the farthest that any body is from where it began, in so many frames of half steps.
double drift(World world, int frames) {
  const World begin = world;
  HalfStep solver;
  double farthest = 0;
  for (int i = 0; i < frames; ++i) {
    world.step(solver, frame, 4);
    for (std::size_t body = 0; body < world.bodies.size(); ++body)
      farthest = std::max(farthest, (world.bodies[body].position - begin.bodies[body].position).norm());
  }
  return farthest;
}

}  // namespace

TEST_CASE("grasp: with a tenth more than the friction that it needs a box is held, with a tenth less it slides") {
  for (unsigned seed = 0; seed < 12; ++seed) {
    Grasp tongs = random_tongs(seed);
    const double needed = tongs.friction_needed();
    REQUIRE(1.1 * needed * tongs.out < tongs.height);
    INFO(seed << ": " << needed);
    tongs.mu = 1.1 * needed;
    CHECK(drift(begun(tongs), 60) < 1e-9);
    tongs.mu = 0.9 * needed;
    // The jaws stay where they are, so N is constant, and the box falls with a = g - 2 mu N / m.
    const double c = std::sqrt(2.0) * Grasp::half_side;
    const double N = tongs.jaw * World::g * (tongs.out + c) / (tongs.height - tongs.mu * tongs.out);
    const double a = World::g - 2 * tongs.mu * N / tongs.load;
    CHECK(a > 0);
    World world = begun(tongs);
    const Vec3 begin = world.bodies[3].position, jaw = world.bodies[1].position;
    HalfStep solver;
    for (int i = 1; i <= 24; ++i) {
      world.step(solver, frame, 4);
      const double t = i * frame;
      CHECK((world.bodies[3].position - begin + a * t * t / 2 * Vec3::UnitY()).norm() < 1e-8);
      CHECK((world.bodies[1].position - jaw).norm() < 1e-8);
    }
  }
}

TEST_CASE("hulls-1015: solved directly, piles of 1, 5, 30 and 91 stay where they are") {
  for (const int base : {1, 2, 4, 6}) {
    World world;
    PileOfHulls{.base = base}(world);
    INFO(world.bodies.size() - 1);
    CHECK(drift(world, 10) < 1e-12);
  }
}

TEST_CASE("chaplygin: solvers come to the truth, of first order, half steps of second") {
  const auto comes = [](const auto& solver, int order, double most) {
    double before = 0;
    for (const int substeps : {4, 16, 64, 256}) {
      const double error = error_of("chaplygin", solver, substeps);
      INFO(substeps << " substeps: " << error << " m, order " << std::log2(before / error) / 2);
      if (before > 0) CHECK(before / error == Approx(std::pow(4, order)).epsilon(0.03));
      before = error;
    }
    CHECK(before < most);
  };
  comes(Solver<Clamping, Baumgarte, FrictionCone>(), 1, 1.6e-4);
  comes(HalfStep(), 2, 7e-9);
}
