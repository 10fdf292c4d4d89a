// What a world looks like: what has one size on the picture, what is magnified, what the legend says.
#include <algorithm>
#include <random>

#include "pushback/common/experiment/marks.h"
#include "pushback/common/experiment/picture_of.h"
#include "pushback/common/render/frame.h"
#include "tests/support/catch.h"

using namespace pushback;

namespace {

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

Vec3 turn_between(const Quat& from, const Quat& to) {
  const Eigen::AngleAxis<Real> turn(to * from.conjugate());
  return turn.angle() * turn.axis();
}

}  // namespace

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
