/// Chapter 25: how far apart, and when they first touch.
#include "pushback/engine/half_step/first_touch.h"

#include "pushback/common/collision/collide.h"
#include "pushback/engine/half_step/gap.h"
#include "tests/support/any_shape.h"
#include "tests/support/catch.h"
#include "tests/support/yardstick.h"

using namespace pushback;

namespace {

constexpr Real touching = in_double ? Real(1e-9) : Real(1e-4);

bool overlap(const Body& a, const Body& b) {
  Contacts found;
  collide(a, b, found);
  return std::any_of(found.begin(), found.end(), [](const Contact& at) { return at.depth > touching; });
}
Body shifted(const Body& body, const Vec3& by) {
  Body moved = body;
  moved.position += by;
  return moved;
}
/// Two bodies that are apart.
std::pair<Body, Body> pair_apart(Random& random) {
  Body a = any_shape(random).at(random.vector(1)), b = any_shape(random).at(Vec3(4, 0, 0) + random.vector(1));
  a.index = 0;
  b.index = 1;
  a.refresh_inertia();
  b.refresh_inertia();
  return {a, b};
}

}  // namespace

TEST_CASE("impact: a gap is closed by moving so far along its normal, and not by less") {
  if (!in_double) return;
  Random random(25);
  int beyond = 0;
  for (int i = 0; i < 2000; ++i) {
    CAPTURE(i);
    const auto [a, b] = pair_apart(random);
    const Gap gap = gap_between(a, b), back = gap_between(b, a);
    REQUIRE(gap.distance > 0);
    CHECK(gap.normal.norm() == Approx(1));
    CHECK(back.distance == Approx(gap.distance).margin(1e-7));
    // Where corners meet exactly, the depth is that of a face beside them.
    const Real closed = gap_between(a, shifted(b, -gap.distance * gap.normal)).distance;
    CHECK(closed < 10 * touching);
    CHECK(closed > Real(-0.001));
    const Real other = gap.distance * random.between(Real(0.1), Real(0.999));  // whichever way
    CHECK_FALSE(overlap(a, shifted(b, -other * random.direction())));
    beyond += overlap(a, shifted(b, -(gap.distance + Real(0.01)) * gap.normal));
  }
  CHECK(beyond > 1990);  // corners that meet may pass each other
}

TEST_CASE("impact: between round bodies and a plane, a gap is what collision detection says") {
  Random random(26);
  for (int i = 0; i < 500; ++i) {
    CAPTURE(i);
    Body plane = half_space(random.direction()).with_skin(Real(0.01));
    Body a = any_shape(random).at(random.vector(3)), b = sphere(random.between(Real(0.1), 1), 1).at(random.vector(3));
    plane.index = 0, a.index = 1, b.index = 2;
    Contacts found;
    const auto deepest = [&](const Body& p, const Body& q) {
      found.clear();
      collide(p, q, found, {.least = 100});
      Real depth = -100;
      for (const Contact& at : found) depth = std::max(depth, at.depth);
      return depth;
    };
    CHECK(gap_between(plane, a).distance == Approx(-deepest(plane, a)).margin(1e-6));
    CHECK((gap_between(plane, a).normal + gap_between(a, plane).normal).norm() < 100 * eps);
    const Real depth = deepest(a, b);
    if (depth < 0) CHECK(gap_between(a, b).distance == Approx(-depth).margin(1e-6));
  }
}

TEST_CASE("impact: between boxes whose faces are parallel but for rounding, a gap is not lost") {
  if (!in_double) return;
  Random random(3);
  for (int i = 0; i < 20000; ++i) {
    CAPTURE(i);
    const Real z = random.between(Real(0.01), Real(0.5)), y = random.between(Real(0.01), Real(0.5)),
               x = random.between(Real(0.01), Real(0.5));
    const Vec3 half(x, y, z);
    const Real apart = random.between(Real(0.001), 2), turn = std::pow(Real(10), random.between(-12, -7));
    const int axis = i % 3;
    const Body a = box(half, 1).oriented(random.orientation());
    Body b = box(half, 1).oriented(a.orientation);
    b.position = a.orientation * ((2 * half[axis] + apart) * Vec3::Unit(axis));
    b.orientation = Quat(Eigen::AngleAxis<Real>(turn, random.direction())) * b.orientation;
    CHECK(gap_between(a, b).distance == Approx(apart).margin(2 * turn + 1e-9));
  }
}

