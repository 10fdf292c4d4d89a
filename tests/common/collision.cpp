// The narrow phase against hand-computed cases, and against properties that hold for every pair of shapes.
#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <vector>

#include "pushback/common/bodies/random.h"
#include "pushback/common/collision/collide.h"
#include "pushback/common/world/world.h"
#include "tests/support/catch.h"
#include "tests/support/contacts_of.h"
#include "tests/support/hulls.h"
#include "tests/support/outside.h"
#include "tests/support/yardstick.h"

using namespace pushback;

namespace {

// ---- tools --------------------------------------------------------------------------------------------------------

constexpr Real tight = 1000 * eps;  // 2e-13 in double, 1e-4 in float: for lengths of about 1 m

constexpr std::uint64_t seed = 20240607;

enum Kind { a_sphere, a_box, a_capsule, a_half_space };
Body shape_of(Kind kind, Random& random) {
  if (kind == a_half_space) return half_space(random.direction());
  const auto length = [&] { return random.between(Real(0.2), 1); };
  const Real first = length();
  if (kind == a_sphere) return sphere(first, 1);
  const Real second = length();
  if (kind == a_capsule) return capsule(first / 2, second, 1);
  const Real third = length();
  return box({first, second, third}, 1);
}
const std::vector<Kind> convex = {a_sphere, a_box, a_capsule};

/// How far the shape reaches along n from the body's centre; infinity for a half-space that n does not leave squarely.
Real reach(const Body& body, const Vec3& n) {
  const Vec3 local = body.orientation.conjugate() * n;
  struct Reach {
    const Vec3& n;
    Real operator()(const Sphere& s) const { return s.radius; }
    Real operator()(const Box& b) const { return b.half_extents.dot(n.cwiseAbs()); }
    Real operator()(const Capsule& c) const { return c.radius + c.half_length * std::abs(n.y()); }
    Real operator()(const HalfSpace& h) const {
      return n.dot(h.normal) > 1 - tight ? Real(0) : std::numeric_limits<Real>::infinity();
    }
    Real operator()(const Hull& h) const {
      Real most = -std::numeric_limits<Real>::infinity();
      for (const Vec3& corner : h.solid->corners) most = std::max(most, n.dot(corner));
      return most;
    }
  };
  return std::visit(Reach{local}, body.shape);
}

/// How far b would have to move along n to be clear of a.
Real overlap_along(const Body& a, const Body& b, const Vec3& n) {
  return reach(a, n) + reach(b, -n) - n.dot(b.position - a.position);
}

/// The least of it over all directions, by trying: many, then ever nearer to the best.
Real least_overlap(const Body& a, const Body& b, Random& random) {
  Real least = std::numeric_limits<Real>::infinity();
  Vec3 best = Vec3::UnitX();
  const auto try_direction = [&](const Vec3& n) {
    if (const Real overlap = overlap_along(a, b, n); overlap < least) {
      least = overlap;
      best = n;
    }
  };
  for (const Body* body : {&a, &b}) {
    for (int i = 0; i < 3; ++i) {
      try_direction(body->orientation * Vec3::Unit(i));
      try_direction(body->orientation * -Vec3::Unit(i));
    }
  }
  for (int i = 0; i < 2000; ++i) try_direction(random.direction());
  for (Real size = Real(0.1); size > Real(1e-6); size /= 2) {
    for (int failures = 0; failures < 30; ++failures) {
      const Real before = least;
      try_direction((best + random.vector(size)).normalized());
      if (least < before) failures = 0;
    }
  }
  return least;
}

std::vector<std::uint32_t> features(const Contacts& contacts) {
  std::vector<std::uint32_t> result;
  for (const Contact& c : contacts) result.push_back(c.id.feature);
  std::sort(result.begin(), result.end());
  return result;
}

void require_equal(const Vec3& a, const Vec3& b, Real tolerance = tight) {
  INFO("(" << a.transpose() << ") and (" << b.transpose() << ")");
  REQUIRE((a - b).norm() <= tolerance);
}

void jitter(Body& body, Random& random, Real size) {
  body.position += random.vector(size);
  body.orientation.vec() += random.vector(size);
  body.orientation.w() += random.between(-size, size);
  body.orientation.normalize();
}

/// Random pairs of these that overlap a little or a lot.
template <class Draw, class Examine>
void for_random_pairs(int count, Random& random, Real nearest, Real farthest, const Draw& draw,
                      const Examine& examine) {
  for (int found = 0, tries = 0; found < count; ++tries) {
    REQUIRE(tries < 100 * count);
    auto [a, b] = draw();
    const Real distance = random.between(nearest, farthest);
    b.position = a.position + distance * random.direction();
    const Contacts contacts = contacts_of(a, b);
    if (contacts.empty()) continue;
    ++found;
    INFO("try " << tries);
    examine(a, b, contacts, random);
  }
}
/// Of every two shapes but hulls.
template <class Examine>
void for_random_contacts(int count, const Examine& examine) {
  Random random(seed);
  for (const Kind kind_a : {a_sphere, a_box, a_capsule, a_half_space}) {
    for (const Kind kind_b : convex) {
      INFO("shapes " << kind_a << " and " << kind_b);
      const auto draw = [&] {
        Body a = shape_of(kind_a, random), b = shape_of(kind_b, random);
        a.position = random.vector(1);
        a.orientation = random.orientation();
        b.orientation = random.orientation();
        return std::pair(a, b);
      };
      for_random_pairs(count, random, 0, 2, draw, examine);
    }
  }
}
/// Of two hulls.
template <class Examine>
void for_random_hulls(int count, const Examine& examine) {
  Random random(11);
  const auto draw = [&] {
    Body a = random_hull(random);
    a.at(random.vector(1));
    return std::pair(a, random_hull(random));
  };
  for_random_pairs(count, random, Real(0.2), Real(1.6), draw, examine);
}

bool both_hulls(const Body& a, const Body& b) {
  return std::holds_alternative<Hull>(a.shape) && std::holds_alternative<Hull>(b.shape);
}

}  // namespace

