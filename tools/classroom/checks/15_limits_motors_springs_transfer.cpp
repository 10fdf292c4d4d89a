#include "pushback/chapters/13_joints/distance.h"
#include "pushback/chapters/15_limits_motors_springs/exercise/transfer/asked.h"
#include "pushback/common/basics/shortest_turn.h"
#include "pushback/common/exercise/shown.h"

namespace pushback::exercise_15_transfer {

namespace {

constexpr Real strength = 100;  // N

struct Held : AnyEffect, HoldsJoints {};

/// Balls without weight, each on a rod of its own from the immovable world.
struct Rods {
  World world;
  Solver<Held> solver;
  std::vector<Vec3> away;  // from where its rod begins

  explicit Rods(const Answer& answer) : solver(with_effect<Solver<Held>>(answer.joints)) { world.gravity.setZero(); }
  /// `speed`: m/s, by which it would leave; negative: by which it would come.
  void add(Real mass, Real speed, Random& random) {
    away.push_back(random.direction());
    const Vec3 begins = beginning_of(away.size() - 1), at = begins + away.back();
    const int ball = world.add(sphere(Real(0.1), mass).at(at).moving(speed * away.back()));
    world.joints.push_back(distance(world, the_world, begins, ball, at));
  }
  void solve(Real h, const std::vector<std::size_t>& quantities = {}) {
    solver.solve(world, h, 4);
    show(with_rods(), quantities);
  }
  /// m, of a ball's rod.
  static Vec3 beginning_of(std::size_t ball) {
    const std::size_t column = ball % 3, row = ball / 3;
    return {Real(2.5) * static_cast<Real>(1 + column), Real(-2.5) * static_cast<Real>(row), 0};
  }
  /// To be seen: a rod is a body, and one that is broken points past its ball.
  World with_rods() const {
    World seen;
    seen.bodies = world.bodies;
    for (std::size_t ball = 0; ball < away.size(); ++ball) {
      const bool held = std::any_of(world.joints.begin(), world.joints.end(),
                                    [&](const Joint& joint) { return joint.b == static_cast<int>(ball); });
      const Vec3 along = held ? away[ball] : (away[ball] + 2 * tangents_of(away[ball]).tangent1).normalized();
      Body rod = box({Real(0.02), Real(0.5), Real(0.02)}, 1).at(beginning_of(ball) + along / 2);
      rod.orientation = shortest_turn(Vec3::UnitY(), along);
      seen.add(rod);
    }
    return seen;
  }
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
std::array<Real, 2> two_steps(Random& random, Real times, const Answer& answer,
                              const std::vector<std::size_t>& quantities) {
  const Real mass = random.between(2, 10), h = 1 / random.between(40, 100);
  Rods rods(answer);
  rods.add(mass, times * h * strength / mass, random);
  std::array<Real, 2> speeds{};
  for (Real& speed : speeds) {
    rods.solve(h, quantities);
    speed = rods.speed(0);
  }
  return speeds;
}

/// Of four balls the first and the third pull too hard: the speed of the third, m/s, which rod comes first then, and how much the
/// rods hold, kg, after a step of half the length in which a third pulls with 0.7 of what a rod bears in a whole one.
std::array<Real, 3> four_balls(Random& random, const Answer& answer) {
  const Real h = 1 / random.between(40, 100);
  Rods rods(answer);
  for (const Real times : {Real(3), Real(0), Real(2.5), Real(0.995)}) {
    const Real mass = random.between(2, 10);
    rods.add(mass, times * h * strength / mass, random);
  }
  rods.solve(h, {2, 3});
  const Real speed = rods.speed(2);
  const Real first = rods.world.joints.empty() ? 0 : static_cast<Real>(rods.world.joints.front().b);
  for (Body& ball : rods.world.bodies) ball.velocity.setZero();
  Body& second = rods.world.bodies[1];
  second.velocity = Real(0.7) * h * strength * second.inverse_mass * rods.away[1];
  rods.solve(h / 2, {4});
  return {speed, first, rods.held()};
}

std::vector<Check<Answer>> checks() {
  return {
      {"a rod holds a load that it can bear",
       1,
       {{"your ball, whose rod can bear it, goes on with", "m/s", 1e-6}, {"your rods still hold", "kg", 1e-6}},
       [](Random& random, const Answer& answer) -> Numbers {
         const Real mass = random.between(2, 10), h = 1 / random.between(40, 100);
         Rods rods(answer);
         rods.add(mass, random.between(Real(0.3), Real(0.9)) * h * strength / mass, random);
         rods.solve(h);
         return {rods.speed(0), rods.held()};
       }},
      {"a rod that is pulled too hard takes h F off its load, and is gone",
       2,
       {{"your ball, which pulls too hard at its rod, goes on with", "m/s", 1e-6},
        {"in the next step your ball, whose rod is broken, goes on with", "m/s", 1e-6},
        {"your ball, which is far too fast for its rod, goes on with", "m/s", 1e-6}},
       [](Random& random, const Answer& answer) -> Numbers {
         const auto [first, second] = two_steps(random, random.between(Real(2.5), 4), answer, {0, 1});
         const auto far_too_fast = two_steps(random, random.between(150, 200), answer, {2});
         return {first, second, far_too_fast[0]};
       }},
      {"so is a rod that is pushed too hard",
       2,
       {{"your ball, which pushes too hard at its rod, comes on with", "m/s", 1e-6},
        {"in the next step your ball, whose rod is broken, comes on with", "m/s", 1e-6}},
       [](Random& random, const Answer& answer) -> Numbers {
         const auto [first, second] = two_steps(random, -random.between(Real(2.5), 4), answer, {0, 1});
         return {-first, -second};
       }},
      {"of several rods those break that bear too much",
       3,
       {{"of six balls, two pull too hard and one sleeps; your rods still hold", "kg", 1e-6},
        {"of six balls, two pulled too hard one step ago; your rods still hold", "kg", 1e-6},
        {"of four balls, the third pulls too hard and goes on with", "m/s", 1e-6},
        {"of four balls, the first pulls too hard; the name of your first rod is number", "", 1e-6},
        {"the same balls, in a step of half the length; your rods still hold", "kg", 1e-6}},
       [](Random& random, const Answer& answer) -> Numbers {
         const Real h = 1 / random.between(40, 100);
         Rods rods(answer);
         Real mass = 2;
         for (const Real times : {Real(0), Real(2), Real(3), Real(0.2), Real(0.3), Real(0.1)}) {
           mass += random.between(1, 2);
           rods.add(mass, times * h * strength / mass, random);
         }
         rods.world.bodies[0].asleep = true;
         rods.solve(h, {0});
         const Real held = rods.held();
         rods.solve(h, {1});
         const auto [fast, first, shorter] = four_balls(random, answer);
         return {held, rods.held(), fast, first, shorter};
       }},
  };
}

enum class TakesOut { broken, forwards, one, all, number_of_row, by_swap };

/// A mistake: the limits that it sets, the impulse that it takes for that of a broken rod, and the joints that it takes out.
struct Mistaken : Joints {
  std::function<void(Row& row, Real h)> limit;
  std::function<bool(Real impulse, Real h)> broken;
  TakesOut takes_out;

