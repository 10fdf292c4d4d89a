#include "pushback/chapters/00_naive_impulses/naive.h"
#include "pushback/chapters/01_velocity_constraint/scenes.h"
#include "pushback/chapters/01_velocity_constraint/solver.h"
#include "pushback/common/experiment/experiment.h"
#include "pushback/common/experiment/marks.h"
#include "pushback/common/experiment/row_by_row.h"

using namespace pushback;
using namespace pushback::velocity_constraint_scenes;

namespace {

/// For comparison: as if nothing ever touched.
struct NoSolver : StepSolver {
  void solve(World&, Real, int) override {}
};

/// Normals from a left-handed model, taken over without a thought: x has the wrong sign.
struct MirroredNormals : Effect {
  void adjust_separation(StepContext& step) {
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
  void adjust_separation(StepContext& step) {
    for (const Contact& contact : step.contacts) push_apart(step.world, contact);
  }
};

/// Of a body that starts at rest and gains 1 m/s in each of n steps of 1 s, m.
Real way_of_one(Real n) {
  return n * (n + 1) / 2;
}

/// Of the box that is dropped, and of the one that is thrown upwards, m.
Real dropped_height(const World& world) {
  return world.bodies[2].position.y();
}
Real thrown_height(const World& world) {
  return world.bodies[3].position.y();
}
/// Of the dropped box below the top of the slab, y = 0, mm. A box that fell through the slab has no contact left to measure.
Real depth_of_lowest_corner(const World& world) {
  const Body& body = world.bodies[2];
  const Vec3 upwards = body.orientation.conjugate() * Vec3::UnitY();
  return 1000 * (upwards.cwiseAbs().sum() * Real(0.5) - body.position.y());
}
/// Between the instants at which the cube on the slope is shown, s.
constexpr Real every = Real(0.7);

/// Where the cube should be at each of them.
void add_slid(Picture& picture, const CubeOnSlope& cube, Real until, Real dt) {
  World world;
  cube(world);
  const Body start = world.bodies.back();
  const Vec3 down = -World::g * std::sin(cube.angle) * Vec3(std::cos(cube.angle), std::sin(cube.angle), 0);
  for (Real t = 0; t < until + dt / 2; t += every)
    add_outline(picture, Body(start).at(start.position + way_of_one(std::round(t / dt)) * dt * dt * down));
}

Real largest_error(const Run& run) {
  Real largest = 0;
  for (const Sample& sample : run.samples) largest = std::max(largest, sample.residual);
  return largest;
}

}  // namespace

int main(int argc, char** argv) {
  Experiment e("01_velocity_constraint", "What does the velocity constraint J V = 0 do on its own?");
  DroppedBox dropped;
  e.parameter({"--drop", "", "m", "Drop height above the slab", 0.1, 2}, &dropped.drop);
  LeavingBox leaving;
  e.parameter({"--speed", "v", "m/s", "Speed of the box thrown upwards", 0.5, 7}, &leaving.speed);
  CubeOnSlope cube;
  e.parameter({"--slope", "θ", "rad", "Angle of the slope", 0, 0.6}, &cube.angle);
  return e.run(argc, argv, [&] {
    const DroppedAndUnderPlate apart{dropped};
    e.scene({.name = "It pushes a falling box, and it pulls one that should fall",
             .fill = apart,
             .camera = {{Real(0.7), Real(1.85), 15}, {0, Real(1.72), 0}, Real(0.275)},
             .seconds = Real(0.6),
             .instants = {Real(0.6)},
             .arrow = Real(0.13),
             .key = "pull",
             .caption = "Outlines: where the boxes should be. The slab pushes the yellow box, as it should. The plate "
                        "pulls the red one, which nothing ties to it.",
             .marks =
                 [=, h = e.dt()](Picture& picture, const World&, Real time) {
                   if (time == 0) return;
                   const Body outline = box(Vec3::Constant(Real(0.5)), 1);
                   add_outline(picture, Body(outline).at({-apart.aside, Real(0.5), 0}), near_black_colour(), Real(1.8));
                   add_outline(picture, Body(outline).at({apart.aside, apart.height - apart.fallen(time, h), 0}),
                               near_black_colour(), Real(1.8));
                 },
             .cell_height = 460,
             .guess = Guess{{0, 1}, true}});
    for (Variant* variant : {&e.variant("no constraint", NoSolver{}), &e.variant("J V = 0", Solver<>{})})
      variant->expect("red box falls", apart.fallen(Real(0.6), e.dt())).expect("yellow box sinks", 0);
    e.series_without_curves(
        "fallen", [](const World& world) { return DroppedAndUnderPlate::height - world.bodies.back().position.y(); });
    e.number("red box falls", "m", [](const Run& run) { return run.series.at("fallen").back(); });
    e.number("yellow box sinks", "mm", [](const Run& run) { return depth_of_lowest_corner(run.world); });

    e.scene({.name = "It stops a fall, and holds what leaves",
             .fill = DroppedAndThrown{dropped, leaving},
             .seconds = 1,
             .pictures = false});
    for (Variant* variant : {&e.variant("no constraint", NoSolver{}), &e.variant("J V = 0", Solver<>{})})
      variant->expect("dropped: below the slab's top", 0)
          .expect("thrown: highest point", leaving.highest_point(e.dt()))
          .expect("J V after the solve", 0);
    e.series("height of the dropped box", "m", dropped_height);
    e.series("height of the thrown box", "m", thrown_height);
    e.number("dropped: below the slab's top", "mm", [](const Run& run) { return depth_of_lowest_corner(run.world); });
    e.number("thrown: highest point", "m", [](const Run& run) {
      const auto& heights = run.series.at("height of the thrown box");
      return *std::max_element(heights.begin(), heights.end());
    });
    e.number("J V after the solve", "m/s", largest_error);

    e.scene({.name = "A reader's cube slides up the slope",
             .fill = cube,
             .camera = {{Real(0.3), Real(1.9), 30}, {Real(0.3), Real(0.5), 0}, Real(0.147)},
             .seconds = Real(1.4),
             .contacts = Drawn::nothing,
             .key = "slope",
             .caption = "One cube at three instants; it starts in the middle. Outlines: where gravity takes it. With "
                        "one sign wrong in the normal, it slides up the slope.",
             .marks = [=, h = e.dt()](Picture& picture, const World&, Real time) { add_slid(picture, cube, time, h); },
             .strobe = Strobe{.every = every, .shift_per_second = Vec3::Zero(), .height = 440}});
    const Real slid = -World::g * std::sin(cube.angle) * way_of_one(std::round(Real(1.4) / e.dt())) * e.dt() * e.dt();
    e.variant("n as it is", Solver<RightNormals>{})
        .expect("way up the slope", slid)
        .reference("-g sin θ t²/2", [cube](Real t) { return -World::g * std::sin(cube.angle) * t * t / 2; });
    e.variant("n with x mirrored", Solver<MirroredNormals>{}).expect("way up the slope", slid);
    e.series("way up the slope", "m", [cube](const World& world) { return cube.way_up(world); });
    e.number("way up the slope", "m", [](const Run& run) { return run.series.at("way up the slope").back(); });

    e.rows("J V = 0", [h = e.dt()] {
      return row_by_row(on_two_corners(3, Vec3::Constant(Real(0.5)), 1, {0, -1, 0}), Solver<>{}, h, 8);
    });
  });
}