// ---- closed forms -------------------------------------------------------------------------------------------------

TEST_CASE("two spheres overlap along the line through their centres") {
  Body a = sphere(2, 1).at({1, 1, 1}).rough(Real(0.9)).bouncy(Real(0.2));
  Body b = sphere(1, 1).at(Vec3(1, 1, 1) + Vec3(Real(1.6), 0, Real(1.2))).rough(Real(0.4)).bouncy(Real(0.7));
  const Contacts contacts = contacts_of(a, b);  // centres 2 m apart, radii 2 m and 1 m
  REQUIRE(contacts.size() == 1);
  const Contact& c = contacts[0];
  require_equal(c.normal, {Real(0.8), 0, Real(0.6)});
  REQUIRE(c.depth == Approx(1));
  require_equal(c.point, Vec3(1, 1, 1) + Real(1.5) * c.normal);  // surfaces at 2 m and at 1 m
  REQUIRE(c.friction == Approx(0.6));                            // sqrt(0.9 * 0.4)
  REQUIRE(c.restitution == Approx(0.7));                         // the larger
  REQUIRE(c.id.body_a == 3);
  REQUIRE(c.id.body_b == 8);
}

TEST_CASE("centres in one place still give a finite unit normal") {
  Random random(seed);
  for (const Kind kind_a : convex) {
    for (const Kind kind_b : convex) {
      for (const bool turned : {false, true}) {
        Body a = shape_of(kind_a, random), b = shape_of(kind_b, random);
        if (turned) b.orientation = random.orientation();
        const Contacts contacts = contacts_of(a, b);
        INFO("shapes " << kind_a << " and " << kind_b);
        REQUIRE(!contacts.empty());
        for (const Contact& c : contacts) {
          REQUIRE(c.normal.norm() == Approx(1));
          REQUIRE(c.point.allFinite());
          REQUIRE(std::isfinite(c.depth));
        }
        REQUIRE(deepest(contacts) == Approx(least_overlap(a, b, random)).margin(0.02));
      }
    }
  }
}

TEST_CASE("a sphere sinks into a half-space by its radius less its height") {
  Body plane = half_space({0, 3, 4}).at({0, 0, 10}).rough(1);  // normal (0, 0.6, 0.8)
  Body ball = sphere(2, 1).at(Vec3(5, 0, 10) + Real(1.5) * Vec3(0, Real(0.6), Real(0.8)));
  const Contacts contacts = contacts_of(plane, ball);
  REQUIRE(contacts.size() == 1);
  require_equal(contacts[0].normal, {0, Real(0.6), Real(0.8)});
  REQUIRE(contacts[0].depth == Approx(0.5));
  require_equal(contacts[0].point, Vec3(5, 0, 10) - Real(0.25) * Vec3(0, Real(0.6), Real(0.8)));
}

TEST_CASE("a box lies on a half-space on four corners, named by their numbers") {
  Body floor = ground();
  Body crate = box({1, 2, 3}, 1).at({10, Real(1.9), 20});
  const Contacts contacts = contacts_of(crate, floor);
  REQUIRE(contacts.size() == 4);
  const std::vector<std::uint32_t> lower_corners = {0, 1, 4, 5};  // bit 1, the y axis, is not set
  REQUIRE(features(contacts) == lower_corners);
  for (const Contact& c : contacts) {
    require_equal(c.normal, -Vec3::UnitY());
    REQUIRE(c.depth == Approx(0.1));
    const Real x = (c.id.feature & 1) ? 11 : 9, z = (c.id.feature & 4) ? 23 : 17;
    require_equal(c.point, {x, Real(-0.05), z}, 10 * tight);
  }
}

