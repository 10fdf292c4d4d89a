// Hulls: what they weigh, and where they touch. Wherever a hull is a box in disguise, it is held against a box.
#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <string>
#include <vector>

#include "pushback/chapters/07_warm_start/full_solver.h"
#include "pushback/common/basics/shortest_turn.h"
#include "pushback/common/bodies/random.h"
#include "pushback/common/collision/broad_phase.h"
#include "pushback/common/collision/collide.h"
#include "pushback/common/world/measure.h"
#include "tests/support/catch.h"
#include "tests/support/complaint.h"
#include "tests/support/contacts_of.h"
#include "tests/support/hulls.h"
#include "tests/support/outside.h"
#include "tests/support/yardstick.h"

using namespace pushback;

namespace {

// ---- tools --------------------------------------------------------------------------------------------------------

constexpr Real tight = 5000 * eps;  // 1e-12 in double, 6e-4 in float: for lengths of about 1 m

Vec3 lengths(Random& random, Real low, Real high) {  // one statement each, as in random.h
  const Real x = random.between(low, high);
  const Real y = random.between(low, high);
  const Real z = random.between(low, high);
  return {x, y, z};
}

Body anyhow(Body body, Random& random) {
  const Real angle = random.between(-pi, pi);
  return body.turned(angle, random.direction());
}

std::vector<std::uint32_t> names(const Contacts& contacts) {
  std::vector<std::uint32_t> result;
  for (const Contact& c : contacts) result.push_back(c.id.feature);
  return result;
}

/// How far the body reaches along n from the world's origin.
Real reach(const Body& body, const Vec3& n) {
  const Real centre = n.dot(body.position);
  if (const auto* s = std::get_if<Sphere>(&body.shape)) return centre + s->radius;
  if (const auto* c = std::get_if<Capsule>(&body.shape)) {
    return centre + c->radius + c->half_length * std::abs(n.dot(body.orientation * Vec3::UnitY()));
  }
  Real most = -std::numeric_limits<Real>::infinity();
  for (const Vec3& corner : corners_of(body)) most = std::max(most, n.dot(corner));
  return most;
}

/// How far b would have to move along n to be clear of a.
Real overlap_along(const Body& a, const Body& b, const Vec3& n) {
  return reach(a, n) + reach(b, -n);
}

/// The least overlap of two sets of points, from their differences alone: across any three points of one, or any two of
/// one and any two of the other. Knows nothing of faces and edges.
Real least_overlap(const Points& a, const Points& b) {
  Real least = std::numeric_limits<Real>::infinity();
  const auto try_axis = [&](const Vec3& axis) {
    if (axis.norm() < Real(1e-6)) return;
    const Vec3 n = axis.normalized();
    Real low_a = 1e9, high_a = -low_a, low_b = low_a, high_b = high_a;
    for (const Vec3& p : a) low_a = std::min(low_a, n.dot(p)), high_a = std::max(high_a, n.dot(p));
    for (const Vec3& p : b) low_b = std::min(low_b, n.dot(p)), high_b = std::max(high_b, n.dot(p));
    least = std::min({least, high_a - low_b, high_b - low_a});
  };
  const auto sides = [](const Points& points) {
    Points result;
    for (std::size_t i = 0; i < points.size(); ++i) {
      for (std::size_t j = i + 1; j < points.size(); ++j) result.push_back(points[j] - points[i]);
    }
    return result;
  };
  const Points sides_a = sides(a), sides_b = sides(b);
  for (const Vec3& p : sides_a) {
    for (const Vec3& q : sides_b) try_axis(p.cross(q));
  }
  for (const Points* points : {&a, &b}) {
    for (std::size_t i = 1; i < points->size(); ++i) {
      for (std::size_t j = i + 1; j < points->size(); ++j) {
        for (std::size_t k = 0; k < i; ++k) {
          try_axis(((*points)[i] - (*points)[k]).cross((*points)[j] - (*points)[k]));
        }
      }
    }
  }
  return least;
}

void require_equal(const Vec3& a, const Vec3& b, Real tolerance = tight) {
  INFO("(" << a.transpose() << ") and (" << b.transpose() << ")");
  REQUIRE((a - b).norm() <= tolerance);
}

void jitter(Body& body, Random& random, Real size) {
  body.position += random.vector(size);
  const Real angle = random.between(-size, size);
  body.turned(angle, random.direction());
}

}  // namespace

