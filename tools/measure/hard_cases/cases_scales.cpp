/// Far from the origin, very thin, very small, and spinning.
#include <fmt/format.h>

#include <cmath>

#include "pushback/common/world/measure.h"
#include "pushback/tools/measure/hard_cases/cases.h"
#include "pushback/tools/measure/hard_cases/standing.h"

namespace pushback {

namespace {

/// All of it falls.
void in_the_air(World& world) {
  falling_and_sliding(world, Real(0.21));
}

HardCase far_from_the_origin(const std::string& name, const std::string& title, Real distance) {
  HardCase c;
  c.name = name;
  c.title = title;
  c.stresses = "places have few digits left for what is near them: only differences may count";
  c.criteria = {{"off the motion at the origin", "mm", 1}};
  c.scene = {.name = title, .fill = in_the_air, .camera = view({-Real(0.5), 1, 1}, 4), .seconds = 5};
  c.run = [distance](Trial& trial) -> std::vector<Real> {
    const Vec3 shift{distance, 0, distance};
    Play here = trial.play(in_the_air, standing);
    Play there = trial.play(
        [&shift](World& world) {
          in_the_air(world);
          for (Body& body : world.bodies) body.position += shift;
        },
        standing);
    Real apart = 0;
    here.run(5, frame, [&](const World& world) {
      there.step();
      for (std::size_t i = 0; i < world.bodies.size(); ++i)
        apart = std::max(apart, (there.world.bodies[i].position - shift - world.bodies[i].position).norm());
    });
    return {1000 * apart};
  };
  return c;
}

/// Sides of 1 : 1000. A needle and a plate fall askew; another needle lies on another plate.
void needle_and_plate(World& world) {
  constexpr Real thin = Real(0.005), long_half = 5;
  world.add(ground());
  world.add(box({long_half, thin, thin}, 10).turned(Real(0.05), Vec3::UnitZ()).at({0, Real(0.5), 7}));
  world.add(box({long_half, thin, long_half}, 100).turned(Real(0.05), Vec3(1, 0, 2).normalized()).at({-8, 1, 0}));
  world.add(box({long_half, thin, long_half}, 100).at({8, thin, 0}));
  world.add(box({long_half, thin, thin}, 10).at({8, 3 * thin, 0}));
}

std::vector<Real> rest_of_the_thin(Trial& trial) {
  // A plate 1 cm thick is through the ground with an edge before a step finds it: 5 m/s for 1/60 s.
  Play play = trial.play(needle_and_plate, [](const World& world) {
    Allowance allowance = standing(world);
    allowance.overlap = Real(0.2);
    return allowance;
  });
  Real rim = 0;
  play.run(9);
  play.run(1, frame, [&](const World& world) {
    for (const Body& body : world.bodies) rim = std::max(rim, body.velocity.norm() + 5 * body.angular_velocity.norm());
  });
  return {1000 * rim, 1000 * deepest_overlap(play.world)};
}

HardCase tiny(int millimetres, const std::string& stresses) {
  const Real size = static_cast<Real>(millimetres) / 1000;
  HardCase c;
  c.name = fmt::format("tiny-{}mm", millimetres);
  c.title = fmt::format("five boxes of {} mm", millimetres);
  c.stresses = stresses;
  c.criteria = {{"drift after 10 s, of a side", "%", 2},
                {"deepest overlap, of a side", "%", 10},
                {"speed in the last second", "mm/s", 1}};
  c.scene = {.name = c.title,
             .fill =
                 [size](World& world) {
                   world.add(ground());
                   for (int i = 0; i < 5; ++i)
                     world.add(box(Vec3::Constant(size / 2), 1000 * size * size * size)
                                   .at({0, size * (static_cast<Real>(i) + Real(0.5)), 0}));
                 },
             .camera = view({0, size * Real(2.5), 0}, 6 * size),
             .seconds = 10};
  c.run = [fill = c.scene.fill, size](Trial& trial) -> std::vector<Real> {
    Play play = trial.play(fill, standing);
    const Stood s = stand(play, 10);
    return {100 * s.drift / size, 100 * play.watcher().deepest() / size, 1000 * s.jitter};
  };
  return c;
}

/// How often a freely spinning body of these principal inertias turns over about its middle axis y within `seconds`:
/// Euler's equations by fourth-order Runge-Kutta, in steps of a thousandth of a frame.
int flips_of(const Vec3& inertia, Vec3 w, Real seconds) {
  const auto slope = [&inertia](const Vec3& at) -> Vec3 {
    return inertia.cwiseProduct(at).cross(at).cwiseQuotient(inertia);
  };
  const Real h = frame / 1000;
  int flips = 0;
  for (long i = std::lround(seconds / h); i > 0; --i) {
    const Vec3 k1 = slope(w), k2 = slope(w + h / 2 * k1), k3 = slope(w + h / 2 * k2), k4 = slope(w + h * k3);
    const Vec3 next = w + h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
    flips += (next.y() > 0) != (w.y() > 0) ? 1 : 0;
    w = next;
  }
  return flips;
}

/// A body of 1 x 2 x 4 m about the axis of its middle inertia, a little askew, in free space.
void middle_axis(World& world) {
  world.gravity.setZero();
  world.add(box({Real(0.5), 1, 2}, 100).at({0, Real(2.2), 0}).spinning({Real(0.01), 5, Real(0.01)}));
}

std::vector<Real> spin(Trial& trial) {
  // The turning keeps the energy to rounding; what is allowed is what the criterion says.
  Play play = trial.play(middle_axis, [](const World& world) {
    return Allowance{.energy = kinetic_energy(world) / 10000, .isolated = true};
  });
  const Body& body = play.world.bodies[0];
  const Real energy = kinetic_energy(play.world), momentum = spin_momentum(body).norm();
  const int should = flips_of(body.principal_inverse_inertia.cwiseInverse(), body.angular_velocity, 10);
  Real energy_off = 0, momentum_off = 0;
  int flips = 0;
  bool up = true;
  play.run(10, frame, [&](const World& world) {
    energy_off = std::max(energy_off, std::abs(kinetic_energy(world) / energy - 1));
    momentum_off = std::max(momentum_off, std::abs(spin_momentum(body).norm() / momentum - 1));
    const bool now_up = (body.orientation.conjugate() * body.angular_velocity).y() > 0;
    flips += now_up != up ? 1 : 0;
    up = now_up;
  });
  return {energy_off, momentum_off, static_cast<Real>(std::abs(flips - should))};
}

}  // namespace

std::vector<HardCase> scale_cases() {
  HardCase thin;
  thin.name = "needle-and-plate";
  thin.title = "needle and plate";
  thin.stresses = "sides of 1 : 1000, inertias of 1 : 1000000, no thicker than twice the slop";
  thin.criteria = {{"speed of a rim in the last second", "mm/s", 10}, {"overlap after 10 s", "mm", 6}};
  thin.scene = {.name = thin.title, .fill = needle_and_plate, .camera = view({13, 0, 0}, Real(0.3)), .seconds = 1};
  thin.run = rest_of_the_thin;

  HardCase middle;
  middle.name = "middle-axis";
  middle.title = "spin about the middle axis";
  middle.stresses = "turns over and over: the gyroscopic term, with no energy from it";
  middle.criteria = {{"energy, off by", "", Real(1e-4)}, {"|L|, off by", "", Real(1e-4)}, {"flips, off by", "", 0}};
  middle.scene = {.name = middle.title, .fill = middle_axis, .camera = view({0, Real(2.2), 0}, 5), .seconds = 2};
  middle.run = spin;

  const auto lands = [](World& world) {
    middle_axis(world);
    world.gravity = World{}.gravity;
    world.add(ground());
  };

  return {tiny(50, "the slop is a tenth of a side"),
          tiny(5, "the slop is as large as a body"),
          far_from_the_origin("far-1e5", "100 km from the origin", Real(1e5)),
          far_from_the_origin("far-1e7", "10,000 km from the origin", Real(1e7)),
          thin,
          middle,
          must_settle(
              {.name = "spinning-landing",
               .title = "lands spinning",
               .stresses = "spin about the middle axis, ended by the ground: it must come to rest, and gain nothing",
               .fill = lands,
               .camera = view({0, Real(1.5), 0}, 5),
               .seconds = Real(0.5),
               .overlap = Real(0.3)})};  // corners come down with up to 12 m/s: 0.2 m in a step
}

}  // namespace pushback