TEST_CASE("a box stands on an edge or on a corner of its own") {
  Body floor = ground();
  Body on_edge = box({1, 1, 1}, 1).turned(pi / 4, Vec3::UnitZ()).at({0, std::sqrt(Real(2)) - Real(0.01), 0});
  const Contacts edge = contacts_of(floor, on_edge);
  REQUIRE(edge.size() == 2);
  for (const Contact& c : edge) REQUIRE(c.depth == Approx(0.01));
  Body on_corner = box({1, 1, 1}, 1);
  on_corner.orientation = Quat(Eigen::AngleAxis<Real>(std::acos(1 / std::sqrt(Real(3))), Vec3(1, 0, -1).normalized()));
  on_corner.position = {0, std::sqrt(Real(3)) - Real(0.01), 0};
  REQUIRE(contacts_of(floor, on_corner).size() == 1);
  REQUIRE(deepest(contacts_of(floor, on_corner)) == Approx(0.01));
}

TEST_CASE("a capsule lies on a half-space on both ends and stands on one") {
  Body floor = ground();
  Body lying = capsule(Real(0.5), 2, 1).turned(pi / 2, Vec3::UnitZ()).at({0, Real(0.4), 0});
  Contacts contacts = contacts_of(floor, lying);
  REQUIRE(contacts.size() == 2);
  for (const Contact& c : contacts) {
    REQUIRE(c.depth == Approx(0.1));
    REQUIRE(std::abs(c.point.x()) == Approx(2));
    REQUIRE(c.point.y() == Approx(-0.05));
  }
  Body standing = capsule(Real(0.5), 2, 1).at({0, Real(2.4), 0});
  contacts = contacts_of(floor, standing);
  REQUIRE(contacts.size() == 1);
  REQUIRE(contacts[0].depth == Approx(0.1));
  require_equal(contacts[0].point, {0, Real(-0.05), 0});
}

TEST_CASE("a sphere touches a box at a face, an edge, a corner, or from inside") {
  Body crate = box({1, 2, 3}, 1).at({0, 0, 0});
  const auto touch_at = [&](const Vec3& centre, Real radius) {
    Body ball = sphere(radius, 1).at(centre);
    const Contacts contacts = contacts_of(crate, ball);
    REQUIRE(contacts.size() == 1);
    return contacts[0];
  };
  Contact c = touch_at({Real(1.4), 1, 1}, Real(0.5));
  require_equal(c.normal, Vec3::UnitX());
  REQUIRE(c.depth == Approx(0.1));
  require_equal(c.point, {Real(0.95), 1, 1});
  c = touch_at({Real(1.3), Real(2.4), 1}, 1);
  require_equal(c.normal, {Real(0.6), Real(0.8), 0});
  REQUIRE(c.depth == Approx(0.5));
  require_equal(c.point, Vec3(1, 2, 1) - Real(0.25) * c.normal);
  c = touch_at({Real(1.2), Real(2.3), Real(3.6)}, Real(0.8));  // 0.2, 0.3, 0.6 off the corner: 0.7 m away
  require_equal(c.normal, Vec3(2, 3, 6) / 7);
  REQUIRE(c.depth == Approx(0.1));
  c = touch_at({Real(0.7), 1, -1}, Real(0.5));  // centre 0.3 m below the face
  require_equal(c.normal, Vec3::UnitX());
  REQUIRE(c.depth == Approx(0.8));
  require_equal(c.point, {Real(0.6), 1, -1});  // surfaces at 1 m and at 0.2 m
}

TEST_CASE("a capsule and a sphere touch beside the segment or beyond its end") {
  Body pill = capsule(Real(0.5), 2, 1);
  Body beside = sphere(1, 1).at({Real(1.2), 1, 0});
  Contacts contacts = contacts_of(pill, beside);
  REQUIRE(contacts.size() == 1);
  require_equal(contacts[0].normal, Vec3::UnitX());
  REQUIRE(contacts[0].depth == Approx(0.3));
  require_equal(contacts[0].point, {Real(0.35), 1, 0});
  Body beyond = sphere(1, 1).at({Real(0.6), Real(2.8), 0});
  contacts = contacts_of(beyond, pill);
  REQUIRE(contacts.size() == 1);
  require_equal(contacts[0].normal, {Real(-0.6), Real(-0.8), 0});
  REQUIRE(contacts[0].depth == Approx(0.5));
}

