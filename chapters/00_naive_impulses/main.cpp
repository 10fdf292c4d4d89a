#include <fmt/format.h>

#include "pushback/chapters/00_naive_impulses/naive.h"
#include "pushback/chapters/00_naive_impulses/scenes.h"
#include "pushback/common/experiment/experiment.h"

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

void two_takes(Experiment& e) {
  e.variant("take 1: once", NaiveOnce{});
  e.variant("take 2: again, averaged", NaiveAveraged{});
}

}  // namespace

int main(int argc, char** argv) {
  Experiment e("00_naive_impulses", "What if every contact simply gets its impulse?");
  SparseHit hit;
  e.parameter({"--speed", "v", "m/s", "Speed of the ball that hits the box", 0.5, 20}, &hit.speed);
  e.parameter({"--mass-ratio", "m₁/m₂", "", "Mass of that ball, in masses of the box", 0.01, 100}, &hit.mass_ratio);
  int boxes = 5;
  e.parameter({"--boxes", "n", "", "Boxes of the stack", 2, 10}, &boxes);
  return e.run(argc, argv, [&] {
    e.scene({.name = "one hit in empty space",
             .fill = hit,
             .camera = {{Real(0.4), 2, Real(6.2)}, {Real(0.4), Real(1.05), 0}},
             .seconds = Real(1.2)});
    two_takes(e);
    e.series("speed of the ball", "m/s", [](const World& world) { return world.bodies[1].velocity.x(); });
    e.number("energy kept", "%", [](const Run& run) {
      return 100 * run.samples.back().kinetic_energy / run.samples.front().kinetic_energy;
    });
    e.number("momentum gained", "N s",
             [](const Run& run) { return (run.samples.back().momentum - run.samples.front().momentum).norm(); });

    const Camera near_ground{{Real(2.2), Real(1.5), Real(3.4)}, {0, Real(0.6), 0}};
    e.scene({.name = "a box put on the ground",
             .fill = [](World& world) { stack(world, 1); },
             .camera = near_ground,
             .seconds = 3});
    two_takes(e);
    e.series("height of the box", "m", top);
    e.number("jitter", "m/s", jitter);

    const Real tall = static_cast<Real>(boxes), farther = tall / 5;
    e.scene({.name = fmt::format("a stack of {}", spelled(boxes)),
             .fill = [boxes](World& world) { stack(world, boxes); },
             .camera = {farther * Vec3(8, 5, 15), {0, farther * Real(3.2), 0}},
             .seconds = 6,
             .instants = {0, 1, 3, 6}});
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
  });
}