// ---- mass ---------------------------------------------------------------------------------------------------------

TEST_CASE("a hull of a box's eight corners weighs what the box weighs") {
  Random random(1);
  for (int i = 0; i < 300; ++i) {
    const Vec3 extents = lengths(random, Real(0.1), 2);
    const Vec3 where = random.vector(3);
    const Real mass = random.over_decades(Real(0.01), 1000), angle = i < 100 ? 0 : random.between(-pi, pi);
    Body crate = box(extents, mass).turned(angle, random.direction()).at(where);
    Points points = corners_of(crate);
    for (int k = 0; k < 8; ++k) points.push_back(where + Real(0.5) * (points[random.below(8)] - where));  // inside
    points.push_back((points[0] + points[1]) / 2);                                                        // on an edge
    points.push_back((points[0] + points[3]) / 2);                                                        // on a face
    points.push_back(points[5]);
    random.shuffle(points);
    const Body made = hull(points, mass);
    REQUIRE(solid_of(made).corners.size() == 8);
    REQUIRE(solid_of(made).faces.size() == 6);
    REQUIRE(solid_of(made).edges.size() == 12);
    REQUIRE(solid_of(made).volume == Approx(8 * extents.prod()));
    require_equal(made.position, where);
    REQUIRE(made.inverse_mass == crate.inverse_mass);
    REQUIRE((made.inverse_inertia - crate.inverse_inertia).norm() <= tight * crate.inverse_inertia.norm());
    // Of the points' own axes, if they are principal.
    if (angle == 0) REQUIRE(made.orientation.coeffs() == Quat::Identity().coeffs());
  }
}

TEST_CASE("the inertia of a tetrahedron with three edges at right angles") {
  // With legs a, b, c along the axes: <x x> = a^2/10 and <x y> = ab/20 over the solid, the centre at (a, b, c)/4, so
  // about the centre <x x> = 3 a^2/80 and <x y> = -ab/80.
  Random random(3);
  for (int i = 0; i < 100; ++i) {
    const Vec3 legs = lengths(random, Real(0.2), 3);
    const Vec3 corner = random.vector(2);
    const Real mass = random.between(1, 10);
    Points points = {corner};
    for (int axis = 0; axis < 3; ++axis) points.push_back(corner + legs[axis] * Vec3::Unit(axis));
    const Body made = hull(points, mass);
    require_equal(made.position, corner + legs / 4);
    REQUIRE(solid_of(made).volume == Approx(legs.prod() / 6));
    Mat3 inertia = mass / 80 * legs * legs.transpose();
    inertia.diagonal() = 3 * mass / 80 * (Vec3::Constant(legs.squaredNorm()) - legs.cwiseAbs2());
    const Mat3 product = inertia * made.inverse_inertia;
    REQUIRE((product - Mat3::Identity()).norm() < 100 * tight);
    const Points now = corners_of(made);  // all where they were given
    for (std::size_t k = 0; k < 4; ++k) require_equal(now[k], points[k]);
  }
  const Body regular = hull({{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}}, 2);  // m s^2 / 20, s^2 = 8
  REQUIRE((regular.inverse_inertia - Mat3::Identity() / Real(0.8)).norm() < tight);
}

TEST_CASE("at() moves the centre of mass, turned() turns about it") {
  const Points ramp = wedge(3, 1, 2);
  Body made = hull(ramp, 1);
  require_equal(made.position, {Real(0.5), Real(1) / 3, 0});
  Body turned = hull(ramp, 1).turned(pi / 2, Vec3::UnitZ()).at({7, 8, 9});
  const Quat quarter(Eigen::AngleAxis<Real>(pi / 2, Vec3::UnitZ()));
  const Points now = corners_of(turned);
  for (std::size_t i = 0; i < ramp.size(); ++i) {
    require_equal(now[i], Vec3(7, 8, 9) + quarter * (ramp[i] - made.position), 10 * tight);
  }
}

