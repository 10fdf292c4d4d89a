#include "pushback/chapters/02_clamping/clamping.h"
#include "pushback/chapters/03_baumgarte/exercise/asked.h"
#include "pushback/tools/classroom/checks/scenes.h"

namespace pushback::exercise_03 {

namespace {

struct Capped : Effect {
  Answer answer{};
  Real beta = Real(0.2), cap = 3, asked = 0;
  void build(StepContext& step) {
    for (Row& row : step.rows) {
      row.bias = -asked;
      answer.push_out(row, beta, cap, step.dt);
    }
  }
};

/// A ball without weight, `depth` deep in the ground, or above it if that is negative. `solved`: its speed after the step, m/s.
struct Ball {
  Real depth, h, beta, cap, asked = 0, speed = 0;

  Real solved(Random& random, const Answer& answer) const {
    const Real radius = random.between(Real(0.3), Real(0.5));
    const Real mass = random.between(5, 20);
    World world = on_the_ground(sphere(radius, mass).at({0, radius - depth, 0}).moving({0, speed, 0}), -depth);
    Solver<Clamping, Capped> solver;
    static_cast<Capped&>(solver) = {{}, answer, beta, cap, asked};
    solver.solve(world, h, 1);
    return world.bodies[1].velocity.y();
  }
};

/// With β d / h = `speed`.
Ball ball_wanting(Random& random, Real speed, Real cap) {
  const Real h = 1 / random.between(50, 240), beta = random.between(Real(0.1), Real(0.3));
  return {speed * h / beta, h, beta, cap};
}

void right(Row& row, Real beta, Real cap, Real h) {
  row.bias = std::min(row.bias, std::max(-cap, beta / h * row.separation));
}

}  // namespace

std::vector<Check<Answer>> checks_of(const Answer& /*any*/) {
  return {
      {"a shallow ball leaves at β d / h, as without a cap", 1,
       [](Random& random, const Answer& answer) -> std::vector<Reading> {
         const Real cap = random.between(1, 3);
         Ball shallow = ball_wanting(random, cap * random.between(Real(0.2), Real(0.8)), cap);
         shallow.speed = -random.between(1, 3);
         // In metres it is less deep than the cap is fast in m/s.
         Ball slow = ball_wanting(random, cap * random.between(Real(0.2), Real(0.3)), cap);
         const Real longer = random.between(Real(0.2), Real(0.3));
         slow.depth *= longer / slow.h;
         slow.h = longer;
         return {{"your shallow ball leaves at", shallow.solved(random, answer), "m/s"},
                 {"in a long step your shallow ball leaves at", slow.solved(random, answer), "m/s"}};
       },
       "below the cap, the push-out removes the fraction β of the overlap in one step. Its speed is β d / h, and b is "
       "minus this speed, however fast the ball moves."},
      {"a deep ball leaves at the cap", 2,
       [](Random& random, const Answer& answer) -> std::vector<Reading> {
         const Real cap = random.between(Real(0.5), 1);
         const Ball deep = ball_wanting(random, cap * random.between(Real(1.5), 3), cap);
         Ball lost = deep;
         lost.depth = random.between(Real(1.2), 2);
         return {{"your deep ball leaves at", deep.solved(random, answer), "m/s"},
                 {"your ball, which is more than a metre deep, leaves at", lost.solved(random, answer), "m/s"}};
       },
       "a body that is too deep is pushed out at the cap. The cap is a speed, just as β d / h is."},
      {"a ball that should bounce faster than the cap does so", 2,
       [](Random& random, const Answer& answer) -> std::vector<Reading> {
         const Real cap = random.between(Real(0.5), 1);
         Ball fast = ball_wanting(random, cap * 2, cap), slow = ball_wanting(random, cap * Real(0.8), cap);
         fast.asked = cap * random.between(Real(2.5), 4);
         slow.asked = cap * random.between(Real(0.1), Real(0.6));
         return {{"your ball, which should bounce faster than the cap, leaves at", fast.solved(random, answer), "m/s"},
                 {"your ball, which should bounce more slowly than the push-out, leaves at",
                  slow.solved(random, answer), "m/s"}};
       },
       "the cap limits only the push-out. Keep the higher of the two target speeds, which is the lower b."},
      {"a ball that is still apart continues to move, and is not stopped early", 1,
       [](Random& random, const Answer& answer) -> std::vector<Reading> {
         const Real cap = random.between(Real(0.5), 1);
         Ball leaving = ball_wanting(random, -cap * 2, cap), coming = leaving;
         leaving.speed = cap * random.between(Real(0.1), Real(0.4));
         coming.speed = -cap * 5;
         return {{"your ball, which is above the ground and leaving, leaves at", leaving.solved(random, answer), "m/s"},
                 {"your ball, which is above the ground and approaching, continues at", coming.solved(random, answer),
                  "m/s"}};
       },
       "if C > 0 there is no overlap to remove, so b stays as it is."},
  };
}

Exercise exercise() {
  return exercise_of("a push-out with a cap on its speed",
                     {"The cap is the highest speed of the push-out. Should the push-out use the higher or the lower "
                      "of β d / h and the cap?",
                      "b is minus a speed, so the lower of two speeds is the higher of two negative values of b.",
                      "The cap limits only the push-out. Apply the cap first, then compare the result with the b that "
                      "is already there."},
                     Answer{right});
}

}  // namespace pushback::exercise_03
