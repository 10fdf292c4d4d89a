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
  e.parameter({"--drop", "h₀", "m", "Drop height of the ball", 0.1, 2}, &ball.drop);
  Real gap = Real(0.08);
  e.parameter({"--gap", "", "m", "Gap between the separated balls", 0.08, 0.5}, &gap);
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
    const std::array<const char*, 3> apexes{"first apex", "second apex", "third apex"},
        references{"e² h₀", "e⁴ h₀", "e⁶ h₀"};
    const auto three_bounces = [&](Variant& variant) {
      for (std::size_t k = 0; k < apexes.size(); ++k) {
        const Real expected = ball.apex(bounciness, static_cast<int>(k) + 1, threshold);
        variant.expect(apexes[k], expected);
        variant.reference(references[k], [expected](Real) { return expected; });
      }
    };
    three_bounces(e.variant("from where it was detected", simultaneous));
    three_bounces(
        e.variant("from the surface", with_threshold(Solver<Clamping, Baumgarte, Slop, RestitutionFromSurface>{})));
    const std::string height = "height";
    const auto height_shown = [ball](const World& world) { return std::max(ball.height_of(world, 0), Real(0.002)); };
    e.series(height, "m", height_shown, true);
    for (std::size_t k = 0; k < apexes.size(); ++k) e.number(apexes[k], "m", apex(height, k));

    const auto in_a_row = [&] {
      e.number("speed of the last ball", "m/s", [](const Run& run) { return run.world.bodies[4].velocity.x(); });
      e.number("energy kept", "%", [](const Run& run) {
        return 100 * run.samples.back().kinetic_energy / run.samples.front().kinetic_energy;
      });
      e.number("momentum gained", "N s",
               [](const Run& run) { return (run.samples.back().momentum - run.samples.front().momentum).norm(); });
    };
    const auto expect = [threshold](Variant& variant, Real speed) {
      if (threshold < arriving_speed) variant.expect("speed of the last ball", speed);  // else they do not bounce
    };
    const auto to_the_end = with_threshold(Solver<Clamping, Baumgarte, Slop, SimultaneousImpacts>{});
    e.scene({.name = "five balls in a row, e = 1",
             .fill = five_in_a_row(0),
             .camera = {{Real(1.2), Real(4.3), 22}, {Real(1.2), Real(0.3), 0}, Real(0.1)},
             .seconds = Real(1.05),
             .instants = {Real(0.3), Real(0.6), 1},
             .caption = "Arrows are speeds. Between 0.3 and 0.6 s the blue ball hits the others.",
             .start_shown = false,  // one variant has gaps
             .marks =
                 [](Picture& picture, const World& world, Real time) {
                   if (time > 0) add_speeds(picture, world);
                 },
             .cell_height = 140,
             .guess = Guess{{1, 2}}});
    const auto apart = [gap](World& world) {
      world.bodies.clear();
      five_in_a_row(gap)(world);
    };
    expect(e.variant(fmt::format("{:.3g} cm between them", 100 * gap), simultaneous).changing(apart), 4);
    expect(e.variant("touching, sequential", with_threshold(Solver<Clamping, Baumgarte, Slop, SequentialImpacts>{})),
           4);
    expect(e.variant("touching, simultaneous", to_the_end).coloured(4), Real(1.6));
    e.series("speed of the last ball", "m/s", [](const World& world) { return world.bodies[4].velocity.x(); });
    in_a_row();

    e.scene({.name = "the same balls, touching, simultaneous",
             .fill = five_in_a_row(0),
             .seconds = Real(1.05),
             .pictures = false});
    expect(e.variant("1 sweep", simultaneous).with_exactly(1), Real(1.6));
    expect(e.variant("10 sweeps", simultaneous).with_exactly(10), Real(1.6));
    expect(e.variant("to the end", to_the_end).coloured(4), Real(1.6));
    e.series("kinetic energy", "J", [](const World& world) { return kinetic_energy(world); });
    in_a_row();
  });
}