TEST_CASE("every corner is within the hull of random points, every edge has two faces, no point is beyond a face") {
  Random random(4);
  for (int i = 0; i < 300; ++i) {
    Points points;
    const std::size_t count = 4 + random.below(29);
    const Real wide = random.over_decades(Real(0.1), 10), high = random.over_decades(Real(0.1), 10);
    const Vec3 stretch(wide, high, 1);
    while (points.size() < count) points.push_back(random.direction().cwiseProduct(stretch));
    const Body made = hull(points, 1);
    const Polyhedron& solid = solid_of(made);
    REQUIRE(solid.corners.size() + solid.faces.size() == solid.edges.size() + 2);  // Euler
    for (const Vec3& p : points) REQUIRE(outside(made, p) <= std::max(Real(1e-6), 1000 * eps));
    for (const Polyhedron::Edge& edge : solid.edges) {
      REQUIRE(edge.from < edge.to);
      const Vec3 along = solid.corners[std::size_t(edge.to)] - solid.corners[std::size_t(edge.from)];
      const Vec3 out = solid.faces[std::size_t(edge.left)].normal.cross(solid.faces[std::size_t(edge.right)].normal);
      REQUIRE(out.dot(along) > 0);
    }
  }
}

TEST_CASE("what is no solid is refused, and the message says what is wrong") {
  const Real nan = std::numeric_limits<Real>::quiet_NaN();
  Points points = corners_of_box({1, 1, 1});
  const auto says = [&](const std::string& text) {
    const std::string what = complaint([&] { hull(points, 1); });
    INFO(what);
    REQUIRE(what.find(text) != std::string::npos);
  };
  REQUIRE(complaint([&] { hull(points, 0); }).find("mass is 0") != std::string::npos);
  points[5].y() = nan;
  says("point 5 of a hull is (1, nan, 1)");
  points.resize(3);
  says("number of points of a hull is 3: from 4 to 32 are needed");
  points.clear();
  says("number of points of a hull is 0");
  points.assign(33, Vec3::Zero());
  says("number of points of a hull is 33");
  points = {{0, 0, 0}, {1, 0, 0}, {0, 0, 1}, {1, 0, 1}, {3, 0, 5}};
  says("volume of a hull is 0: points that do not all lie in one plane are needed");
  points = {{0, 0, 0}, {1, 1, 1}, {2, 2, 2}, {3, 3, 3}};
  says("volume of a hull is 0");
  points.assign(8, Vec3(1, 2, 3));
  says("volume of a hull is 0");
  Body made = box({1, 1, 1}, 1);
  made.shape = Hull{};
  World world;
  REQUIRE(complaint([&] { world.add(made); }).find("hull has no solid") != std::string::npos);
  made = hull(wedge(1, 1, 1), 1);
  made.friction = -1;
  REQUIRE_FALSE(complaint([&] { world.add(made); }).empty());
}

TEST_CASE("the bounds of a hull are as tight as they can be") {
  Random random(5);
  for (int i = 0; i < 100; ++i) {
    const Body body = random_hull(random).at(random.vector(3));
    const Bounds bounds = bounds_of(body);
    for (int axis = 0; axis < 3; ++axis) {
      REQUIRE(std::abs(bounds.high[axis] - reach(body, Vec3::Unit(axis))) < tight);
      REQUIRE(std::abs(bounds.low[axis] + reach(body, -Vec3::Unit(axis))) < tight);
    }
  }
}

// ---- as boxes do --------------------------------------------------------------------------------------------------

