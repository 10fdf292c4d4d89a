#include "pushback/chapters/09_impacts/scenes.h"
#include "pushback/chapters/09_impacts/sequential.h"
#include "pushback/chapters/09_impacts/simultaneous.h"

using namespace pushback;
using namespace pushback::impacts_scenes;
using namespace pushback::restitution_scenes;

namespace {

/// s, until a ball that falls from `drop` (m) has come up from its third bounce.
Real time_of_third_apex(Real drop, Real e) {
  return std::sqrt(2 * drop / World::g) * (1 + 2 * e + 2 * e * e + e * e * e);
}

}  // namespace

int main(int argc, char** argv) {
  Experiment e("09_impacts", "What happens when several bodies collide in the same step?");
  Real threshold = Real(0.1);
  e.parameter({"--threshold", "", "m/s", "Speed of approach below which nothing bounces", 0, 10}, &threshold);
  Real bounciness = Real(0.5);
  FallingBalls ball;
  e.parameter({"--bounciness", "e", "", "Restitution of the ball that is dropped", 0, 1}, &bounciness);
  e.parameter({"--drop", "h₀", "m", "How far this ball falls", 0.1, 2}, &ball.drop);
  Real gap = Real(0.08);
  e.parameter({"--gap", "", "m", "Gap between the five balls that do not touch", 0.08, 0.5}, &gap);
  return e.run(argc, argv, [&] {
    const auto with_threshold = [threshold](auto solver) {
      solver.threshold = threshold;
      return solver;
    };
    const auto simultaneous = with_threshold(Solver<Clamping, Baumgarte, Restitution>{});

    ball.bounciness = {bounciness};
    e.scene({.name = fmt::format("a ball with e = {}, three bounces", bounciness),
             .fill = ball,
             .seconds = std::max(Real(2), Real(1.1) * time_of_third_apex(ball.drop, bounciness)),
             .pictures = false});
    const std::array<const char*, 3> apexes{"first apex", "second apex", "third apex"};
    const auto three_bounces = [&](Variant& variant) {
      for (std::size_t k = 0; k < apexes.size(); ++k)
        variant.expect(apexes[k], ball.apex(bounciness, static_cast<int>(k) + 1, threshold));
    };
    three_bounces(e.variant("from where it was detected", simultaneous));
    three_bounces(
        e.variant("from the surface", with_threshold(Solver<Clamping, Baumgarte, Slop, RestitutionFromSurface>{})));
    const std::string height = fmt::format("height, e = {}", bounciness);
    e.series(height, "m", [ball](const World& world) { return ball.height_of(world, 0); });
    for (std::size_t k = 0; k < apexes.size(); ++k) e.number(apexes[k], "m", apex(height, k));

    const Camera from_the_side{{1, Real(2.2), 8}, {1, Real(0.3), 0}};
    const auto row_of_balls = [&](const std::string& title, Real between) {
      e.scene({.name = title,
               .fill = five_in_a_row(between),
               .camera = from_the_side,
               .seconds = Real(1.2),
               .instants = {0, Real(0.5), Real(0.8), Real(1.2)}});
      const auto expect = [threshold](Variant& variant, Real speed) {
        if (threshold < 4) variant.expect("speed of the last ball", speed);  // else they do not bounce
      };
      expect(e.variant("simultaneous", simultaneous), between > 0 ? 4 : Real(1.6));
      if (between == 0) {
        expect(e.variant("simultaneous, to the end",
                         with_threshold(Solver<Clamping, Baumgarte, Slop, SimultaneousImpacts>{})),
               Real(1.6));
        expect(e.variant("sequential", with_threshold(Solver<Clamping, Baumgarte, Slop, SequentialImpacts>{})), 4);
      }
      e.series("speed of the last ball", "m/s", [](const World& world) { return world.bodies[4].velocity.x(); });
      e.number("momentum gained", "N s",
               [](const Run& run) { return (run.samples.back().momentum - run.samples.front().momentum).norm(); });
      e.number("energy kept", "%", [](const Run& run) {
        return 100 * run.samples.back().kinetic_energy / run.samples.front().kinetic_energy;
      });
      e.number("speed of the last ball", "m/s", [](const Run& run) { return run.world.bodies[4].velocity.x(); });
    };
    row_of_balls(fmt::format("five balls with {:.3g} cm between them, e = 1", 100 * gap), gap);
    row_of_balls("five balls that touch, e = 1", 0);
  });
}
