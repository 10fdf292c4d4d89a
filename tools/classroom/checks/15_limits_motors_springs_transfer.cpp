#include "pushback/chapters/13_joints/distance.h"
#include "pushback/chapters/15_limits_motors_springs/exercise/transfer/asked.h"

namespace pushback::exercise_15_transfer {

namespace {

constexpr Real strength = 100;  // N

struct Held : AnyEffect, SupportsJoints {};

/// Balls without weight, each on a rod of its own from the immovable world.
struct Rods {
  World world;
  Solver<Held> solver;
  std::vector<Vec3> away;  // from the origin, where all rods begin

  explicit Rods(const Answer& answer) : solver(with_effect<Solver<Held>>(answer.joints)) { world.gravity.setZero(); }
  /// `speed`: m/s, by which it would leave; negative: by which it would come.
  void add(Real mass, Real speed, Random& random) {
    away.push_back(random.direction());
    const int ball = world.add(sphere(Real(0.1), mass).at(away.back()).moving(speed * away.back()));
    world.joints.push_back(distance(world, the_world, Vec3::Zero(), ball, away.back()));
  }
  void solve(Real h) { solver.solve(world, h, 4); }
  Real speed(std::size_t ball) const { return world.bodies[ball].velocity.dot(away[ball]); }
  /// All that is still on a rod, kg.
  Real held() const {
    Real sum = 0;
    for (const Joint& joint : world.joints) sum += 1 / world.body(joint.b).inverse_mass;
    return sum;
  }
};

/// A ball that is too fast for its rod by `times`, in units of what the rod takes off in a step: its speeds after one and after
/// two steps.
std::array<Real, 2> two_steps(Random& random, Real times, const Answer& answer) {
  const Real mass = random.between(2, 10), h = 1 / random.between(40, 100);
  Rods rods(answer);
  rods.add(mass, times * h * strength / mass, random);
  std::array<Real, 2> speeds{};
  for (Real& speed : speeds) {
    rods.solve(h);
    speed = rods.speed(0);
  }
  return speeds;
}

struct Breaking : Joints {
  void build(StepContext& step) {
    Joints::build(step);
    for (JointRow& row : joint_rows_) {
      row.lo = -step.dt * strength;
      row.hi = step.dt * strength;
    }
  }
  void report(StepContext& step) {
    std::vector<Joint>& joints = step.world.joints;
    for (auto row = joint_rows_.rbegin(); row != joint_rows_.rend(); ++row)
      if (std::abs(row->impulse) >= step.dt * strength)
        joints.erase(joints.begin() + static_cast<std::ptrdiff_t>(row->owner));
  }
};
}  // namespace

std::vector<Check<Answer>> checks_of(const Answer& /*any*/) {
  return {
      {"a rod holds a load if it is strong enough", 1,
       [](Random& random, const Answer& answer) -> std::vector<Reading> {
         const Real mass = random.between(2, 10), h = 1 / random.between(40, 100);
         Rods rods(answer);
         rods.add(mass, random.between(Real(0.3), Real(0.9)) * h * strength / mass, random);
         rods.solve(h);
         return {{"your ball, whose rod is strong enough, continues at", rods.speed(0), "m/s"},
                 {"the number of your unbroken rods is", rods.held(), "kg"}};
       },
       "a rod that needs less than the impulse h F in a step holds its ball and does not break."},
      {"a rod that is pulled too hard slows its load by the impulse h F, and breaks", 2,
       [](Random& random, const Answer& answer) -> std::vector<Reading> {
         const auto [first, second] = two_steps(random, random.between(Real(2.5), 4), answer);
         const auto far_too_fast = two_steps(random, random.between(150, 200), answer);
         return {{"your ball, which pulls its rod too hard, continues at", first, "m/s"},
                 {"in the next step your ball, whose rod is broken, continues at", second, "m/s"},
                 {"your ball, which is far too fast for its rod, continues at", far_too_fast[0], "m/s"}};
       },
       "a rod cannot give more than the impulse h F in a step. If its accumulated impulse reaches this limit, the rod "
       "breaks and is gone from the next step on."},
      {"a rod that is pushed too hard also breaks", 2,
       [](Random& random, const Answer& answer) -> std::vector<Reading> {
         const auto [first, second] = two_steps(random, -random.between(Real(2.5), 4), answer);
         return {{"your ball, which pushes its rod too hard, continues at", -first, "m/s"},
                 {"in the next step your ball, whose rod is broken, continues at", -second, "m/s"}};
       },
       "a rod is pushed as well as pulled. Its accumulated impulse is between -h F and h F, and it breaks at either "
       "limit."},
      {"of several rods, only the overloaded ones break", 3,
       [](Random& random, const Answer& answer) -> std::vector<Reading> {
         const Real h = 1 / random.between(40, 100);
         Rods rods(answer);
         Real mass = 2;
         for (const Real times : {Real(0), Real(2), Real(3), Real(0.2), Real(0.7), Real(0.1)}) {
           mass += random.between(1, 2);
           rods.add(mass, times * h * strength / mass, random);
         }
         rods.world.bodies[0].asleep = true;
         rods.solve(h);
         const Real held = rods.held();
         Body& next = rods.world.bodies[3];
         next.velocity = Real(0.7) * h * strength * next.inverse_mass * rods.away[3];
         rods.solve(h / 2);
         return {{"with two of six balls too fast and one asleep, the number of your unbroken rods is", held, "kg"},
                 {"after a step of half the length, in which one more ball is too fast, the number of your unbroken "
                  "rods is",
                  rods.held(), "kg"}};
       },
       "each rod can carry F, with the h of this step. Remove the joints whose own row has reached a limit. row.owner "
       "is the index of the joint. The other joints stay in their order."},
  };
}

Exercise exercise() {
  return exercise_of(
      "a joint that breaks",
      {"F is a force, and a row accumulates impulses. What is the largest impulse of a force F in a step of h, for a "
       "pull and for a push?",
       "The accumulated impulse never exceeds its limits. How do you tell a rod at its limit from a rod that holds?",
       "std::vector::erase shifts all later elements. If you go from the last row to the first, each index is still "
       "right when you use it."},
      Answer{Breaking{}});
}

}  // namespace pushback::exercise_15_transfer