TEST_CASE("a hull of a box's corners collides as the box does") {
  Random random(6);
  int found = 0, by_edges = 0, undecided = 0;
  for (int i = 0; found < 1000; ++i) {
    REQUIRE(i < 20000);
    const auto length = [&] { return random.between(Real(0.2), 1); };
    const auto random_box = [&](Vec3& extents) {
      const Real x = length(), y = length(), z = length(), angle = random.between(-pi, pi);
      extents = {x, y, z};
      return box(extents, 1).turned(angle, random.direction()).at(random.vector(1));
    };
    Vec3 extents_a, extents_b;
    Body a = random_box(extents_a), b = random_box(extents_b);
    const auto disguised = [](const Body& crate) {
      return hull(corners_of_box(std::get<Box>(crate.shape).half_extents), 1);
    };
    Body hull_a = disguised(a), hull_b = disguised(b);
    hull_a.position = a.position;
    hull_a.orientation = a.orientation;
    hull_b.position = b.position;
    hull_b.orientation = b.orientation;
    const Contacts expected = contacts_of(a, b);
    found += !expected.empty();
    by_edges += expected.size() == 1 && (expected[0].id.feature >> 16) == 3;
    const Real clearly = Real(1e-3) * std::min(extents_a.minCoeff(), extents_b.minCoeff());
    for (const auto& [first, second] : {std::pair<Body*, Body*>{&hull_a, &hull_b}, {&hull_a, &b}, {&a, &hull_b}}) {
      const Contacts got = contacts_of(*first, *second);
      INFO("try " << i);
      REQUIRE(got.empty() == expected.empty());
      if (expected.empty()) continue;
      if ((got[0].normal - expected[0].normal).norm() < tight) {
        REQUIRE(std::abs(deepest(got) - deepest(expected)) < tight);
        if (got.size() < 4 || expected.size() < 4) REQUIRE(got.size() == expected.size());
        continue;
      }
      // Two directions may be as good as each other, to a thousandth; boxes and hulls ask in different orders.
      ++undecided;
      REQUIRE(std::abs(overlap_along(a, b, got[0].normal) - overlap_along(a, b, expected[0].normal)) < 2 * clearly);
    }
  }
  REQUIRE(by_edges > 50);
  REQUIRE(undecided < 60);  // of 3000
}

TEST_CASE("a hull of a box's corners meets planes, balls and capsules as the box does") {
  Random random(7);
  int found = 0, undecided = 0;
  for (int i = 0; i < 3000; ++i) {
    const Vec3 extents = lengths(random, Real(0.2), 1);
    const Real angle = random.between(-pi, pi);
    Body crate = box(extents, 1).turned(angle, random.direction()).at(random.vector(1));
    Body made = hull(corners_of_box(extents), 1);
    made.position = crate.position;
    made.orientation = crate.orientation;
    const Real radius = random.between(Real(0.1), Real(0.6)), half = random.between(Real(0.2), 1);
    Body other = i % 3 == 0   ? half_space(random.direction())
                 : i % 3 == 1 ? sphere(radius, 1).at(random.vector(1))
                              : capsule(radius, half, 1).at(random.vector(1));
    other = anyhow(other, random);
    const Contacts expected = contacts_of(crate, other), got = contacts_of(made, other);
    INFO("try " << i);
    REQUIRE(got.empty() == expected.empty());
    if (expected.empty()) continue;
    ++found;
    if ((got[0].normal - expected[0].normal).norm() > tight) {  // a core across the middle: two ways out as good
      ++undecided;
      REQUIRE(std::abs(deepest(got) - deepest(expected)) < Real(0.05));
      continue;
    }
    REQUIRE(std::abs(deepest(got) - deepest(expected)) < tight);
    REQUIRE(got.size() >= expected.size());  // in a plane, a box has the corners of one face alone
    if (i % 3 != 0) REQUIRE(got.size() == expected.size());
  }
  REQUIRE(found > 1000);
  REQUIRE(undecided < 20);
}

// ---- properties ---------------------------------------------------------------------------------------------------

TEST_CASE("hulls overlap as deep as their points say, and do not touch where these are apart") {
  Random random(8);
  int apart = 0, overlapping = 0, lost = 0;
  for (int i = 0; i < 600; ++i) {
    Body a = random_hull(random).at(random.vector(1)), b = random_hull(random);
    const Real distance = random.between(Real(0.2), 2);
    b.position = a.position + distance * random.direction();
    const Real least = least_overlap(corners_of(a), corners_of(b));
    const Contacts contacts = contacts_of(a, b);
    INFO("try " << i << ", overlap " << least);
    if (least < -tight) {
      ++apart;
      REQUIRE(contacts.empty());
    }
    if (least < Real(2e-3)) continue;
    ++overlapping;
    REQUIRE(!contacts.empty());
    // An edge's normal that is all but a face's gives way to it: 0.02 of a length at most. Else it is a thousandth.
    REQUIRE(overlap_along(a, b, contacts[0].normal) <= least + Real(0.02));
    REQUIRE(deepest(contacts) <= overlap_along(a, b, contacts[0].normal) + tight);
    lost += deepest(contacts) < least - Real(2e-3);
  }
  REQUIRE(apart > 100);
  REQUIRE(overlapping > 200);
  INFO(lost << " of " << overlapping);
  REQUIRE(lost == 0);
}

