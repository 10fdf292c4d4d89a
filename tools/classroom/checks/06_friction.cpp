#include "pushback/chapters/02_clamping/clamping.h"
#include "pushback/chapters/06_friction/exercise/asked.h"
#include "pushback/common/exercise/shown.h"

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
  Vec3 velocity = Vec3::Zero(), spin = Vec3::Zero();
  bool floor_first = true;  ///< whether the floor is A
  int sweeps = 4;           ///< it is exact after one, unless it slips and turns at once

  explicit Ball(Random& random) : radius(random.between(Real(0.2), Real(0.5))), mass(random.between(5, 20)) {}

  /// After the step.
  Body solved(const Surfaces& surfaces, const Answer& answer, const std::vector<std::size_t>& quantities = {}) const {
    World world;
    if (floor_first) world.add(ground());
    const int ball = world.add(sphere(radius, mass).at({0, radius, 0}).moving(velocity).spinning(spin));
    if (!floor_first) world.add(ground());
    world.contacts = {{.normal = {0, floor_first ? Real(1) : Real(-1), 0}, .id = {0, 1, 0}}};
    Solver<Clamping, Rubbing> solver;
    static_cast<Rubbing&>(solver) = {{}, answer, surfaces};
    solver.solve(world, Real(1) / 60, sweeps);
    // Only to be seen: what slips does so against the belt.
    world.bodies[floor_first ? 0 : 1].velocity = floor_first ? surfaces.belt_a : surfaces.belt_b;
    show(world, quantities);
    return world.body(ball);
  }
};

Vec3 random_belt(Random& random) {
  const Real along = random.between(1, 2), across = random.between(Real(0.4), Real(0.8));
  return {along, 0, across};
}

std::vector<Check<Answer>> checks() {
  return {
      {"a ball that is put on a belt is taken along, and rolls on it",
       1,
       {{"your ball on a belt sets off along x with", "m/s", 1e-6},
        {"your ball on a belt sets off along z with", "m/s", 1e-6}},
       [](Random& random, const Answer& answer) -> Numbers {
         Ball ball(random);
         ball.velocity.y() = -random.between(6, 8);
         const Surfaces surfaces{.mu = random.between(Real(0.5), Real(0.8)), .lever = 0, .belt_a = random_belt(random)};
         const Vec3 after = ball.solved(surfaces, answer).velocity;
         return {after.x(), after.z()};
       }},
      {"a ball is taken along, whichever of the two bodies is the conveyor",
       1,
       {{"your ball on a belt that is body B sets off along x with", "m/s", 1e-6},
        {"your ball on a belt that is body B sets off along z with", "m/s", 1e-6}},
       [](Random& random, const Answer& answer) -> Numbers {
         Ball ball(random);
         ball.velocity.y() = -random.between(6, 8);
         ball.floor_first = false;
         const Surfaces surfaces{.mu = random.between(Real(0.5), Real(0.8)), .lever = 0, .belt_b = random_belt(random)};
         const Vec3 after = ball.solved(surfaces, answer).velocity;
         return {after.x(), after.z()};
       }},
      {"a belt that is too fast slips away under the ball, which gains μ Σλn / m",
       2,
       {{"your ball, which the belt leaves behind, gains", "m/s", 1e-6},
        {"your ball, which comes along faster than its belt, is braked by", "m/s", 1e-6}},
       [](Random& random, const Answer& answer) -> Numbers {
         Ball slow(random);
         slow.velocity.y() = -random.between(1, 2);
         Ball fast = slow;
         const Real belt = random.between(40, 50);
         fast.velocity.x() = random.between(2, 3) * belt;
         const Surfaces surfaces{
             .mu = random.between(Real(0.4), Real(0.6)), .lever = 0, .belt_a = belt * Vec3::UnitX()};
         return {slow.solved(surfaces, answer, {0}).velocity.x(),
                 fast.velocity.x() - fast.solved(surfaces, answer, {1}).velocity.x()};
       }},
      {"where nothing rubs, a turn loses ϱ Σλn / I, and stops when it is less",
       1,
       {{"your ball, which turns fast on a smooth floor, turns more slowly by", "rad/s", 1e-6},
        {"your ball, which turns slowly on a smooth floor, turns on with", "rad/s", 1e-6},
        {"your ball, which turns slowly the other way, turns on with", "rad/s", 1e-6}},
       [](Random& random, const Answer& answer) -> Numbers {
         Ball fast(random);
         const Real arrival = random.between(1, 2);
         const Real lever = random.between(Real(0.01), Real(0.02));
         const Surfaces surfaces{.mu = 0, .lever = lever, .belt_a = random_belt(random)};  // which slips away under it
         const Real most = surfaces.lever * arrival / (Real(0.4) * fast.radius * fast.radius);  // rad/s
         fast.velocity.y() = -arrival;
         Ball slow = fast;
         fast.spin.x() = random.between(6, 9) * most;
         slow.spin.x() = random.between(Real(0.4), Real(0.7)) * most;
         Ball other_way = slow;
         other_way.spin *= -1;
         return {fast.spin.x() - fast.solved(surfaces, answer, {0}).angular_velocity.x(),
                 slow.solved(surfaces, answer, {1}).angular_velocity.x(),
                 other_way.solved(surfaces, answer, {2}).angular_velocity.x()};
       }},
      {"a ball that rolls is slowed by its rolling resistance, and keeps rolling",
       2,
       {{"your ball, which rolls, is slowed by", "m/s", 1e-6},
        {"your ball, which rolls, is then turning with", "rad/s", 1e-6}},
       [](Random& random, const Answer& answer) -> Numbers {
         Ball ball(random);
         const Real speed = random.between(3, 6);
         ball.velocity = {speed, -random.between(1, 2), 0};
         ball.spin.z() = -speed / ball.radius;
         ball.sweeps = 200;
         const Real mu = random.between(Real(0.5), Real(0.8)), lever = random.between(Real(0.01), Real(0.02));
         const Body after = ball.solved({.mu = mu, .lever = lever}, answer);
         return {speed - after.velocity.x(), after.angular_velocity.z()};
       }},
      {"a ball that cannot roll is taken along by a belt as a box is",
       1,
       {{"your ball, whose belt does not let it turn, sets off with", "m/s", 1e-6},
        {"your ball, whose belt does not let it turn, turns with", "rad/s", 1e-6}},
       [](Random& random, const Answer& answer) -> Numbers {
         Ball ball(random);
         const Real along = random.between(1, 2), across = random.between(Real(0.3), Real(0.4)) * along;
         ball.velocity.y() = -random.between(6, 8);
         ball.sweeps = 200;
         const Surfaces surfaces{.mu = random.between(Real(0.5), Real(0.8)),
                                 .lever = Real(1.2) * ball.radius,
                                 .belt_a = {along, 0, across}};
         const Body after = ball.solved(surfaces, answer);
         return {after.velocity.norm(), after.angular_velocity.norm()};
       }},
  };
}

