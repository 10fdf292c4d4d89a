#include <fmt/format.h>

#include <algorithm>

#include "pushback/chapters/09_impacts/from_surface.h"
#include "pushback/chapters/19_accuracy_and_time/true_places.h"
#include "pushback/chapters/24_half_step/study.h"
#include "pushback/chapters/25_moment_of_impact/scenes.h"
#include "pushback/common/experiment/experiment.h"
#include "pushback/common/experiment/marks.h"
#include "pushback/engine/half_step/half_step.h"

using namespace pushback;
using namespace pushback::moment_of_impact_scenes;
using namespace pushback::half_step_scenes;

namespace {

using Whole = Solver<Clamping, Baumgarte, Slop, RestitutionFromSurface>;  // chapter 09

HalfStep cut(Impacts impacts) {
  HalfStep step = at_impacts();
  step.impacts = impacts;
  return step;
}

/// The last time at which the speed was above 1 mm/s, s.
Real last_moving(const Run& run) {
  const auto& speeds = run.series.at("speed");
  for (std::size_t i = speeds.size(); i-- > 0;)
    if (speeds[i] > Real(0.001)) return static_cast<Real>(i + 1) / frames_per_second;
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  Experiment e("25_moment_of_impact", "When exactly do they meet?");
  Bullet bullet;
  e.parameter({"--speed", "v", "m/s", "Speed of the bullet", 10, 900}, &bullet.speed);
  SpinningRod rod;
  e.parameter({"--spin", "ω", "rad/s", "Spin of the rod", 1, 20}, &rod.spin);
  return e.run(argc, argv, [&] {
    const auto by_each_step = [&] {
      e.variant("whole step", Whole{}).coloured(0);
      e.variant("half step", HalfStep{}).with_exactly(1).coloured(1);
      e.variant("cut at impacts", at_impacts()).with_exactly(1).coloured(2);
    };

    e.scene({.name = fmt::format("a bullet of 10 mm at {} m/s, and a sheet of 1 mm", bullet.speed),
             .fill = bullet,
             .camera = {{Real(-0.03), Real(0.02), Real(0.2)}, {Real(-0.03), 0, 0}},
             .seconds = Real(1) / 30,
             .instants = {Real(1) / 60},
             .caption = "After 1/60 s. Ring: where the bullet should be.",
             .marks = [bullet](Picture& picture, const World& /*world*/, Real time) {
               if (time > 0) add_ring(picture, {bullet.place(time), 0, 0}, Vec3::UnitZ(), Bullet::radius);
             }});
    by_each_step();
    e.series_without_curves("x", [](const World& world) { return 1000 * world.bodies[1].position.x(); });
    e.series_without_curves("off", [bullet](const World& world) {
      return 1000 * std::abs(world.bodies[1].position.x() - bullet.place(world.time));
    });
    e.number("after 1/60 s at x", "mm", [](const Run& run) { return run.series.at("x").front(); });
    e.number("off by", "mm", [](const Run& run) { return run.series.at("off").front(); });

    e.scene({.name = "a rod that spins beside a wall of 1 mm",
             .fill = rod,
             .camera = {{Real(-0.05), Real(0.3), Real(2.9)}, {Real(-0.05), 0, 0}},
             .seconds = Real(0.4),
             .instants = {Real(0.1), Real(0.2), Real(0.3)},
             .caption = "Outline: where the rod should be.",
             .start_shown = false,
             .marks = [rod](Picture& picture, const World& /*world*/, Real time) {
               add_outline(picture, rod.truth(time), near_black_colour(), Real(1.2));
             }});
    by_each_step();
    e.series("beyond the wall", "mm", [](const World& world) { return 1000 * SpinningRod::beyond(world); });
    e.series_without_curves("off", [rod](const World& world) {
      return 1000 * (world.bodies[1].position - rod.truth(world.time).position).norm();
    });
    e.number("beyond the wall by up to", "mm",
             [](const Run& run) { return std::max(Real(0), run.largest("beyond the wall")); });
    e.number("largest error", "mm", [](const Run& run) { return run.largest("off"); });

    for (const std::string name : {"bounce", "break"}) {
      const Motion& motion = motion_named(name);
      const TruePlaces& truth = true_places_of(motion);
      e.scene({.name = motion.title,
               .fill = [&motion](World& world) { motion.begin(world); },
               .seconds = static_cast<Real>(motion.seconds),
               .pictures = false});
      e.variant("half step", in_substeps(1)).with_exactly(1).coloured(1);
      e.variant("half step, 64 substeps", in_substeps(64)).with_exactly(1).coloured(3);
      e.variant("cut at impacts", in_substeps(1, at_impacts())).with_exactly(1).coloured(2);
      e.series_without_curves("error", [&truth](const World& world) { return truth.error(world); });
      e.number("largest error", "mm", [](const Run& run) { return run.largest("error"); });
    }

    const Motion& bounce = motion_named("bounce");
    e.scene({.name = "the same ball, until it rests",
             .fill = [&bounce](World& world) { bounce.begin(world); },
             .seconds = 5,
             .pictures = false});
    const Real rests = std::sqrt(2 / World::g) * Real(1.8) / Real(0.2);  // t (1 + e) / (1 - e)
    for (const auto& [name, solver] : {std::pair<std::string, AnySolver>{"half step", in_substeps(1)},
                                       {"cut at impacts", in_substeps(1, at_impacts())}})
      e.variant(name, solver).with_exactly(1).coloured(name == "half step" ? 1 : 2).expect("rests after", rests);
    e.series("height", "m", [](const World& world) { return world.bodies[1].position.y() - Real(0.5); });
    e.series_without_curves("speed", [](const World& world) { return world.bodies[1].velocity.norm(); });
    e.number("rests after", "s", last_moving);

    const PendulumAtWall pendulum;
    static const TruePlaces swings(pendulum.truth(2 * frames_per_second));
    e.scene({.name = "a double pendulum meets a wall, e = 0.8", .fill = pendulum, .seconds = 2, .pictures = false});
    e.variant("half step", in_substeps(1)).with_exactly(1).coloured(1);
    e.variant("half step, 8 substeps", in_substeps(8)).with_exactly(1).coloured(3);
    e.variant("cut at impacts", in_substeps(1, at_impacts())).with_exactly(1).coloured(2);
    e.variant("cut at impacts, 8 substeps", in_substeps(8, at_impacts())).with_exactly(1).coloured(4);
    e.series_without_curves("error", [](const World& world) { return swings.error(world); });
    e.number("largest error", "mm", [](const Run& run) { return run.largest("error"); });

    e.scene({.name = "five balls that touch, hit with 5 m/s", .fill = cradle, .seconds = Real(0.2), .pictures = false});
    e.variant("sequential", cut(Impacts::sequential))
        .with_exactly(1)
        .coloured(2)
        .expect("first ball", 0)
        .expect("last ball", 5);
    e.variant("simultaneous", cut(Impacts::simultaneous))
        .with_exactly(1)
        .coloured(4)
        .expect("first ball", -3)
        .expect("last ball", 2);
    e.series_without_curves("speed", [](const World& world) { return world.bodies[4].velocity.x(); });
    e.number("first ball", "m/s", [](const Run& run) { return run.world.bodies[0].velocity.x(); });
    e.number("last ball", "m/s", [](const Run& run) { return run.world.bodies[4].velocity.x(); });

    e.study([&e] {
      for (const std::string name : {"bounce", "break"}) {
        const Motion& motion = motion_named(name);
        const std::vector<Places> truth = motion.truth(motion.frames());
        Curve half{"half step", {}, {}, line_colour(1), Curve::Style::line_and_points};
        Curve with_cuts{"cut at impacts", {}, {}, line_colour(2), Curve::Style::line_and_points};
        for (const int count : {1, 2, 4, 8, 16, 32, 64}) {
          const auto add = [&](Curve& to, const AnySolver& solver) {
            to.x.push_back(static_cast<Real>(count));
            to.y.push_back(1000 * largest_error(motion, truth, solver));
          };
          add(half, in_substeps(count));
          add(with_cuts, in_substeps(count, at_impacts()));
        }
        e.panel({.title = motion.title,
                 .x_label = "substeps in 1/60 s",
                 .y_label = "largest error, mm",
                 .log_x = true,
                 .log_y = true,
                 .curves = {half, with_cuts}});
      }
    });
  });
}
