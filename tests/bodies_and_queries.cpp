// The code of docs/bodies_and_queries.md, and what the page says of it.
#include <fmt/format.h>

#include <optional>

#include "pushback/chapters/13_joints/weld.h"
#include "pushback/common/world/query.h"
#include "pushback/engine/presets.h"
#include "tests/support/call.h"
#include "tests/support/yardstick.h"

using namespace pushback;

TEST_CASE("bodies and queries: debris lies on the scenery and falls through people") {
  World world;
  constexpr std::uint32_t scenery = 1, people = 2, debris = 4;
  world.add(ground());  // in group 1, like every body that says nothing
  world.add(sphere(0.5, 80).at({0, 0.5, 0}).in_groups(people));
  world.add(box({0.125, 0.125, 0.125}, 1).at({0, 3, 0}).in_groups(debris).touching(scenery | debris));

  Recommended solver;
  for (int i = 0; i < 120; ++i) world.step(solver, h);
  CHECK((world.bodies[1].position - Vec3(0, 0.5, 0)).norm() < Real(1e-3));
  CHECK(std::abs(world.bodies[2].position.y() - Real(0.125)) < Real(1e-3));
}

TEST_CASE("bodies and queries: limbs of a group that does not touch itself") {
  World world;
  constexpr std::uint32_t limbs = 8;
  for (int i = 0; i < 3; ++i)
    world.add(capsule(0.125, 0.25, 5).at({Real(i) / 8, 1, 0}).in_groups(limbs).touching(every_group & ~limbs));

  world.add(box({1, 0.5, 1}, 50).at({0, 0.25, 0}));
  world.find_contacts();
  CHECK(world.contacts.size() >= 3);
  for (const Contact& contact : world.contacts) CHECK(contact.id.body_b == 3);
}

TEST_CASE("bodies and queries: a lift goes up by 2 m in 4 s, and turns by a quarter") {
  World world;
  Recommended solver;
  const Real dt = Real(1) / 60;
  const int lift = world.add(box({1, 0.125, 1}, 1).fixed());
  const int load = world.add(box({0.25, 0.25, 0.25}, 30).at({0.5, 0.375, 0}));

  for (int i = 1; i <= 240; ++i) {
    const Real share = (1 - std::cos(pi * Real(i) / 240)) / 2;  // 0 to 1, beginning and ending at rest
    const Quat turn(Eigen::AngleAxis<Real>(share * pi / 2, Vec3::UnitY()));
    world.bodies[std::size_t(lift)].moved_to({0, 2 * share, 0}, turn, dt);
    world.step(solver, dt);
  }

  CHECK((world.bodies[std::size_t(lift)].position - Vec3(0, 2, 0)).norm() < point_rounding);
  CHECK((world.bodies[std::size_t(load)].position - Vec3(0, 2.375, -0.5)).norm() < Real(1e-3));
}

TEST_CASE("bodies and queries: a conveyor with a roller at its end") {
  World world;
  Recommended solver;
  world.add(box({3, 0.25, 1}, 1).fixed().at({-3, -0.24, 0}).conveying({1, 0, 0}));  // 1 cm above the ground
  const Body roller = capsule(0.25, 1, 1).turned(pi / 2, Vec3::UnitX()).fixed();
  world.add(Body(roller).at({0, -0.24, 0}).spinning({0, 0, -4}));  // 4 rad/s on 0.25 m: 1 m/s as well

  world.add(box({0.25, 0.125, 0.25}, 10).at({-2, 0.135, 0}));
  for (int i = 0; i < 60; ++i) world.step(solver, h);
  CHECK(std::abs(world.bodies[2].velocity.x() - 1) < Real(1e-3));
  for (int i = 0; i < 240; ++i) world.step(solver, h);
  CHECK(world.bodies[2].position.y() < -1);  // over the roller, and down
  CHECK(world.bodies[0].position == Vec3(-3, -0.24, 0));
}

namespace {

/// m/s: of a box after a second on the page's belt, whose surface is `above` the ground.
template <class Solver>
Real speed_on_belt(Real above) {
  World world;
  Solver solver;
  world.add(ground());
  world.add(box({3, 0.25, 1}, 1).fixed().at({-3, above - Real(0.25), 0}).conveying({1, 0, 0}));
  world.add(box({0.2, 0.2, 0.2}, 5).at({-5, above + Real(0.2), 0}));
  for (int i = 0; i < 60; ++i) world.step(solver, Real(1) / 60);
  return world.bodies[2].velocity.x();
}

}  // namespace

TEST_CASE("bodies and queries: a belt that stands out of the ground conveys, one in its plane does not") {
  CHECK(speed_on_belt<Recommended>(Real(0.01)) == Approx(1).epsilon(1e-3));
  CHECK(speed_on_belt<Exact>(Real(0.01)) == Approx(1).epsilon(1e-3));
  CHECK(speed_on_belt<Fast>(Real(0.01)) == Approx(1).epsilon(1e-2));
  if (!in_double) return;  // the page is about double
  const std::string sentence = fmt::format("after a second it moves at {:.2f} m/s", speed_on_belt<Recommended>(0));
  INFO(sentence);
  CHECK(text_of(fs::path(SOURCE_DIR) / "docs/bodies_and_queries.md").find(sentence) != std::string::npos);
}

TEST_CASE("bodies and queries: a removed body leaves an empty place, and what lay on it falls") {
  World world;
  Recommended solver;
  world.add(ground());
  const int crate = world.add(box({0.25, 0.25, 0.25}, 10).at({0, 0.25, 0}));
  const int ball = world.add(sphere(0.25, 5).at({0, 0.75, 0}));
  world.remove(crate);  // the ball falls; its index is what it was
  for (int i = 0; i < 60; ++i) world.step(solver, h);
  CHECK(world.bodies[std::size_t(ball)].position.y() == Approx(0.25).epsilon(1e-3));
  CHECK(world.bodies.size() == 3);
}

