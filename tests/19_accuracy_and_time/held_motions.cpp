/// What tongs hold and what a pile carries: forces that balance, and solvers that leave everything where it is, or let it fall as it must.
#include "pushback/tools/measure/study/held_motions.h"

#include <cmath>
#include <map>
#include <random>

#include "pushback/chapters/13_joints/ball_and_socket.h"
#include "pushback/chapters/24_half_step/half_step.h"
#include "pushback/chapters/27_which_error/within_error.h"
#include "pushback/common/world/measure.h"
#include "pushback/tools/measure/study/every_motion.h"
#include "tests/support/catch.h"

using namespace pushback;
using namespace pushback::further;

namespace {

constexpr double frame = 1.0 / frames_per_second;

World begun(const Grasp& tongs) {
  World world;
  tongs(world);
  for (const Pin& pin : tongs.pins()) world.joints.push_back(ball_and_socket(world, pin.a, pin.b, pin.anchor));
  return world;
}

/// Tongs of random measures that do not jam at the friction that they need.
Grasp random_tongs(unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> number(0, 1);
  return {.height = 0.3 + 0.3 * number(random),
          .out = 0.05 + 0.13 * number(random),
          .load = 2 + 4 * number(random),
          .jaw = 6 + 6 * number(random)};
}

/// m, the farthest that any body is from where it began, in so many frames.
template <class ContactSolver>
double drift(World world, ContactSolver solver, int frames) {
  const World begin = world;
  double farthest = 0;
  for (int i = 0; i < frames; ++i) {
    world.step(solver, frame, 4);
    for (std::size_t body = 0; body < world.bodies.size(); ++body)
      farthest = std::max(farthest, (world.bodies[body].position - begin.bodies[body].position).norm());
  }
  return farthest;
}

}  // namespace

TEST_CASE("grasp: four points just touch, two a jaw, and friction and moments about the pins need what is said") {
  for (unsigned seed = 0; seed < 30; ++seed) {
    const Grasp tongs = seed == 0 ? Grasp() : random_tongs(seed);
    World world = begun(tongs);
    world.find_contacts();
    INFO(seed);
    REQUIRE(world.contacts.size() == 4);
    CHECK(std::abs(deepest_overlap(world)) < 1e-12);
    for (const Pin& pin : tongs.pins()) {
      const Body& jaw = world.bodies[static_cast<std::size_t>(pin.b)];
      const double F = tongs.load * World::g / 2;
      int points = 0;
      for (const Contact& contact : world.contacts) {
        if (contact.id.body_a != static_cast<std::uint32_t>(jaw.index)) continue;  // the box is the last body
        ++points;
        CHECK(std::abs(contact.normal.x()) == Approx(1));
        // N H = M g (w + c) + F w
        const double N = (World::g / jaw.inverse_mass * std::abs(jaw.position.x() - pin.anchor.x()) +
                          F * std::abs(contact.point.x() - pin.anchor.x())) /
                         (pin.anchor.y() - contact.point.y());
        CHECK(tongs.friction_needed() == Approx(F / N));
      }
      CHECK(points == 2);
    }
  }
}

TEST_CASE("grasp: with a tenth more than the friction that it needs a box is held, with a tenth less it slides") {
  for (unsigned seed = 0; seed < 12; ++seed) {
    Grasp tongs = random_tongs(seed);
    const double needed = tongs.friction_needed();
    REQUIRE(1.1 * needed * tongs.out < tongs.height);
    INFO(seed << ": " << needed);
    tongs.mu = 1.1 * needed;
    CHECK(drift(begun(tongs), HalfStep(), 60) < 1e-9);
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

// ---- hulls-1015 ------------------------------------------------------------------------------------------------------

TEST_CASE("hulls-1015: solved directly, piles of 1, 5, 30 and 91 stay where they are") {
  for (const int base : {1, 2, 4, 6}) {
    World world;
    PileOfHulls{.base = base}(world);
    INFO(world.bodies.size() - 1);
    CHECK(drift(world, HalfStep(), 10) < 1e-12);
  }
}
