#include "pushback/chapters/05_restitution/exercise/asked.h"
#include "pushback/tools/classroom/checks/scenes.h"

namespace pushback::exercise_05 {

namespace {

constexpr Real threshold = Real(0.1), yield = 2;  // m/s

/// What the push-out has asked for.
struct Asking : Effect {
  Real speed = 0;  // m/s
  void build(StepContext& step) {
    for (Row& row : step.rows) row.bias = -speed;
  }
};

using Bouncing = Solver<Clamping, Asking, AnyEffect>;

/// A ball that lands.
struct Ball {
  Real e, arrives;  // of slow impacts, of 0 ... 1; m/s
  Real gravity = 0, h = Real(1) / 60, slides = 0, asked = 0;

  /// Its speed upwards after the step, m/s.
  Real solved(const Answer& answer) const {
    const Vec3 centre{0, Real(0.299), 0};
    World world = on_the_ground(sphere(Real(0.3), 10).at(centre).moving({slides, -arrives, 0}).bouncy(e));
    world.gravity = {0, -gravity, 0};
    auto solver = with_effect<Bouncing>(answer.bounce);
    solver.speed = asked;
    world.step(solver, h, 1);
    return world.bodies[1].velocity.y();
  }
};

/// A ball of which gravity adds 0.15 to 0.25 m/s in a step, which is more than the threshold.
Ball heavy(Random& random, Real e, Real arrives) {
  return {e, arrives, World::g, 1 / random.between(40, 65)};
}

Real some_e(Random& random) {
  return random.between(Real(0.7), Real(0.9));
}

/// The first is too slow to bounce, the second lands slowly on a ground that is bouncier than it is. Its speed upwards, m/s.
Real second_of_two(Random& random, const Answer& answer) {
  const Real creeps = random.between(Real(0.03), Real(0.09)), lands = yield * random.between(Real(0.6), Real(0.9));
  World world = on_the_ground(sphere(Real(0.3), 10).at({0, Real(0.299), 0}).moving({0, -creeps, 0}));
  world.add(sphere(Real(0.3), 10)
                .at({1, Real(0.299), 0})
                .moving({0, -lands, 0})
                .bouncy(random.between(Real(0.3), Real(0.5))));
  world.bodies[0].bouncy(some_e(random));
  world.gravity.setZero();
  auto solver = with_effect<Bouncing>(answer.bounce);
  world.step(solver, Real(1) / 60, 1);
  return world.bodies[2].velocity.y();
}

struct Bounce : Effect {
  void build(StepContext& step) {
    for (std::size_t i = 0; i < step.contacts.size(); ++i) {
      const Real v = approach_speed(step.world, step.contacts[i]);
      if (v >= -threshold) continue;
      const Real e = step.contacts[i].restitution * std::min(Real(1), std::pow(yield / -v, Real(0.25)));
      step.rows[i].bias = std::min(step.rows[i].bias, e * v);
    }
  }
};
}  // namespace

std::vector<Check<Answer>> checks_of(const Answer& /*any*/) {
  return {
      {"a slow impact has the restitution of its contact, and gains no energy", 2,
       [](Random& random, const Answer& answer) -> std::vector<Reading> {
         const Ball slow{some_e(random), random.between(Real(0.16), Real(0.4))};
         return {{"your slow ball leaves with", slow.solved(answer), "m/s"},
                 {"your second of two balls, whose ground is bouncier than it is, leaves with",
                  second_of_two(random, answer), "m/s"}};
       },
       "up to the yield speed, e is the restitution of the contact, step.contacts[i].restitution, and never more. An "
       "impact gains no energy."},
      {"above the yield speed e falls with the fourth root of the speed", 2,
       [](Random& random, const Answer& answer) -> std::vector<Reading> {
         return {{"your fast ball leaves with", Ball{some_e(random), random.between(4, 40)}.solved(answer), "m/s"}};
       },
       "above the yield speed e = e_0 (v_y / v)^(1/4), with the whole speed v of the approach. Sixteen times the yield "
       "speed halves e."},
      {"this step's gravity is no part of the approach", 2,
       [](Random& random, const Answer& answer) -> std::vector<Reading> {
         const Ball lands = heavy(random, some_e(random), random.between(4, 8));
         const Ball creeps = heavy(random, some_e(random), random.between(Real(0.04), Real(0.09)));
         return {{"your fast ball, which gravity accelerates as it lands, leaves with", lands.solved(answer), "m/s"},
                 {"your ball, which lands more slowly than the threshold but for gravity, leaves with",
                  creeps.solved(answer), "m/s"}};
       },
       "the ball has not fallen by this step's gravity yet. The speed of approach is the one from before it, for the "
       "bounce and for the threshold."},
      {"only the motion along the normal counts", 1,
       [](Random& random, const Answer& answer) -> std::vector<Reading> {
         Ball ball{some_e(random), random.between(Real(0.5), Real(0.9))};
         ball.slides = random.between(6, 12);
         return {{"your ball, which slides fast and lands gently, leaves with", ball.solved(answer), "m/s"}};
       },
       "sliding along the ground does not press the ball into it. e depends on the speed along the normal."},
      {"of the bounce and the push-out, the one for more speed stays", 2,
       [](Random& random, const Answer& answer) -> std::vector<Reading> {
         Ball more{some_e(random), random.between(4, 8)}, less{some_e(random), random.between(4, 8)};
         more.asked = more.arrives * random.between(Real(1.2), 2);
         less.asked = less.arrives * random.between(Real(0.05), Real(0.2));
         Ball slow{some_e(random), random.between(Real(0.03), Real(0.09))};
         slow.asked = random.between(Real(0.3), Real(0.6));
         return {{"your ball, which is pushed out faster than it bounces, leaves with", more.solved(answer), "m/s"},
                 {"your ball, which bounces faster than it is pushed out, leaves with", less.solved(answer), "m/s"},
                 {"your ball, which is too slow to bounce and is pushed out, leaves with", slow.solved(answer), "m/s"}};
       },
       "bounce and push-out are each a least speed, and the lesser b satisfies both. Where nothing bounces, b stays as "
       "it was."},
      {"what arrives more slowly than the threshold stays, what arrives faster bounces", 1,
       [](Random& random, const Answer& answer) -> std::vector<Reading> {
         const Ball slow{some_e(random), random.between(Real(0.03), Real(0.09))},
             faster{some_e(random), threshold * random.between(Real(1.02), Real(1.1))};  // whose e v is below it
         return {{"your ball, which arrives more slowly than the threshold, leaves with", slow.solved(answer), "m/s"},
                 {"your ball, which arrives a little faster than the threshold, leaves with", faster.solved(answer),
                  "m/s"}};
       },
       "the threshold is for the speed of the approach, v_n. What arrives more slowly does not bounce, what arrives "
       "faster does, by the lesser of the old b and e v_n."},
  };
}

Exercise exercise() {
  return exercise_of(
      "a restitution that falls with the speed",
      {"Two laws agree at v = v_y, where e = e_0, and one is proportional to v to the power of -1/4. Which power of "
       "v_y / v is that?",
       "Below the yield speed this law gives more than e_0, above it less. Which of the two laws is right is a min or "
       "a max.",
       "The rest is chapter 05's: where v_n < -threshold, b becomes the lesser of the old b and e v_n, with your e."},
      Answer{Bounce{}});
}

}  // namespace pushback::exercise_05