TEST_CASE("two capsules cross at one point, lie side by side at two") {
  Body a = capsule(Real(0.5), 2, 1);
  Body crossing = capsule(Real(0.5), 2, 1).turned(pi / 2, Vec3::UnitZ()).at({1, 1, Real(0.9)});
  Contacts contacts = contacts_of(a, crossing);
  REQUIRE(contacts.size() == 1);
  require_equal(contacts[0].normal, Vec3::UnitZ());
  REQUIRE(contacts[0].depth == Approx(0.1));
  require_equal(contacts[0].point, {0, 1, Real(0.45)});

  Body beside = capsule(Real(0.5), 1, 1).at({Real(0.8), Real(1.5), 0});  // from y = 0.5 to 2.5; a ends at 2
  contacts = contacts_of(a, beside);
  REQUIRE(contacts.size() == 2);
  for (const Contact& c : contacts) {
    require_equal(c.normal, Vec3::UnitX());
    REQUIRE(c.depth == Approx(0.2));
  }
  std::sort(contacts.begin(), contacts.end(), [](auto& p, auto& q) { return p.point.y() < q.point.y(); });
  require_equal(contacts[0].point, {Real(0.4), Real(0.5), 0});
  require_equal(contacts[1].point, {Real(0.4), 2, 0});

  Body in_line = capsule(Real(0.5), 1, 1).at({0, Real(3.9), 0});  // end to end
  contacts = contacts_of(a, in_line);
  REQUIRE(contacts.size() == 1);
  require_equal(contacts[0].normal, Vec3::UnitY());
  REQUIRE(contacts[0].depth == Approx(0.1));
}

TEST_CASE("a capsule lies on a box as far as the box goes, stands on it, leans on its edge") {
  Body table = box({1, 1, 1}, 1);
  Body lying = capsule(Real(0.5), 1, 1).turned(pi / 2, Vec3::UnitZ()).at({Real(0.5), Real(1.4), 0});
  Contacts contacts = contacts_of(table, lying);  // from x = -0.5 to 1.5, the box ends at 1
  REQUIRE(contacts.size() == 2);
  std::sort(contacts.begin(), contacts.end(), [](auto& p, auto& q) { return p.point.x() < q.point.x(); });
  for (const Contact& c : contacts) {
    require_equal(c.normal, Vec3::UnitY());
    REQUIRE(c.depth == Approx(0.1));
  }
  require_equal(contacts[0].point, {Real(-0.5), Real(0.95), 0});
  require_equal(contacts[1].point, {1, Real(0.95), 0});

  Body standing = capsule(Real(0.5), 1, 1).at({0, Real(2.4), 0});
  contacts = contacts_of(table, standing);
  REQUIRE(contacts.size() == 1);
  require_equal(contacts[0].point, {0, Real(0.95), 0});

  // Across the edge at (1, 1): the segment passes it at 0.4 m along (0.6, 0.8), perpendicular to it.
  Body leaning = capsule(Real(0.5), 1, 1);
  leaning.orientation = Quat(Eigen::AngleAxis<Real>(std::atan2(Real(0.6), Real(0.8)) + pi / 2, -Vec3::UnitZ()));
  leaning.position = Vec3(1, 1, 0) + Real(0.4) * Vec3(Real(0.6), Real(0.8), 0);
  contacts = contacts_of(table, leaning);
  REQUIRE(contacts.size() == 1);
  require_equal(contacts[0].normal, {Real(0.6), Real(0.8), 0});
  REQUIRE(contacts[0].depth == Approx(0.1));
  require_equal(contacts[0].point, Vec3(1, 1, 0) - Real(0.05) * contacts[0].normal);

  // Along the edge, on the bisector: two points.
  Body along = capsule(Real(0.5), Real(0.75), 1).turned(pi / 2, Vec3::UnitX());
  along.position = Vec3(1, 1, 0) + Real(0.4) * Vec3(1, 1, 0).normalized();
  contacts = contacts_of(table, along);
  REQUIRE(contacts.size() == 2);
  for (const Contact& c : contacts) REQUIRE(c.depth == Approx(0.1));
  for (const Contact& c : contacts) REQUIRE(std::abs(c.point.z()) == Approx(0.75));

  // Its lower end 0.5 m below the top: the surfaces lie at 1 m and at 0.4 m.
  Body stuck = capsule(Real(0.1), 1, 1).at({0, Real(1.5), 0});
  contacts = contacts_of(table, stuck);
  REQUIRE(contacts.size() == 1);
  require_equal(contacts[0].normal, Vec3::UnitY());
  REQUIRE(contacts[0].depth == Approx(0.6));
  require_equal(contacts[0].point, {0, Real(0.7), 0});

  // Right through the box, nearest to the top.
  Body through = capsule(Real(0.1), 3, 1).turned(pi / 2, Vec3::UnitZ()).at({0, Real(0.8), 0});
  contacts = contacts_of(table, through);
  REQUIRE(contacts.size() == 2);
  for (const Contact& c : contacts) {
    require_equal(c.normal, Vec3::UnitY());
    REQUIRE(c.depth == Approx(0.3));
    REQUIRE(std::abs(c.point.x()) == Approx(1));
  }
}