void hold(Row& row, Real speed, Real bound) {
  row.lo = -bound;
  row.hi = bound;
  row.reach(row.impulse - row.effective_mass * speed);
}
void hold_each_correction(Row& row, Real speed, Real bound) {
  row.reach(row.impulse + std::clamp(-row.effective_mass * speed, -bound, bound));
}
Real slip_of(const Row& slip, const Surfaces& surfaces) {
  return slip.speed() + (surfaces.belt_b - surfaces.belt_a).dot(slip.n);
}

void hold_slip(const Row& normal, Row& slip, const Surfaces& surfaces) {
  hold(slip, slip_of(slip, surfaces), surfaces.mu * normal.impulse);
}
void hold_roll(const Row& normal, Row& roll, const Surfaces& surfaces) {
  hold(roll, roll.speed(), surfaces.lever * normal.impulse);
}

void right(const Row& normal, Row& slip, Row& roll, const Surfaces& surfaces) {
  hold_slip(normal, slip, surfaces);
  hold_roll(normal, roll, surfaces);
}

/// A mistake in the slip's speed, the roll as it should be.
template <auto speed_of>
void with_slip(const Row& normal, Row& slip, Row& roll, const Surfaces& surfaces) {
  hold(slip, speed_of(slip, surfaces), surfaces.mu * normal.impulse);
  hold_roll(normal, roll, surfaces);
}
/// A mistake in the roll's bound, the slip as it should be.
template <auto bound_of>
void with_roll_bound(const Row& normal, Row& slip, Row& roll, const Surfaces& surfaces) {
  hold_slip(normal, slip, surfaces);
  hold(roll, roll.speed(), bound_of(normal, surfaces));
}

constexpr Real inf = std::numeric_limits<Real>::infinity();