TEST_CASE("a ball or a capsule in a hull is as deep as it has to be moved") {
  Random random(9);
  int found = 0, gaps = 0;
  for (int i = 0; i < 3000; ++i) {
    const bool ball = i % 2 == 0;
    Body a = random_hull(random);
    const Real radius = random.between(Real(0.05), Real(0.5)), half = random.between(Real(0.1), Real(0.8));
    Body b = ball ? sphere(radius, 1) : capsule(radius, half, 1);
    const Real angle = random.between(-pi, pi), distance = random.between(0, Real(1.6));
    b.turned(angle, random.direction());
    b.position = a.position + distance * random.direction();
    const Contacts contacts = contacts_of(a, b);
    // Least over many directions: from above.
    Real least = std::numeric_limits<Real>::infinity();
    Vec3 best = Vec3::UnitX();
    const auto try_direction = [&](const Vec3& n) {
      const Real overlap = overlap_along(a, b, n);
      if (overlap < least) least = overlap, best = n;
    };
    for (int k = 0; k < 100; ++k) try_direction(random.direction());
    for (const Polyhedron::Face& face : solid_of(a).faces) try_direction(a.orientation * face.normal);
    for (Real size = Real(0.3); size > Real(1e-5); size *= Real(0.7)) {
      for (int k = 0; k < 12; ++k) try_direction((best + random.vector(size)).normalized());
    }
    INFO("try " << i << ", overlap " << least);
    if (least < -tight) {
      ++gaps;
      REQUIRE(contacts.empty());
      continue;
    }
    if (contacts.empty()) continue;
    ++found;
    const Real tolerance = ball ? Real(2e-3) : Real(0.025);  // what all but lies flat lies flat
    REQUIRE(overlap_along(a, b, contacts[0].normal) <= least + tolerance);
    REQUIRE(std::abs(deepest(contacts) - overlap_along(a, b, contacts[0].normal)) < tolerance);
    for (const Contact& c : contacts) REQUIRE(outside(a, c.point) <= c.depth / 2 + tolerance);
  }
  REQUIRE(found > 800);
  REQUIRE(gaps > 300);
}

TEST_CASE("hulls from a millimetre to a kilometre give finite contacts") {
  Random random(10);
  int found = 0;
  for (int i = 0; i < 4000; ++i) {
    const auto any = [&] {
      const Real x = random.over_decades(Real(1e-3), 1000), y = random.over_decades(Real(1e-3), 1000),
                 z = random.over_decades(Real(1e-3), 1000);
      const Real angle = random.between(-pi, pi);
      if (i % 4 == 0) return box({x, y, z}, 1).turned(angle, random.direction());
      if (i % 4 == 1) return hull(wedge(x, x * std::min(Real(1), y), x), 1).turned(angle, random.direction());
      const Real scale = z;
      Body made = random_hull(random);
      Points points = corners_of(made);
      for (Vec3& p : points) p *= scale;
      return hull(points, 1);
    };
    const auto thick = [&] {
      const Real scale = random.over_decades(Real(1e-3), 1000);
      Points points = corners_of(random_hull(random));
      for (Vec3& p : points) p *= scale;
      return hull(points, 1);
    };
    Body a = thick(), b = any();
    const Vec3 n = random.direction();
    b.position = a.position = Vec3::Zero();
    if (i % 7 != 0) b.position = n * random.between(0, 1) * overlap_along(a, b, n);
    const Contacts contacts = contacts_of(a, b);
    found += !contacts.empty();
    for (const Contact& c : contacts) {
      REQUIRE(c.point.allFinite());
      REQUIRE(std::isfinite(c.depth));
      REQUIRE(c.depth >= 0);
      REQUIRE(std::abs(c.normal.norm() - 1) < tight);
    }
  }
  REQUIRE(found > 1500);
}

