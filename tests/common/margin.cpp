/// Contacts within a margin: what is apart is found as what overlaps is, only farther.
#include "pushback/common/collision/margin.h"

#include <algorithm>

#include "pushback/common/collision/broad_phase.h"
#include "pushback/common/collision/collide.h"
#include "pushback/common/world/situations.h"
#include "tests/support/any_shape.h"
#include "tests/support/catch.h"
#include "tests/support/yardstick.h"

using namespace pushback;

TEST_CASE("margin: two bodies moved apart along the normal touch at the same points, by so much less deep") {
  Random random(1);
  int compared = 0;
  for (int i = 0; i < 8000; ++i) {
    Body a = any_shape(random), b = any_shape(random);
    if (i % 5 == 0) a = ground();
    a.index = 0;
    b.index = 1;
    b.at(random.vector(Real(1.2)));
    Contacts touching;
    collide(a, b, touching);
    const auto by_depth = [](const Contact& p, const Contact& q) { return p.depth < q.depth; };
    if (touching.empty()) continue;
    const Real deepest = std::max_element(touching.begin(), touching.end(), by_depth)->depth;
    if (deepest > Real(0.05)) continue;
    const Real gap = deepest + Real(0.01);
    b.position += gap * touching[0].normal;
    Contacts apart;
    collide(a, b, apart);
    CHECK(apart.empty());
    collide(a, b, apart, {.least = gap});
    for (const Contact& before : touching) {
      const auto now = std::find_if(apart.begin(), apart.end(), [&](const Contact& c) { return c.id == before.id; });
      if (now == apart.end() || now->normal.dot(before.normal) < 1 - Real(1e-6))
        continue;  // another one of its features is nearer now
      CHECK(now->depth == Approx(before.depth - gap).margin(1e-6));
      CHECK((now->point - (before.point + gap / 2 * before.normal)).norm() < Real(1e-6));
      ++compared;
    }
  }
  CHECK(compared > 200);
}

TEST_CASE("margin: nothing is farther apart than the margin, and without one nothing is apart") {
  Random random(2);
  for (int i = 0; i < 2000; ++i) {
    Body a = any_shape(random), b = any_shape(random);
    a.index = 0;
    b.index = 1;
    b.at(random.vector(2)).moving(random.vector(3));
    for (const Margin margin : {Margin{}, Margin{.least = Real(0.1)}, Margin{.least = Real(0.01), .ahead = h}}) {
      Contacts found;
      collide(a, b, found, margin);
      for (const Contact& contact : found) CHECK(contact.depth >= -margin.of(a, b));
    }
  }
}

TEST_CASE("margin: who comes to touch on a straight way within the time ahead is among the near pairs") {
  Random random(3);
  for (int i = 0; i < 20; ++i) {
    std::vector<Body> bodies;
    World world;
    world.add(ground());
    for (int k = 0; k < 60; ++k) world.add(random.body(1).at(random.vector(6)).moving(random.vector(30)));
    const Margin margin{.least = 0, .ahead = h};
    const std::vector<BodyPair> near = near_pairs(world.bodies, margin);
    World later = world;
    for (int step = 1; step <= 4; ++step) {
      for (std::size_t k = 0; k < world.bodies.size(); ++k)
        later.bodies[k].position =
            world.bodies[k].position + static_cast<Real>(step) * h / 4 * world.bodies[k].velocity;
      for (const auto& [first, second] : near_pairs(later.bodies)) {
        Contacts found;
        collide(later.bodies[static_cast<std::size_t>(first)], later.bodies[static_cast<std::size_t>(second)], found);
        if (!found.empty()) CHECK(std::binary_search(near.begin(), near.end(), BodyPair(first, second)));
      }
    }
  }
}
