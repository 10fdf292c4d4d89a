// Where rays hit, against the distance of a point from each shape, which is written down here once more.
#include "pushback/common/collision/ray.h"

#include <algorithm>

#include "pushback/common/bodies/random.h"
#include "pushback/common/world/query.h"
#include "tests/support/catch.h"
#include "tests/support/complaint.h"
#include "tests/support/outside.h"
#include "tests/support/yardstick.h"

using namespace pushback;

namespace {

constexpr Real infinite = std::numeric_limits<Real>::infinity();

/// Any of the five shapes, somewhere within 1 m of the origin.
Body any_of_five(Random& random) {
  const std::size_t kind = random.below(6);
  if (kind == 0) return half_space(random.direction()).at(random.vector(1));
  if (kind > 1) return random.body(1).at(random.vector(1));
  std::vector<Vec3> points;
  for (int i = 0; i < 12; ++i) points.push_back(random.direction());
  return hull(points, 1).oriented(random.orientation()).at(random.vector(1));
}

Ray any_ray(Random& random) {
  Ray ray;
  ray.origin = random.vector(3);
  ray.direction = random.vector(1) - ray.origin;
  if (random.below(3) == 0) ray.length = random.between(0, 5);
  return ray;
}

Real distance_to(const Body& body, const Ray& ray) {
  const auto hit = first_hit(ray, body);
  return hit ? hit->distance : infinite;
}

}  // namespace

TEST_CASE("ray: it hits on the surface, no nearer point of it is inside, and what it misses it is never inside of") {
  Random random(1);
  int hits = 0, from_inside = 0, misses = 0;
  for (int i = 0; i < 20000; ++i) {
    const Body body = any_of_five(random);
    const Ray ray = any_ray(random);
    const Vec3 direction = ray.direction.normalized();
    const auto hit = first_hit(ray, body);
    const Real way = hit ? hit->distance : std::min(ray.length, Real(20));
    for (int k = 0; k < 100; ++k)
      REQUIRE(outside(body, ray.origin + way * Real(k) / 100 * direction) >=
              (hit && hit->inside ? -infinite : -point_rounding));
    if (!hit) {
      ++misses;
    } else if (hit->inside) {
      ++from_inside;
      REQUIRE(outside(body, ray.origin) < point_rounding);
      REQUIRE((hit->distance == 0 && hit->point == ray.origin && hit->normal == -direction));
    } else {
      ++hits;
      REQUIRE(hit->distance >= 0);
      REQUIRE(hit->distance <= ray.length);
      REQUIRE((hit->point - (ray.origin + hit->distance * direction)).norm() < point_rounding);
      REQUIRE(std::abs(outside(body, hit->point)) < point_rounding);
      REQUIRE(std::abs(hit->normal.norm() - 1) < point_rounding);
      REQUIRE(hit->normal.dot(direction) <= point_rounding);
      const Real step = Real(0.01);
      REQUIRE(std::abs(outside(body, hit->point + step * hit->normal) - step) < point_rounding);
    }
  }
  CHECK(hits > 5000);
  CHECK(from_inside > 500);
  CHECK(misses > 2000);
}

TEST_CASE("ray: distances in closed form") {
  const Ray along_x{.origin = {-5, 0, 0}, .direction = {2, 0, 0}};
  const Real root = std::sqrt(Real(2));
  CHECK(distance_to(sphere(1, 1), along_x) == Approx(4));
  CHECK(distance_to(sphere(1, 1).at({0, Real(0.6), 0}), along_x) == Approx(Real(5) - Real(0.8)));
  CHECK(distance_to(box({1, 2, 3}, 1), along_x) == Approx(4));
  CHECK(distance_to(box({1, 1, 1}, 1).turned(pi / 4, Vec3::UnitY()), along_x) == Approx(5 - root));
  CHECK(distance_to(capsule(1, 2, 1), along_x) == Approx(4));                                          // its side
  CHECK(distance_to(capsule(1, 2, 1).turned(pi / 2, Vec3::UnitZ()), along_x) == Approx(2));            // its end
  CHECK(distance_to(capsule(1, 2, 1).at({0, Real(2.6), 0}), along_x) == Approx(Real(5) - Real(0.8)));  // round end
  CHECK(distance_to(half_space({-1, 1, 0}).at({1, 0, 0}), along_x) == Approx(6));
  CHECK(distance_to(half_space({-1, 1, 0}).at({1, 3, 0}), along_x) == Approx(3));
  const auto corner = first_hit({.origin = {-5, 5, Real(0.25)}, .direction = {1, -1, 0}}, sphere(1, 1));
  REQUIRE(corner);
  CHECK(corner->distance == Approx(5 * root - std::sqrt(Real(1) - Real(0.0625))));
  CHECK((corner->point - corner->normal).norm() < point_rounding);  // of the unit sphere
}

