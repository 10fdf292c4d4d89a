#include <fmt/format.h>

#include "pushback/chapters/00_naive_impulses/naive.h"
#include "pushback/chapters/00_naive_impulses/scenes.h"
#include "pushback/common/experiment/experiment.h"
#include "pushback/common/experiment/marks.h"

using namespace pushback;
using namespace pushback::naive_impulses_scenes;

namespace {

/// Root mean square of the speed, m/s, over the bodies that move and the last second.
Real jitter(const Run& run) {
  Real sum = 0;
  const std::vector<Sample> last = run.last(1);
  for (const Sample& sample : last) sum += 2 * sample.kinetic_energy;
  Real mass = 0;
  for (const Body& body : run.world.bodies) mass += body.movable() ? 1 / body.inverse_mass : 0;
  return std::sqrt(sum / mass / static_cast<Real>(last.size()));
}

/// Height of the topmost centre of mass, m.
Real top(const World& world) {
  Real highest = 0;
  for (const Body& body : world.bodies) highest = std::max(highest, body.position.y());
  return highest;
}

/// Pairs of a stack of which the lower one has come to be above the upper one: centre above centre, to within half a side.
Real pairs_in_reverse(const World& world) {
  int count = 0;
  for (std::size_t lower = 1; lower < world.bodies.size(); ++lower) {
    for (std::size_t upper = lower + 1; upper < world.bodies.size(); ++upper) {
      const Vec3 way = world.bodies[lower].position - world.bodies[upper].position;
      count += way.y() > Real(0.5) && std::abs(way.x()) < Real(0.5) && std::abs(way.z()) < Real(0.5);
    }
  }
  return static_cast<Real>(count);
}

/// The impulse of the lecture: -(1 + e) on the linear part alone, and the spins with the other sign.
struct AsPrinted : StepSolver {
  void solve(World& world, Real, int) override {
    for (Contact& c : world.contacts) {
      const Real speed = separating_speed(world, c);
      if (speed >= 0) continue;
      const auto [a, b] = world.bodies_of(c);
      const Real linear = c.normal.dot(b.velocity - a.velocity);
      const Real printed = (1 + c.restitution) * linear - (speed - linear);
      apply_impulse(world, c, pair_impulse(world, c) * printed / ((1 + c.restitution) * speed));
    }
  }
};

void two_takes(Experiment& e) {
  e.variant("take 1: once", NaiveOnce{});
  e.variant("take 2: again, averaged", NaiveAveraged{});
}

/// The bodies as the exact impulse would have them, at each instant of a strobe.
void add_exact(Picture& picture, const SpinningHit& hit, const Strobe& strobe, Real until, Real dt) {
  World exact;
  hit(exact);
  NaiveOnce solver;
  for (int instant = 0; static_cast<Real>(instant) * strobe.every < until + dt / 2; ++instant) {
    const Real t = static_cast<Real>(instant) * strobe.every;
    while (exact.time < t - dt / 2) exact.step(solver, dt);
    for (Body body : exact.bodies) {
      body.position += t * strobe.shift_per_second;
      add_outline(picture, body);
    }
  }
}

}  // namespace

int main(int argc, char** argv) {
  Experiment e("00_naive_impulses", "What if every contact simply gets its impulse?");
  SpinningHit hit;
  e.parameter({"--speed", "v", "m/s", "Speed of the ball that hits the bar", 0.5, 20}, &hit.speed);
  e.parameter({"--mass-ratio", "m₁/m₂", "", "Mass of the ball relative to the bar", 0.01, 100}, &hit.mass_ratio);
  int boxes = 5;
  e.parameter({"--boxes", "n", "", "Boxes in the stack", 2, 10}, &boxes);
  return e.run(argc, argv, [&] {
    const Real tall = static_cast<Real>(boxes);
    e.scene({.name = fmt::format("a stack of {}", spelled(boxes)),
             .fill = [boxes](World& world) { stack(world, boxes); },
             .camera = {{0, tall, tall * 8}, {0, tall * Real(0.82), 0}, Real(0.24)},
             .seconds = 6,
             .instants = {Real(1.25)},
             .contacts = Drawn::nothing,
             .key = "stack",
             .caption = "Each stack should stay in the outline. One falls apart at once. In the other the boxes pass "
                        "through each other: compare the order of their colours with the start.",
             .marks =
                 [tall](Picture& picture, const World&, Real time) {
                   if (time > 0)
                     add_outline(picture, box({Real(0.5), tall / 2, Real(0.5)}, 1).at({0, tall / 2, 0}),
                                 near_black_colour(), Real(1.5));
                 },
             .cell_height = 500,
             .guess = Guess{{0, 1}, true}});
    two_takes(e);
    e.series("height of the topmost box", "m", top);
    e.number("jitter", "m/s", jitter);
    const std::string of_all_pairs = fmt::format("of {}", boxes * (boxes - 1) / 2);
    e.series("pairs in reverse order", of_all_pairs, pairs_in_reverse);
    e.number("most pairs in reverse order", of_all_pairs, [](const Run& run) {
      const auto& pairs = run.series.at("pairs in reverse order");
      return *std::max_element(pairs.begin(), pairs.end());
    });
    e.number("height kept", "%", [tall](const Run& run) {
      return 100 * run.series.at("height of the topmost box").back() / (tall - Real(0.5));
    });

    e.scene({.name = "a box put on the ground",
             .fill = [](World& world) { stack(world, 1); },
             .seconds = 3,
             .pictures = false});
    two_takes(e);
    e.series("height of the box", "m", top);
    e.number("jitter", "m/s", jitter);

    const Strobe strobe{.every = Real(0.1), .shift_per_second = {25, 0, 0}, .height = 320};
    e.scene(
        {.name = "one impact in empty space",
         .fill = hit,
         .camera = {{Real(6.2), Real(0.3), 24}, {Real(6.2), Real(-0.15), 0}, Real(0.15)},
         .seconds = Real(0.5),
         .key = "hit",
         .caption =
             "From left to right, a ball hits a bar that spins. Thin outlines: the motion that keeps the energy. Both "
             "takes keep it; with the formula that the lecture prints, the bodies leave them.",
         .marks = [=, h = e.dt()](Picture& picture, const World&,
                                  Real time) { add_exact(picture, hit, strobe, time, h); },
         .strobe = strobe});
    e.variant("takes 1 and 2", NaiveOnce{});
    e.variant("formula as printed", AsPrinted{});
    e.series("kinetic energy", "J", kinetic_energy);
    e.number("energy kept", "%", [](const Run& run) {
      return 100 * run.samples.back().kinetic_energy / run.samples.front().kinetic_energy;
    });
    e.number("momentum gained", "N s",
             [](const Run& run) { return (run.samples.back().momentum - run.samples.front().momentum).norm(); });
  });
}
