// What a world looks like: what has one size on the picture, what is magnified, what the legend says.
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

Vec3 turn_between(const Quat& from, const Quat& to) {
  const Eigen::AngleAxis<Real> turn(to * from.conjugate());
  return turn.angle() * turn.axis();
}

}  // namespace

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
