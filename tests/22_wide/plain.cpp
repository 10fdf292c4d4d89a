/// Chapter 22: the plain form of the colouring, compared with the engine's sets.
#include "pushback/chapters/22_wide/plain.h"

#include <algorithm>

#include "pushback/common/bodies/random.h"
#include "pushback/engine/substeps/pair_colouring.h"
#include "tests/support/catch.h"

using namespace pushback;

namespace {

std::vector<bool> movable_in(const World& world) {
  std::vector<bool> movable;
  for (const Body& body : world.bodies) movable.push_back(body.movable());
  return movable;
}

std::vector<plain_22::Set> plain_sets(const std::vector<TouchingPair>& pairs, const World& world) {
  std::vector<plain_22::Pair> plain;
  for (const TouchingPair& pair : pairs) plain.push_back({pair.a, pair.b});
  return plain_22::coloured(plain, movable_in(world));
}

/// Each pair is in one set, and no movable body occurs twice in a set.
void check_sets(const std::vector<plain_22::Set>& sets, const std::vector<TouchingPair>& pairs, const World& world) {
  std::vector<plain_22::Pair> left;
  for (const TouchingPair& pair : pairs) left.push_back({pair.a, pair.b});
  for (const plain_22::Set& set : sets) {
    std::vector<int> occurs(world.bodies.size(), 0);
    for (const plain_22::Pair& pair : set) {
      const auto at = std::find(left.begin(), left.end(), pair);
      REQUIRE(at != left.end());
      left.erase(at);
      for (const std::size_t body : {pair.a, pair.b})
        if (world.bodies[body].movable()) CHECK(++occurs[body] == 1);
    }
  }
  CHECK(left.empty());
}

std::vector<plain_22::Set> engine_sets(const std::vector<TouchingPair>& pairs, const World& world) {
  std::vector<plain_22::Set> sets;
  for (const auto& set : colour_pairs(pairs, world)) {
    sets.emplace_back();
    for (const TouchingPair& pair : set) sets.back().push_back({pair.a, pair.b});
  }
  return sets;
}

/// In a set, the engine puts pairs with more contacts first.
void sort_as_engine(std::vector<plain_22::Set>& sets, const std::vector<TouchingPair>& pairs) {
  const auto contacts = [&pairs](const plain_22::Pair& pair) {
    const auto is = [&pair](const TouchingPair& one) { return one.a == pair.a && one.b == pair.b; };
    return std::find_if(pairs.begin(), pairs.end(), is)->count;
  };
  for (plain_22::Set& set : sets)
    std::stable_sort(set.begin(), set.end(), [&](const auto& p, const auto& q) { return contacts(p) > contacts(q); });
}

}  // namespace

TEST_CASE(
    "plain colouring: of any pairs in any order, the sets are the engine's, which puts pairs with more contacts "
    "first") {
  Random random(22);
  for (int i = 0; i < 50; ++i) {
    const std::size_t bodies = 2 + random.below(40);
    World world;
    for (std::size_t k = 0; k < bodies; ++k) world.add(random.below(6) > 0 ? sphere(1, 1) : sphere(1, 1).fixed());
    std::vector<TouchingPair> pairs;
    for (std::size_t a = 0; a < bodies; ++a)
      for (std::size_t b = a + 1; b < bodies; ++b)
        if (random.below(3) == 0 && (world.bodies[a].movable() || world.bodies[b].movable()))
          pairs.push_back({a, b, pairs.size(), 1 + random.below(4)});
    random.shuffle(pairs);
    std::vector<plain_22::Set> sets = plain_sets(pairs, world);
    check_sets(sets, pairs, world);
    sort_as_engine(sets, pairs);
    CHECK(sets == engine_sets(pairs, world));
  }
}