TEST_CASE("bodies and queries: a lamp hangs from a joint that may bear somewhat more") {
  World world;
  Recommended solver;
  const int lamp = world.add(sphere(0.25, 10).at({0, 2, 0}));
  world.joints.push_back(ball_and_socket(world, the_world, lamp, {0, 3, 0}));
  world.joints.back().breaks_at.force = 120;  // N; the lamp weighs 98.1 N
  for (int i = 0; i < 60; ++i) world.step(solver, h);
  CHECK(world.joints.size() == 1);
}

TEST_CASE("bodies and queries: a joint that bears more than it may is gone after the step") {
  for (const Real most : {Real(98), Real(99)}) {  // N, of 98.1
    World world;
    Recommended solver;
    const int lamp = world.add(sphere(0.25, 10).at({0, 2, 0}));
    world.joints.push_back(ball_and_socket(world, the_world, lamp, {0, 3, 0}));
    world.joints.back().breaks_at.force = most;
    for (int i = 0; i < 10; ++i) world.step(solver, h);
    CHECK(world.joints.size() == (most > 10 * g ? 1 : 0));
    if (!world.joints.empty()) CHECK(load_of(world, world.joints[0], h).force == Approx(10 * g).epsilon(1e-6));
  }
  for (const Real most : {Real(98), Real(99)}) {  // N m: a beam on a wall, its weight at an arm of 1 m
    World world;
    Recommended solver;
    const int beam = world.add(box({0.5, 0.125, 0.125}, 10).at({1, 0, 0}));
    world.joints.push_back(weld(world, the_world, beam, {0, 0, 0}));
    world.joints.back().breaks_at.torque = most;
    for (int i = 0; i < 10; ++i) world.step(solver, h);
    CHECK(world.joints.size() == (most > 10 * g ? 1 : 0));
    if (!world.joints.empty()) CHECK(load_of(world, world.joints[0], h).torque == Approx(10 * g).epsilon(1e-6));
  }
}

TEST_CASE("bodies and queries: by how much a face gives way that its surface runs away from is on the page") {
  if (!in_double) return;  // the page is about double
  World world;
  Recommended solver;
  world.add(ground());
  world.add(box({1, 1, 1}, 1).fixed().at({0, 1, 0}).conveying({-1, 0, 0}));
  world.add(box({0.25, 0.25, 0.25}, 10).at({1.25, 0.25, 0}).rough(0));
  Real deepest = 0;
  for (int i = 0; i < 120; ++i) {
    world.bodies[2].force = {-50, 0, 0};
    world.step(solver, h);
    deepest = std::max(deepest, Real(1.25) - world.bodies[2].position.x());
  }
  const std::string sentence = fmt::format("sinks by {:.0f} mm", 1000 * deepest);
  INFO(sentence);
  CHECK(text_of(fs::path(SOURCE_DIR) / "docs/bodies_and_queries.md").find(sentence) != std::string::npos);
}

TEST_CASE("bodies and queries: skins keep two boxes apart") {
  World world;
  Recommended solver;
  const Real skin = Real(0.02);
  world.add(ground().with_skin(skin / 2));
  world.add(box({0.25, 0.25, 0.25}, 10).at({0, 0.3125, 0}).with_skin(skin));
  world.add(box({0.25, 0.25, 0.25}, 10).at({0, 0.875, 0}).with_skin(skin));

  for (int i = 0; i < 240; ++i) world.step(solver, h);
  const Real lower = world.bodies[1].position.y(), upper = world.bodies[2].position.y();
  CHECK(std::abs(lower - Real(0.25) - Real(1.5) * skin) < Real(1e-4));
  CHECK(std::abs(upper - lower - Real(0.5) - 2 * skin) < Real(1e-4));
}

TEST_CASE("bodies and queries: what a ray hits, and what a body would touch") {
  World world;
  constexpr std::uint32_t people = 2;
  world.add(ground());
  world.add(sphere(0.5, 80).at({0, 0.5, 0}).in_groups(people));
  world.add(box({0.5, 0.5, 0.5}, 80).at({5, 0.5, 0}));

  const Ray sight{.origin = {-4, 0.5, 0}, .direction = {1, 0, 0}, .length = 20};
  const std::optional<RayHit> hit = nearest_hit(world, sight);    // body 1, at 3.5 m
  const std::vector<RayHit> on_the_way = all_hits(world, sight);  // bodies 1 and 2

  REQUIRE(hit);
  CHECK(hit->body == 1);
  CHECK(std::abs(hit->distance - Real(3.5)) < point_rounding);
  CHECK((hit->point - Vec3(-0.5, 0.5, 0)).norm() < point_rounding);
  CHECK((hit->normal - Vec3(-1, 0, 0)).norm() < point_rounding);
  REQUIRE(on_the_way.size() == 2);
  CHECK((on_the_way[0].body == 1 && on_the_way[1].body == 2));
  CHECK(nearest_hit(world, {.origin = {-4, 2, 0}, .direction = {1, 0, 0}}) == std::nullopt);

  const Body place = box({1, 1, 1}, 1).at({5, 1.25, 0});
  const bool room = overlaps(world, place).empty();
  const Body sensor = sphere(0.125, 1).at({0, 2, 0}).with_skin(1).touching(people);
  const std::vector<Overlap> within_a_metre = overlaps(world, sensor);

  CHECK_FALSE(room);
  REQUIRE(within_a_metre.size() == 1);
  CHECK(within_a_metre[0].body == 1);
  CHECK(std::abs(within_a_metre[0].contacts[0].depth - Real(0.125)) < point_rounding);  // 0.875 m apart
}
