#include "pushback/tools/measure/study/every_motion.h"

#include <algorithm>

#include "pushback/chapters/24_half_step/top.h"
#include "pushback/chapters/25_moment_of_impact/scenes.h"
#include "pushback/common/basics/named.h"
#include "pushback/tools/measure/study/chaplygin.h"
#include "pushback/tools/measure/study/further_motions.h"
#include "pushback/tools/measure/study/held_motions.h"

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
          .pins = {{the_world, 0, Vec3::Zero()}},
          .most_substeps = 1024,
          .most_sweeps = 4,
          .most_passes = 2048};
}

Motion pendulum_at_wall() {
  const moment_of_impact_scenes::PendulumAtWall pendulum;
  return {.name = "pendulum-at-wall",
          .title = "a double pendulum meets a wall, e = 0.8",
          .fill = [pendulum](World& world) { pendulum.fill(world); },
          .seconds = 2,
          .truth = [pendulum](int frames) { return pendulum.truth(frames); },
          .pins = pendulum.pins(),
          .most_substeps = 1024,
          .most_sweeps = 16,
          .most_passes = 2048};
}

Motion gaps() {
  const further::Gaps balls;
  return {.name = "gaps",
          .title = "six balls in a row with gaps, e = 0.9",
          .fill = balls,
          .seconds = balls.seconds,
          .truth = [balls](int frames) { return balls.truth(frames); },
          .most_substeps = 2048,
          .most_sweeps = 4,
          .most_passes = 2048};
}

Motion superball() {
  const further::Superball ball;
  return {.name = "superball",
          .title = "a ball that spins between two plates, e = 0.9",
          .fill = ball,
          .seconds = ball.seconds,
          .truth = [ball](int frames) { return ball.truth(frames); },
          .most_substeps = 2048,
          .most_sweeps = 4,
          .most_passes = 2048};
}

Motion conveyor() {
  const further::Conveyor belt;
  return {.name = "conveyor",
          .title = "a box is put on a belt",
          .fill = belt,
          .seconds = belt.seconds,
          .truth = [belt](int frames) { return belt.truth(frames); },
          .most_substeps = 1024,
          .most_sweeps = 16,
          .most_passes = 2048};
}

Motion grasp() {
  const further::Grasp tongs;
  return {.name = "grasp",
          .title = "tongs hold a box by friction",
          .fill = tongs,
          .seconds = tongs.seconds,
          .truth = [tongs](int frames) { return further::staying(tongs, frames); },
          .pins = tongs.pins(),
          .most_substeps = 256,
          .most_sweeps = 64,
          .most_passes = 1024};
}

Motion chaplygin() {
  const further::Chaplygin ball;
  return {.name = "chaplygin",
          .title = "a ball of three moments of inertia rolls",
          .fill = ball,
          .seconds = ball.seconds,
          .truth = [ball](int frames) { return ball.truth(frames); },
          .most_substeps = 1024,
          .most_sweeps = 16,
          .most_passes = 2048};
}

Motion hulls() {
  const further::PileOfHulls pile;
  return {.name = "hulls-1015",
          .title = "a pyramid of 1,015 hulls",
          .fill = pile,
          .seconds = pile.seconds,
          .truth = [pile](int frames) { return further::staying(pile, frames); },
          .most_substeps = 8,
          .most_sweeps = 16,
          .most_passes = 16};
}

}  // namespace

const std::vector<Motion>& every_motion() {
  static const std::vector<Motion> motions = [] {
    std::vector<Motion> all = all_motions();
    all.push_back(top_on_a_pin());
    all.push_back(pendulum_at_wall());
    all.push_back(gaps());
    all.push_back(superball());
    all.push_back(conveyor());
    all.push_back(grasp());
    all.push_back(chaplygin());
    all.push_back(hulls());
    return all;
  }();
  return motions;
}

const Motion& any_motion_named(const std::string& name) {
  return named("motion", every_motion(), name);
}

bool has_contacts(const Motion& motion) {
  World world;
  motion.fill(world);
  const auto stands = [](const Body& body) { return !body.movable(); };
  return motion.pins.empty() || std::any_of(world.bodies.begin(), world.bodies.end(), stands);
}

int moving_bodies(const Motion& motion) {
  World world;
  motion.fill(world);
  return static_cast<int>(
      std::count_if(world.bodies.begin(), world.bodies.end(), [](const Body& body) { return body.movable(); }));
}

bool has_conveyor(const Motion& motion) {
  World world;
  motion.fill(world);
  return std::any_of(world.bodies.begin(), world.bodies.end(), [](const Body& body) { return body.conveys; });
}

}  // namespace pushback
