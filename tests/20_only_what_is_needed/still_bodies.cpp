// Bodies that stay where they are: the tree against asking every one.
#include "pushback/engine/islands/still_bodies.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "pushback/common/bodies/random.h"
#include "pushback/common/world/world.h"
#include "tests/support/catch.h"

using namespace pushback;

namespace {

/// What the tree finds, after what was there before.
std::vector<int> near(const StillBodies& still, const Bounds& bounds) {
  std::vector<int> found = {7, -5};
  still.near(bounds, found);
  REQUIRE(found.size() >= 2);
  REQUIRE(std::vector<int>(found.begin(), found.begin() + 2) == std::vector<int>{7, -5});
  return {found.begin() + 2, found.end()};
}

/// Asks the tree of these bodies who is near each query; how many it found, all queries together.
std::size_t require_as_one_by_one(const std::vector<Body>& bodies, const std::vector<int>& which,
                                  const std::vector<Bounds>& queries) {
  const StillBodies still(bodies, which);
  std::size_t count = 0;
  for (const Bounds& query : queries) {
    std::vector<int> expected;
    for (const int index : which) {
      if (bounds_of(bodies[std::size_t(index)]).overlaps(query)) expected.push_back(index);
    }
    REQUIRE(near(still, query) == expected);
    count += expected.size();
  }
  return count;
}

std::vector<Body> random_bodies(int count, Real size, Random& random) {
  std::vector<Body> bodies;
  for (int i = 0; i < count; ++i) {
    Body body = random.body(1);
    bodies.push_back(body.at(random.vector(size)));
  }
  return bodies;
}

std::vector<Bounds> bounds_of_all(const std::vector<Body>& bodies) {
  std::vector<Bounds> bounds;
  for (const Body& body : bodies) bounds.push_back(bounds_of(body));
  return bounds;
}

constexpr Real infinity = std::numeric_limits<Real>::infinity();
const Bounds everywhere = {Vec3::Constant(-infinity), Vec3::Constant(infinity)};

}  // namespace

TEST_CASE("the tree finds those that asking every one finds, in ascending order") {
  Random random(1);
  std::size_t found = 0;
  for (const int count : {1, 2, 3, 4, 5, 10, 50, 300}) {
    for (const Real size :
         {Real(0), Real(1), Real(5), Real(20), Real(1e30)}) {  // all at the same place, ..., far apart
      std::vector<Body> bodies = random_bodies(count, size, random);
      if (count > 4) bodies.back() = box({10000, Real(0.1), 10000}, 1).at({1, 0, 2});  // one that reaches everywhere
      std::vector<int> which;                                                          // about two of three
      for (int i = 0; i < count; ++i) {
        if (random.below(3) > 0) which.push_back(i);
      }
      std::vector<Bounds> queries = bounds_of_all(random_bodies(50, size + 1, random));
      queries.push_back(everywhere);
      INFO(which.size() << " of " << count << " bodies within " << size << " m");
      found += require_as_one_by_one(bodies, which, queries);
      found += require_as_one_by_one(bodies, which, bounds_of_all(bodies));
    }
  }
  REQUIRE(found > 100000);
}

TEST_CASE("the pairs among the moving, and of these with the still ones, are all the near pairs") {
  Random random(5);
  std::size_t found = 0;
  for (int scene = 0; scene < 20; ++scene) {
    std::vector<Body> bodies = random_bodies(200, 5, random);
    std::vector<int> moving, still;
    for (int i = 0; i < 200; ++i) {
      (random.below(20) == 0 ? moving : still).push_back(i);
    }
    for (const int index : still) bodies[std::size_t(index)].fixed();
    std::vector<BodyPair> pairs = near_pairs(bodies, moving);
    const StillBodies tree(bodies, still);
    for (const int index : moving) {
      for (const int other : near(tree, bounds_of(bodies[std::size_t(index)]))) {
        pairs.push_back(std::minmax(index, other));
      }
    }
    std::sort(pairs.begin(), pairs.end());
    REQUIRE(pairs == near_pairs(bodies));
    found += pairs.size();
  }
  REQUIRE(found > 500);
}
