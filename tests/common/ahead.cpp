/// What is looked at before it touches: contacts that are apart have the normal with which bodies touch that move straight on, and what
/// meets in a sliver alone holds nobody.
#include <algorithm>
#include <cmath>

#include "pushback/common/collision/collide.h"
#include "pushback/common/collision/margin.h"
#include "tests/support/any_shape.h"
#include "tests/support/catch.h"
#include "tests/support/hulls.h"
#include "tests/support/yardstick.h"

using namespace pushback;

namespace {

Body cube_hull(Real half) {
  return hull(corners_of_box(Vec3::Constant(half)), 1);
}

/// Where `b` has gone `t` of the time ahead, seen from `a`; with nothing ahead any more.
Contacts after(const Body& a, Body b, Real t) {
  b.position += t * h * (b.velocity - a.velocity);
  b.velocity = a.velocity;
  Contacts found;
  collide(a, b, found);
  return found;
}

}  // namespace

TEST_CASE("ahead: bodies that come from afar touch first along the normal that was foretold") {
  Random random(1);
  int touched = 0;
  for (int i = 0; i < 20000; ++i) {
    Body a = any_shape(random), b = any_shape(random);
    a.index = 0;
    b.index = 1;
    b.at(random.vector(3)).moving(random.vector(60));
    if (!after(a, b, 0).empty()) continue;
    Contacts found;
    collide(a, b, found, {.least = Real(0.001), .ahead = h});
    if (found.empty() || !found[0].ahead) continue;
    constexpr int parts = 2000;
    for (int k = 1; k <= parts; ++k) {
      const Contacts then = after(a, b, static_cast<Real>(k) / parts);
      if (then.empty()) continue;
      if (k == 1) break;
      CHECK(then[0].normal.dot(found[0].normal) > Real(0.999));
      // Along it the way there is as long as it was said to be.
      const Real way = h * (a.velocity - b.velocity).dot(found[0].normal) * static_cast<Real>(k) / parts;
      const auto deepest = std::max_element(found.begin(), found.end(),
                                            [](const Contact& p, const Contact& q) { return p.depth < q.depth; });
      CHECK(-deepest->depth == Approx(way).margin(Real(2) * h * (b.velocity - a.velocity).norm() / parts));
      ++touched;
      break;
    }
  }
  CHECK(touched > 300);
}

TEST_CASE("slivers: over tiles that lie flush no contact has another normal than their tops") {
  Random random(3);
  int points = 0;
  for (int i = 0; i < 4000; ++i) {
    const bool hulls = i % 2 == 0;
    constexpr Real half = Real(0.25), size = Real(0.2);
    const Real sinks = random.between(0, Real(1e-4));
    Body body = i % 3 == 0 ? cube_hull(size) : box(Vec3::Constant(size), 1);
    body.turned(random.between(0, 2 * pi), Vec3::UnitY());
    body.at({random.between(-half, half), size - sinks, random.between(-half, half)});
    body.moving({random.between(-5, 5), 0, random.between(-5, 5)});
    body.index = 9;
    int held = 0;
    for (int x = -2; x <= 2; ++x) {
      for (int z = -2; z <= 2; ++z) {
        Body tile = hulls ? cube_hull(half) : box(Vec3::Constant(half), 1);
        tile.fixed().at({2 * half * static_cast<Real>(x), -half, 2 * half * static_cast<Real>(z)});
        tile.index = 0;
        for (const Margin margin : {Margin{}, Margin{.least = Real(0.02), .ahead = h}}) {
          Contacts found;
          collide(tile, body, found, margin);
          for (const Contact& at : found) {
            if (at.depth <= -margin.of(tile, body)) continue;  // it tells that they come near each other
            CHECK(at.normal.y() > Real(0.9999));
            ++held;
          }
        }
      }
    }
    CHECK(held >= 3);
    points += held;
  }
  CHECK(points > 10000);
}

TEST_CASE("slivers: a step that is higher than a thousandth of the body is a wall") {
  constexpr Real size = Real(0.2);
  Body tile = box(Vec3::Constant(1), 1);
  tile.fixed().at({1, -1, 0}).index = 0;
  for (const Real deep : {Real(0.5e-3) * size, Real(2e-3) * size}) {
    for (const Margin margin : {Margin{}, Margin{.least = Real(0.02), .ahead = h}}) {
      Body body = box(Vec3::Constant(size), 1);
      body.at({-size + Real(1e-5), size - deep, 0}).moving({4, 0, 0}).index = 1;
      Contacts found;
      collide(tile, body, found, margin);
      std::erase_if(found, [&](const Contact& at) { return at.depth <= -margin.of(tile, body); });
      CHECK(found.empty() == (deep < Real(1e-3) * size));
      for (const Contact& at : found) CHECK(at.normal.x() == Approx(-1));
    }
  }
}