TEST_CASE("ray: along faces, from the surface, from inside, and as long as it has to be") {
  const Body cube = box({1, 1, 1}, 1);
  const auto from = [](const Vec3& origin, const Vec3& direction, Real length = infinite) {
    return Ray{.origin = origin, .direction = direction, .length = length};
  };
  CHECK(distance_to(cube, from({-3, Real(0.5), 0}, {1, 0, 0})) == 2);  // parallel to four faces, between them
  CHECK(distance_to(cube, from({-3, 1, 0}, {1, 0, 0})) == 2);          // within the plane of one of them
  CHECK(distance_to(cube, from({-3, Real(1.001), 0}, {1, 0, 0})) == infinite);
  CHECK(distance_to(cube, from({-3, 0, 0}, {-1, 0, 0})) == infinite);  // behind it
  CHECK(distance_to(cube, from({-3, 0, 0}, {1, 0, 0}, 2)) == 2);
  CHECK(distance_to(cube, from({-3, 0, 0}, {1, 0, 0}, Real(1.999))) == infinite);
  CHECK(distance_to(cube, from({-3, 0, 0}, {1000, 0, 0}, 2)) == 2);  // its direction's length is of no matter
  CHECK(distance_to(capsule(1, 2, 1), from({1, -9, 0}, {0, 1, 0})) == Approx(7));
  CHECK(distance_to(ground(), from({0, 1, 0}, {1, 0, 0})) == infinite);  // parallel to a plane
  CHECK(distance_to(ground(), from({0, -1, 0}, {1, 0, 0})) == 0);        // and below it

  const auto onto = first_hit(from({-1, 0, 0}, {1, 0, 0}), cube);  // from the surface, inwards
  REQUIRE(onto);
  CHECK((onto->distance == 0 && !onto->inside && onto->normal == -Vec3::UnitX()));
  for (const Body& body : {cube, sphere(1, 1), capsule(1, 1, 1)}) {
    CHECK(distance_to(body, from({-1, 0, 0}, {-1, 0, 0})) == infinite);  // outwards
    const auto inside = first_hit(from({Real(0.25), 0, 0}, {1, 1, 0}, 0), body);
    REQUIRE(inside);
    CHECK((inside->inside && inside->distance == 0));
  }
}

TEST_CASE("ray: the nearest hit is the first of all hits, and these are those of each body by itself") {
  Random random(4);
  int several = 0;
  for (int i = 0; i < 200; ++i) {
    World world;
    for (int k = 0; k < 40; ++k) {
      Body body = random.body(1).at(random.vector(2)).in_groups(1u << random.below(4));
      world.add(body);
    }
    Ray ray = any_ray(random);
    ray.touches = static_cast<std::uint32_t>(random.below(16));
    std::vector<std::pair<Real, int>> expected;
    for (const Body& body : world.bodies) {
      if ((body.groups & ray.touches) == 0) continue;
      if (const auto hit = first_hit(ray, body)) expected.emplace_back(hit->distance, body.index);
    }
    std::sort(expected.begin(), expected.end());
    std::vector<std::pair<Real, int>> found;
    for (const RayHit& hit : all_hits(world, ray)) found.emplace_back(hit.distance, hit.body);
    CHECK(found == expected);
    const auto nearest = nearest_hit(world, ray);
    CHECK(nearest.has_value() == !expected.empty());
    if (nearest) CHECK(std::pair(nearest->distance, nearest->body) == expected.front());
    several += expected.size() > 1;
  }
  CHECK(several > 50);
}

TEST_CASE("ray: who is only just hit is not lost among many: corners and edges seen from afar, along the axes") {
  Random random(5);
  int hits = 0;
  for (int i = 0; i < 20000; ++i) {
    World world;
    const Real z = random.between(Real(0.1), 1), y = random.between(Real(0.1), 1), x = random.between(Real(0.1), 1);
    const Vec3 half(x, y, z);
    Body body = box(half, 1).at(random.vector(10));
    if (i % 2 == 0) body.oriented(random.orientation());
    if (i % 7 == 0) body = half_space(i % 2 == 0 ? Vec3::UnitY() : random.direction()).at(random.vector(10));
    world.add(body);
    const Vec3 sides((i & 1) ? 1 : -1, (i & 2) ? 1 : -1, (i & 4) ? 1 : -1);
    const Vec3 aim = body.position + body.orientation * half.cwiseProduct(sides);
    Ray ray{.origin = random.vector(100), .direction = {}};
    ray.direction = aim - ray.origin;
    if (i % 3 == 0) {  // parallel to two axes, in the plane of a face where the box is not turned
      ray.direction = 50 * Vec3::Unit(i % 9 / 3);
      ray.origin = aim - ray.direction;
    }
    if (i % 5 == 0) ray.length = ray.direction.norm();
    const auto alone = first_hit(ray, world.bodies[0]), among = nearest_hit(world, ray);
    REQUIRE(alone.has_value() == among.has_value());
    hits += alone.has_value();
  }
  CHECK(hits > 5000);
}

TEST_CASE("ray: what cannot be a ray is refused by name") {
  World world;
  const auto said = [&world](const Ray& ray) {
    const std::string words = complaint([&] { nearest_hit(world, ray); });
    CHECK(complaint([&] { all_hits(world, ray); }) == words);
    CHECK(complaint([&] { first_hit(ray, ground()); }) == words);
    return words;
  };
  const Real nan = std::numeric_limits<Real>::quiet_NaN();
  CHECK(said({.direction = Vec3::Zero()}) ==
        "length of the direction of a ray is 0: a finite number above 0 is needed");
  CHECK(said({.direction = {0, nan, 0}}) == "direction of a ray is (0, nan, 0): three finite numbers are needed");
  CHECK(said({.origin = {infinite, 0, 0}}) == "origin of a ray is (inf, 0, 0): three finite numbers are needed");
  CHECK(said({.length = -1}) == "length of a ray is -1: a number, 0 or more, or infinity, is needed");
  CHECK(said({.length = nan}) == "length of a ray is nan: a number, 0 or more, or infinity, is needed");
  CHECK(said({}).empty());
}
