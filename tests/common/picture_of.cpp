// What a world looks like: what has one size on the picture, what is magnified, what the legend says.
#include <algorithm>
#include <random>

#include "pushback/common/experiment/legend.h"
#include "pushback/common/experiment/marks.h"
#include "pushback/common/experiment/picture_of.h"
#include "pushback/common/render/frame.h"
#include "tests/support/catch.h"

using namespace pushback;

namespace {

constexpr int high = 281;

/// Boxes of 10 m at all distances, with a contact under each.
World boxes() {
  World world;
  world.add(ground());
  for (int i = 0; i < 6; ++i) {
    const auto x = static_cast<Real>(i);
    const int index = world.add(box({5, 5, 5}, 2).at({2 * x - 5, Real(0.5), -6 * x}));
    Contact contact;
    contact.point = {2 * x - 5, 0, -6 * x};
    contact.normal = Vec3::UnitY();
    contact.impulse = {0, Real(0.3), 0};
    contact.id = {0, static_cast<std::uint32_t>(index), 0};
    world.contacts.push_back(contact);
  }
  return world;
}
const Camera from_above{{3, 5, 9}, {0, 0, 0}, Real(0.5)};

/// By how many pixels two points are apart on the picture, by the matrix that the painter draws with.
Real apart(const Picture& picture, const Vec3& a, const Vec3& b) {
  const Eigen::Matrix4f clip = Frame(picture).clip_from_eye(500, high, Eigen::Vector2f::Zero());
  const auto pixel = [&](const Vec3& at) {
    const Eigen::Vector4f seen = clip * Vec3(at - picture.camera.eye).cast<float>().homogeneous();
    return Eigen::Vector2f(seen.x() / seen.w() * 250, seen.y() / seen.w() * high / 2);
  };
  return static_cast<Real>((pixel(a) - pixel(b)).norm());
}
/// How many pixels a length across the line of sight takes at a point.
Real pixels(const Picture& picture, const Vec3& at, Real length) {
  const Vec3 ahead = (picture.camera.target - picture.camera.eye).normalized();
  return apart(picture, at, at + length * ahead.cross(Vec3::UnitY()).normalized());
}

Vec3 turn_between(const Quat& from, const Quat& to) {
  const Eigen::AngleAxis<Real> turn(to * from.conjugate());
  return turn.angle() * turn.axis();
}

bool shows(const Legend& legend, LegendEntry::Kind kind, Ink ink) {
  const std::vector<LegendEntry> entries = legend.entries();
  return std::any_of(entries.begin(), entries.end(), [&](const LegendEntry& one) {
    return one.kind == kind && one.colour.red == ink.red && one.colour.green == ink.green &&
           one.colour.blue == ink.blue;
  });
}

}  // namespace

TEST_CASE("dots, arrows and lines are as thick on the picture wherever they are") {
  Picture picture = picture_of(boxes(), from_above, 2);
  REQUIRE(picture.dots.size() == 6);
  REQUIRE(picture.arrows.size() == 6);
  for (const Dot& dot : picture.dots)
    CHECK(pixels(picture, dot.position, dot.radius) == Approx(0.018 * high).epsilon(1e-3));
  for (const Arrow& arrow : picture.arrows) {
    CHECK(pixels(picture, arrow.tail, arrow.thickness) == Approx(0.012 * high).epsilon(1e-3));
    CHECK((arrow.tip - arrow.tail).isApprox(Vec3(0, Real(0.6), 0), Real(1e-9)));  // its length says how much
  }

  const Vec3 near{0, 0, 4}, far{0, 0, -60};
  add_line(picture, {near, far});
  Real length = 0;
  for (const Line& line : picture.lines) {
    length += (line.to - line.from).norm();
    for (const Vec3& end : {line.from, line.to})
      CHECK(pixels(picture, end, line.thickness) == Approx(2.5).epsilon(0.07));
  }
  CHECK(length == Approx((far - near).norm()));
}

TEST_CASE("a dot is never large beside the bodies") {
  World world = boxes();
  for (std::size_t i = 1; i < world.bodies.size(); ++i)
    world.bodies[i].shape = Box{{Real(0.01), Real(0.01), Real(0.01)}};
  for (const Dot& dot : picture_of(world, from_above, 2).dots) CHECK(dot.radius == Approx(0.15 * 0.02));
}

TEST_CASE("an outline lies on the body's surface") {
  const Vec3 axis = Vec3(1, 2, 3).normalized();
  const Body block = box({1, 2, 3}, 1).at({4, 5, 6}).turned(Real(0.7), axis);
  const Body ball = sphere(2, 1).at({4, 5, 6}).turned(Real(0.7), axis);
  const Body pill = capsule(Real(0.5), 1, 1).at({4, 5, 6}).turned(Real(0.7), axis);
  Picture picture;
  add_outline(picture, block);
  Real edges = 0;
  for (const Line& line : picture.lines) {
    edges += (line.to - line.from).norm();
    for (const Vec3& end : {line.from, line.to}) {
      const Vec3 share = point_on(block, end).cwiseAbs().cwiseQuotient(Vec3(1, 2, 3));
      CHECK(share.maxCoeff() == Approx(1));
      CHECK((share.array() > 1 - 1e-9).count() >= 2);  // on two faces at once: on an edge
    }
  }
  CHECK(edges == Approx(4 * (2 + 4 + 6)));
  picture.lines.clear();
  add_outline(picture, ball);
  CHECK(picture.lines.size() >= 3 * 48);
  for (const Line& line : picture.lines) CHECK((line.from - ball.position).norm() <= 2 + 1e-9);
  for (const Line& line : picture.lines) CHECK((line.from - ball.position).norm() > 1.99);
  picture.lines.clear();
  add_outline(picture, pill);
  for (const Line& line : picture.lines) {
    const Vec3 on = point_on(pill, line.from);
    const Vec3 core(0, std::clamp(on.y(), Real(-1), Real(1)), 0);
    CHECK((on - core).norm() == Approx(0.5).epsilon(0.01));
  }
  picture.lines.clear();
  add_outline(picture, ground());
  CHECK(picture.lines.empty());
}

