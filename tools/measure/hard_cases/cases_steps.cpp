/// The same scenes by other steps, with every contact given twice, and with the bodies in another order.
#include <cmath>

#include "pushback/common/bodies/random.h"
#include "pushback/tools/measure/hard_cases/cases.h"
#include "pushback/tools/measure/hard_cases/standing.h"

namespace pushback {

namespace {

const std::vector<Criterion> stands{
    {"drift", "mm", 1}, {"deeper than the slop", "mm", 1}, {"speed at the end", "mm/s", 1}, {"energy gained", "J", 5}};

void stack_of_five(World& world) {
  stack(world, 5);
}

/// What `stands` asks for. 5 J lift the five by 0.1 mm.
std::vector<Real> numbers_of(const Stood& s, const Play& play) {
  return {1000 * s.drift, 1000 * s.beyond, 1000 * s.jitter, play.watcher().energy_gained()};
}

HardCase step_of(const std::string& name, const std::string& title, const std::string& stresses, Real dt,
                 Real seconds) {
  HardCase c;
  c.name = name;
  c.title = title;
  c.stresses = stresses;
  c.criteria = stands;
  c.scene = {.name = title, .fill = stack_of_five, .camera = view({0, Real(2.5), 0}, 6), .seconds = seconds};
  c.run = [dt, seconds](Trial& trial) {
    Play play = trial.play(stack_of_five, standing);
    return numbers_of(stand(play, seconds, dt), play);
  };
  return c;
}

/// A fiftieth of a second of a stack of three.
std::vector<Real> tiny_steps(Trial& trial) {
  Play play = trial.play([](World& world) { stack(world, 3); }, standing);
  Stood s;
  play.run(Real(0.02), Real(1e-5), [&](const World& world) {
    for (const Body& body : world.bodies) {
      s.jitter = body.movable() ? std::max(s.jitter, body.velocity.norm()) : s.jitter;
      s.drift = std::max(s.drift, std::hypot(body.position.x(), body.position.z()));
    }
  });
  s.beyond = std::max(Real(0), play.watcher().deepest() - slop);
  return numbers_of(s, play);
}

/// Every step another dt, from 1/240 to 1/30 s.
std::vector<Real> changing_steps(Trial& trial) {
  Play play = trial.play(stack_of_five, standing);
  Random random(30);
  Real time = 0;
  Stood s;
  while (time < 10 && play.sound()) {
    const Real dt = random.over_decades(Real(1) / 240, Real(1) / 30);
    play.step(dt);
    time += dt;
    for (const Body& body : play.world.bodies) {
      if (time > 9) s.jitter = std::max(s.jitter, body.velocity.norm());
      s.drift = std::max(s.drift, std::hypot(body.position.x(), body.position.z()));
    }
  }
  s.beyond = std::max(Real(0), play.watcher().deepest() - slop);
  return numbers_of(s, play);
}

/// The box slides from the start.
void box_on_the_ground(World& world) {
  falling_and_sliding(world, Real(0.2));
}

std::vector<Real> once_and_twice(Trial& trial) {
  Play once = trial.play_given(box_on_the_ground, standing, false);
  Play twice = trial.play_given(box_on_the_ground, standing, true);
  Real apart = 0;
  once.run(5, frame, [&](const World& world) {
    twice.step();
    for (std::size_t i = 0; i < world.bodies.size(); ++i)
      apart = std::max(apart, (twice.world.bodies[i].position - world.bodies[i].position).norm());
  });
  return {1000 * apart};
}

/// A pyramid of base 5 whose bodies, the ground among them, were added in another order.
void shuffled_pyramid(World& world, std::uint64_t seed) {
  World in_order;
  pyramid(in_order, 5);
  Random random(seed);
  random.shuffle(in_order.bodies);
  for (const Body& body : in_order.bodies) world.add(body);
}

std::vector<Real> any_order(Trial& trial) {
  Stood worst;
  for (const std::uint64_t seed : {1, 2, 3, 4, 5}) {
    Play play = trial.play([seed](World& world) { shuffled_pyramid(world, seed); }, standing);
    const Stood s = stand(play, 10);
    worst.drift = std::max(worst.drift, s.drift);
    worst.beyond = std::max(worst.beyond, s.beyond);
    worst.jitter = std::max(worst.jitter, s.jitter);
  }
  return {1000 * worst.drift, 1000 * worst.beyond, 1000 * worst.jitter};
}

}  // namespace

std::vector<HardCase> step_cases() {
  HardCase tiny = step_of("dt-1e-5", "steps of 10 microseconds",
                          "a step adds 0.1 mm/s: what is divided by h grows, what h multiplies is nearly lost",
                          Real(1e-5), Real(0.02));
  tiny.scene.fill = [](World& world) { stack(world, 3); };
  tiny.run = tiny_steps;

  HardCase changing =
      step_of("dt-changing", "every step another dt", "last step's impulses are those of another h", frame, 10);
  changing.run = changing_steps;

  HardCase twice;
  twice.name = "contacts-twice";
  twice.title = "contacts given twice";
  twice.stresses = "rows that say the same: the loads can be shared in any way, the motion must not change";
  twice.criteria = {{"off the motion with each once", "mm", 1}};
  twice.scene = {.name = twice.title, .fill = box_on_the_ground, .camera = view({0, 1, 1}, 4), .seconds = 5};
  twice.run = once_and_twice;

  HardCase order;
  order.name = "any-order";
  order.title = "bodies in five orders";
  order.stresses = "a sweep goes by the bodies' order: a pyramid of base 5 must stand in whichever";
  order.criteria = {
      {"drift after 10 s", "mm", 1}, {"deeper than the slop", "mm", 1}, {"speed in the last second", "mm/s", 1}};
  order.scene = {.name = order.title,
                 .fill = [](World& world) { shuffled_pyramid(world, 1); },
                 .camera = view({0, 2, 0}, 6),
                 .seconds = 10};
  order.run = any_order;

  const std::string coarse = "a stack of five, as coarse as it gets: 98 mm of fall in a step";
  return {step_of("dt-10", "steps of 1/10 s", coarse, Real(1) / 10, 10),
          step_of("dt-30", "steps of 1/30 s", "a stack of five", Real(1) / 30, 10),
          step_of("dt-60", "steps of 1/60 s", "a stack of five: the measure for the other steps", frame, 10),
          step_of("dt-240", "steps of 1/240 s", "a stack of five, by fine steps", Real(1) / 240, 10),
          tiny,
          changing,
          twice,
          order};
}

}  // namespace pushback