// ---- lying flat ---------------------------------------------------------------------------------------------------

TEST_CASE("equal hulls face to face keep four points and their names whatever the rounding") {
  Random random(12);
  const Points bottom_up = prism(8, Real(0.5), Real(0.3));
  for (const Points& points : {corners_of_box({1, 1, 1}), wedge(2, 1, 1), prism(3, 1, Real(0.3)), bottom_up}) {
    for (const bool turned : {false, true}) {
      std::vector<std::uint32_t> before;
      const Real angle = random.between(-pi, pi);
      const Vec3 axis = random.direction();
      for (const Real size : {Real(0), Real(1e-15), Real(1e-12), Real(1e-9), Real(1e-6)}) {
        for (int step = 0; step < 40; ++step) {
          Body lower = hull(points, 1);
          Points above = points;
          const Bounds bounds = bounds_of(lower);
          // The mirror image, so that equal faces lie on each other.
          for (Vec3& p : above) p.y() = 2 * bounds.low.y() - p.y() + Real(0.01);
          Body upper = hull(above, 1);
          if (turned) {
            for (Body* body : {&lower, &upper}) {
              const Quat turn(Eigen::AngleAxis<Real>(angle, axis));
              body->position = turn * body->position;
              body->turned(angle, axis);
            }
          }
          jitter(lower, random, size);
          jitter(upper, random, size);
          const Contacts contacts = contacts_of(lower, upper);
          INFO(points.size() << " points, jitter " << size << ", step " << step);
          REQUIRE(contacts.size() == (points.size() == 6 && points[2].y() != 0 ? 3 : 4));
          if (before.empty()) before = names(contacts);
          REQUIRE(names(contacts) == before);
        }
      }
    }
  }
}

TEST_CASE("the stones of an arch touch their neighbours at four points from the beginning") {
  for (const int count : {5, 7, 11, 15}) {
    for (const Vec3& where : {Vec3(0, 0, 0), Vec3(3, 0, -8)}) {
      std::vector<Body> stones;
      for (int i = 0; i < count; ++i) {
        Points points = stone(i, count, 2, Real(2.5), Real(0.4));
        for (Vec3& p : points) p += where;
        stones.push_back(hull(points, 1));
      }
      for (std::size_t i = 1; i < stones.size(); ++i) {
        INFO("stone " << i << " of " << count);
        const Contacts contacts = contacts_of(stones[i - 1], stones[i]);
        REQUIRE(contacts.size() == 4);
        REQUIRE(deepest(contacts) < tight);
        const Real angle = pi * Real(i) / Real(count);
        require_equal(contacts[0].normal, {-std::sin(angle), std::cos(angle), 0}, 10 * tight);
      }
    }
  }
}

TEST_CASE("names outlive a change of the reference face of hulls") {
  std::set<std::uint32_t> all;
  int turned = 0;
  for (int i = -20; i <= 20; ++i) {
    Body a = hull(corners_of_box({Real(0.5), Real(0.5), Real(0.5)}), 1).at({Real(0.4), Real(0.1), 0});
    Body b = hull(prism(4, Real(1.5), 1), 1).at({0, Real(1.59), 0}).turned(Real(0.002) * Real(i), Vec3::UnitZ());
    for (const Contact& c : contacts_of(a, b)) {
      all.insert(c.id.feature);
      if ((c.normal - Vec3::UnitY()).norm() > Real(1e-6)) ++turned;
    }
  }
  REQUIRE(turned > 0);
  REQUIRE(all.size() <= 4);
}