TEST_CASE("magnified: displacements and turns are so many times as large, and contacts ride on their bodies") {
  const World start = boxes();
  World now = start;
  std::mt19937 random(7);
  std::uniform_real_distribution<double> some(-1, 1);
  const auto any = [&] { return Vec3(Real(some(random)), Real(some(random)), Real(some(random))); };
  for (Body& body : now.bodies) {
    body.position += Real(0.001) * any();
    body.orientation = Quat(Eigen::AngleAxis<Real>(Real(0.002), any().normalized())) * body.orientation;
  }
  now.contacts.back().id.body_a = 3;         // between two that move
  now.bodies[2].orientation.coeffs() *= -1;  // the same orientation
  const Real times = 100;
  const World drawn = magnified(now, start, times);
  CHECK(drawn.bodies[0].position == now.bodies[0].position);
  for (std::size_t i = 1; i < now.bodies.size(); ++i) {
    const Body &was = start.bodies[i], &is = now.bodies[i], &shown = drawn.bodies[i];
    CHECK((shown.position - was.position).isApprox(times * (is.position - was.position), Real(1e-9)));
    const Quat same = is.orientation.w() < 0 ? Quat(-is.orientation.coeffs()) : is.orientation;
    CHECK(turn_between(was.orientation, shown.orientation)
              .isApprox(times * turn_between(was.orientation, same), Real(1e-6)));
  }
  for (std::size_t i = 0; i < now.contacts.size(); ++i) {
    const std::uint32_t on = i + 1 == now.contacts.size() ? 3u : now.contacts[i].id.body_b;
    CHECK(point_on(drawn.bodies[on], drawn.contacts[i].point)
              .isApprox(point_on(now.bodies[on], now.contacts[i].point), Real(1e-9)));
  }
  const World plain = magnified(now, start, 1);
  for (std::size_t i = 0; i < now.bodies.size(); ++i)
    CHECK(plain.bodies[i].position.isApprox(now.bodies[i].position, Real(1e-12)));
}

TEST_CASE("what moves is added elsewhere, once more, and its dots have their size there") {
  const World world = boxes();
  Picture picture = picture_of(world, from_above, 2);
  const Picture alone = picture;
  const Vec3 shift{3, 1, -20};
  const Vec3 corner = world.bodies[1].position, end = corner + Vec3::UnitX();
  add_moving(picture, world, 2, shift, [&](Picture& added, const World&) { add_line(added, {corner, end}); });
  REQUIRE(picture.lines.size() == 1);
  const Line& line = picture.lines[0];
  CHECK(line.from.isApprox(corner + shift));
  CHECK(line.to.isApprox(end + shift));
  CHECK(pixels(picture, (line.from + line.to) / 2, line.thickness) == Approx(line_pixels / 281 * high).epsilon(1e-3));
  REQUIRE(picture.solids.size() == 7 + 6);  // the ground only once
  for (std::size_t i = 0; i < 6; ++i) {
    CHECK(picture.solids[7 + i].position.isApprox(alone.solids[1 + i].position + shift));
    const Dot& dot = picture.dots[6 + i];
    CHECK(dot.position.isApprox(alone.dots[i].position + shift));
    CHECK(pixels(picture, dot.position, dot.radius) == Approx(0.018 * high).epsilon(1e-3));
    CHECK(picture.arrows[6 + i].tip.isApprox(alone.arrows[i].tip + shift));
  }
}

TEST_CASE("the legend names what is drawn, and nothing else") {
  using Kind = LegendEntry::Kind;
  World world = boxes();
  Legend nothing;
  World bare = world;
  bare.contacts.clear();
  nothing.see(picture_of(bare, from_above, 2));
  CHECK(nothing.entries().empty());

  for (Contact& contact : world.contacts) contact.state = ContactState::sliding;
  Legend weak;
  for (Contact& contact : world.contacts) contact.impulse *= Real(1e-3);  // arrows too short to be drawn
  weak.see(picture_of(world, from_above, 2));
  CHECK(weak.entries().size() == 1);
  CHECK(shows(weak, Kind::dot, contact_ink(ContactState::sliding)));

  world.contacts.front().impulse = {Real(0.3), 0, 0};
  world.bodies.back().asleep = true;
  Legend strong;
  strong.see(picture_of(world, from_above, 2));
  CHECK(strong.entries().size() == 3);
  CHECK(shows(strong, Kind::arrow, friction_arrow_ink()));
  CHECK_FALSE(shows(strong, Kind::arrow, normal_arrow_ink()));
  CHECK(shows(strong, Kind::body, asleep_ink()));

  nothing.add(strong);
  CHECK(nothing.entries().size() == 3);
}
