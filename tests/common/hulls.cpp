// Hulls as solids: what they weigh, what is none, and that they lie where they are put. Where they touch: collision.cpp.
#include <algorithm>
#include <limits>
#include <string>
#include <vector>

#include "pushback/common/bodies/random.h"
#include "pushback/common/world/world.h"
#include "tests/support/catch.h"
#include "tests/support/complaint.h"
#include "tests/support/hulls.h"
#include "tests/support/outside.h"
#include "tests/support/yardstick.h"

using namespace pushback;

namespace {

constexpr Real rounding = 5000 * eps;  // 1e-12 in double, 6e-4 in float: for lengths of about 1 m

Vec3 lengths(Random& random, Real low, Real high) {  // one statement each, as in random.h
  const Real x = random.between(low, high);
  const Real y = random.between(low, high);
  const Real z = random.between(low, high);
  return {x, y, z};
}

void require_near(const Vec3& a, const Vec3& b, Real tolerance = rounding) {
  INFO("(" << a.transpose() << ") and (" << b.transpose() << ")");
  REQUIRE((a - b).norm() <= tolerance);
}

}  // namespace

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
    require_near(made.position, where);
    REQUIRE(made.inverse_mass == crate.inverse_mass);
    REQUIRE((made.inverse_inertia - crate.inverse_inertia).norm() <= rounding * crate.inverse_inertia.norm());
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
    require_near(made.position, corner + legs / 4);
    REQUIRE(solid_of(made).volume == Approx(legs.prod() / 6));
    Mat3 inertia = mass / 80 * legs * legs.transpose();
    inertia.diagonal() = 3 * mass / 80 * (Vec3::Constant(legs.squaredNorm()) - legs.cwiseAbs2());
    const Mat3 product = inertia * made.inverse_inertia;
    REQUIRE((product - Mat3::Identity()).norm() < 100 * rounding);
    const Points now = corners_of(made);  // all where they were given
    for (std::size_t k = 0; k < 4; ++k) require_near(now[k], points[k]);
  }
  const Body regular = hull({{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}}, 2);  // m s^2 / 20, s^2 = 8
  REQUIRE((regular.inverse_inertia - Mat3::Identity() / Real(0.8)).norm() < rounding);
}

TEST_CASE("at() moves the centre of mass, turned() turns about it") {
  const Points ramp = wedge(3, 1, 2);
  Body made = hull(ramp, 1);
  require_near(made.position, {Real(0.5), Real(1) / 3, 0});
  Body turned = hull(ramp, 1).turned(pi / 2, Vec3::UnitZ()).at({7, 8, 9});
  const Quat quarter(Eigen::AngleAxis<Real>(pi / 2, Vec3::UnitZ()));
  const Points now = corners_of(turned);
  for (std::size_t i = 0; i < ramp.size(); ++i) {
    require_near(now[i], Vec3(7, 8, 9) + quarter * (ramp[i] - made.position), 10 * rounding);
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
