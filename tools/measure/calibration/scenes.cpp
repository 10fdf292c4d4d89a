#include "pushback/tools/measure/calibration/calibration.h"

#include <array>
#include <cmath>

#include "pushback/chapters/13_joints/ball_and_socket.h"
#include "pushback/chapters/13_joints/hinge.h"
#include "pushback/common/bodies/random.h"

namespace pushback::calibration {

namespace {

/// Draws a scene. One statement for each number that is drawn, because operands and arguments have no order.
class Draw {
 public:
  explicit Draw(std::uint64_t number) : random_(number) {
    restitution_ = std::array{Real(0), Real(0.5), Real(0.9)}[random_.below(3)];
    friction_ = between(0, 1);
    made_.asked = std::array{Real(1e-2), Real(1e-3), Real(1e-4)}[random_.below(3)];
    const bool jointed = random_.below(5) == 0;
    const auto [kind, fill] = jointed ? std::pair("jointed", &Draw::jointed) : kinds[random_.below(kinds.size())];
    made_.kind = kind;
    (this->*fill)();
  }
  Scene made() { return std::move(made_); }

 private:
  using Fill = void (Draw::*)();
  static const std::array<std::pair<const char*, Fill>, 5> kinds;

  Real between(Real low, Real high) { return random_.between(low, high); }
  Real mass() { return random_.over_decades(Real(0.3), 10); }
  std::size_t from_one_to(std::size_t most) { return 1 + random_.below(most); }
  int put(Body body) { return made_.world.add(body.bouncy(restitution_).rough(friction_)); }
  Vec3 half_extents(Real least, Real most, Real lowest, Real highest) {
    const Real x = between(least, most);
    const Real y = between(lowest, highest);
    const Real z = between(least, most);
    return {x, y, z};
  }

  /// A ball, a box, a capsule or a hull with a reach of 0.1 to 0.7 m, turned at random.
  Body any_shape() {
    const Real size = between(Real(0.1), Real(0.4));
    const Real kilograms = mass();
    const Real y = between(Real(0.3), 1);
    const Real z = between(Real(0.3), 1);
    const Quat turn = random_.orientation();
    switch (random_.below(4)) {
      case 0:
        return sphere(size, kilograms).oriented(turn);
      case 1:
        return box({size, y * size, z * size}, kilograms).oriented(turn);
      case 2:
        return capsule(y * size, size, kilograms).oriented(turn);
      default:
        break;
    }
    std::vector<Vec3> points;
    for (int i = 0; i < 8; ++i) points.push_back(size * random_.direction());
    return hull(points, kilograms).oriented(turn);
  }

  void thrown() {
    put(ground());
    const std::size_t count = from_one_to(3);
    for (std::size_t i = 0; i < count; ++i) {
      Body body = any_shape();
      body.at({Real(1.2) * static_cast<Real>(i), between(Real(0.6), 2), 0});
      body.moving(random_.vector(3));
      put(body.spinning(random_.vector(5)));
    }
  }

  void meeting() {
    put(ground());
    for (const int side : {-1, 1}) {
      Body body = any_shape();
      const Real far = between(Real(0.6), Real(1.2));
      const Real high = between(Real(0.6), Real(1.5));
      body.at({static_cast<Real>(side) * far, high, 0});
      body.moving({-static_cast<Real>(side) * between(1, 5), 1, 0});
      put(body.spinning(random_.vector(5)));
    }
  }

  void sliding() {
    const Real slope = between(0, Real(0.6));
    const Real heading = between(0, 2 * pi);
    const Vec3 normal(std::sin(slope), std::cos(slope), 0);
    const Quat tilt = Quat::FromTwoVectors(Vec3::UnitY(), normal);
    put(half_space(normal));
    const std::size_t count = from_one_to(3);
    for (std::size_t i = 0; i < count; ++i) {
      const Vec3 half = half_extents(Real(0.1), Real(0.4), Real(0.05), Real(0.2));
      Body body = box(half, mass());
      body.oriented(tilt * Quat(Eigen::AngleAxis<Real>(between(0, 2 * pi), Vec3::UnitY())));
      body.at(tilt * Vec3(0, half.y(), Real(1.5) * static_cast<Real>(i)));
      put(body.moving(tilt * (between(0, 4) * Vec3(std::cos(heading), 0, std::sin(heading)))));
    }
  }