TEST_CASE("a wedge stands on the whole of its blade, on a plane and on a box") {
  Body floor = ground();
  Body table = box({2, 1, 2}, 1).at({0, -1, 0});
  for (const Real tilt : {Real(-1e-9), Real(0), Real(1e-9), Real(1e-3)}) {
    Body blade = hull(wedge(1, Real(0.3), 1), 1).turned(pi / 2 + Real(0.15), Vec3::UnitZ());
    blade.turned(tilt, Vec3::UnitX());
    blade.position.y() = 0;
    blade.position.y() = reach(blade, -Vec3::UnitY()) - Real(0.01);
    for (Body* below : {&floor, &table}) {
      const Contacts contacts = contacts_of(*below, blade);
      INFO("tilt " << tilt);
      REQUIRE(contacts.size() == 2);
      for (const Contact& c : contacts) REQUIRE(std::abs(c.depth - Real(0.01)) <= Real(0.0011));
      require_equal(contacts[0].normal, Vec3::UnitY(), Real(1.1e-3));
    }
  }
}

TEST_CASE("of two faces that look down alike the same one counts however they tremble") {
  Random random(14);
  Body floor = ground();
  std::vector<std::uint32_t> before;
  for (int step = 0; step < 100; ++step) {
    Body crate = hull(corners_of_box({1, 1, 1}), 1).turned(pi / 4, Vec3::UnitZ()).at({0, Real(-0.2), 0});
    jitter(crate, random, std::max(Real(1e-12), 4 * eps));
    const Contacts contacts = contacts_of(floor, crate);  // so deep that one of its faces is all below
    REQUIRE(contacts.size() == 4);
    if (before.empty()) before = names(contacts);
    REQUIRE(names(contacts) == before);
  }
}

TEST_CASE("a corner on which a stone stands gives way to none that is merely within the margin") {
  Random random(7);
  const Body plane = ground();
  int crowded = 0;
  for (int stone = 0; stone < 200; ++stone) {
    std::vector<Vec3> points;
    for (int k = 0; k < 12; ++k) points.push_back(Real(0.4) * random.direction());
    Body body = hull(points, 100);
    body.index = 1;
    const Polyhedron& solid = *std::get<Hull>(body.shape).solid;
    const auto& face = solid.faces[random.below(solid.faces.size())];
    body.oriented(shortest_turn(face.normal, -Vec3::UnitY())).at({0, face.offset - Real(1e-5), 0});
    Contacts touching, near;
    collide(plane, body, touching);
    collide(plane, body, near, {.least = Real(0.2)});
    REQUIRE(touching.size() == 3);
    crowded += near.size() == 4;
    for (const Contact& contact : touching)
      CHECK(std::any_of(near.begin(), near.end(), [&](const Contact& other) { return other.id == contact.id; }));
  }
  CHECK(crowded > 100);
}

TEST_CASE("a stone that stands on an edge of one face and a corner of another touches with all three") {
  // The base is bent by a milliradian along the edge from (-1, 0, -1) to (1, 0, 1).
  const Points bent = {{-1, 0, -1}, {1, 0, 1}, {1, Real(0.001), -1}, {-1, Real(0.001), 1}, {0, 2, 0}};
  Body floor = ground();
  for (const Real lower : {Real(0.0011), Real(0.002)}) {
    Body stone = hull(bent, 1);
    stone.position.y() -= lower;
    CHECK(contacts_of(floor, stone).size() == 4);
  }
}

TEST_CASE("two edges of hulls that cross have one name, whichever has the reference face") {
  Body lower = hull(corners_of_box({3, Real(0.5), Real(0.5)}), 1);
  std::vector<std::uint32_t> before;
  for (const Vec3& axis : {Vec3::UnitX().eval(), Vec3::UnitZ().eval()}) {
    Body upper = hull(corners_of_box({Real(0.5), Real(0.5), 3}), 1).turned(Real(0.01), axis).at({0, Real(0.98), 0});
    const Contacts contacts = contacts_of(lower, upper);
    REQUIRE(contacts.size() == 4);
    require_equal(contacts[0].normal, axis.x() == 1 ? Vec3(upper.orientation * Vec3::UnitY()) : Vec3(Vec3::UnitY()));
    if (before.empty()) before = names(contacts);
    REQUIRE(names(contacts) == before);
  }
}

