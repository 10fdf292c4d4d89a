/// Chapter 27: in how many of scenes that nobody has looked at an error is kept.
#include <array>

#include "pushback/chapters/13_joints/ball_and_socket.h"
#include "pushback/chapters/19_accuracy_and_time/truth.h"
#include "pushback/chapters/25_moment_of_impact/scenes.h"
#include "pushback/common/bodies/random.h"
#include "tests/27_which_error/played.h"
#include "tests/support/catch.h"

using namespace pushback;
using namespace pushback::which_error_tests;

namespace {

constexpr std::array errors{Real(1e-2), Real(1e-3), Real(1e-4), Real(1e-5)};  // m

/// Scenes within one error.
struct Tally {
  int scenes = 0, kept = 0, missed_by_3 = 0, missed_unsaid = 0;
  Real largest = 0;
  void add(const Fared& fared) {
    ++scenes;
    kept += fared.off <= 1;
    missed_by_3 += fared.off > 3;
    missed_unsaid += fared.off > 1 && fared.said;
    largest = std::max(largest, fared.off);
  }
  std::string words() const {
    return fmt::format("{} of {} kept, missed by up to {:.3g} times, {} by more than 3, {} unsaid", kept, scenes,
                       largest, missed_by_3, missed_unsaid);
  }
};
using Tallies = std::array<Tally, errors.size()>;

void play(const World& world, const std::vector<Places>& truth, Tallies& tallies) {
  for (std::size_t i = 0; i < errors.size(); ++i) tallies[i].add(fare(world, errors[i], truth));
}
Places places_of(const World& world) {
  Places places;
  for (const Body& body : world.bodies) places.push_back(body.position.cast<double>());
  return places;
}

/// One to six links of 0.2 to 1 m and 0.3 to 30 kg, each let go at an angle of its own. They hang free: none touches another.
World random_chain(Random& random) {
  World world;
  Vec3 pin = Vec3::Zero();
  int before = the_world;
  for (std::size_t count = 1 + random.below(6); count > 0; --count) {
    const Real length = random.between(Real(0.2), 1), mass = random.over_decades(Real(0.3), 30);
    const Real angle = random.between(Real(-1.5), Real(1.5));
    const Vec3 down(std::sin(angle), -std::cos(angle), 0);
    const int link = world.add(box({Real(0.05), length / 2, Real(0.05)}, mass)
                                   .turned(angle, Vec3::UnitZ())
                                   .at(pin + length / 2 * down)
                                   .touching(0));
    world.joints.push_back(ball_and_socket(world, before, link, pin));
    before = link;
    pin += length * down;
  }
  return world;
}
/// In 64 steps of fourth order, 320 half steps, to each of World::step.
std::vector<Places> true_places(World world, int substeps) {
  HalfStep step = composed();
  step.substeps = substeps;
  step.tolerance = Real(1e-12);
  std::vector<Places> places;
  for (int frame = 0; frame < 60; ++frame) {
    world.step(step, h);
    places.push_back(places_of(world));
  }
  return places;
}
double farthest_apart(const std::vector<Places>& one, const std::vector<Places>& other) {
  double largest = 0;
  for (std::size_t frame = 0; frame < one.size(); ++frame)
    for (std::size_t i = 0; i < one[frame].size(); ++i)
      largest = std::max(largest, (one[frame][i] - other[frame][i]).norm());
  return largest;
}

}  // namespace

TEST_CASE("within an error: chains let go at any angles, of which some whip so that nobody knows where they are") {
  Tallies tallies;
  int unknown = 0;  // its truth depends on the steps that it is found in
  for (const std::uint64_t seed : {5, 6, 7}) {
    Random random(seed);
    for (int i = 0; i < 20; ++i) {
      const World chain = random_chain(random);
      const std::vector<Places> truth = true_places(chain, 64);
      if (farthest_apart(true_places(chain, 32), truth) > 1e-6) ++unknown;
      else play(chain, truth, tallies);
    }
  }
  CHECK(unknown <= 5);
  for (const Tally& tally : tallies) {
    INFO(tally.words());
    CHECK(tally.kept >= tally.scenes * 98 / 100);
    CHECK(tally.missed_by_3 <= 1);  // the same chain, 11, 19 and 6 times: so many are asked for, and it is not so
  }
}

TEST_CASE("within an error: balls on a billiard table") {
  Tallies tallies;
  Random random(29);
  for (int i = 0; i < 40; ++i) {
    constexpr Real radius = Real(0.1), apart = Real(0.3), moved = Real(0.04);
    const Real e = random.between(Real(0.8), 1);
    World world;
    Places at, velocities;
    for (int ball = 0; ball < 12; ++ball) {
      Vec3 place = Vec3(static_cast<Real>(ball % 4), 0, static_cast<Real>(ball / 4)) * apart + random.vector(moved);
      Vec3 velocity = ball % 3 == 0 ? random.vector(3) : Vec3::Zero();
      place.y() = radius;
      velocity.y() = 0;
      world.add(sphere(radius, 1).at(place).moving(velocity).rough(0).bouncy(e));
      at.push_back(place.cast<double>());
      velocities.push_back(velocity.cast<double>());
    }
    world.add(ground().rough(0).bouncy(e));
    play(world, truth::places_of_colliding(at, velocities, double(radius), double(e), 60), tallies);
  }
  for (const Tally& tally : tallies) {
    INFO(tally.words());
    CHECK(tally.kept == 40);
  }
}
