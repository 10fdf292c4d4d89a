#include "pushback/chapters/11_substeps/study.h"
#include "pushback/chapters/21_detected_once/scenes.h"
#include "pushback/chapters/21_detected_once/study.h"
#include "pushback/common/experiment/marks.h"

using namespace pushback;
using namespace pushback::detected_once_scenes;
using namespace pushback::substeps_scenes;

namespace {

/// Adds the outline of the cube under the solver `in_each` at each instant of a strobe.
void add_first_row(Picture& picture, const RollingCube& cube, DetectedInEach in_each, const Strobe& strobe, Real until,
                   int substeps, Real dt) {
  World world;
  cube(world);
  const Real h = dt / static_cast<Real>(substeps);
  for (Real t = strobe.from; t < until + h / 2; t += strobe.every) {
    while (world.time < t - h / 2) world.step(in_each, h, 1);
    Body outline = world.bodies.back();
    outline.position += (t - strobe.from) * strobe.shift_per_second;
    add_outline(picture, outline, near_black_colour(), Real(3.5));
  }
}

}  // namespace

int main(int argc, char** argv) {
  Experiment e("21_detected_once", "How often must contacts be detected?");
  DetectedOnce once;
  e.parameter({"--substeps", "", "", "Substeps per step", 1, 128}, &once.substeps);
  e.parameter({"--margin", "", "m", "Gap up to which bodies count as touching", 0, 0.2}, &once.margin);
  RollingCube cube;
  e.parameter({"--spin", "ω", "rad/s", "Spin of the rolling cube", 0, 30}, &cube.spin);
  FallingBall ball;
  e.parameter({"--speed", "v", "m/s", "Speed of the arriving ball", 0.5, 30}, &ball.speed);
  int tall = 40;
  e.parameter({"--boxes", "n", "", "Boxes in the stack", 2, 40}, &tall);
  HeavyOnLight heavy;
  e.parameter({"--mass-ratio", "", "", "Mass ratio of the upper and lower box", 1, 2000}, &heavy.mass_ratio);
  return e.run(argc, argv, [&] {
    DetectedInEach in_each;
    const auto each = [&] {
      e.variant("detected in each substep", Substeps(in_each, once.substeps)).with_exactly(1).coloured(0);
    };
    const auto kept = [&]() -> Variant& { return e.variant("detected once", once).with_exactly(1).coloured(1); };

    const Strobe strobe{.every = Real(0.5), .shift_per_second = {3, 0, 0}, .height = 200};
    e.scene(
        {.name = "a cube rolls",
         .fill = cube,
         .camera = {{Real(8.3), Real(1.4), 40}, {Real(8.3), Real(0.95), 0}, Real(0.0608)},
         .seconds = Real(2.5),
         .contacts = Drawn::nothing,
         .caption =
             "The cube is drawn every 0.5 s, each time 1.5 m farther to the right than it is. The outlines are the "
             "cube of the first row. Detected once per step, the cube falls behind.",
         .marks = [=, h = e.dt()](Picture& picture, const World&,
                                  Real time) { add_first_row(picture, cube, in_each, strobe, time, once.substeps, h); },
         .strobe = strobe,
         .in_brief = {{0, 1}}});
    each();
    DetectedOnce in_a_quarter = once;
    in_a_quarter.substeps = std::max(1, once.substeps / 4);
    kept();
    e.variant("detected four times", Substeps(in_a_quarter, 4)).with_exactly(1).coloured(3);
    e.series("height", "m", [](const World& world) { return world.bodies[1].position.y(); });
    e.series_without_curves("distance", [](const World& world) { return world.bodies[1].position.x(); });
    e.number("distance", "m", [](const Run& run) { return run.series.at("distance").back(); });

    e.scene({.name = "a ball arrives", .fill = ball, .seconds = 2, .pictures = false});
    each();
    WithoutMargin late;
    late.substeps = once.substeps;
    e.variant("detected once, without a margin", late).with_exactly(1).coloured(2);
    kept();
    e.series("height of the ball", "m", [](const World& world) { return world.bodies[1].position.y(); });
    e.number("deepest", "mm", [](const Run& run) {
      const auto& heights = run.series.at("height of the ball");
      return 1000 * std::max(Real(0), Real(0.5) - *std::min_element(heights.begin(), heights.end()));
    });

    e.scene({.name = "a stack of " + spelled(tall),
             .fill = [tall](World& world) { stack(world, tall); },
             .seconds = 10,
             .pictures = false});
    watch_stack(e);
    each();
    kept();
    scene_of_heavy(e, heavy);
    each();
    kept();
  });
}
