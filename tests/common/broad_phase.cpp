// The broad phase against asking every pair.
#include "pushback/common/collision/broad_phase.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "pushback/common/bodies/random.h"
#include "pushback/common/world/world.h"
#include "tests/support/catch.h"
#include "tests/support/hulls.h"

using namespace pushback;

namespace {

/// A world of spheres, boxes and capsules in a cube, some of them immovable, and of a few half-spaces.
World random_world(int count, Real size, Random& random) {
  World world;
  for (int i = 0; i < count; ++i) {
    Body body = random.body(1);
    if (i % 11 == 0 && i < 50) body = half_space(random.vector(1) + Vec3(0, Real(1.5), 0));
    body.at(random.vector(size));
    if (i % 4 == 0) body.fixed();
    world.add(body);
  }
  return world;
}

bool is_half_space(const Body& body) {
  return std::holds_alternative<HalfSpace>(body.shape);
}

/// Whether any corner of the bounds is on the solid side.
bool reaches_into(const Bounds& bounds, const Body& plane) {
  const Vec3 normal = plane.orientation * std::get<HalfSpace>(plane.shape).normal;
  for (int corner = 0; corner < 8; ++corner) {
    const Vec3 p((corner & 1) ? bounds.high.x() : bounds.low.x(), (corner & 2) ? bounds.high.y() : bounds.low.y(),
                 (corner & 4) ? bounds.high.z() : bounds.low.z());
    if (normal.dot(p - plane.position) <= 0) return true;
  }
  return false;
}

std::vector<BodyPair> every_near_pair(const std::vector<Body>& bodies) {
  std::vector<BodyPair> pairs;
  for (int i = 0; i < int(bodies.size()); ++i) {
    for (int j = i + 1; j < int(bodies.size()); ++j) {
      const Body &a = bodies[std::size_t(i)], &b = bodies[std::size_t(j)];
      if (!a.movable() && !b.movable()) continue;
      const bool near = is_half_space(a)   ? !is_half_space(b) && reaches_into(bounds_of(b), a)
                        : is_half_space(b) ? reaches_into(bounds_of(a), b)
                                           : bounds_of(a).overlaps(bounds_of(b));
      if (near) pairs.emplace_back(i, j);
    }
  }
  return pairs;
}

}  // namespace

TEST_CASE("bounds are the smallest boxes along the world axes") {
  const auto require_bounds = [](const Body& body, const Vec3& reach) {
    const Bounds bounds = bounds_of(body);
    for (int i = 0; i < 3; ++i) {
      REQUIRE(bounds.low[i] == Approx(body.position[i] - reach[i]).margin(1e-5));
      REQUIRE(bounds.high[i] == Approx(body.position[i] + reach[i]).margin(1e-5));
      REQUIRE(bounds.low[i] <= body.position[i] - reach[i]);  // rounded outwards
      REQUIRE(bounds.high[i] >= body.position[i] + reach[i]);
    }
  };
  require_bounds(sphere(2, 1).at({1, 2, 3}), {2, 2, 2});
  require_bounds(box({1, 2, 3}, 1).at({4, 5, 6}), {1, 2, 3});
  const Real root = std::sqrt(Real(0.5));
  require_bounds(box({1, 2, 3}, 1).at({4, 5, 6}).turned(pi / 4, Vec3::UnitZ()), {3 * root, 3 * root, 3});
  require_bounds(capsule(Real(0.5), 2, 1).at({4, 5, 6}), {Real(0.5), Real(2.5), Real(0.5)});
  require_bounds(capsule(Real(0.5), 2, 1).at({4, 5, 6}).turned(pi / 4, Vec3::UnitX()),
                 {Real(0.5), 2 * root + Real(0.5), 2 * root + Real(0.5)});
  require_bounds(hull(corners_of_box({1, 2, 3}), 1).at({4, 5, 6}).turned(pi / 4, Vec3::UnitZ()),
                 {3 * root, 3 * root, 3});
  const Bounds all = bounds_of(ground());
  REQUIRE(all.low == Vec3::Constant(-std::numeric_limits<Real>::infinity()));
  REQUIRE(all.high == Vec3::Constant(std::numeric_limits<Real>::infinity()));
}