  void rolling() {
    put(ground());
    const std::size_t count = from_one_to(4);
    for (std::size_t i = 0; i < count; ++i) {
      const Real radius = between(Real(0.1), Real(0.3));
      const Real kilograms = mass();
      const Real heading = between(Real(-0.5), Real(0.5));
      const Real along = i % 2 == 0 ? std::cos(heading) : -std::cos(heading);
      Body body = random_.below(3) == 0 ? capsule(radius, Real(0.25), kilograms).turned(pi / 2, Vec3::UnitX())
                                        : sphere(radius, kilograms);
      body.at({Real(1.2) * static_cast<Real>(i), radius, 0});
      body.moving(between(0, 4) * Vec3(along, 0, std::sin(heading)));
      put(body.spinning({0, 0, between(-10, 10)}));
    }
  }

  void struck() {
    put(ground());
    const std::size_t count = 1 + from_one_to(3);
    Real top = 0;
    for (std::size_t i = 0; i < count; ++i) {
      const Vec3 half = half_extents(Real(0.15), Real(0.3), Real(0.1), Real(0.25));
      Body body = box(half, mass());
      body.turned(between(0, 2 * pi), Vec3::UnitY());
      put(body.at({0, top + half.y(), 0}));
      top += 2 * half.y();
    }
    Body body = any_shape();
    const Real high = std::max(between(Real(0.3), 1) * top, Real(0.45));
    body.at({Real(-1.2), high, between(Real(-0.2), Real(0.2))});
    body.moving({between(1, 8), Real(0.5), 0});
    put(body.spinning(random_.vector(3)));
  }

  /// A chain that hangs, hangs over a floor or is thrown.
  void jointed() {
    const std::size_t way = random_.below(3);
    const bool flies = way == 2;
    if (way > 0) put(ground());
    const std::size_t count = from_one_to(4) + (flies ? 1 : 0);
    Vec3 end(0, between(Real(0.8), 2), 0);
    int before = the_world;
    World& world = made_.world;
    for (std::size_t i = 0; i < count; ++i) {
      Vec3 along = random_.direction();
      if (way > 0) along.y() = Real(0.4) * std::abs(along.y());
      along.normalize();
      const Real length = between(Real(0.3), Real(0.6));
      const Real kilograms = mass();
      Body body = random_.below(2) == 0 ? box({Real(0.06), Real(0.4) * length, Real(0.06)}, kilograms)
                                        : capsule(Real(0.06), Real(0.3) * length, kilograms);
      body.oriented(Quat::FromTwoVectors(Vec3::UnitY(), along)).at(end + length / 2 * along);
      if (flies) body.moving({1, 1, 0});
      const int link = put(body);
      const Vec3 axis = random_.direction();
      const bool turns = random_.below(3) == 0;
      if (i > 0 || !flies)
        world.joints.push_back(turns ? hinge(world, before, link, end, axis)
                                     : ball_and_socket(world, before, link, end));
      before = link;
      end += length * along;
    }
  }

  Random random_;
  Scene made_;
  Real restitution_ = 0, friction_ = 0;
};

const std::array<std::pair<const char*, Draw::Fill>, 5> Draw::kinds{std::pair("thrown", &Draw::thrown),
                                                                    {"meeting", &Draw::meeting},
                                                                    {"sliding", &Draw::sliding},
                                                                    {"rolling", &Draw::rolling},
                                                                    {"struck", &Draw::struck}};

}  // namespace

Scene scene(std::uint64_t number) {
  return Draw(number).made();
}

}  // namespace pushback::calibration