TEST_CASE("boxes with aligned faces touch at the four corners of what they share") {
  Body lower = box({1, 1, 1}, 1);
  Body upper = box({1, 1, 1}, 1).at({Real(0.5), Real(1.9), Real(-0.25)});
  const Contacts contacts = contacts_of(lower, upper);  // shared: x from -0.5 to 1, z from -1 to 0.75
  REQUIRE(contacts.size() == 4);
  for (const Contact& c : contacts) {
    require_equal(c.normal, Vec3::UnitY());
    REQUIRE(c.depth == Approx(0.1));
    REQUIRE(c.point.y() == Approx(0.95));
    const Vec3 offset = c.point - Vec3(Real(0.25), 0, Real(-0.125));
    REQUIRE(std::abs(offset.x()) == Approx(0.75));
    REQUIRE(std::abs(offset.z()) == Approx(0.875));
  }
}

TEST_CASE("two boxes whose edges cross touch at one point") {
  // Both turned by 45 degrees, one about z, one about x: the upper edge of one runs along z, the lower
  // edge of the other along x.
  const Real ridge = std::sqrt(Real(2));
  Body lower = box({1, 1, 1}, 1).turned(pi / 4, Vec3::UnitZ());
  Body upper = box({1, 1, 1}, 1).turned(pi / 4, Vec3::UnitX()).at({Real(0.3), 2 * ridge - Real(0.1), Real(0.2)});
  const Contacts contacts = contacts_of(lower, upper);
  REQUIRE(contacts.size() == 1);
  require_equal(contacts[0].normal, Vec3::UnitY());
  REQUIRE(contacts[0].depth == Approx(0.1));
  require_equal(contacts[0].point, {0, ridge - Real(0.05), Real(0.2)});
}

// ---- properties ---------------------------------------------------------------------------------------------------

TEST_CASE("two bodies that nothing moves do not collide") {
  Body floor = ground();
  Body block = box({1, 1, 1}, 1).fixed();
  Body wall = half_space(Vec3::UnitX());
  REQUIRE(contacts_of(floor, block).empty());
  REQUIRE(contacts_of(block, block).empty());
  REQUIRE(contacts_of(floor, wall).empty());
}

TEST_CASE("normals are unit and point to b, depths are not negative, names are unique and in order") {
  const auto examine = [](Body& a, Body& b, const Contacts& contacts, Random&) {
    REQUIRE(contacts.size() <= 4);
    for (std::size_t i = 0; i < contacts.size(); ++i) {
      const Contact& c = contacts[i];
      REQUIRE(std::abs(c.normal.norm() - 1) < tight);
      REQUIRE(c.depth >= 0);
      REQUIRE(c.id.body_a == static_cast<std::uint32_t>(a.index));
      REQUIRE(c.id.body_b == static_cast<std::uint32_t>(b.index));
      if (i > 0) REQUIRE(contacts[i - 1].id < c.id);
    }
    // Along the normal b gets out sooner than against it.
    const Vec3 normal = contacts[0].normal;
    REQUIRE(overlap_along(a, b, normal) <= overlap_along(a, b, -normal) + Real(2e-3));
  };
  for_random_contacts(200, examine);
  for_random_hulls(2000, examine);
}

TEST_CASE("the shapes in the other order give the opposite normal and the same depth") {
  const auto examine = [](Body& a, Body& b, const Contacts& contacts, Random&) {
    const Contacts other = contacts_of(b, a);
    // Two boxes, or two hulls, may each prefer their own face where both are as good to a thousandth.
    const bool boxes = std::holds_alternative<Box>(a.shape) && std::holds_alternative<Box>(b.shape);
    const bool alike = !boxes && !both_hulls(a, b);
    REQUIRE(!other.empty());
    if (alike) {
      REQUIRE(other.size() == contacts.size());
      require_equal(other[0].normal, -contacts[0].normal, 100 * tight);
    }
    if (both_hulls(a, b) && (other[0].normal + contacts[0].normal).norm() > Real(1e-3)) {
      REQUIRE(std::abs(overlap_along(b, a, other[0].normal) - overlap_along(a, b, contacts[0].normal)) < Real(2e-3));
    } else {
      REQUIRE(std::abs(deepest(other) - deepest(contacts)) < (alike ? 100 * tight : Real(2e-3)));
    }
  };
  for_random_contacts(200, examine);
  for_random_hulls(500, examine);
}