  Mistaken(std::function<void(Row&, Real)> sets, std::function<bool(Real, Real)> finds,
           TakesOut what = TakesOut::broken)
      : limit(std::move(sets)), broken(std::move(finds)), takes_out(what) {}
  void build(StepContext& step) {
    Joints::build(step);
    for (JointRow& row : joint_rows_) limit(row, step.dt);
  }
  void report(StepContext& step) {
    std::vector<std::size_t> out;
    for (std::size_t i = 0; i < joint_rows_.size(); ++i)
      if (broken(joint_rows_[i].impulse, step.dt))
        out.push_back(takes_out == TakesOut::number_of_row ? i : joint_rows_[i].owner);
    if (takes_out != TakesOut::forwards) std::reverse(out.begin(), out.end());
    if (takes_out == TakesOut::one && !out.empty()) out = {out.back()};
    std::vector<Joint>& joints = step.world.joints;
    if (takes_out == TakesOut::all && !out.empty()) joints.clear();
    else
      for (const std::size_t joint : out)
        if (joint < joints.size()) {
          if (takes_out == TakesOut::by_swap) {
            std::swap(joints[joint], joints.back());
            joints.pop_back();
          } else joints.erase(joints.begin() + static_cast<std::ptrdiff_t>(joint));
        }
  }
};

void both_limits(Row& row, Real h) {
  row.lo = -h * strength;
  row.hi = h * strength;
}
bool is_broken(Real impulse, Real h) {
  return std::abs(impulse) >= h * strength;
}

/// Right for the first of the rows, or in the first of the steps.
struct OfSome : Mistaken {
  std::size_t limited = std::numeric_limits<std::size_t>::max();
  bool keeps_h = false;
  Real h = 0;

