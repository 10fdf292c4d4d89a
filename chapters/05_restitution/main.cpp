#include <set>

#include "pushback/chapters/05_restitution/mistakes.h"
#include "pushback/chapters/05_restitution/scenes.h"

using namespace pushback;
using namespace pushback::restitution_scenes;

int main(int argc, char** argv) {
  Experiment e("05_restitution", "How high does it bounce, and how high should it?");
  Real threshold = Real(0.1);
  e.parameter({"--threshold", "", "m/s", "Speed of approach below which nothing bounces", 0, 10}, &threshold);
  FallingBalls balls;
  e.parameter({"--bounciness", "e", "", "Restitution of the balls that are dropped, each another", 0, 1},
              &balls.bounciness);
  e.parameter({"--drop", "h₀", "m", "How far these balls fall", 0.1, 2}, &balls.drop);
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
  });
}