TEST_CASE("a pair that is moved as a whole touches at the same points") {
  for_random_contacts(100, [](Body& a, Body& b, const Contacts& contacts, Random& random) {
    const Quat turn = random.orientation();
    const Vec3 shift = random.vector(5);
    Body moved_a = a, moved_b = b;
    for (Body* body : {&moved_a, &moved_b}) {
      body->position = turn * body->position + shift;
      body->orientation = turn * body->orientation;
    }
    const Contacts moved = contacts_of(moved_a, moved_b);
    REQUIRE(features(moved) == features(contacts));
    for (std::size_t i = 0; i < contacts.size(); ++i) {
      REQUIRE(std::abs(moved[i].depth - contacts[i].depth) < 100 * tight);
      require_equal(moved[i].normal, turn * contacts[i].normal, 100 * tight);
      require_equal(moved[i].point, turn * contacts[i].point + shift, 300 * tight);
    }
  });
}

TEST_CASE("moving b out by the deepest depth separates the pair, and nothing shorter would") {
  for_random_contacts(60, [](Body& a, Body& b, const Contacts& contacts, Random& random) {
    const Real depth = deepest(contacts);
    const Vec3 normal = contacts[0].normal;
    INFO("depth " << depth << ", to be moved " << overlap_along(a, b, normal));
    // Where two axes are equally good to a thousandth, the first is taken. And lying flat is preferred: a box or a
    // capsule that slopes by less than 0.02 towards a face takes its normal, at the price of 0.02 times half its
    // length.
    const bool boxes = std::holds_alternative<Box>(a.shape) || std::holds_alternative<Box>(b.shape);
    const Real tolerance = boxes ? Real(0.02) : Real(2e-3);
    REQUIRE(overlap_along(a, b, normal) <= depth + tolerance);
    if (std::holds_alternative<HalfSpace>(a.shape)) return;
    REQUIRE(depth <= least_overlap(a, b, random) + tolerance);
  });
}

TEST_CASE("pairs with a gap have no contacts, pairs without one have some") {
  Random random(seed);
  for (const Kind kind_a : convex) {
    for (const Kind kind_b : convex) {
      for (int i = 0; i < 150; ++i) {
        Body a = shape_of(kind_a, random), b = shape_of(kind_b, random);
        a.orientation = random.orientation();
        b.orientation = random.orientation();
        const Real distance = random.between(Real(0.2), Real(2.5));
        b.position = distance * random.direction();
        const Real overlap = least_overlap(a, b, random);
        INFO("shapes " << kind_a << " and " << kind_b << ", overlap " << overlap);
        if (overlap < -10 * tight) REQUIRE(contacts_of(a, b).empty());
        if (overlap > Real(2e-3)) REQUIRE(!contacts_of(a, b).empty());
      }
    }
  }
}

TEST_CASE("contact points lie in both shapes, midway between their surfaces") {
  const auto examine = [](Body& a, Body& b, const Contacts& contacts, Random&) {
    if (deepest(contacts) > Real(0.1)) return;  // deeper, the midpoint may lie beyond the far side of a small shape
    const Real part = both_hulls(a, b) ? Real(0.5) : Real(0.25);
    for (const Contact& c : contacts) {
      REQUIRE(outside(a, c.point) <= Real(2e-3) + part * c.depth);  // a shallow corner of a tilted box, for one
      REQUIRE(outside(b, c.point) <= Real(2e-3) + part * c.depth);
      if (c.depth < deepest(contacts)) continue;
      // Half the depth along the normal lies the surface of a; b's lies as far the other way.
      REQUIRE(outside(a, c.point + (c.depth / 2 + Real(2e-3)) * c.normal) >= 0);
      REQUIRE(outside(b, c.point - (c.depth / 2 + Real(2e-3)) * c.normal) >=
              (both_hulls(a, b) ? Real(-2e-3) : Real(0)));
    }
  };
  for_random_contacts(300, examine);
  for_random_hulls(1000, examine);
}

TEST_CASE("names do not change when the pair trembles") {
  const Real tremble = std::max(Real(1e-9), 4 * eps);
  const auto examine = [&](Body& a, Body& b, const Contacts& contacts, Random& random) {
    for (int i = 0; i < 5; ++i) {
      Body other_a = a, other_b = b;
      jitter(other_a, random, tremble);
      jitter(other_b, random, tremble);
      const Contacts now = contacts_of(other_a, other_b);
      for (const Contact& c : contacts) {  // what is not about to lift off is still there, under its name
        if (c.depth < 100 * tremble) continue;
        const bool still = std::any_of(now.begin(), now.end(), [&](const Contact& d) {
          return d.id == c.id && (d.point - c.point).norm() < 1000 * tremble + Real(1e-6);
        });
        REQUIRE(still);
      }
    }
  };
  for_random_contacts(100, examine);
  for_random_hulls(300, examine);
}

