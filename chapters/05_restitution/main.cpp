#include <set>

#include "pushback/chapters/09_impacts/simultaneous.h"
#include "pushback/chapters/09_impacts/sequential.h"
#include "pushback/chapters/05_restitution/mistakes.h"
#include "pushback/chapters/05_restitution/scenes.h"

using namespace pushback;

int main(int argc, char** argv) {
  Experiment e("05_restitution", "How high does it bounce, and how high should it?");
  Real threshold = Real(0.1);
  e.parameter({"--threshold", "", "m/s", "Speed of approach below which nothing bounces", 0, 10}, &threshold);
  FallingBalls balls;
  e.parameter({"--bounciness", "e", "", "Restitution of the balls that are dropped, each another", 0, 1},
              &balls.bounciness);
  e.parameter({"--drop", "h₀", "m", "How far these balls fall", 0.1, 2}, &balls.drop);
  Real gap = Real(0.08);
  e.parameter({"--gap", "", "m", "Gap between the five balls that do not touch", 0.08, 0.5}, &gap);
  return e.run(argc, argv, [&] {
    Solver<Clamping, Baumgarte, Restitution> larger;
    larger.threshold = threshold;

    const std::vector<Real>& bounciness = balls.bounciness;
    if (std::set<Real>(bounciness.begin(), bounciness.end()).size() < bounciness.size())
      throw InvalidInput(fmt::format("--bounciness is {}: each number once is needed", fmt::join(bounciness, ",")));
    e.scene({.name = fmt::format("{} ball{}: e = {}", spelled(static_cast<double>(bounciness.size())),
                                 bounciness.size() == 1 ? "" : "s", fmt::join(bounciness, ", ")),
             .fill = balls,
             .camera = {{0, Real(1.9), 7}, {0, Real(1.22), 0}},
             .seconds = 4,
             .instants = {0, Real(0.96), Real(1.15), Real(1.28)}});
    const auto compare = [&](Variant& variant, Real its_threshold) {
      for (const Real bounce : bounciness)
        variant.expect(fmt::format("first apex, e = {}", bounce), balls.apex(bounce, 1, its_threshold));
    };
    compare(e.variant("the larger of bounce and push-out", larger), threshold);
    compare(e.variant("their sum", Solver<Clamping, Baumgarte, RestitutionAdded>{}), 0);
    compare(e.variant("bounce in a pass of its own", Solver<Clamping, Baumgarte, RestitutionApart>{}), 0);
    compare(e.variant("this step's gravity counted in", Solver<Clamping, Baumgarte, RestitutionWithGravity>{}), 0);
    for (std::size_t ball = bounciness.size(); ball-- > 0;) {
      if (bounciness[ball] == 0) continue;
      const std::string height = fmt::format("height, e = {}", bounciness[ball]);
      e.series(height, "m", [=](const World& world) { return balls.height_of(world, ball); });
      e.number(fmt::format("first apex, e = {}", bounciness[ball]), "m", apex(height));
    }

    const std::array<const char*, 3> apexes{"first apex", "second apex", "third apex"};
    const std::size_t again = balls.dullest();
    e.scene({.name = fmt::format("the ball with e = {} again, three bounces", bounciness[again]),
             .fill = balls,
             .camera = {},
             .seconds = std::max(Real(2), Real(1.1) * balls.time_of_third_apex(bounciness[again])),
             .pictures = false});
    const auto three_bounces = [&](Variant& variant) {
      for (std::size_t k = 0; k < apexes.size(); ++k)
        variant.expect(apexes[k], balls.apex(bounciness[again], static_cast<int>(k) + 1, threshold));
    };
    Solver<Clamping, Baumgarte, Slop, RestitutionFromSurface> from_surface;
    from_surface.threshold = threshold;
    three_bounces(e.variant("from where it was found", larger));
    three_bounces(e.variant("from the surface", from_surface));
    const std::string height = fmt::format("height, e = {}", bounciness[again]);
    e.series(height, "m", [=](const World& world) { return balls.height_of(world, again); });
    for (std::size_t k = 0; k < apexes.size(); ++k) e.number(apexes[k], "m", apex(height, k));

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
    Solver<Clamping, Baumgarte, Slop, SequentialImpacts> in_turn;
    in_turn.threshold = threshold;
    Solver<Clamping, Baumgarte, Slop, SimultaneousImpacts> at_once;
    at_once.threshold = threshold;
    const auto row_of_balls = [&](const std::string& title, Real between) {
      e.scene({.name = title,
               .fill = five_in_a_row(between),
               .camera = from_the_side,
               .seconds = Real(1.2),
               .instants = {0, Real(0.5), Real(0.8), Real(1.2)}});
      const auto expect = [threshold](Variant& variant, Real speed) {
        if (threshold < 4) variant.expect("speed of the last ball", speed);  // else they do not bounce
      };
      expect(e.variant("all at once", larger), between > 0 ? 4 : Real(1.6));
      if (between == 0) {
        expect(e.variant("all at once, until nothing changes", at_once), Real(1.6));
        expect(e.variant("one after the other", in_turn), 4);
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