  explicit OfSome(std::size_t most, bool keeps = false)
      : Mistaken(both_limits, is_broken), limited(most), keeps_h(keeps) {}
  void build(StepContext& step) {
    Joints::build(step);
    if (h == 0 || !keeps_h) h = step.dt;
    for (std::size_t i = 0; i < std::min(limited, joint_rows_.size()); ++i) both_limits(joint_rows_[i], h);
  }
  void report(StepContext& step) {
    const Real its_h = h;
    broken = [its_h](Real sum, Real) { return is_broken(sum, its_h); };
    Mistaken::report(step);
  }
};

std::vector<Mistake<Answer>> mistakes() {
  const auto no_limits = [](Row&, Real) {};
  const auto forces = [](Row& row, Real) { both_limits(row, 1); };
  const auto pulled_only = [](Row& row, Real h) { row.lo = -h * strength; };
  const auto pushed_only = [](Row& row, Real h) { row.hi = h * strength; };
  const auto never = [](Real, Real) { return false; };
  const auto pulled_off = [](Real impulse, Real h) { return impulse <= -h * strength; };
  const auto pushed_off = [](Real impulse, Real h) { return impulse >= h * strength; };
  const std::string impulse =
      "it looks as if a force stood where an impulse is meant. In a step of h seconds the rod does no more than h F; F "
      "newton seconds are what it does in a whole second.";
  const std::string holds =
      "it looks as if the rod held its load first, and broke then. A rod cannot give more than it bears: the limits "
      "have to be there before the first sweep.";
  const std::string pull =
      "it looks as if only a pull could be too much. A rod is pushed as well, and its impulse is then above 0: it "
      "needs both limits, and either of them breaks it.";
  const std::string push =
      "it looks as if only a push could be too much. Where a rod pulls, its impulse is below 0: it needs both limits, "
      "and either of them breaks it.";
  const std::string still =
      "it looks as if the rod had given all that it can, and was still there afterwards. A sum that is limited never "
      "exceeds its limit: the rod is broken where its sum reaches h F.";
  const std::string some =
      "it looks as if some rods had no limits. Every row of joint_rows_ needs its own: each rod bears F.";
  return {
      {"limits left out", some, {OfSome(1)}},
      {"limits left out", some, {OfSome(2)}},
      {"the h of the first step",
       "it looks as if h were that of the first step. F does h F in a step of h seconds, and steps may be of different "
       "lengths: step.dt is the length of this one.",
       {OfSome(100, true)}},
      {"broken too early",
       "it looks as if a rod broke that still holds. Broken is a rod whose sum has reached h F, and no other.",
       {Mistaken(both_limits, [](Real sum, Real h) { return std::abs(sum) >= Real(0.99) * h * strength; })}},
      {"another order",
       "it looks as if the last rod had been moved into the place of a broken one. The others keep their order: "
       "step.world.joints.erase.",
       {Mistaken(both_limits, is_broken, TakesOut::by_swap)}},
      {"it holds, and breaks then", holds, {Mistaken(no_limits, is_broken)}},
      {"a force for an impulse", impulse, {Mistaken(forces, [](Real sum, Real) { return is_broken(sum, 1); })}},
      {"a force for an impulse", impulse, {Mistaken(forces, is_broken)}},
      {"nothing breaks",
       "it looks as if no rod ever broke: each holds whatever pulls at it. Limit its impulse to what F does in a step.",
       {Mistaken(no_limits, never)}},
      {"still there", still, {Mistaken(both_limits, never)}},
      {"only when pulled", pull, {Mistaken(both_limits, pulled_off)}},
      {"only when pulled", pull, {Mistaken(pulled_only, is_broken)}},
      {"only when pulled", pull, {Mistaken(pulled_only, pulled_off)}},
      {"only when pushed", push, {Mistaken(both_limits, pushed_off)}},
      {"only when pushed", push, {Mistaken(pushed_only, is_broken)}},
      {"only when pushed", push, {Mistaken(pushed_only, pushed_off)}},
      {"limits of a rope",
       "it looks as if one limit were 0, as that of a rope or a contact. A rod pulls and pushes: from -h F to h F.",
       {Mistaken(
           [](Row& row, Real h) {
             row.lo = 0;
             row.hi = h * strength;
           },
           is_broken)}},
      {"limits of a rope",
       "it looks as if one limit were 0, as that of a rope or a contact. A rod pulls and pushes: from -h F to h F.",
       {Mistaken(
           [](Row& row, Real h) {
             row.lo = -h * strength;
             row.hi = 0;
           },
           is_broken)}},
      {"the number of the row",
       "it looks as if the number of the row were taken for that of its joint. Joints that sleep have no row: the "
       "right number is row.owner.",
       {Mistaken(both_limits, is_broken, TakesOut::number_of_row)}},
      {"numbers that have moved",
       "it looks as if joints were taken out from the front. Those behind move up by one, and the next owner is no "
       "longer the index of its joint: a rod that holds is taken out. Go from the back.",
       {Mistaken(both_limits, is_broken, TakesOut::forwards)}},
      {"one of them only",
       "it looks as if only one rod broke in a step. Each of them bears its own load.",
       {Mistaken(both_limits, is_broken, TakesOut::one)}},
      {"all of them",
       "it looks as if all rods broke with the first. Only those are gone whose own row has reached a limit.",
       {Mistaken(both_limits, is_broken, TakesOut::all)}},
  };
}

}  // namespace

Numbers play(std::size_t check, Random& random, const Answer& answer) {
  return checks()[check].play(random, answer);
}

Exercise exercise() {
  return exercise_of<Answer>(
      "a joint that breaks",
      {"F is a force, and a row sums impulses. What is the most that a force of F does in a step of h, pulled or "
       "pushed?",
       "A sum with limits never exceeds them. What tells a rod that gave all it can from one that holds?",
       "std::vector::erase moves all that is behind. From the last row to the first, no index is wrong before its "
       "turn."},
      checks(), {Mistaken(both_limits, is_broken)}, mistakes());
}

}  // namespace pushback::exercise_15_transfer
