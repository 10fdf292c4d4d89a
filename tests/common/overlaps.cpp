// What a body that is not in the world would touch there.
#include <algorithm>

#include "pushback/common/bodies/random.h"
#include "pushback/common/collision/collide.h"
#include "pushback/common/world/query.h"
#include "tests/support/catch.h"
#include "tests/support/complaint.h"

using namespace pushback;

namespace {

/// Of several shapes, every fourth immovable, in groups of their own, some with skins; and the ground.
World crowd(Random& random) {
  World world;
  world.add(ground());
  for (int i = 0; i < 40; ++i) {
    Body body = random.body(1).at(random.vector(2));
    body.in_groups(1u << random.below(3)).touching(static_cast<std::uint32_t>(random.below(8)));
    if (i % 4 == 0) body.fixed();
    if (i % 3 == 0) body.with_skin(random.between(0, Real(0.1)));
    world.add(body);
  }
  return world;
}

}  // namespace

TEST_CASE("overlaps: they are the contacts that the ghost would have if it were in the world") {
  Random random(1);
  int found_some = 0;
  for (int i = 0; i < 300; ++i) {
    const World world = crowd(random);
    Body ghost = random.body(1).at(random.vector(2));
    ghost.in_groups(1u << random.below(3)).touching(static_cast<std::uint32_t>(random.below(8)));
    if (i % 3 == 0) ghost.with_skin(random.between(0, Real(0.2)));
    World with_it = world;
    const auto itself = static_cast<std::uint32_t>(with_it.add(ghost));
    with_it.find_contacts();
    Contacts expected;
    for (const Contact& contact : with_it.contacts)
      if (contact.id.body_b == itself) expected.push_back(contact);
    Contacts found;
    if (i % 2 == 0) ghost.fixed();  // is of no matter
    for (const Overlap& overlap : overlaps(world, ghost)) {
      for (const Contact& contact : overlap.contacts) {
        CHECK(contact.id.body_a == static_cast<std::uint32_t>(overlap.body));
        found.push_back(contact);
      }
    }
    REQUIRE(found.size() == expected.size());
    for (std::size_t k = 0; k < found.size(); ++k) {
      REQUIRE(found[k].id == expected[k].id);
      REQUIRE((found[k].point == expected[k].point && found[k].normal == expected[k].normal));
      REQUIRE(found[k].depth == expected[k].depth);
    }
    found_some += !found.empty();
  }
  CHECK(found_some > 100);
}

TEST_CASE("overlaps: a fixed ghost finds what is immovable, and with a skin what is near") {
  World world;
  world.add(ground());
  const int post = world.add(box({1, 1, 1}, 1).at({0, 5, 0}).fixed());
  const auto touched = [&world](const Body& ghost) {
    std::vector<int> bodies;
    for (const Overlap& overlap : overlaps(world, ghost)) bodies.push_back(overlap.body);
    return bodies;
  };
  const Body ball = sphere(Real(0.5), 1).at({0, Real(6.75), 0}).fixed();  // 0.25 m above the post
  CHECK(touched(ball).empty());
  CHECK(touched(Body(ball).with_skin(Real(0.2))).empty());
  const auto near = overlaps(world, Body(ball).with_skin(Real(0.3)));
  REQUIRE(near.size() == 1);
  CHECK(near[0].body == post);
  REQUIRE(near[0].contacts.size() == 1);
  CHECK(near[0].contacts[0].depth == Approx(0.05));
  CHECK(near[0].contacts[0].normal == Vec3::UnitY());
  CHECK(touched(Body(ball).at({0, Real(0.4), 0})) == std::vector<int>{0});
  CHECK(touched(half_space({0, 1, 0}).at({0, Real(4.5), 0})) == std::vector<int>{post});  // two half-spaces never touch
  CHECK(touched(Body(ball).at({0, Real(5), 0}).touching(2)).empty());
}

TEST_CASE("overlaps: a ghost that could not be added to the world is refused in the same words") {
  World world;
  const Body wrong = sphere(1, 1).at({0, std::numeric_limits<Real>::infinity(), 0});
  CHECK(complaint([&] { overlaps(world, wrong); }) == complaint([&] { world.add(wrong); }));
  CHECK(complaint([&] { overlaps(world, wrong); }) == "position is (0, inf, 0): three finite numbers are needed");
}
