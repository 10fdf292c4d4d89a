#include "pushback/tools/study/further_motions.h"

#include "pushback/chapters/24_half_step/top.h"
#include "pushback/chapters/25_moment_of_impact/scenes.h"

namespace pushback {

namespace {

Motion top_on_a_pin() {
  const half_step_scenes::Top top;
  return {.name = "top",
          .title = "a top on a pin",
          .fill =
              [top](World& world) {
                top(world);
                world.joints.clear();  // it is a pin of the motion
              },
          .seconds = 2,
          .truth =
              [top](int frames) {
                std::vector<Places> found;
                for (int frame = 1; frame <= frames; ++frame)
                  found.push_back({(half_step_scenes::Top::stem *
                                    top.axis(static_cast<Real>(frame) / static_cast<Real>(frames_per_second)))
                                       .cast<double>()});
                return found;
              },
          .pins = {{the_world, 0, Vec3::Zero()}}};
}

Motion pendulum_at_wall() {
  const moment_of_impact_scenes::PendulumAtWall pendulum;
  return {.name = "pendulum-at-wall",
          .title = "a double pendulum meets a wall, e = 0.8",
          .fill = [pendulum](World& world) { pendulum.fill(world); },
          .seconds = 2,
          .truth = [pendulum](int frames) { return pendulum.truth(frames); },
          .pins = pendulum.pins()};
}

}  // namespace

std::vector<Motion> further_motions() {
  return {top_on_a_pin(), pendulum_at_wall()};
}

}  // namespace pushback
