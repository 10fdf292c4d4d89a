#include <set>

#include "pushback/chapters/05_restitution/mistakes.h"
#include "pushback/chapters/05_restitution/scenes.h"
#include "pushback/common/experiment/marks.h"

using namespace pushback;
using namespace pushback::restitution_scenes;

namespace {

/// What the first lines of a strobe picture mean. Its pictures move to the right at `pace`, m/s.
std::vector<Label> labels_of_lines(const BouncingBall& ball, Real pace) {
  const std::vector<std::string> texts{"the top of the ball should reach h₀", "e² h₀", "e⁴ h₀", "e⁶ h₀"};
  std::vector<Label> labels;
  for (int k = 0; k < static_cast<int>(texts.size()); ++k) {
    const Vec3 at(pace * std::max(Real(-0.1), ball.lands(k)), ball.apex(k) + 2 * ball.radius, 0);
    labels.push_back({at, texts[static_cast<std::size_t>(k)]});
  }
  return labels;
}

}  // namespace

int main(int argc, char** argv) {
  Experiment e("05_restitution", "How high does it bounce, and how high should it?");
  Real threshold = Real(0.1);
  e.parameter({"--threshold", "", "m/s", "Speed of approach below which nothing bounces", 0, 10}, &threshold);
  FallingBalls balls;
  e.parameter({"--bounciness", "e", "", "Restitution of the dropped balls, one value each", 0, 1}, &balls.bounciness);
  e.parameter({"--drop", "h₀", "m", "Drop height of the balls", 0.1, 2}, &balls.drop);
  return e.run(argc, argv, [&] {
    Solver<Clamping, Baumgarte, Restitution> larger;
    larger.threshold = threshold;

    const std::vector<Real>& bounciness = balls.bounciness;
    if (std::set<Real>(bounciness.begin(), bounciness.end()).size() < bounciness.size())
      throw InvalidInput(fmt::format("--bounciness is {}: each number once is needed", fmt::join(bounciness, ",")));
    e.scene({.name = fmt::format("{} ball{}: e = {}", spelled(static_cast<double>(bounciness.size())),
                                 bounciness.size() == 1 ? "" : "s", fmt::join(bounciness, ", ")),
             .fill = balls,
             .seconds = 4,
             .pictures = false});
    const auto compare = [&](Variant& variant, Real its_threshold) {
      for (const Real bounce : bounciness)
        variant.expect(fmt::format("first apex, e = {}", bounce), balls.apex(bounce, 1, its_threshold));
    };
    const Solver<Clamping, Baumgarte, RestitutionAdded> added;
    const Solver<Clamping, Baumgarte, RestitutionApart> apart;
    const Solver<Clamping, Baumgarte, RestitutionWithGravity> with_gravity;
    compare(e.variant("bounce or push-out", larger).coloured(0), threshold);
    compare(e.variant("bounce + push-out", added), 0);
    compare(e.variant("gravity counted in", with_gravity), 0);
    compare(e.variant("bounce in a pass of its own", apart).without_curves(), 0);
    for (std::size_t ball = bounciness.size(); ball-- > 0;) {
      if (bounciness[ball] == 0) continue;
      const std::string height = fmt::format("height, e = {}", bounciness[ball]);
      e.series(height, "m", [=](const World& world) { return balls.height_of(world, ball); });
      e.number(fmt::format("first apex, e = {}", bounciness[ball]), "m", apex(height));
    }

    const BouncingBall ball;
    constexpr Real pace = Real(2.4), watched = Real(4.4);  // m/s, of the pictures across the sheet; s
    const Vec3 middle = pace * watched / 2 * Vec3::UnitX();
    e.scene({.name = fmt::format("one ball, e = {}", ball.e),
             .fill = ball,
             .camera = {middle + Vec3(0, Real(1.3), 20), middle + Vec3(0, Real(1.19), 0), Real(0.146)},
             .seconds = watched,
             .contacts = Drawn::points,
             .key = "strobe",
             .caption =
                 "The top of the ball should just reach each line, at e²ᵏ h₀ after bounce k. The rows differ in the "
                 "bias of a contact: the larger of bounce and push-out, their sum, and the larger again, with "
                 "a bounce that counts in this step's gravity.",
             .marks =
                 [=](Picture& picture, const World&, Real time) {
                   for (int k = 0; ball.lands(k) < time; ++k) {
                     const Real y = ball.apex(k) + 2 * ball.radius;
                     add_line(picture, {Vec3(pace * std::max(Real(-0.1), ball.lands(k)), y, 0),
                                        Vec3(pace * std::min(time, ball.lands(k + 1)), y, 0)});
                   }
                 },
             .labels = labels_of_lines(ball, pace),
             .strobe = Strobe{.every = Real(1) / 15, .shift_per_second = pace * Vec3::UnitX(), .height = 360},
             .in_brief = {{0, 1}},
             .guess = Guess{{0, 1, 2}}});
    for (Variant* variant : {&e.variant("bounce or push-out", larger).coloured(0),
                             &e.variant("bounce + push-out", added), &e.variant("gravity counted in", with_gravity)}) {
      for (int k = 1; k <= 3; ++k) variant->expect(fmt::format("apex {}", k), ball.apex(k));
    }
    e.series_without_curves("height", [=](const World& world) { return world.bodies[1].position.y() - ball.radius; });
    for (int k = 1; k <= 3; ++k)
      e.number(fmt::format("apex {}", k), "m", apex("height", static_cast<std::size_t>(k - 1)));

    e.scene({.name = "boxes with e = 0.8 dropped by 20 mm",
             .fill = at_rest,
             .camera = {},
             .seconds = 3,
             .pictures = false});
    using WithGravity = Solver<Clamping, Baumgarte, Slop, RestitutionWithGravity>;
    for (int i = 0; i < 3; ++i) {
      WithGravity solver;
      solver.threshold = Real(0.5) * static_cast<Real>(i);
      e.variant(fmt::format("gravity counted in, threshold {} m/s", solver.threshold), solver).curves =
          i != 1;  // 0.5 is as 0
    }
    Solver<Clamping, Baumgarte, Slop, Restitution> without_gravity;
    without_gravity.threshold = threshold;
    e.variant(fmt::format("gravity left out, threshold {} m/s", threshold), without_gravity).coloured(0);
    e.series("height over the ground", "mm",
             [](const World& world) { return 1000 * (world.bodies[1].position.y() - Real(0.4)); });
    e.number("speed left after 3 s", "m/s", [](const Run& run) {
      Real sum = 0;
      for (const Sample& sample : run.last(Real(0.5))) sum = std::max(sum, 2 * sample.kinetic_energy / 300);
      return std::sqrt(sum);
    });
  });
}
