#include "pushback/chapters/05_restitution/at_once.h"
#include "pushback/chapters/05_restitution/in_turn.h"
#include "pushback/chapters/05_restitution/mistakes.h"
#include "pushback/chapters/05_restitution/scenes.h"

using namespace pushback;

int main(int argc, char** argv) {
  Experiment e("05_restitution", "How high does it bounce, and how high should it?");
  Real threshold = Real(0.1);
  e.parameter({"--threshold", "", "m/s", "Speed of approach below which nothing bounces", not_negative()}, &threshold);
  return e.run(argc, argv, [&] {
    Solver<Clamping, Baumgarte, Restitution> larger;
    larger.threshold = threshold;

    e.scene({.name = "four balls: e = 0, 0.5, 0.8, 1",
             .fill = four_balls,
             .camera = {{0, Real(1.9), 7}, {0, Real(1.22), 0}},
             .seconds = 4,
             .instants = {0, Real(0.96), Real(1.15), Real(1.28)}});
    const auto compare = [&](Variant& variant) {
      for (const Real bounce : {Real(0.5), Real(0.8), Real(1)})
        variant.expect(fmt::format("first apex, e = {}", bounce), bounce * bounce * drop);
    };
    compare(e.variant("the larger of bounce and push-out", larger));
    compare(e.variant("their sum", Solver<Clamping, Baumgarte, RestitutionAdded>{}));
    compare(e.variant("bounce in a pass of its own", Solver<Clamping, Baumgarte, RestitutionApart>{}));
    compare(e.variant("this step's gravity counted in", Solver<Clamping, Baumgarte, RestitutionWithGravity>{}));
    for (std::size_t ball = 3; ball > 0; --ball) {
      e.series(fmt::format("height, e = {}", bounciness[ball]), "m",
               [ball](const World& world) { return height_of(world, ball); });
      e.number(fmt::format("first apex, e = {}", bounciness[ball]), "m", apex(ball));
    }

    const std::array<const char*, 3> apexes{"first apex", "second apex", "third apex"};
    e.scene({.name = "the ball with e = 0.5 again, three bounces",
             .fill = four_balls,
             .camera = {},
             .seconds = 2,
             .pictures = false});
    const auto three_bounces = [&](Variant& variant) {
      for (std::size_t k = 0; k < apexes.size(); ++k)
        variant.expect(apexes[k], drop * std::pow(Real(0.5), static_cast<Real>(2 * (k + 1))));
    };
    Solver<Clamping, Baumgarte, Slop, RestitutionFromSurface> from_surface;
    from_surface.threshold = threshold;
    three_bounces(e.variant("from where it was found", larger));
    three_bounces(e.variant("from the surface", from_surface));
    e.series("height, e = 0.5", "m", [](const World& world) { return height_of(world, 1); });
    for (std::size_t k = 0; k < apexes.size(); ++k) e.number(apexes[k], "m", apex(1, k));

    e.scene({.name = "boxes with e = 0.8 dropped by 20 mm",
             .fill = at_rest,
             .camera = {},
             .seconds = 3,
             .pictures = false});
    using WithGravity = Solver<Clamping, Baumgarte, Slop, RestitutionWithGravity>;
    for (const Real least : {Real(0), Real(0.5), Real(1)}) {
      WithGravity solver;
      solver.threshold = least;
      e.variant(fmt::format("gravity counted in, threshold {} m/s", least), solver);
    }
    Solver<Clamping, Baumgarte, Slop, Restitution> without_gravity;
    without_gravity.threshold = threshold;
    e.variant(fmt::format("gravity left out, threshold {} m/s", threshold), without_gravity);
    e.series("height over the ground", "mm",
             [](const World& world) { return 1000 * (world.bodies[1].position.y() - Real(0.4)); });
    e.number("speed left after 3 s", "m/s", [](const Run& run) {
      Real sum = 0;
      for (const Sample& sample : run.last(Real(0.5))) sum = std::max(sum, 2 * sample.kinetic_energy / 300);
      return std::sqrt(sum);
    });

    const Camera from_the_side{{1, Real(2.2), 8}, {1, Real(0.3), 0}};
    Solver<Clamping, Baumgarte, Slop, ImpactsInTurn> in_turn;
    in_turn.threshold = threshold;
    Solver<Clamping, Baumgarte, Slop, ImpactsAtOnce> at_once;
    at_once.threshold = threshold;
    const auto row_of_balls = [&](const std::string& title, Real gap) {
      e.scene({.name = title,
               .fill = five_in_a_row(gap),
               .camera = from_the_side,
               .seconds = Real(1.2),
               .instants = {0, Real(0.5), Real(0.8), Real(1.2)}});
      e.variant("all at once", larger).expect("speed of the last ball", gap > 0 ? 4 : Real(1.6));
      if (gap == 0) {
        e.variant("all at once, until nothing changes", at_once).expect("speed of the last ball", Real(1.6));
        e.variant("one after the other", in_turn).expect("speed of the last ball", 4);
      }
      e.series("speed of the last ball", "m/s", [](const World& world) { return world.bodies[4].velocity.x(); });
      e.number("momentum gained", "N s",
               [](const Run& run) { return (run.samples.back().momentum - run.samples.front().momentum).norm(); });
      e.number("energy kept", "%", [](const Run& run) {
        return 100 * run.samples.back().kinetic_energy / run.samples.front().kinetic_energy;
      });
      e.number("speed of the last ball", "m/s", [](const Run& run) { return run.world.bodies[4].velocity.x(); });
    };
    row_of_balls("five balls with 8 cm between them, e = 1", Real(0.08));
    row_of_balls("five balls that touch, e = 1", 0);
  });
}
