#include "pushback/chapters/00_naive_impulses/naive.h"
#include "pushback/chapters/01_velocity_constraint/scenes.h"
#include "pushback/chapters/01_velocity_constraint/solver.h"
#include "pushback/common/experiment/experiment.h"

using namespace pushback;
using namespace pushback::velocity_constraint_scenes;

namespace {

/// For comparison: as if nothing ever touched.
struct NoSolver : StepSolver {
  void solve(World&, Real, int) {}
};

/// Normals from a left-handed model, taken over without a thought: x has the wrong sign.
struct MirroredNormals : Effect {
  void touch(Step& step) {
    for (std::size_t i = 0; i < step.contacts.size(); ++i) {
      Contact mirrored = step.contacts[i];
      mirrored.normal.x() = -mirrored.normal.x();
      step.rows[i] = Row(step.world, mirrored, mirrored.normal, i);
      push_apart(step.world, mirrored);
    }
  }
};

/// The same without the mistake.
struct RightNormals : Effect {
  void touch(Step& step) {
    for (const Contact& contact : step.contacts) push_apart(step.world, contact);
  }
};

/// Of a body that starts at rest and gains 1 m/s in each of n steps of 1 s, m.
Real way_of_one(Real n) {
  return n * (n + 1) / 2;
}

Real height(const World& world) {
  return world.bodies.back().position.y();
}
/// Of the box below the top of the slab, y = 0, mm. A box that fell through the slab has no contact left to measure.
Real depth_of_lowest_corner(const World& world) {
  const Body& body = world.bodies.back();
  const Vec3 upwards = body.orientation.conjugate() * Vec3::UnitY();
  return 1000 * (upwards.cwiseAbs().sum() * Real(0.5) - body.position.y());
}
Real largest_error(const Run& run) {
  Real largest = 0;
  for (const Sample& sample : run.samples) largest = std::max(largest, sample.residual);
  return largest;
}

}  // namespace

int main(int argc, char** argv) {
  Experiment e("01_velocity_constraint", "What does J V = 0 do, all by itself?");
  DroppedBox dropped;
  e.parameter({"--drop", "", "m", "How far above the slab the box is let go", 0.1, 2}, &dropped.drop);
  LeavingBox leaving;
  e.parameter({"--speed", "v", "m/s", "Speed of the box that is thrown upwards", 0.5, 7}, &leaving.speed);
  CubeOnSlope cube;
  e.parameter({"--slope", "θ", "rad", "Angle of the slope", 0, 0.6}, &cube.angle);
  return e.run(argc, argv, [&] {
    const Camera camera{{Real(0.9), Real(1.3), Real(5)}, {0, Real(0.95), 0}};
    e.scene({.name = "It stops the fall, and keeps the overlap",
             .fill = dropped,
             .camera = camera,
             .seconds = 1,
             .instants = {0, Real(0.3), Real(0.5), 1}});
    e.variant("no constraint", NoSolver{});
    e.variant("J V = 0", Solver<>{}).expect("J V after the solve", 0);
    e.series("height of the box", "m", height);
    e.number("lowest corner below the slab's top", "mm",
             [](const Run& run) { return depth_of_lowest_corner(run.world); });
    e.number("J V after the solve", "m/s", largest_error);

    e.scene({.name = "It pulls: a box thrown upwards", .fill = leaving, .camera = camera, .seconds = Real(0.8)});
    e.variant("no constraint", NoSolver{}).expect("highest point", leaving.highest_point(e.dt()));
    e.variant("J V = 0", Solver<>{});
    e.series("height of the box", "m", height);
    e.number("highest point", "m", [](const Run& run) {
      const auto& heights = run.series.at("height of the box");
      return *std::max_element(heights.begin(), heights.end());
    });

    e.scene({.name = "A reader's cube slides up the slope",
             .fill = cube,
             .camera = {{0, 2, 11}, {0, Real(0.15), 0}},
             .seconds = Real(1.4)});
    e.variant("n as it is", Solver<RightNormals>{})
        .expect("way up the slope",
                -World::g * std::sin(cube.angle) * way_of_one(std::round(Real(1.4) / e.dt())) * e.dt() * e.dt())
        .reference("-g sin θ t²/2", [cube](Real t) { return -World::g * std::sin(cube.angle) * t * t / 2; });
    e.variant("n with x mirrored", Solver<MirroredNormals>{});
    e.series("way up the slope", "m", [cube](const World& world) { return cube.way_up(world); });
    e.number("way up the slope", "m", [](const Run& run) { return run.series.at("way up the slope").back(); });
  });
}