TEST_CASE("equal boxes face to face keep four points and their names whatever the rounding") {
  Random random(seed);
  for (const Vec3& extents : {Vec3(1, 1, 1), Vec3(Real(0.5), Real(0.25), 2), Vec3(10, Real(0.01), 10)}) {
    for (const Quat& turn : {Quat::Identity(), random.orientation(), random.orientation()}) {
      for (int axis = 0; axis < 3; ++axis) {
        std::vector<std::uint32_t> names;
        for (const Real size : {Real(0), Real(1e-16), Real(1e-14), Real(1e-12), Real(1e-9), Real(1e-6)}) {
          for (int step = 0; step < 60; ++step) {
            Body a = box(extents, 1).at({3, 4, 5}), b = a;
            a.orientation = b.orientation = turn;
            b.position += turn * (Vec3::Unit(axis) * (2 * extents[axis] - Real(0.01) * extents.minCoeff()));
            jitter(a, random, size * extents.minCoeff());
            jitter(b, random, size * extents.minCoeff());
            const Contacts contacts = contacts_of(a, b);
            INFO("extents " << extents.transpose() << ", axis " << axis << ", jitter " << size << ", step " << step);
            REQUIRE(contacts.size() == 4);
            if (names.empty()) names = features(contacts);
            REQUIRE(features(contacts) == names);
          }
        }
      }
    }
  }
}

TEST_CASE("a stack of turned boxes touches at the same four points in every step") {
  Random random(seed);
  for (const Real degrees : {Real(0.01), Real(1), Real(20), Real(45), Real(80)}) {
    std::vector<std::uint32_t> names;
    for (int step = 0; step < 300; ++step) {
      Body a = box({1, 1, 1}, 1), b = box({1, 1, 1}, 1).turned(degrees * pi / 180, Vec3::UnitY());
      b.position = {0, Real(1.998), 0};
      jitter(a, random, Real(1e-5));  // as a stack breathes: a hundredth of a millimetre
      jitter(b, random, Real(1e-5));
      const Contacts contacts = contacts_of(a, b);
      INFO("turned by " << degrees << " degrees, step " << step);
      REQUIRE(contacts.size() == 4);
      if (names.empty()) names = features(contacts);
      REQUIRE(features(contacts) == names);
    }
  }
}

TEST_CASE("four of many points still span most of the area that is shared") {
  Random random(seed);
  for (int i = 0; i < 200; ++i) {
    const Real angle = random.between(0, pi / 2);
    Body a = box({1, 1, 1}, 1), b = box({1, 1, 1}, 1).turned(angle, Vec3::UnitY()).at({0, Real(1.99), 0});
    const Contacts contacts = contacts_of(a, b);
    REQUIRE(contacts.size() == 4);
    // Four points of a convex outline; their hull has the area of half the cross product of its diagonals, for the
    // order in which they go round.
    std::vector<Vec3> p;
    for (const Contact& c : contacts) p.push_back(c.point);
    std::sort(p.begin(), p.end(),
              [](const Vec3& u, const Vec3& v) { return std::atan2(u.z(), u.x()) < std::atan2(v.z(), v.x()); });
    const Real area = std::abs((p[2] - p[0]).cross(p[3] - p[1]).y()) / 2;
    // Two squares of 2 m turned against each other share an octagon around a circle of 1 m:
    // 4 (tan(angle / 2) + tan(pi / 4 - angle / 2)).
    const Real shared = 4 * (std::tan(angle / 2) + std::tan(pi / 4 - angle / 2));
    INFO("angle " << angle << ": " << area << " of " << shared);
    REQUIRE(area <= shared * Real(1.001));
    REQUIRE(area >= Real(0.7) * shared);
  }
}

TEST_CASE("names outlive a change of the reference face") {
  // A box on another tilts slightly either way: whichever has the reference face, the corners that touch are the same.
  std::set<std::uint32_t> names;
  int turned = 0;
  for (int i = -20; i <= 20; ++i) {
    const Real angle = Real(0.002) * Real(i);
    Body a = box({Real(0.5), Real(0.5), Real(0.5)}, 1).at({Real(0.4), Real(0.1), 0});
    Body b = box({1, 1, 1}, 1).at({0, Real(1.59), 0}).turned(angle, Vec3::UnitZ());
    for (const Contact& c : contacts_of(a, b)) {
      names.insert(c.id.feature);
      if ((c.normal - Vec3::UnitY()).norm() > Real(1e-6)) ++turned;
    }
  }
  REQUIRE(turned > 0);         // the normal was b's at times,
  REQUIRE(names.size() <= 4);  // yet the points were always a's four upper corners
}

TEST_CASE("two edges that cross have one name, whichever box has the reference face") {
  Body lower = box({3, Real(0.5), Real(0.5)}, 1);
  std::vector<std::uint32_t> names;
  for (const Vec3& axis : {Vec3::UnitX().eval(), Vec3::UnitZ().eval()}) {
    Body upper = box({Real(0.5), Real(0.5), 3}, 1).turned(Real(0.01), axis).at({0, Real(0.98), 0});
    const Contacts contacts = contacts_of(lower, upper);
    REQUIRE(contacts.size() == 4);
    // Tilted about x, the upper one reaches far down along the lower one's normal, so its own is taken; about z, not.
    const Vec3 tilted = upper.orientation * Vec3::UnitY();
    require_equal(contacts[0].normal, axis.x() == 1 ? tilted : Vec3(Vec3::UnitY()));
    if (names.empty()) names = features(contacts);
    REQUIRE(features(contacts) == names);
  }
}