std::vector<Mistake<Answer>> mistakes() {
  const std::string each =
      "it looks as if each correction were clamped, not their sum, or the sum began at 0 in each sweep. Every sweep "
      "then adds the full bound once more.";
  const std::string ends =
      "it looks as if lo and hi were the same, or swapped: the sum then sits at one end of the interval, whichever way "
      "the surfaces slip. It is anything from minus the bound to the bound.";
  const std::string one_sided =
      "it looks as if the sum of a row could not be negative. A normal only pushes; what holds a slip or a turn acts "
      "both ways, from minus the bound to the bound.";
  return {
      {"belt forgotten",
       "it looks as if the belt stood still. What friction holds is the slip of the surfaces: that of the bodies, and "
       "how the belt runs under it along t, which is slip.n (the normal's n has no part of it).",
       {with_slip<[](const Row& slip, const Surfaces&) { return slip.speed(); }>}},
      {"sign of the belt",
       "it looks as if the belt ran the other way. The surface of A moves with v_A + belt_a, that of B with v_B + "
       "belt_b; the slip is the second minus the first.",
       {with_slip<[](const Row& slip, const Surfaces& surfaces) {
         return slip.speed() + (surfaces.belt_a - surfaces.belt_b).dot(slip.n);
       }>}},
      {"belt of B as if it were A's",
       "it looks as if a belt counted the same on A and on B. The slip is B's surface minus A's: the two belts have "
       "opposite signs.",
       {with_slip<[](const Row& slip, const Surfaces& surfaces) {
         return slip.speed() - (surfaces.belt_a + surfaces.belt_b).dot(slip.n);
       }>}},
      {"belt of B forgotten",
       "it looks as if only A could be a conveyor. Which body is A is decided by its index, not by what it is.",
       {with_slip<[](const Row& slip, const Surfaces& surfaces) {
         return slip.speed() - surfaces.belt_a.dot(slip.n);
       }>}},
      {"the belt's whole speed",
       "it looks as if each tangent had the whole speed of the belt. A row has the part along its own t: belt · t.",
       {with_slip<[](const Row& slip, const Surfaces& surfaces) {
         return slip.speed() + surfaces.belt_b.norm() - surfaces.belt_a.norm();
       }>}},
      {"a belt faster in each sweep",
       "it looks as if the belt got faster with each sweep. rub is called several times a step: what it adds to a bias "
       "is added each time.",
       {with_slip<[](Row& slip, const Surfaces& surfaces) {
         slip.bias += (surfaces.belt_b - surfaces.belt_a).dot(slip.n);
         return slip.speed() + slip.bias;
       }>}},
      {"no bound",
       "it looks as if the belt could pull as hard as it likes. Friction is at most μ Σλn, of a belt as of a floor.",
       {[](const Row& normal, Row& slip, Row& roll, const Surfaces& surfaces) {
         hold(slip, slip_of(slip, surfaces), inf);
         hold_roll(normal, roll, surfaces);
       }}},
      {"each correction clamped", each, {[](const Row& normal, Row& slip, Row& roll, const Surfaces& surfaces) {
         hold_each_correction(slip, slip_of(slip, surfaces), surfaces.mu * normal.impulse);
         hold_each_correction(roll, roll.speed(), surfaces.lever * normal.impulse);
       }}},
      {"each correction clamped", each, {[](const Row& normal, Row& slip, Row& roll, const Surfaces& surfaces) {
         hold_each_correction(slip, slip_of(slip, surfaces), surfaces.mu * normal.impulse);
         hold_roll(normal, roll, surfaces);
       }}},
      {"each correction clamped", each, {[](const Row& normal, Row& slip, Row& roll, const Surfaces& surfaces) {
         hold_slip(normal, slip, surfaces);
         hold_each_correction(roll, roll.speed(), surfaces.lever * normal.impulse);
       }}},
      {"one-sided", one_sided, {[](const Row& normal, Row& slip, Row& roll, const Surfaces& surfaces) {
         slip.lo = roll.lo = 0;
         slip.hi = surfaces.mu * normal.impulse;
         roll.hi = surfaces.lever * normal.impulse;
         slip.reach(slip.impulse - slip.effective_mass * slip_of(slip, surfaces));
         roll.reach(roll.wanted());
       }}},
      {"one-sided", one_sided, {[](const Row& normal, Row& slip, Row& roll, const Surfaces& surfaces) {
         hold_slip(normal, slip, surfaces);
         roll.lo = 0;
         roll.hi = surfaces.lever * normal.impulse;
         roll.reach(roll.wanted());
       }}},
      {"hi for lo", ends, {[](const Row& normal, Row& slip, Row& roll, const Surfaces& surfaces) {
         slip.lo = slip.hi = surfaces.mu * normal.impulse;
         roll.lo = roll.hi = surfaces.lever * normal.impulse;
         slip.reach(slip.impulse - slip.effective_mass * slip_of(slip, surfaces));
         roll.reach(roll.wanted());
       }}},
      {"hi for lo", ends, {[](const Row& normal, Row& slip, Row& roll, const Surfaces& surfaces) {
         slip.lo = surfaces.mu * normal.impulse;
         slip.hi = -slip.lo;
         roll.lo = surfaces.lever * normal.impulse;
         roll.hi = -roll.lo;
         slip.reach(slip.impulse - slip.effective_mass * slip_of(slip, surfaces));
         roll.reach(roll.wanted());
       }}},
      {"slip forgotten",
       "it looks as if nothing held the slip. Only friction takes a ball along: slip is solved as well, against the "
       "slip of the surfaces.",
       {[](const Row& normal, Row&, Row& roll, const Surfaces& surfaces) { hold_roll(normal, roll, surfaces); }}},
      {"sign of the slip",
       "it looks as if friction pushed along with the slip. The impulse that makes the slip of the surfaces 0 is minus "
       "that slip times the effective mass.",
       {[](const Row& normal, Row& slip, Row& roll, const Surfaces& surfaces) {
         hold(slip, -slip_of(slip, surfaces), surfaces.mu * normal.impulse);
         hold_roll(normal, roll, surfaces);
       }}},
      {"μ forgotten",
       "it looks as if the bound of the slip were Σλn. Friction is at most the part μ of the push.",
       {[](const Row& normal, Row& slip, Row& roll, const Surfaces& surfaces) {
         hold(slip, slip_of(slip, surfaces), normal.impulse);
         hold_roll(normal, roll, surfaces);
       }}},
      {"roll forgotten",
       "it looks as if nothing held the turn. A row that is never solved does nothing.",
       {[](const Row& normal, Row& slip, Row&, const Surfaces& surfaces) { hold_slip(normal, slip, surfaces); }}},
      {"roll without bound",
       "it looks as if no ball could turn. Rolling resistance is at most ϱ times the push on the ground.",
       {with_roll_bound<[](const Row&, const Surfaces&) { return inf; }>}},
      {"μ for ϱ",
       "it looks as if the turn were held by μ Σλn. That is an impulse in N s; a turn is held by N m s, ϱ Σλn.",
       {with_roll_bound<[](const Row& normal, const Surfaces& surfaces) { return surfaces.mu * normal.impulse; }>}},
      {"μ times ϱ",
       "it looks as if rolling resistance came from friction, with μ ϱ Σλn. The ground gives way under what presses on "
       "it, rough or smooth: ϱ Σλn.",
       {with_roll_bound<[](const Row& normal, const Surfaces& surfaces) {
         return surfaces.mu * surfaces.lever * normal.impulse;
       }>}},
      {"ϱ times friction",
       "it looks as if the turn's bound came from the friction impulse. The ground gives way under what presses on it: "
       "ϱ times the sum of the normal.",
       {[](const Row& normal, Row& slip, Row& roll, const Surfaces& surfaces) {
         hold_slip(normal, slip, surfaces);
         hold(roll, roll.speed(), surfaces.lever * std::abs(slip.impulse));
       }}},
      {"sign of the roll",
       "it looks as if rolling resistance drove the ball. It opposes the turn.",
       {[](const Row& normal, Row& slip, Row& roll, const Surfaces& surfaces) {
         hold_slip(normal, slip, surfaces);
         hold(roll, -roll.speed(), surfaces.lever * normal.impulse);
       }}},
      {"the belt turns",
       "it looks as if the turn were to follow the belt. A belt runs straight: what rolls over it resists turning "
       "against the conveyor, w_B - w_A alone.",
       {[](const Row& normal, Row& slip, Row& roll, const Surfaces& surfaces) {
         hold_slip(normal, slip, surfaces);
         hold(roll, roll.speed() + (surfaces.belt_b - surfaces.belt_a).dot(slip.n), surfaces.lever * normal.impulse);
       }}},
  };
}

}  // namespace

Numbers play(std::size_t check, Random& random, const Answer& answer) {
  return checks()[check].play(random, answer);
}

Exercise exercise() {
  return exercise_of<Answer>(
      "a conveyor belt, and rolling resistance",
      {"How fast does the surface of A move at the contact point, if A moves with v_A and its belt runs over it?",
       "The surfaces slip with slip.speed() plus B's belt minus A's, along t = slip.n. Friction makes that 0, within "
       "its bound.",
       "Rolling resistance makes roll.speed() 0, within its own bound: minus and plus surfaces.lever times "
       "normal.impulse."},
      checks(), {right}, mistakes());
}

}  // namespace pushback::exercise_06
