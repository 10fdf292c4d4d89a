#include <algorithm>
#include <cmath>

#include "pushback/chapters/13_joints/ball_and_socket.h"
#include "pushback/chapters/19_accuracy_and_time/motion.h"
#include "pushback/chapters/19_accuracy_and_time/truth.h"
#include "pushback/common/basics/named.h"
#include "pushback/common/world/situations.h"

namespace pushback {

int Motion::frames() const {
  return static_cast<int>(std::lround(seconds * frames_per_second));
}

void Motion::begin(World& world) const {
  fill(world);
  for (const Pin& pin : pins) world.joints.push_back(ball_and_socket(world, pin.a, pin.b, pin.anchor));
}

namespace {

Places places_of(const std::function<void(World&)>& fill) {
  World world;
  fill(world);
  Places found;
  for (const Body& body : world.bodies) found.push_back(body.position.cast<double>());
  return found;
}

/// All bodies stay where they start.
auto at_rest(const std::function<void(World&)>& fill) {
  return [start = places_of(fill)](int frames) { return std::vector<Places>(static_cast<std::size_t>(frames), start); };
}

/// The last body moves by way(t) (m, s) along a direction. The others stay where they start.
template <class Way>
auto along(const std::function<void(World&)>& fill, const Eigen::Vector3d& direction, const Way& way) {
  return [start = places_of(fill), direction, way](int frames) {
    std::vector<Places> found(static_cast<std::size_t>(frames), start);
    for (int frame = 0; frame < frames; ++frame)
      found[static_cast<std::size_t>(frame)].back() += way((frame + 1.0) / frames_per_second) * direction;
    return found;
  };
}

Motion bounce() {
  constexpr Real e = Real(0.8), drop = 1, radius = Real(0.5);
  const auto fill = [=](World& world) {
    world.add(ground().bouncy(e));
    world.add(sphere(radius, 100).at({0, radius + drop, 0}).bouncy(e));
  };
  const auto way = [=](double t) { return truth::height_of_bouncing(drop, static_cast<double>(e), t) - drop; };
  return {.name = "bounce",
          .title = "a ball bounces, e = 0.8",
          .fill = fill,
          .seconds = 2.5,
          .truth = along(fill, Eigen::Vector3d::UnitY(), way),
          .most_substeps = 2048,
          .most_sweeps = 4,
          .most_passes = 2048};
}

Motion on_a_slope() {
  constexpr Real angle = pi / 6, mu = Real(0.4);
  constexpr double g = truth::g;
  const auto fill = [=](World& world) {
    const Vec3 out(std::sin(angle), std::cos(angle), 0);
    world.add(half_space(out).rough(mu));
    world.add(
        box({Real(0.5), Real(0.25), Real(0.5)}, 100).turned(-angle, Vec3::UnitZ()).at(Real(0.25) * out).rough(mu));
  };
  const double a =
      g * (std::sin(static_cast<double>(angle)) - static_cast<double>(mu) * std::cos(static_cast<double>(angle)));
  const Eigen::Vector3d down(std::cos(static_cast<double>(angle)), -std::sin(static_cast<double>(angle)), 0);
  return {.name = "incline",
          .title = "a box slides down a slope",
          .fill = fill,
          .seconds = 1.5,
          .truth = along(fill, down, [=](double t) { return a * t * t / 2; }),
          .most_substeps = 1024,
          .most_sweeps = 16,
          .most_passes = 2048};
}

Motion sliding() {
  constexpr Real mu = Real(0.5), heading = pi / 6, speed = 6;
  const Vec3 ahead(std::cos(heading), 0, std::sin(heading));
  const auto fill = [=](World& world) {
    world.add(ground().rough(mu));
    world.add(box({Real(0.5), Real(0.2), Real(0.5)}, 100).at({0, Real(0.2), 0}).moving(speed * ahead).rough(mu));
  };
  const auto way = [=](double t) { return truth::way_of_sliding(speed, static_cast<double>(mu) * truth::g, t); };
  return {.name = "sliding",
          .title = "a box slides and stops",
          .fill = fill,
          .seconds = 2,
          .truth = along(fill, ahead.cast<double>(), way),
          .most_substeps = 1024,
          .most_sweeps = 16,
          .most_passes = 2048};
}

Motion rolling() {
  constexpr Real mu = Real(0.3), heading = pi / 6, speed = 6, radius = Real(0.5);
  const Vec3 ahead(std::cos(heading), 0, std::sin(heading));
  const auto fill = [=](World& world) {
    world.add(ground().rough(mu));
    world.add(sphere(radius, 100).at({0, radius, 0}).moving(speed * ahead).rough(mu));
  };
  const auto way = [=](double t) { return truth::way_of_rolling(speed, static_cast<double>(mu), t); };
  return {.name = "rolling",
          .title = "a ball slides, then rolls",
          .fill = fill,
          .seconds = 2,
          .truth = along(fill, ahead.cast<double>(), way),
          .most_substeps = 1024,
          .most_sweeps = 4,
          .most_passes = 2048};
}

Motion resting(const std::string& name, const std::string& title, double seconds,
               const std::function<void(World&)>& fill) {
  return {.name = name, .title = title, .fill = fill, .seconds = seconds, .truth = at_rest(fill)};
}

void heavy_on_light(World& world) {
  const Vec3 cube = Vec3::Constant(Real(0.5));  // half of 1 m
  world.add(ground());
  world.add(box(cube, 100).at({0, Real(0.5), 0}));
  world.add(box(cube, 10000).at({0, Real(1.5), 0}));
}

/// Links with a ball on the last, pinned to each other and to the world, all in one line at `angle` (rad) from the vertical.
Motion hanging(const std::string& name, const std::string& title, int links, Real ball_mass, Real angle) {
  constexpr Real length = Real(0.5), half_width = Real(0.05), link_mass = 1, radius = Real(0.3);
  const Vec3 down(std::sin(angle), -std::cos(angle), 0);
  const auto fill = [=](World& world) {
    for (int i = 0; i < links; ++i)
      world.add(box({half_width, length / 2, half_width}, link_mass)
                    .turned(angle, Vec3::UnitZ())
                    .at((static_cast<Real>(i) + Real(0.5)) * length * down));
    world.add(sphere(radius, ball_mass).at((static_cast<Real>(links) * length + radius) * down));
  };
  std::vector<Pin> pins;
  std::vector<truth::Hanging> bodies;
  for (int i = 0; i <= links; ++i) {
    pins.push_back({i == 0 ? the_world : i - 1, i, static_cast<Real>(i) * length * down});
    World alone;
    alone.add(i < links ? box({half_width, length / 2, half_width}, link_mass) : sphere(radius, ball_mass));
    const Body& body = alone.bodies[0];
    bodies.push_back({.mass = 1 / static_cast<double>(body.inverse_mass),
                      .inertia = 1 / static_cast<double>(body.principal_inverse_inertia.z()),
                      .to_centre = static_cast<double>(i < links ? length / 2 : radius),
                      .to_next = static_cast<double>(length)});
  }
  return {.name = name,
          .title = title,
          .fill = fill,
          .seconds = 2,
          .truth = [=](int frames) { return truth::places_of_hanging(bodies, static_cast<double>(angle), frames); },
          .pins = pins,
          .most_substeps = links == 0 ? 2048 : 256,
          .most_sweeps = links == 0 ? 4 : 64,
          .most_passes = links == 0 ? 4096 : 1024};
}

/// Fifteen balls with gaps between them, and one that hits them. No two impacts coincide, so the truth can be computed.
Motion billiard_break() {
  constexpr Real radius = Real(0.1), gap = Real(0.01), e = Real(0.95), speed = 5;
  const auto fill = [=](World& world) {
    world.gravity.setZero();
    const Real apart = 2 * radius + gap;
    for (int row = 0; row < 5; ++row)
      for (int i = 0; i <= row; ++i)
        world.add(sphere(radius, 1)
                      .at({static_cast<Real>(row) * apart * std::sqrt(Real(3)) / 2, 0,
                           (static_cast<Real>(i) - static_cast<Real>(row) / 2) * apart})
                      .rough(0)
                      .bouncy(e));
    world.add(sphere(radius, 1).at({-1, 0, Real(0.03)}).moving({speed, 0, 0}).rough(0).bouncy(e));
  };
  const auto truth = [=](int frames) {
    World world;
    fill(world);
    Places velocities;
    for (const Body& body : world.bodies) velocities.push_back(body.velocity.cast<double>());
    return truth::places_of_colliding(places_of(fill), velocities, static_cast<double>(radius), static_cast<double>(e),
                                      frames);
  };
  return {.name = "break",
          .title = "a break of fifteen balls, e = 0.95",
          .fill = fill,
          .seconds = 0.6,
          .truth = truth,
          .most_substeps = 4096,
          .most_sweeps = 4,
          .most_passes = 4096};
}

}  // namespace

const std::vector<Motion>& all_motions() {
  static const std::vector<Motion> motions{
      bounce(),
      on_a_slope(),
      sliding(),
      rolling(),
      hanging("pendulum", "a ball on a pin", 0, 100, pi / 3),
      resting("stack-10", "a stack of ten", 5, [](World& world) { stack(world, 10); }),
      resting("pyramid-10", "a pyramid of base ten", 3, [](World& world) { pyramid(world, 10); }),
      resting("heavy-on-light", "a hundred times heavier on a box", 5, heavy_on_light),
      hanging("chain", "ten links swing a hundredfold mass", 10, 100, pi / 6),
      billiard_break()};
  return motions;
}

const Motion& motion_named(std::string_view name) {
  return named("motion", all_motions(), name);
}

}  // namespace pushback