TEST_CASE("the deepest of many points is one of the four") {
  // Two squares turned by 45 degrees share an octagon. Mirrored in a diagonal of the lower one, the pair is the same;
  // so whichever of its corners is pressed down, that must be as deep as any other.
  Real least = 1, most = 0;
  for (int i = 0; i < 8; ++i) {
    const Real towards = pi / 8 + pi / 4 * Real(i);
    Body a = box({1, 1, 1}, 1), b = box({1, 1, 1}, 1).turned(pi / 4, Vec3::UnitY());
    b.turned(Real(0.015), {std::sin(towards), 0, std::cos(towards)}).at({0, Real(1.95), 0});
    const Contacts contacts = contacts_of(a, b);
    REQUIRE(contacts.size() == 4);
    least = std::min(least, deepest(contacts));
    most = std::max(most, deepest(contacts));
  }
  REQUIRE(most > Real(0.06));  // about 0.05 + 0.015 * 1.08
  REQUIRE(most - least < Real(1e-3));
}

TEST_CASE("a box that shares its centre with another shape is pushed the same way however they tremble") {
  Random random(seed);
  for (const Kind kind : convex) {
    for (const bool aligned : {true, false}) {
      Body a = box({1, Real(1.1), Real(1.2)}, 1), b = shape_of(kind, random);
      if (!aligned) b.orientation = random.orientation();
      const Vec3 normal = contacts_of(a, b)[0].normal;
      for (int step = 0; step < 50; ++step) {
        Body other_a = a, other_b = b;
        jitter(other_a, random, 16 * eps);
        jitter(other_b, random, 16 * eps);
        require_equal(contacts_of(other_a, other_b)[0].normal, normal, 10 * tight);
      }
    }
  }
}

TEST_CASE("shapes with sides of 1 to 1000, from a millimetre to a kilometre, give finite contacts") {
  Random random(seed);
  const auto length = [&] { return std::pow(Real(10), random.between(-3, 3)); };
  int found = 0;
  for (int i = 0; i < 20000; ++i) {
    const auto any = [&](int kind) {
      const Real x = length(), y = length(), z = length();
      if (kind == 0) return box({x, y, z}, 1);
      return kind == 1 ? capsule(x, y, 1) : sphere(x, 1);
    };
    Body a = any(i % 3), b = any(i % 5 == 0 ? 0 : i % 3);
    a.orientation = random.orientation();
    b.orientation = i % 2 == 0 ? random.orientation() : a.orientation;
    const Vec3 n = random.direction();
    b.position = n * (reach(a, n) + reach(b, -n)) * random.between(0, 1);
    if (i % 7 == 0) b.position.setZero();
    const Contacts contacts = contacts_of(a, b);
    found += !contacts.empty();
    const Real size = std::max(reach(a, Vec3::UnitX()), reach(b, Vec3::UnitX())) + reach(a, n) + reach(b, n);
    for (const Contact& c : contacts) {
      REQUIRE(c.point.allFinite());
      REQUIRE(std::isfinite(c.depth));
      REQUIRE(c.depth >= 0);
      REQUIRE(c.depth <= 10 * size);
      REQUIRE(std::abs(c.normal.norm() - 1) < 10 * tight);
    }
  }
  REQUIRE(found > 5000);
}

TEST_CASE("far from the origin the depth is as exact as the positions are") {
  const Real far = std::is_same_v<Real, double> ? Real(1e7) : Real(1024);
  const Vec3 shift(far, -far, far);
  for_random_contacts(50, [&](Body& a, Body& b, const Contacts& contacts, Random&) {
    Body far_a = a, far_b = b;
    far_a.position += shift;
    far_b.position += shift;
    const Vec3 rounded = (far_b.position - far_a.position) - (b.position - a.position);
    const Contacts there = contacts_of(far_a, far_b);
    REQUIRE(!there.empty());
    REQUIRE(std::abs(deepest(there) - deepest(contacts)) <= rounded.norm() + Real(2e-3));
    far_b.position = far_a.position + (b.position - a.position);
    // The same relative position, to the last digit, gives the same depth to the last digit.
    Body near_a = a, near_b = b;
    near_a.position.setZero();
    near_b.position = far_b.position - far_a.position;
    const Contacts again = contacts_of(near_a, near_b), far_again = contacts_of(far_a, far_b);
    REQUIRE(again.size() == far_again.size());
    for (std::size_t i = 0; i < again.size(); ++i) REQUIRE(again[i].depth == far_again[i].depth);
  });
}
