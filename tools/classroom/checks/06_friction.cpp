#include "pushback/chapters/02_clamping/clamping.h"
#include "pushback/chapters/06_friction/exercise/asked.h"
#include "pushback/tools/classroom/checks/scenes.h"

namespace pushback::exercise_06 {

namespace {

struct Rubbing : Effect {
  Answer answer{};
  Surfaces surfaces{};
  void build(StepContext& step) {
    for (std::size_t i = 0; i < step.contacts.size(); ++i) {
      const auto [a, b] = step.world.bodies_of(step.contacts[i]);
      const auto [tangent1, tangent2] = tangents_of(step.contacts[i].normal);
      for (const Vec3& tangent : {tangent1, tangent2}) {
        step.rows.emplace_back(step.world, step.contacts[i], tangent, i);
        step.rows.emplace_back(a, b, Jacobian::about(tangent), i);
      }
    }
  }
  void sweep(StepContext& step) {
    for (std::size_t k = step.contacts.size(); k < step.rows.size(); k += 2)
      answer.rub(step.rows[step.rows[k].owner], step.rows[k], step.rows[k + 1], surfaces);
  }
};

/// A ball on a floor that may be a belt.
struct Ball {
  Real radius, mass;
  Vec3 velocity, spin = Vec3::Zero();
  int sweeps = 4;  ///< it is exact after one, unless it slips and turns at once

  /// It lands with this speed, m/s.
  Ball(Random& random, Real lands)
      : radius(random.between(Real(0.2), Real(0.5))), mass(random.between(5, 20)), velocity(0, -lands, 0) {}

