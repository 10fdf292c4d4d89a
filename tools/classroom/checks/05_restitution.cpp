#include "pushback/chapters/05_restitution/exercise/asked.h"
#include "pushback/tools/classroom/checks/scenes.h"

namespace pushback::exercise_05 {

namespace {

constexpr Real threshold = Real(0.1), yield = 2;  // m/s

/// A push-out that has set a target speed.
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
         return {{"your slow ball leaves at", slow.solved(answer), "m/s"},
                 {"the second of your two balls, whose ground is bouncier than it is, leaves at",
                  second_of_two(random, answer), "m/s"}};
       },
       "up to the yield speed, e is at most the restitution of the contact, step.contacts[i].restitution. An impact "
       "gains no energy."},
      {"above the yield speed e falls with the fourth root of the speed", 2,
       [](Random& random, const Answer& answer) -> std::vector<Reading> {
         return {{"your fast ball leaves at", Ball{some_e(random), random.between(4, 40)}.solved(answer), "m/s"}};
       },
       "above the yield speed e = e_0 (v_y / v)^(1/4), where v is the whole approach speed. At sixteen times the yield "
       "speed, e is half as large."},
      {"this step's gravity does not count towards the approach speed", 2,
       [](Random& random, const Answer& answer) -> std::vector<Reading> {
         const Ball lands = heavy(random, some_e(random), random.between(4, 8));
         const Ball creeps = heavy(random, some_e(random), random.between(Real(0.04), Real(0.09)));
         return {{"your fast ball, which gravity accelerates while it lands, leaves at", lands.solved(answer), "m/s"},
                 {"your ball, which arrives below the threshold without this step's gravity, leaves at",
                  creeps.solved(answer), "m/s"}};
       },
       "this step's gravity has not moved the ball yet. The approach speed is the speed before this step's gravity, "
       "both for the bounce and for the threshold."},
      {"only the motion along the normal counts", 1,
       [](Random& random, const Answer& answer) -> std::vector<Reading> {
         Ball ball{some_e(random), random.between(Real(0.5), Real(0.9))};
         ball.slides = random.between(6, 12);
         return {{"your ball, which slides fast and lands gently, leaves at", ball.solved(answer), "m/s"}};
       },
       "sliding along the ground does not press the ball into it. e depends only on the speed along the normal."},
      {"the faster of bounce and push-out is kept", 2,
       [](Random& random, const Answer& answer) -> std::vector<Reading> {
         Ball more{some_e(random), random.between(4, 8)}, less{some_e(random), random.between(4, 8)};
         more.asked = more.arrives * random.between(Real(1.2), 2);
         less.asked = less.arrives * random.between(Real(0.05), Real(0.2));
         Ball slow{some_e(random), random.between(Real(0.03), Real(0.09))};
         slow.asked = random.between(Real(0.3), Real(0.6));
         return {{"your ball, whose push-out is faster than its bounce, leaves at", more.solved(answer), "m/s"},
                 {"your ball, whose bounce is faster than its push-out, leaves at", less.solved(answer), "m/s"},
                 {"your ball, which is too slow to bounce and is pushed out, leaves at", slow.solved(answer), "m/s"}};
       },
       "bounce and push-out are both minimum speeds, and the lower b satisfies both. If there is no bounce, b stays as "
       "it was."},
      {"a ball bounces only if it arrives faster than the threshold", 1,
       [](Random& random, const Answer& answer) -> std::vector<Reading> {
         const Ball slow{some_e(random), random.between(Real(0.03), Real(0.09))},
             faster{some_e(random), threshold * random.between(Real(1.02), Real(1.1))};  // whose e v is below it
         return {
             {"your ball, which arrives more slowly than the threshold, leaves at", slow.solved(answer), "m/s"},
             {"your ball, which arrives a little faster than the threshold, leaves at", faster.solved(answer), "m/s"}};
       },
       "compare the threshold with the approach speed v_n. A slower body does not bounce. For a faster one, b is the "
       "lower of the old b and e v_n."},
  };
}

Exercise exercise() {
  return exercise_of(
      "a restitution that falls with the speed",
      {"Two laws agree at v = v_y, where e = e_0. One is proportional to v to the power -1/4. To which power does it "
       "contain v_y / v?",
       "Below the yield speed this law gives more than e_0, and above it less. A min or a max selects the right law.",
       "The rest is as in chapter 05. If v_n < -threshold, b becomes the lower of the old b and e v_n, with your e."},
      Answer{Bounce{}});
}

}  // namespace pushback::exercise_05
