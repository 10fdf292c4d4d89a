#include <cmath>

#include "pushback/chapters/08_friction_cone/friction_cone.h"
#include "pushback/chapters/19_accuracy_and_time/exercise/transfer/asked.h"
#include "pushback/tools/classroom/checks/scenes.h"

namespace pushback::exercise_19_transfer {

namespace {

/// A box, and a moment at which one asks where it is.
struct Push {
  double speed, slope, mu, t;

  /// When it stops, s.
  double turn() const { return speed / (g * (std::sin(slope) + mu * std::cos(slope))); }
  Real asked(const Answer& answer) const { return static_cast<Real>(answer.way(speed, slope, mu, t)); }
};

/// `held`: mu as a part of what would just hold it; `turns`: the moment, as a part of when it stops.
Push push_of(Random& random, double held, double turns) {
  Push push{between(random, 2, 4), between(random, 0.5, 0.8), 0, 0};
  push.mu = held * std::tan(push.slope);
  push.t = turns * push.turn();
  return push;
}

/// How far off a simulation is, mm: a ball that cannot turn, so that it slides as a box does, on a slope along x.
Real off(const Push& push, int substeps, const Answer& answer) {
  constexpr int frames = 30;
  const Real h = Real(1) / static_cast<Real>(60 * substeps), slope = static_cast<Real>(push.slope);
  World world = on_the_ground(sphere(Real(0.5), 2).at({0, Real(0.5), 0}));
  world.gravity = -static_cast<Real>(g) * Vec3(std::sin(slope), std::cos(slope), 0);
  world.contacts[0].friction = static_cast<Real>(push.mu);
  Body& ball = world.bodies[1];
  ball.velocity.x() = static_cast<Real>(push.speed);
  ball.inverse_inertia.setZero();
  Solver<Clamping, FrictionCone> solver;
  for (int step = 0; step < frames * substeps; ++step) {
    integrate_velocity(ball, world.gravity, h);
    solver.solve(world, h, 1);
    ball.position += h * ball.velocity;
  }
  const double true_way = answer.way(push.speed, push.slope, push.mu, frames / 60.0);
  return 1000 * std::abs(ball.position.x() - static_cast<Real>(true_way));
}

double right(double speed, double slope, double mu, double t) {
  const double pull = g * std::sin(slope), rub = g * mu * std::cos(slope), up = pull + rub, turn = speed / up;
  if (t < turn) return speed * t - up * t * t / 2;
  const double top = speed * speed / (2 * up);
  return rub >= pull ? top : top - (pull - rub) * (t - turn) * (t - turn) / 2;
}

}  // namespace

std::vector<Check<Answer>> checks_of(const Answer& /*any*/) {
  return {
      {"on the way up, weight and friction slow the box", 1,
       [](Random& random, const Answer& answer) -> std::vector<Reading> {
         const double turns = between(random, 0.4, 0.9), held = between(random, 0.3, 0.7);
         return {{"on its way up the position of your box is", push_of(random, held, turns).asked(answer), "m"}};
       },
       "on the way up, weight and friction both slow the box, by g sin and μ g cos of the slope. Its position is v t - "
       "a t²/2."},
      {"if friction can hold the box, it stays", 1,
       [](Random& random, const Answer& answer) -> std::vector<Reading> {
         const double turns = between(random, 2, 3), held = between(random, 1.2, 1.6);
         const Push stays = push_of(random, held, turns);
         Push rests = stays;
         rests.speed = 0;
         return {{"long after it has stopped, the position of your box, which friction holds, is", stays.asked(answer),
                  "m"},
                 {"the position of your box that starts at rest and that friction holds is", rests.asked(answer), "m"}};
       },
       "if μ is larger than the tangent of the slope, friction balances exactly the force that pulls the box down. The "
       "box stays where it stopped."},
      {"if friction cannot hold the box, it slides back", 2,
       [](Random& random, const Answer& answer) -> std::vector<Reading> {
         const double turns = between(random, 3, 4), held = between(random, 0.3, 0.6);
         const Push back = push_of(random, held, turns);
         Push nearly = push_of(random, 1, 0), starts = push_of(random, between(random, 0.3, 0.6), 0);
         const double part = between(random, 0.3, 0.7);
         nearly.mu = part * std::sin(nearly.slope) + (1 - part) * std::tan(nearly.slope);
         nearly.t = between(random, 3, 4) * nearly.turn();
         starts.speed = 0;
         starts.t = between(random, 0.5, 1);
         return {{"after it has stopped, the position of your box, which slides back, is", back.asked(answer), "m"},
                 {"the position of your box, which slides back and which friction almost holds, is",
                  nearly.asked(answer), "m"},
                 {"the position of your box that starts at rest and that friction does not hold is",
                  starts.asked(answer), "m"}};
       },
       "if μ is smaller than the tangent of the slope, the box slides back. It starts from rest, at the place and the "
       "moment of its stop. Friction opposes this motion, so it now points up the slope."},
      {"without friction the box comes back just as it went up", 1,
       [](Random& random, const Answer& answer) -> std::vector<Reading> {
         return {{"without friction, on its way back, the position of your box is",
                  push_of(random, 0, between(random, 1.2, 1.8)).asked(answer), "m"}};
       },
       "without friction the acceleration is g sin of the slope all the time, both up and down."},
      {"a simulation with shorter steps is nearer to the truth", 1,
       [](Random& random, const Answer& answer) -> std::vector<Reading> {
         Push push = push_of(random, between(random, 0.1, 0.3), 0);
         push.speed = between(random, 1, 2);  // it has stopped after 0.3 s at most
         return {{"the distance of a simulation with 2 substeps from your truth is", off(push, 2, answer), "mm", 1e-2},
                 {"the distance of a simulation with 8 substeps from your truth is", off(push, 8, answer), "mm", 1e-2}};
       },
       "a simulation comes nearer to the truth with shorter steps. This box goes up, stops and slides back. If your "
       "truth is wrong, the simulation keeps a distance from it."},
  };
}

Exercise exercise() {
  return exercise_of(
      "a truth of one's own",
      {"The box has three motions: up, held, back. Which force acts along the slope in each, and when does each end?",
       "An exact solution needs no steps. Compute when the box stops and how far up it is at that moment. There its "
       "way back begins.",
       "To decide whether it is held, compare two forces: the one that pulls it down the slope, and the largest one "
       "that friction can give."},
      Answer{right});
}

}  // namespace pushback::exercise_19_transfer
