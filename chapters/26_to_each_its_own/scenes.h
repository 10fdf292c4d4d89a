/// A yard with bodies of all kinds, a chain that whips, and a solver that colours each body by the way in which it was moved.
#pragma once

#include "pushback/chapters/13_joints/ball_and_socket.h"
#include "pushback/engine/islands/island_solver.h"

namespace pushback::to_each_its_own_scenes {

/// An index of the palette: mustard, blue or brick, which also differ in lightness.
inline int colour_of(StepType how) {
  return how == StepType::flight ? 2 : how == StepType::half_steps ? 0 : 4;
}

/// After each step, colours every movable body by how it was moved.
class Painted : public ForwardingSolver {
 public:
  IslandSolver by_island;

  SolveStats stats() const override { return by_island.stats(); }
  Plan plan(Real /*dt*/) const override { return {}; }  // each island has its own plan
  void whole_step(World& world, Real dt, int sweeps) override {
    by_island.whole_step(world, dt, sweeps);
    for (Body& body : world.bodies)
      if (body.movable()) body.coloured(colour_of(by_island.step_of(body.index)));
  }

 private:
  StepSolver& inner() override { return by_island; }
  const StepSolver& inner() const override { return by_island; }
};
/// The number of movable bodies with the colour of `how`.
inline int moved_so(const World& world, StepType how) {
  return static_cast<int>(std::count_if(world.bodies.begin(), world.bodies.end(), [how](const Body& body) {
    return body.movable() && body.colour == colour_of(how);
  }));
}

/// Links of 1 kg and a ball of `ball` kg, in one line at `angle` from the vertical, pinned to each other and to the world.
struct Chain {
  Real ball = 1000, angle = Real(1.5);  // kg, rad
  int links = 10;
  Vec3 pin = Vec3::Zero();  // m
  Real length = Real(0.5), radius = Real(0.3);

  void operator()(World& world) const {
    const Vec3 down(std::sin(angle), -std::cos(angle), 0);
    int before = the_world;
    for (int i = 0; i <= links; ++i) {
      const Vec3 from = pin + static_cast<Real>(i) * length * down;
      const Body link = i < links ? box({Real(0.05), length / 2, Real(0.05)}, 1) : sphere(radius, ball);
      const Vec3 centre = from + (i < links ? length / 2 : radius) * down;
      const int body = world.add(Body(link).turned(angle, Vec3::UnitZ()).at(centre));
      world.joints.push_back(ball_and_socket(world, before, body, from));
      before = body;
    }
  }
  /// The energy that gravity can add until the chain hangs, J.
  Real fall() const {
    const Real all = static_cast<Real>(links) * length;
    return World::g * (1 - std::cos(angle)) * (ball * (all + radius) + all * static_cast<Real>(links) / 2);
  }
};

/// From left to right: a box that slides up to a stack of ten, a chain, a heavy box on a light one, a ball that bounces, and a ball
/// that hits ten others. A further box flies over them.
struct Yard {
  Real speed = 6;  // m/s, of the ball that hits the others

  void operator()(World& world) const {
    constexpr Real half = Real(0.25), ball = Real(0.25), gap = Real(0.01);
    const Vec3 cube = Vec3::Constant(half);
    world.add(ground());
    world.add(box(cube, 1).at({Real(-8.2), half, 0}).moving({Real(3.6), 0, 0}));
    for (int i = 0; i < 10; ++i) world.add(box(cube, 100).at({Real(-6.5), half + static_cast<Real>(i) / 2, 0}));
    Chain{.ball = 100, .angle = Real(1.2), .links = 5, .pin = {Real(-2.8), Real(4.4), 0}}(world);
    world.add(box(cube, 1).at({Real(0.6), half, 0}));
    world.add(box(cube, 100).at({Real(0.6), 3 * half, 0}));
    world.add(sphere(ball, 10).at({Real(2.2), Real(2.5), 0}).bouncy(Real(0.8)));
    for (int row = 0; row < 4; ++row)
      for (int i = 0; i <= row; ++i) {
        const Real apart = 2 * ball + gap, across = static_cast<Real>(i) - static_cast<Real>(row) / 2;
        world.add(sphere(ball, 10)
                      .at({5 + static_cast<Real>(row) * apart * std::sqrt(Real(3)) / 2, ball, across * apart})
                      .bouncy(Real(0.95))
                      .rough(Real(0.1)));
      }
    world.add(
        sphere(ball, 10).at({Real(3.2), ball, Real(0.03)}).moving({speed, 0, 0}).bouncy(Real(0.95)).rough(Real(0.1)));
    world.add(box({Real(0.4), Real(0.2), Real(0.3)}, 20)
                  .at({Real(-4.5), 4, 2})
                  .moving({Real(2.6), 6, 0})
                  .spinning({1, 2, 4}));
  }
};

}  // namespace pushback::to_each_its_own_scenes