TEST_CASE("impact: the first root is one, and none is before it") {
  Random random(27);
  for (int i = 0; i < 2000; ++i) {
    CAPTURE(i);
    const Real d = random.between(0, 2), c = random.between(-3, 3), a = random.between(-3, 3);
    const auto at = [&](Real s) { return d + c * s + a * s * s / 2; };
    const Real root = first_root(d, c, a), until = std::min(root, Real(20));
    if (std::isfinite(root)) CHECK(std::abs(at(root)) < 1000 * eps * (1 + root * root));
    for (int k = 1; k < 100; ++k) CHECK(at(until * Real(0.01) * static_cast<Real>(k)) > -1000 * eps);
  }
}

TEST_CASE("impact: two balls touch when the closed form says so, however they graze") {
  // |x + v t| = R
  Random random(28);
  int met = 0;
  for (int i = 0; i < 500; ++i) {
    CAPTURE(i);
    const Body a = sphere(Real(0.3), 1).at(random.vector(1)).moving(random.vector(2));
    const Body b = sphere(Real(0.2), 1).at(Vec3(2, 0, 0) + random.vector(1)).moving({-10, 0, 0});
    const Vec3 x = b.position - a.position, v = b.velocity - a.velocity;
    const Real p = x.dot(v), q = x.squaredNorm() - Real(0.25), left = p * p - v.squaredNorm() * q;
    const Vec3 both(0, -g, 0);
    Flight of_a(a, both, Vec3::Zero(), 1), of_b(b, both, Vec3::Zero(), 1);
    const auto touch = first_touch(of_a, of_b, 1, touching);
    if (std::abs(left) < Real(1e-3) || q < 0) continue;  // rounding decides; or they overlap as it begins
    CHECK(touch.has_value() == (left > 0));
    if (touch) CHECK(*touch == Approx((-p - std::sqrt(left)) / v.squaredNorm()).margin(in_double ? 1e-8 : 1e-4));
    met += touch.has_value();
  }
  CHECK(met > 50);
}

TEST_CASE("impact: when two bodies are found to touch they do, and they have not overlapped before") {
  if (!in_double) return;  // a turn in a time so short is rounding in floats
  constexpr Real within = Real(1) / 30;
  for (const bool hardly_moving : {false, true}) {  // but turning fast, and close to each other
    Random random(hardly_moving ? 30 : 29);
    int met = 0;
    for (int i = 0; i < (hardly_moving ? 300 : 600); ++i) {
      CAPTURE(hardly_moving, i);
      auto [a, b] = pair_apart(random);
      Vec3 a_gains = Vec3::Zero(), b_gains = a_gains, a_turns = a_gains, b_turns = a_gains;
      if (hardly_moving) {
        const Gap gap = gap_between(a, b);
        b.position -= random.between(Real(0.95), 1) * gap.distance * gap.normal;
        a.spinning(random.vector(25));
        b.moving(random.vector(1)).spinning(random.vector(25));
      } else {
        a.moving(random.vector(2)).spinning(random.vector(6));
        b.moving(Vec3(-150, 0, 0) + random.vector(20)).spinning(random.vector(20));
        a_gains = random.vector(10), a_turns = random.vector(3), b_gains = random.vector(10),
        b_turns = random.vector(3);
      }
      Flight of_a(a, a_gains, a_turns, within), of_b(b, b_gains, b_turns, within);
      const auto touch = first_touch(of_a, of_b, within, touching);
      if (touch) {
        CHECK(std::abs(gap_between(of_a.at(*touch), of_b.at(*touch)).distance) < 2 * touching);
      }
      met += touch.has_value();
      CHECK(of_a.looks() <= 31);
      const Real until = touch.value_or(within);
      for (int k = 0; k < 400; ++k)
        REQUIRE_FALSE(
            overlap(of_a.at(until * static_cast<Real>(k) / 400), of_b.at(until * static_cast<Real>(k) / 400)));
    }
    CHECK(met > (hardly_moving ? 50 : 200));
  }
}

TEST_CASE("impact: who touches and leaves is found when it is back") {
  const Body plane = ground();
  const Body ball = sphere(Real(0.5), 1).at({0, Real(0.5), 0}).moving({0, 2, 0});
  Flight still(plane, Vec3::Zero(), Vec3::Zero(), 1), thrown(ball, {0, -g, 0}, Vec3::Zero(), 1);
  const auto again = first_touch(still, thrown, 1, touching);
  REQUIRE(again);
  CHECK(*again == Approx(4 / g).epsilon(in_double ? 1e-8 : 1e-4));
  CHECK_FALSE(first_touch(still, thrown, 4 / g - Real(0.01), touching));
}