TEST_CASE("near pairs are those that asking every pair finds, in ascending order") {
  Random random(7);
  std::size_t found = 0;
  for (const int count : {0, 1, 2, 3, 10, 50, 200}) {
    for (const Real size : {Real(0), Real(1), Real(4), Real(20)}) {
      const World world = random_world(count, size, random);
      const std::vector<BodyPair> pairs = near_pairs(world.bodies);
      INFO(count << " bodies within " << size << " m");
      REQUIRE(pairs == every_near_pair(world.bodies));
      REQUIRE(std::is_sorted(pairs.begin(), pairs.end()));
      REQUIRE(std::adjacent_find(pairs.begin(), pairs.end()) == pairs.end());
      for (const auto& [first, second] : pairs) REQUIRE(first < second);
      found += pairs.size();
    }
  }
  REQUIRE(found > 10000);
}

TEST_CASE(
    "whatever the axis along which a scene is spread, their sizes, and however far some are away: the same pairs") {
  Random random(9);
  for (int axis = 0; axis < 3; ++axis) {
    for (const Real far : {Real(3), Real(1e3), Real(1e9)}) {
      World world;
      for (int i = 0; i < 400; ++i) {
        const Real size = i % 50 == 0 ? Real(8) : i % 5 == 0 ? Real(1) : Real(0.1);
        Vec3 where = random.vector(5) + (i % 100 == 1 ? Vec3(far, -far, far) : Vec3::Zero());
        where[axis] *= 8;
        world.add(box(size * (random.vector(1).cwiseAbs() + Vec3::Constant(Real(0.1))), 1).at(where));
      }
      const std::vector<BodyPair> pairs = near_pairs(world.bodies);
      REQUIRE(pairs == every_near_pair(world.bodies));
      REQUIRE(pairs.size() > 100);
    }
  }
}

TEST_CASE("bodies that may move are near if their ways reach, and one that goes far adds no pairs of others") {
  Random random(10);
  for (const int count : {1, 10, 200}) {
    World world = random_world(count, 4, random);
    std::vector<Real> ways;
    for (int i = 0; i < count; ++i) ways.push_back(i % 3 == 0 ? 0 : random.between(0, Real(0.5)));
    std::vector<Body> grown = world.bodies;  // by a skin
    for (std::size_t i = 0; i < grown.size(); ++i) {
      Body& body = grown[i];
      if (is_half_space(body)) body.position += ways[i] * (body.orientation * std::get<HalfSpace>(body.shape).normal);
      else body.skin += ways[i];
    }
    REQUIRE(near_pairs(world.bodies, ways) == every_near_pair(grown));
    if (count < 10) continue;
    std::fill(ways.begin(), ways.end(), Real(0));
    const std::vector<BodyPair> before = near_pairs(world.bodies);
    REQUIRE(near_pairs(world.bodies, ways) == before);
    constexpr int goes_far = 1;
    ways[goes_far] = 50;
    std::vector<BodyPair> now = near_pairs(world.bodies, ways);
    REQUIRE(std::erase_if(now, [](const BodyPair& pair) {
              return pair.first == goes_far || pair.second == goes_far;
            }) == world.bodies.size() - 1);
    std::vector<BodyPair> others = before;
    std::erase_if(others, [](const BodyPair& pair) { return pair.first == goes_far || pair.second == goes_far; });
    REQUIRE(now == others);
  }
}

TEST_CASE("boxes that only just touch are near, wherever they are") {
  Random random(7);
  for (int i = 0; i < 100; ++i) {
    World world;
    const Vec3 where = random.vector(1000);
    world.add(box({Real(0.1), Real(0.1), Real(0.1)}, 1).at(where));
    world.add(box({Real(0.1), Real(0.1), Real(0.1)}, 1).at(where + Vec3(0, Real(0.2), 0)));
    REQUIRE(near_pairs(world.bodies).size() == 1);
  }
}
