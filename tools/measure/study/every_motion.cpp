#include "pushback/tools/measure/study/every_motion.h"

#include <algorithm>

#include "pushback/chapters/24_half_step/top.h"
#include "pushback/chapters/25_moment_of_impact/scenes.h"
#include "pushback/common/basics/named.h"
#include "pushback/tools/measure/study/further_motions.h"

namespace pushback {

namespace {

struct TopOnPin : half_step_scenes::Top {
  static constexpr double seconds = 2;
  void operator()(World& world) const {
    Top::operator()(world);
    world.joints.clear();  // it is a pin of the motion
  }
  std::vector<Pin> pins() const { return {{the_world, 0, Vec3::Zero()}}; }
  std::vector<Places> truth(int frames) const {
    std::vector<Places> found;
    for (int frame = 1; frame <= frames; ++frame)
      found.push_back({(stem * axis(static_cast<Real>(frame) / static_cast<Real>(frames_per_second))).cast<double>()});
    return found;
  }
};

struct WithoutJoints : moment_of_impact_scenes::PendulumAtWall {  // they are pins of the motion
  static constexpr double seconds = 2;
  void operator()(World& world) const { fill(world); }
};

/// How far the study tries to go: substeps, sweeps, and their product.
struct Tried {
  int most_substeps, most_sweeps, most_passes;
};

template <class Scene>
Motion motion_of(const std::string& name, const std::string& title, const Scene& scene, const Tried& tried) {
  Motion motion{.name = name,
                .title = title,
                .fill = scene,
                .seconds = Scene::seconds,
                .truth = [scene](int frames) { return scene.truth(frames); },
                .most_substeps = tried.most_substeps,
                .most_sweeps = tried.most_sweeps,
                .most_passes = tried.most_passes};
  if constexpr (requires { scene.pins(); }) motion.pins = scene.pins();
  return motion;
}

World filled(const Motion& motion) {
  World world;
  motion.fill(world);
  return world;
}

template <class Is>
bool any_body(const Motion& motion, const Is& is) {
  const World world = filled(motion);
  return std::any_of(world.bodies.begin(), world.bodies.end(), is);
}

}  // namespace

const std::vector<Motion>& every_motion() {
  using namespace further;
  static const std::vector<Motion> motions = [] {
    std::vector<Motion> all = all_motions();
    all.push_back(motion_of("top", "a top on a pin", TopOnPin{}, {1024, 4, 2048}));
    all.push_back(
        motion_of("pendulum-at-wall", "a double pendulum meets a wall, e = 0.8", WithoutJoints{}, {1024, 16, 2048}));
    all.push_back(motion_of("gaps", "six balls in a row with gaps, e = 0.9", Gaps{}, {2048, 4, 2048}));
    all.push_back(
        motion_of("superball", "a ball that spins between two plates, e = 0.9", Superball{}, {2048, 4, 2048}));
    all.push_back(motion_of("conveyor", "a box is put on a belt", Conveyor{}, {1024, 16, 2048}));
    all.push_back(motion_of("grasp", "tongs hold a box by friction", Grasp{}, {256, 64, 1024}));
    all.push_back(motion_of("chaplygin", "a ball of three moments of inertia rolls", Chaplygin{}, {1024, 16, 2048}));
    all.push_back(motion_of("hulls-1015", "a pyramid of 1,015 hulls", PileOfHulls{}, {8, 16, 16}));
    return all;
  }();
  return motions;
}

const Motion& any_motion_named(const std::string& name) {
  return named("motion", every_motion(), name);
}

bool has_contacts(const Motion& motion) {
  return motion.pins.empty() || any_body(motion, [](const Body& body) { return !body.movable(); });
}

bool has_bounces(const Motion& motion) {
  return any_body(motion, [](const Body& body) { return body.restitution > 0; });
}

bool has_conveyor(const Motion& motion) {
  return any_body(motion, [](const Body& body) { return body.conveys; });
}

int moving_bodies(const Motion& motion) {
  const World world = filled(motion);
  return static_cast<int>(
      std::count_if(world.bodies.begin(), world.bodies.end(), [](const Body& body) { return body.movable(); }));
}

}  // namespace pushback
