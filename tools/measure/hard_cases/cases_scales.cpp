/// Far from the origin, very thin, very small, and spinning; by other steps, with every contact given twice, and with the bodies in another
/// order.
#include <fmt/format.h>

#include <cmath>

#include "pushback/common/bodies/random.h"
#include "pushback/common/world/measure.h"
#include "pushback/tools/measure/hard_cases/standing.h"

namespace pushback {

namespace {

// ---- scales ----------------------------------------------------------------------------------------------------------

/// All of it falls.
void in_the_air(World& world) {
  falling_and_sliding(world, Real(0.21));
}

HardCase far_from_the_origin(const std::string& name, const std::string& title, Real distance) {
  const auto run = [distance](Trial& trial) -> std::vector<Real> {
    const Vec3 shift{distance, 0, distance};
    const auto far_away = [&shift](World& world) {
      in_the_air(world);
      for (Body& body : world.bodies) body.position += shift;
    };
    Play here = trial.play(in_the_air, standing), there = trial.play(far_away, standing);
    return {farthest_apart(here, there, shift)};
  };
  return {.name = name,
          .title = title,
          .stresses = "places have few digits left for what is near them: only differences may count",
          .criteria = {{"off the motion at the origin", "mm", 1}},
          .scene = seen(in_the_air, view({-Real(0.5), 1, 1}, 4), 5),
          .run = run};
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
  Play play = trial.play(needle_and_plate, striking(Real(0.2)));
  play.run(9);
  const Real rim = play.largest(1, [](const World& world) {
    Real fastest = 0;
    for (const Body& body : world.bodies)
      fastest = std::max(fastest, body.velocity.norm() + 5 * body.angular_velocity.norm());
    return fastest;
  });
  return {1000 * rim, 1000 * deepest_overlap(play.world)};
}

HardCase tiny(int millimetres, const std::string& stresses) {
  const Real size = static_cast<Real>(millimetres) / 1000;
  const auto fill = [size](World& world) {
    world.add(ground());
    for (int i = 0; i < 5; ++i)
      world.add(box(Vec3::Constant(size / 2), 1000 * size * size * size)
                    .at({0, size * (static_cast<Real>(i) + Real(0.5)), 0}));
  };
  const auto run = [fill, size](Trial& trial) -> std::vector<Real> {
    Play play = trial.play(fill, standing);
    const Stood s = stand(play, 10);
    return {100 * s.drift / size, 100 * play.watcher().deepest() / size, 1000 * s.jitter};
  };
  return {.name = fmt::format("tiny-{}mm", millimetres),
          .title = fmt::format("five boxes of {} mm", millimetres),
          .stresses = stresses,
          .criteria = {{"drift after 10 s, of a side", "%", 2},
                       {"deepest overlap, of a side", "%", 10},
                       {"speed in the last second", "mm/s", 1}},
          .scene = seen(fill, view({0, size * Real(2.5), 0}, 6 * size), 10),
          .run = run};
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

// ---- steps -----------------------------------------------------------------------------------------------------------

/// 5 J lift five boxes by 0.1 mm.
const std::vector<Asked> stands{{{"drift", "mm", 1}, &Stood::drift},
                                {{"deeper than the slop", "mm", 1}, &Stood::beyond},
                                {{"speed at the end", "mm/s", 1}, &Stood::jitter},
                                {{"energy gained", "J", 5}, &Stood::gained}};

void stack_of_three(World& world) {
  stack(world, 3);
}
void stack_of_five(World& world) {
  stack(world, 5);
}

HardCase case_of_steps(const std::string& name, const std::string& title, const std::string& stresses) {
  return {
      .name = name, .title = title, .stresses = stresses, .scene = seen(stack_of_five, view({0, Real(2.5), 0}, 6), 10)};
}
HardCase steps_of(int one_over_dt, const std::string& stresses) {
  const HardCase c =
      case_of_steps(fmt::format("dt-{}", one_over_dt), fmt::format("steps of 1/{} s", one_over_dt), stresses);
  return must_stand(c, stands, 10, Real(1) / static_cast<Real>(one_over_dt));
}

/// Looks at the stack after a step; `at_the_end`: at its speed, too.
void look(Stood& stood, const Play& play, bool at_the_end) {
  for (const Body& body : play.world.bodies) {
    if (at_the_end) stood.jitter = std::max(stood.jitter, body.velocity.norm());
    stood.drift = std::max(stood.drift, std::hypot(body.position.x(), body.position.z()));
  }
  stood.beyond = std::max(Real(0), play.watcher().deepest() - slop);
  stood.gained = play.watcher().energy_gained();
}

/// A fiftieth of a second.
Stood tiny_steps(Trial& trial) {
  Play play = trial.play(stack_of_three, standing);
  Stood s;
  play.run(Real(0.02), Real(1e-5), [&](const World&) { look(s, play, true); });
  return s;
}

/// Every step another dt, from 1/240 to 1/30 s.
Stood changing_steps(Trial& trial) {
  Play play = trial.play(stack_of_five, standing);
  Random random(30);
  Stood s;
  for (Real time = 0; time < 10 && play.sound();) {
    const Real dt = random.over_decades(Real(1) / 240, Real(1) / 30);
    play.step(dt);
    time += dt;
    look(s, play, time > 9);
  }
  return s;
}

/// The box slides from the start.
void box_on_the_ground(World& world) {
  falling_and_sliding(world, Real(0.2));
}

std::vector<Real> once_and_twice(Trial& trial) {
  Play once = trial.play(box_on_the_ground, standing, GivenContacts::once);
  Play twice = trial.play(box_on_the_ground, standing, GivenContacts::twice);
  return {farthest_apart(once, twice)};
}

/// A pyramid of base 5 whose bodies, the ground among them, were added in another order.
void shuffled_pyramid(World& world, std::uint64_t seed) {
  World in_order;
  pyramid(in_order, 5);
  Random random(seed);
  random.shuffle(in_order.bodies);
  for (const Body& body : in_order.bodies) world.add(body);
}

Stood any_order(Trial& trial) {
  Stood worst;
  for (const std::uint64_t seed : {1, 2, 3, 4, 5}) {
    Play play = trial.play([seed](World& world) { shuffled_pyramid(world, seed); }, standing);
    const Stood s = stand(play, 10);
    worst.drift = std::max(worst.drift, s.drift);
    worst.beyond = std::max(worst.beyond, s.beyond);
    worst.jitter = std::max(worst.jitter, s.jitter);
  }
  return worst;
}

}  // namespace

std::vector<HardCase> scale_cases() {
  const auto lands = [](World& world) {
    middle_axis(world);
    world.gravity = World{}.gravity;
    world.add(ground());
  };
  return {tiny(50, "the slop is a tenth of a side"),
          tiny(5, "the slop is as large as a body"),
          far_from_the_origin("far-1e5", "100 km from the origin", Real(1e5)),
          far_from_the_origin("far-1e7", "10,000 km from the origin", Real(1e7)),
          {.name = "needle-and-plate",
           .title = "needle and plate",
           .stresses = "sides of 1 : 1000, inertias of 1 : 1000000, no thicker than twice the slop",
           .criteria = {{"speed of a rim in the last second", "mm/s", 10}, {"overlap after 10 s", "mm", 6}},
           .scene = seen(needle_and_plate, view({13, 0, 0}, Real(0.3)), 1),
           .run = rest_of_the_thin},
          {.name = "middle-axis",
           .title = "spin about the middle axis",
           .stresses = "turns over and over: the gyroscopic term, with no energy from it",
           .criteria = {{"energy, off by", "", Real(1e-4)}, {"|L|, off by", "", Real(1e-4)}, {"flips, off by", "", 0}},
           .scene = seen(middle_axis, view({0, Real(2.2), 0}, 5), 2),
           .run = spin},
          must_settle(
              {.name = "spinning-landing",
               .title = "lands spinning",
               .stresses = "spin about the middle axis, ended by the ground: it must come to rest, and gain nothing",
               .scene = seen(lands, view({0, Real(1.5), 0}, 5), Real(0.5))},
              Real(0.3))};  // corners come down with up to 12 m/s: 0.2 m in a step
}

std::vector<HardCase> step_cases() {
  HardCase tiny = case_of_steps("dt-1e-5", "steps of 10 microseconds",
                                "a step adds 0.1 mm/s: what is divided by h grows, what h multiplies is nearly lost");
  tiny.scene.fill = stack_of_three;
  tiny.scene.seconds = Real(0.02);
  return {
      steps_of(10, "a stack of five, as coarse as it gets: 98 mm of fall in a step"),
      steps_of(30, "a stack of five"),
      steps_of(60, "a stack of five: the measure for the other steps"),
      steps_of(240, "a stack of five, by fine steps"),
      must_stand(tiny, stands, tiny_steps),
      must_stand(case_of_steps("dt-changing", "every step another dt", "last step's impulses are those of another h"),
                 stands, changing_steps),
      {.name = "contacts-twice",
       .title = "contacts given twice",
       .stresses = "rows that say the same: the loads can be shared in any way, the motion must not change",
       .criteria = {{"off the motion with each once", "mm", 1}},
       .scene = seen(box_on_the_ground, view({0, 1, 1}, 4), 5),
       .run = once_and_twice},
      must_stand({.name = "any-order",
                  .title = "bodies in five orders",
                  .stresses = "a sweep goes by the bodies' order: a pyramid of base 5 must stand in whichever",
                  .scene = seen([](World& world) { shuffled_pyramid(world, 1); }, view({0, 2, 0}, 6), 10)},
                 {drift_up_to(1), beyond_the_slop(), at_rest()}, any_order)};
}

}  // namespace pushback
