// Skins: what keeps other bodies away from a body's shape.

#include "pushback/common/collision/collide.h"
#include "pushback/engine/islands/sleep.h"
#include "pushback/tools/catalogue/solvers.h"
#include "tests/support/any_shape.h"
#include "tests/support/catch.h"
#include "tests/support/complaint.h"
#include "tests/support/yardstick.h"

using namespace pushback;

TEST_CASE("skin: the depth of any two shapes is larger by both skins than without, where they are apart as well") {
  Random random(2);
  int compared = 0;
  for (int i = 0; i < 5000; ++i) {
    Body a = any_shape(random), b = any_shape(random);
    if (i % 5 == 0) a = ground();
    a.index = 0;
    b.index = 1;
    b.at(random.vector(Real(1.5))).moving(random.vector(1));
    const Margin margin{.least = Real(0.01), .ahead = i % 2 == 0 ? 0 : h};
    Contacts plain, skinned;
    const Real skin_a = random.between(0, Real(0.1)), skin_b = random.between(0, Real(0.1));
    collide(a, b, plain, {.least = margin.least + skin_a + skin_b, .ahead = margin.ahead});
    collide(Body(a).with_skin(skin_a), Body(b).with_skin(skin_b), skinned, margin);
    REQUIRE(plain.size() == skinned.size());
    for (std::size_t k = 0; k < plain.size(); ++k) {
      ++compared;
      CHECK(skinned[k].id == plain[k].id);
      CHECK(skinned[k].normal == plain[k].normal);
      CHECK(std::abs(skinned[k].depth - (plain[k].depth + skin_a + skin_b)) < point_rounding);
      CHECK((skinned[k].point - (plain[k].point + (skin_a - skin_b) / 2 * plain[k].normal)).norm() < point_rounding);
    }
  }
  CHECK(compared > 2000);
}

TEST_CASE("skin: no pair that touches by its skins is lost on the way to the narrow phase") {
  Random random(3);
  std::size_t by_skin = 0;
  for (int i = 0; i < 100; ++i) {
    World world;
    for (int k = 0; k < 30; ++k) {
      Body body = k == 7 ? half_space({0, 1, 0}).at({0, -3, 0}) : random.body(1).at(random.vector(4));
      world.add(body.with_skin(k % 2 == 0 ? 0 : random.between(0, Real(0.5))));
    }
    Contacts expected;
    for (std::size_t a = 0; a < world.bodies.size(); ++a)
      for (std::size_t b = a + 1; b < world.bodies.size(); ++b) collide(world.bodies[a], world.bodies[b], expected);
    world.find_contacts();
    REQUIRE(world.contacts.size() == expected.size());
    for (std::size_t k = 0; k < expected.size(); ++k) CHECK(world.contacts[k].id == expected[k].id);
    for (Body& body : world.bodies) body.skin = 0;
    world.find_contacts();
    by_skin += expected.size() - world.contacts.size();
  }
  CHECK(by_skin > 500);
}

TEST_CASE("skin: a sleeper is touched by its skin") {
  World world;
  world.add(ground());
  world.add(box(Vec3::Constant(Real(0.5)), 100).at({0, Real(0.5), 0}));
  AnySolver solver = solver_named("12 soft contacts").solver;
  OnlyWhatIsNeeded resting(world, solver, Sleep{});
  for (int i = 0; i < 120; ++i) resting.step(world, h, 1);
  REQUIRE(world.bodies[1].asleep);
  world.add(sphere(Real(0.3), 1).at({Real(0.9), Real(0.4), 0}).with_skin(Real(0.05)));  // 0.1 m from the box
  resting.step(world, h, 1);
  CHECK(world.bodies[1].asleep);
  world.add(sphere(Real(0.3), 1).at({Real(-0.9), Real(0.4), 0}).with_skin(Real(0.15)));
  resting.step(world, h, 1);
  CHECK_FALSE(world.bodies[1].asleep);
}

TEST_CASE("skin: one that is no thickness is refused by name") {
  World world;
  Body body = sphere(1, 1);
  CHECK(complaint([&] { body.with_skin(-1); }) == "skin is -1: a finite number, 0 or more, is needed");
  body.skin = std::numeric_limits<Real>::quiet_NaN();
  CHECK(complaint([&] { world.add(body); }) == "skin is nan: a finite number, 0 or more, is needed");
}