TEST_CASE("a capsule lies on a ramp on two points, and along its blade") {
  const Real slope = std::atan2(Real(1), Real(2));
  Body ramp = hull(wedge(2, 1, 1), 1);
  const Vec3 up(-std::sin(slope), std::cos(slope), 0);
  Body lying = capsule(Real(0.1), Real(0.3), 1).turned(slope - pi / 2, Vec3::UnitZ());
  lying.position = Vec3(0, Real(0.5), 0) + Real(0.08) * up;
  Contacts contacts = contacts_of(ramp, lying);
  REQUIRE(contacts.size() == 2);
  for (const Contact& c : contacts) {
    require_equal(c.normal, up);
    REQUIRE(c.depth == Approx(0.02));
  }
  require_equal(contacts[1].point - contacts[0].point, Real(0.6) * Vec3(std::cos(slope), std::sin(slope), 0));
  Body along = capsule(Real(0.1), 2, 1).turned(pi / 2, Vec3::UnitX()).at({Real(-1.06), Real(-0.05), Real(0.2)});
  contacts = contacts_of(ramp, along);  // longer than the blade, which goes from z = -0.5 to 0.5
  REQUIRE(contacts.size() == 2);
  for (const Contact& c : contacts) REQUIRE(std::abs(c.point.z()) == Approx(0.5));
}

TEST_CASE("four points of two faces with many corners span most of what they share") {
  for (int i = 0; i < 20; ++i) {
    Body a = hull(prism(16, 1, Real(0.2)), 1);
    Body b = hull(prism(16, 1, Real(0.2)), 1).turned(Real(0.02) * Real(i), Vec3::UnitY()).at({0, Real(0.39), 0});
    Contacts contacts = contacts_of(a, b);
    REQUIRE(contacts.size() == 4);
    std::sort(contacts.begin(), contacts.end(), [](const Contact& p, const Contact& q) {
      return std::atan2(p.point.z(), p.point.x()) < std::atan2(q.point.z(), q.point.x());
    });
    const Vec3 one = contacts[2].point - contacts[0].point, other = contacts[3].point - contacts[1].point;
    REQUIRE(std::abs(one.cross(other).y()) / 2 > Real(1.85));  // a square in the circle has 2 m^2
  }
}

// ---- in a world ---------------------------------------------------------------------------------------------------

TEST_CASE("what lies on the ground stays there") {
  const Points tetrahedron = {{0, 0, 0}, {1, 0, 0}, {0, 0, 1}, {Real(0.3), Real(0.8), Real(0.3)}};
  const Points crate = corners_of_box({Real(0.5), Real(0.5), Real(0.5)});
  Points plank = corners_of_box({1, Real(0.1), Real(0.5)});
  for (const Points& points : {crate, wedge(2, 1, 1), tetrahedron, prism(16, Real(0.5), Real(0.5)), plank}) {
    for (const bool on_box : {false, true}) {
      World world;
      if (on_box) world.add(box({3, 1, 3}, 1).fixed().at({0, -1, 0}));
      else world.add(ground());
      Body body = hull(points, 100);
      // By a millimetre in the ground: a corner that the first, unfinished sweeps lift by a micrometre still touches.
      body.position.y() += reach(body, -Vec3::UnitY()) - Real(0.001);
      const int index = world.add(body);
      FullSolver solver;
      for (int step = 0; step < 180; ++step) world.step(solver, Real(1) / 60);
      const Body& now = world.bodies[std::size_t(index)];
      INFO(points.size() << " points");
      REQUIRE((now.position - body.position).norm() < Real(1e-4));
      REQUIRE(now.orientation.angularDistance(body.orientation) < Real(1e-4));
      REQUIRE(largest_speed(world) < std::max(Real(1e-6), 1000 * eps));
      for (const Contact& c : world.contacts) REQUIRE(c.state != ContactState::fresh);
    }
  }
}

TEST_CASE("an arch of stones stands between its abutments") {
  World world;
  world.add(ground());
  constexpr int count = 9;
  for (int i = 0; i < count; ++i)
    world.add(hull(stone(i, count, Real(1.6), Real(2.1), Real(0.3)), 50).rough(Real(0.7)));
  FullSolver solver;
  for (int step = 0; step < 300; ++step) world.step(solver, Real(1) / 60, 30);
  const Body& keystone = world.bodies[1 + count / 2];
  REQUIRE(keystone.position.y() > Real(1.7));
  REQUIRE(largest_speed(world) < Real(1e-3));
}
