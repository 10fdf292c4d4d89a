// Which pairs may touch: groups and masks, beside what joints switch off.
#include <algorithm>
#include <set>

#include "pushback/chapters/13_joints/distance.h"
#include "pushback/common/bodies/random.h"
#include "pushback/common/collision/collide.h"
#include "pushback/common/world/world.h"
#include "tests/support/catch.h"

using namespace pushback;

namespace {

World crowd(Random& random, int count) {
  World world;
  world.add(ground());
  for (int i = 0; i < count; ++i) {
    Body body = random.body(1).at(random.vector(2));
    if (i % 5 == 0) body.fixed();
    world.add(body);
  }
  return world;
}

std::set<std::pair<int, int>> touching_pairs_of(const World& world) {
  std::set<std::pair<int, int>> pairs;
  for (const Contact& c : world.contacts) pairs.emplace(int(c.id.body_a), int(c.id.body_b));
  return pairs;
}

/// Whether any bit is 1 in both.
bool share_a_bit(std::uint32_t p, std::uint32_t q) {
  for (int i = 0; i < 32; ++i)
    if ((p >> i) % 2 == 1 && (q >> i) % 2 == 1) return true;
  return false;
}

}  // namespace

TEST_CASE("groups: of what overlaps, exactly those pairs touch of which each touches a group that the other is in") {
  Random random(1);
  std::size_t left = 0, all = 0;
  for (int i = 0; i < 200; ++i) {
    World world = crowd(random, 40);
    const bool dense = i % 2 == 0;
    const auto bits = [&random, dense] {
      const auto some = static_cast<std::uint32_t>(random.below(16));
      return dense ? some | 1u << (28 + random.below(4)) : some;
    };
    for (Body& body : world.bodies) body.in_groups(bits()), body.touching(bits());
    world.find_contacts();
    const Contacts found = world.contacts;
    World open = world;
    for (Body& body : open.bodies) body.in_groups(1).touching(every_group);
    open.find_contacts();
    Contacts expected;
    for (const Contact& contact : open.contacts) {
      const auto [a, b] = std::as_const(world).bodies_of(contact);
      if (share_a_bit(a.touches, b.groups) && share_a_bit(b.touches, a.groups)) expected.push_back(contact);
    }
    REQUIRE(found.size() == expected.size());
    for (std::size_t k = 0; k < found.size(); ++k) {
      REQUIRE(found[k].id == expected[k].id);
      REQUIRE((found[k].depth == expected[k].depth && found[k].point == expected[k].point));
    }
    left += found.size();
    all += open.contacts.size();
  }
  CHECK(left > all / 10);
  CHECK(left < all * 9 / 10);
}

TEST_CASE("groups: who says nothing touches everybody, and who is in no group, or touches none, touches nobody") {
  Random random(2);
  World world = crowd(random, 40);
  world.find_contacts();
  const auto all = touching_pairs_of(world);
  REQUIRE(all.size() > 20);
  const int ghost = all.rbegin()->second;
  for (const bool by_mask : {false, true}) {
    World with_ghost = world;
    Body& body = with_ghost.bodies[std::size_t(ghost)];
    by_mask ? body.touching(0) : body.in_groups(0);
    with_ghost.find_contacts();
    auto expected = all;
    std::erase_if(expected, [ghost](const auto& pair) { return pair.first == ghost || pair.second == ghost; });
    CHECK(expected.size() < all.size());
    CHECK(touching_pairs_of(with_ghost) == expected);
  }
}

TEST_CASE("groups: a joint lets its two bodies pass whatever their groups are, and no group is undone by a joint") {
  World world;
  for (int i = 0; i < 3; ++i) world.add(sphere(1, 1).at({Real(i) / 2, 0, 0}));
  world.find_contacts();
  CHECK(world.contacts.size() == 3);
  world.joints.push_back(distance(world, 0, world.bodies[0].position, 1, world.bodies[1].position));
  world.find_contacts();
  CHECK(touching_pairs_of(world) == std::set<std::pair<int, int>>{{0, 2}, {1, 2}});
  world.bodies[2].in_groups(2);
  world.bodies[0].touching(1);
  world.joints[0].colliding = true;
  world.find_contacts();
  CHECK(touching_pairs_of(world) == std::set<std::pair<int, int>>{{0, 1}, {1, 2}});
}