  /// After the step. `floor_first`: whether the floor is A.
  Body solved(const Surfaces& surfaces, const Answer& answer, bool floor_first = true) const {
    World world = on_the_ground(sphere(radius, mass).at({0, radius, 0}).moving(velocity).spinning(spin));
    if (!floor_first) {
      std::swap(world.bodies[0], world.bodies[1]);
      world.contacts[0].normal *= -1;
    }
    Solver<Clamping, Rubbing> solver;
    static_cast<Rubbing&>(solver) = {{}, answer, surfaces};
    solver.solve(world, Real(1) / 60, sweeps);
    return world.bodies[floor_first ? 1 : 0];
  }
};

Vec3 random_belt(Random& random) {
  const Real along = random.between(1, 2), across = random.between(Real(0.4), Real(0.8));
  return {along, 0, across};
}
Real rough(Random& random) {
  return random.between(Real(0.5), Real(0.8));
}

void hold(Row& row, Real speed, Real bound) {
  row.lo = -bound;
  row.hi = bound;
  row.reach(row.impulse - row.effective_mass * speed);
}

void right(const Row& normal, Row& slip, Row& roll, const Surfaces& surfaces) {
  hold(slip, slip.speed() + (surfaces.belt_b - surfaces.belt_a).dot(slip.n), surfaces.mu * normal.impulse);
  hold(roll, roll.speed(), surfaces.lever * normal.impulse);
}

}  // namespace

std::vector<Check<Answer>> checks_of(const Answer& /*any*/) {
  return {
      {"a ball placed on a belt is carried along, and rolls on it", 1,
       [](Random& random, const Answer& answer) -> std::vector<Reading> {
         const Ball ball(random, random.between(6, 8));
         const Surfaces surfaces{.mu = rough(random), .lever = 0, .belt_a = random_belt(random)};
         const Vec3 after = ball.solved(surfaces, answer).velocity;
         return {{"along x your ball on a belt starts to move at", after.x(), "m/s"},
                 {"along z your ball on a belt starts to move at", after.z(), "m/s"}};
       },
       "friction stops the slip of the surfaces. This is the slip of the bodies plus the relative speed of the belts "
       "along the row's own t."},
      {"a ball is carried along, whichever of the two bodies is the conveyor", 1,
       [](Random& random, const Answer& answer) -> std::vector<Reading> {
         const Ball ball(random, random.between(6, 8));
         const Surfaces surfaces{.mu = rough(random), .lever = 0, .belt_b = random_belt(random)};
         return {{"along x your ball, whose belt is body B, starts to move at",
                  ball.solved(surfaces, answer, false).velocity.x(), "m/s"}};
       },
       "the index decides which body is A. The surface of A moves at v_A + belt_a and the surface of B at v_B + "
       "belt_b. The slip is the second minus the first."},
      {"a belt that is too fast slips under the ball, which gains μ Σλn / m", 2,
       [](Random& random, const Answer& answer) -> std::vector<Reading> {
         const Ball slow(random, random.between(1, 2));
         Ball fast = slow;
         fast.velocity.x() = random.between(100, 120);
         const Surfaces surfaces{.mu = rough(random), .lever = 0, .belt_a = random.between(40, 50) * Vec3::UnitX()};
         return {{"your ball, which the belt leaves behind, gains", slow.solved(surfaces, answer).velocity.x(), "m/s"},
                 {"your ball, which moves faster than its belt, is slowed by",
                  fast.velocity.x() - fast.solved(surfaces, answer).velocity.x(), "m/s"}};
       },
       "friction gives at most μ Σλn, in either direction. This bounds the accumulated impulse, not each correction."},
      {"without friction, rolling resistance slows the spin by ϱ Σλn / I, and stops a slower spin", 1,
       [](Random& random, const Answer& answer) -> std::vector<Reading> {
         const Real lands = random.between(1, 2), lever = random.between(Real(0.01), Real(0.02));
         Ball fast(random, lands);
         const Real most = lever * lands / (Real(0.4) * fast.radius * fast.radius);  // rad/s
         Ball slow = fast;
         fast.spin.x() = random.between(6, 9) * most;
         slow.spin.x() = random.between(Real(0.4), Real(0.7)) * most;
         const Surfaces smooth{.mu = 0, .lever = lever, .belt_a = random_belt(random)};  // it slips away under the ball
         const auto turns = [&](const Ball& ball) { return ball.solved(smooth, answer).angular_velocity.x(); };
         return {{"on a smooth floor your ball, which spins fast, is slowed by", fast.spin.x() - turns(fast), "rad/s"},
                 {"on a smooth floor your ball, which spins slowly, continues to spin at", turns(slow), "rad/s"}};
       },
       "rolling resistance opposes the spin with at most ϱ Σλn in either direction, whatever friction and the belt "
       "do."},
      {"rolling resistance slows a rolling ball, which keeps rolling", 2,
       [](Random& random, const Answer& answer) -> std::vector<Reading> {
         Ball ball(random, random.between(1, 2));
         const Real speed = random.between(3, 6);
         ball.velocity.x() = speed;
         ball.spin.z() = -speed / ball.radius;
         ball.sweeps = 200;
         const Body after = ball.solved({rough(random), random.between(Real(0.01), Real(0.02))}, answer);
         return {{"your ball, which rolls, is slowed by", speed - after.velocity.x(), "m/s"},
                 {"your ball, which rolls, then spins at", after.angular_velocity.z(), "rad/s"}};
       },
       "rolling resistance slows the spin with ϱ Σλn. Friction, which prevents slip, slows the ball's motion along "
       "with it."},
      {"a belt carries a ball that cannot roll like a box", 1,
       [](Random& random, const Answer& answer) -> std::vector<Reading> {
         Ball ball(random, random.between(5, 6));
         ball.sweeps = 200;
         const Surfaces surfaces{Real(0.5), Real(1.2) * ball.radius, random_belt(random)};
         const Body after = ball.solved(surfaces, answer);
         return {{"your ball, which the belt cannot roll, starts to move at", after.velocity.norm(), "m/s"},
                 {"your ball, which the belt cannot roll, spins at", after.angular_velocity.norm(), "rad/s"}};
       },
       "if ϱ Σλn is enough to stop the spin, friction brings the ball to the speed of the belt."},
  };
}

Exercise exercise() {
  return exercise_of(
      "a conveyor belt, and rolling resistance",
      {"How fast does the surface of A move at the contact point, if A moves with v_A and its belt runs over it?",
       "The slip of the surfaces is slip.speed() plus the belt speed of B minus the belt speed of A, along t = slip.n. "
       "Friction makes it 0, within its bound.",
       "Rolling resistance makes roll.speed() 0, within its own bound of ± surfaces.lever times normal.impulse."},
      Answer{right});
}

}  // namespace pushback::exercise_06
