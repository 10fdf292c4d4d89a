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
      {"a rod holds a load that it can bear", 1,
       [](Random& random, const Answer& answer) -> std::vector<Reading> {
         const Real mass = random.between(2, 10), h = 1 / random.between(40, 100);
         Rods rods(answer);
         rods.add(mass, random.between(Real(0.3), Real(0.9)) * h * strength / mass, random);
         rods.solve(h);
         return {{"your ball, whose rod can bear it, goes on with", rods.speed(0), "m/s"},
                 {"your rods still hold", rods.held(), "kg"}};
       },
       "a rod that has to give less than h F in a step holds its ball, and is not broken."},
      {"a rod that is pulled too hard takes h F off its load, and is gone", 2,
       [](Random& random, const Answer& answer) -> std::vector<Reading> {
         const auto [first, second] = two_steps(random, random.between(Real(2.5), 4), answer);
         const auto far_too_fast = two_steps(random, random.between(150, 200), answer);
         return {{"your ball, which pulls too hard at its rod, goes on with", first, "m/s"},
                 {"in the next step your ball, whose rod is broken, goes on with", second, "m/s"},
                 {"your ball, which is far too fast for its rod, goes on with", far_too_fast[0], "m/s"}};
       },
       "a rod cannot give more than h F in a step. One whose sum reaches that has taken h F off its load, and is gone "
       "from the next step on."},
      {"so is a rod that is pushed too hard", 2,
       [](Random& random, const Answer& answer) -> std::vector<Reading> {
         const auto [first, second] = two_steps(random, -random.between(Real(2.5), 4), answer);
         return {{"your ball, which pushes too hard at its rod, comes on with", -first, "m/s"},
                 {"in the next step your ball, whose rod is broken, comes on with", -second, "m/s"}};
       },
       "a rod is pushed as well as pulled. Its sum is between -h F and h F, and either limit breaks it."},
      {"of several rods those break that bear too much", 3,
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
         return {{"of six balls, two pull too hard and one sleeps; your rods still hold", held, "kg"},
                 {"in a step of half the length one more pulls too hard; your rods still hold", rods.held(), "kg"}};
       },
       "each rod bears F, with the h of this step. Those go whose own row has reached a limit, row.owner is the index "
       "of their joint, and the others stay in their order."},
  };
}

Exercise exercise() {
  return exercise_of(
      "a joint that breaks",
      {"F is a force, and a row sums impulses. What is the most that a force of F does in a step of h, pulled or "
       "pushed?",
       "A sum with limits never exceeds them. What tells a rod that gave all it can from one that holds?",
       "std::vector::erase moves all that is behind. From the last row to the first, no index is wrong before its "
       "turn."},
      Answer{Breaking{}});
}

}  // namespace pushback::exercise_15_transfer
