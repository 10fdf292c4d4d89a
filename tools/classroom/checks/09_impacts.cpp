#include "pushback/chapters/02_clamping/clamping.h"
#include "pushback/chapters/09_impacts/exercise/asked.h"
#include "pushback/chapters/09_impacts/sequential.h"
#include "pushback/common/exercise/shown.h"

namespace pushback::exercise_09 {

namespace {

constexpr int most_rounds = 50;
constexpr Real usual_threshold = Real(0.1);  // m/s

struct Rounds : Effect {
  Answer answer{};
  Real threshold = usual_threshold;
  int rounds = 0;      // in which something bounced
  Real separates = 0;  // m/s: the first pair, after them
  std::vector<Real> by_forces = {};

  void build(StepContext& step) {
    for (std::size_t i = 0; i < step.contacts.size(); ++i)
      by_forces.push_back(step.rows[i].speed() - approach_speed(step.world, step.contacts[i]));
  }
  void start(StepContext& step) {
    while (rounds < most_rounds && answer.one_round(step, by_forces, threshold)) ++rounds;
    separates = step.rows[0].speed();
  }
};

/// Balls in a row along x that touch, each pair with a restitution of its own.
struct Line {
  std::vector<Real> masses, speeds, restitutions;
};

struct Solved {
  std::vector<Real> speeds;  // m/s, of each body along the normal of the contacts
  Real impulse;              // N s, of the first contact
  Real rounds, separates;    // see Rounds
};

/// The rest of a step, once its contacts are known.
Solved solved(World& world, const Answer& answer, Real threshold = usual_threshold,
              const std::vector<std::size_t>& quantities = {}) {
  constexpr Real h = Real(1) / 60;
  for (Body& body : world.bodies) {
    keep_velocity(body);
    integrate_velocity(body, world.gravity, h);
  }
  Solver<Clamping, Rounds> solver;
  solver.answer = answer;
  solver.threshold = threshold;
  solver.solve(world, h, 10);
  show(world, quantities);
  Solved after{{}, world.contacts[0].impulse.norm(), static_cast<Real>(solver.rounds), solver.separates};
  for (const Body& body : world.bodies) after.speeds.push_back(body.velocity.dot(world.contacts[0].normal));
  return after;
}

Solved solved(const Line& line, const Answer& answer, Real threshold = usual_threshold,
              const std::vector<std::size_t>& quantities = {}) {
  World world;
  world.gravity.setZero();
  for (std::size_t i = 0; i < line.masses.size(); ++i)
    world.add(
        sphere(Real(0.3), line.masses[i]).at({static_cast<Real>(i) * Real(0.6), 0, 0}).moving({line.speeds[i], 0, 0}));
  for (std::uint32_t i = 0; i < line.restitutions.size(); ++i)
    world.contacts.push_back({.point = {(static_cast<Real>(i) + Real(0.5)) * Real(0.6), 0, 0},
                              .normal = {1, 0, 0},
                              .restitution = line.restitutions[i],
                              .id = {i, i + 1, 0}});
  return solved(world, answer, threshold, quantities);
}

/// A ball that lies on the ground while two others meet in the air, whose contact comes first: its speed upwards, m/s.
Real beside_two_that_meet(Random& random, const Answer& answer) {
  World world;
  world.add(ground());
  world.add(sphere(Real(0.3), random.between(3, 8)).at({0, Real(0.3), 0}));
  world.add(sphere(Real(0.3), random.between(3, 8)).at({2, 5, 0}).moving({random.between(1, 3), 0, 0}));
  world.add(sphere(Real(0.3), random.between(3, 8)).at({Real(2.6), 5, 0}));
  const Real e = random.between(Real(0.5), Real(0.9));
  world.contacts = {{.point = {Real(2.3), 5, 0}, .normal = {1, 0, 0}, .restitution = e, .id = {2, 3, 0}},
                    {.normal = {0, 1, 0}, .restitution = e, .id = {0, 1, 0}}};
  solved(world, answer, usual_threshold, {3});
  return world.bodies[1].velocity.y();
}

/// A ball on the ground: its speed upwards after the step, m/s. In a step it falls by 0.16 m/s, more than the threshold.
Real on_the_ground(Real mass, Real upwards, Real e, const Answer& answer, std::size_t quantity,
                   Real threshold = usual_threshold) {
  World world;
  world.add(ground());
  world.add(sphere(Real(0.3), mass).at({0, Real(0.3), 0}).moving({0, upwards, 0}));
  world.contacts = {{.normal = {0, 1, 0}, .restitution = e, .id = {0, 1, 0}}};
  return solved(world, answer, threshold, {quantity}).speeds[1];
}

std::vector<Check<Answer>> checks() {
  const Quantity rounds{"the rounds in which something bounces are", "", Real(0.5)};
  return {
      {"two balls that meet separate e times as fast as they approached",
       1,
       {{"after your rounds the two balls separate with", "m/s", 1e-6},
        {"after your rounds and the sweeps the two balls separate with", "m/s", 1e-6},
        {"their row keeps an impulse of", "N s", 1e-4}},
       [](Random& random, const Answer& answer) -> Numbers {
         const Real first = random.between(3, 8), second = random.between(3, 8);
         const Real arrives = random.between(2, 4), away = random.between(-1, 1),
                    e = random.between(Real(0.3), Real(0.8));
         const Solved after = solved(Line{{first, second}, {arrives, away}, {e}}, answer);
         return {after.separates, after.speeds[1] - after.speeds[0], after.impulse};
       }},
      {"against the list's order an impact goes on by one pair a round, until none approaches",
       2,
       {{"the ball at the far end of your row leaves with", "m/s", 1e-6},
        {"the ball that has hit your row goes on with", "m/s", 1e-6},
        rounds},
       [](Random& random, const Answer& answer) -> Numbers {
         // Each is lighter than the one that hits it, so they are all apart in the end.
         Line line{{random.between(3, 5)}, {0}, {}};
         const std::size_t pairs = 3 + random.below(2);
         const Real heavier = random.between(Real(1.3), Real(1.5));
         for (std::size_t i = 0; i < pairs; ++i) {
           line.masses.push_back(line.masses.back() * heavier);
           line.speeds.push_back(0);
           line.restitutions.push_back(1);
         }
         line.speeds.back() = -random.between(2, 4);
         const Solved after = solved(line, answer);
         return {-after.speeds.front(), -after.speeds.back(), after.rounds};
       }},
      {"each pair bounces with its own restitution, within one round along the list",
       2,
       {{"the middle one of your three balls goes on with", "m/s", 1e-6},
        {"the last one of your three balls leaves with", "m/s", 1e-6},
        rounds},
       [](Random& random, const Answer& answer) -> Numbers {
         const Real mass = random.between(3, 8), arrives = random.between(2, 4);
         const Real first = random.between(Real(0.7), Real(0.9)), second = random.between(Real(0.2), Real(0.4));
         const Solved after = solved(Line{{mass, mass, mass}, {arrives, 0, 0}, {first, second}}, answer);
         return {after.speeds[1], after.speeds[2], after.rounds};
       }},
      {"a ball that is hit from both sides passes each impact on",
       2,
       {{"the first of your three balls leaves with", "m/s", 1e-6},
        {"the middle one, which is hit from both sides, goes on with", "m/s", 1e-6},
        {"the last of your three balls leaves with", "m/s", 1e-6}},
       [](Random& random, const Answer& answer) -> Numbers {
         const Real mass = random.between(3, 8), e = random.between(Real(0.85), 1);
         const Real right = random.between(2, 4), left = random.between(2, 4);
         return solved(Line{{mass, mass, mass}, {right, 0, -left}, {e, e}}, answer).speeds;
       }},
      {"what approaches more slowly than the threshold is left to the sweeps",
       1,
       {{"your balls, which approach slowly, go on with", "m/s", 1e-6},
        rounds,
        {"your balls, which approach a little faster than the threshold, leave each other with", "m/s", 1e-6}},
       [](Random& random, const Answer& answer) -> Numbers {
         const Real mass = random.between(3, 8), threshold = random.between(Real(0.2), Real(0.4));
         const Real approach = threshold * random.between(Real(0.6), Real(0.9)),
                    e = random.between(Real(0.5), Real(0.9));
         const Solved after = solved(Line{{mass, mass}, {approach, 0}, {e}}, answer, threshold, {0, 1});
         const Real low = random.between(Real(0.03), Real(0.06)), faster = low * random.between(Real(1.1), Real(1.5));
         const Solved bounced = solved(Line{{mass, mass}, {faster, 0}, {e}}, answer, low, {2});
         return {after.speeds[0], after.rounds, bounced.separates};
       }},
      {"this step's gravity is no part of the approach",
       1,
       {{"your ball, which lies still on the ground, leaves with", "m/s", 1e-6},
        {"your ball, which lands, leaves with", "m/s", 1e-6},
        {"your ball, which comes down slowly, leaves with", "m/s", 1e-6},
        {"your ball, which lies still while two others meet, leaves with", "m/s", 1e-6}},
       [](Random& random, const Answer& answer) -> Numbers {
         const Real mass = random.between(3, 8), e = random.between(Real(0.5), Real(0.9)), lands = random.between(1, 4);
         const Real slow = random.between(Real(0.38), Real(0.45));  // e times that is more than it falls in a step
         return {on_the_ground(mass, 0, e, answer, 0), on_the_ground(mass, -lands, e, answer, 1),
                 on_the_ground(mass, -slow, e, answer, 2, Real(0.5)), beside_two_that_meet(random, answer)};
       }},
  };
}

/// A round of the chapter's own.
bool right(StepContext& step, const std::vector<Real>& by_forces, Real limit) {
  struct OneRound : SequentialImpacts {
    OneRound(const StepContext& of, const std::vector<Real>& forces, Real least) {
      threshold = least;
      most_rounds = 1;
      for (std::size_t i = 0; i < forces.size(); ++i) bouncing_.push_back({i, of.contacts[i].restitution, forces[i]});
    }
  };
  const std::size_t solved_before = rows_solved;
  OneRound(step, by_forces, limit).start(step);
  return rows_solved > solved_before;
}

/// A mistake is a round with one of these another.
struct Round {
  /// m/s, of row i, at its turn.
  static Real approach(const StepContext& step, std::size_t i, Real by_forces) {
    return step.rows[i].speed() - by_forces;
  }
  static Real restitution(const StepContext& step, std::size_t i) { return step.contacts[i].restitution; }
  static Real impulse(const Row& row, Real e, Real approach) { return -row.effective_mass * (1 + e) * approach; }
  static void apply(Row& row, Real lambda) {
    row.reach(row.impulse + lambda);
    row.lo = row.impulse;
  }
  static bool bounces(Real approach, Real limit) { return approach < -limit; }
  static bool again(bool bounced, bool /*approached*/) { return bounced; }
  static bool turn(const StepContext&, std::size_t) { return true; }
  static Real forces(const std::vector<Real>& by_forces, std::size_t i) { return by_forces[i]; }
  static constexpr bool ends_at_first = false;
};

template <class Mistaken>
bool round_of(StepContext& step, const std::vector<Real>& by_forces, Real limit) {
  bool bounced = false, approached = false;
  for (std::size_t i = 0; i < step.contacts.size(); ++i) {
    const Real approach = Mistaken::approach(step, i, Mistaken::forces(by_forces, i));
    approached = approached || approach < 0;
    if (!Mistaken::bounces(approach, limit) || !Mistaken::turn(step, i)) continue;
    Mistaken::apply(step.rows[i], Mistaken::impulse(step.rows[i], Mistaken::restitution(step, i), approach));
    bounced = true;
    if (Mistaken::ends_at_first) break;
  }
  return Mistaken::again(bounced, approached);
}

struct EForOnePlusE : Round {
  static Real impulse(const Row& row, Real e, Real approach) { return -row.effective_mass * e * approach; }
};
struct Sign : Round {
  static Real impulse(const Row& row, Real e, Real approach) { return -Round::impulse(row, e, approach); }
};
struct TwiceOnePlusE : Round {
  static Real impulse(const Row& row, Real e, Real approach) { return (1 + e) * Round::impulse(row, e, approach); }
};
struct NoE : Round {
  static Real impulse(const Row& row, Real, Real approach) { return Round::impulse(row, 0, approach); }
};
struct TwoE : Round {
  static Real impulse(const Row& row, Real e, Real approach) { return Round::impulse(row, 2 * e - 1, approach); }
};
struct MeanPairs : Round {
  static Real restitution(const StepContext& step, std::size_t) {
    Real sum = 0;
    for (const Contact& contact : step.contacts) sum += contact.restitution;
    return sum / static_cast<Real>(step.contacts.size());
  }
};
struct FirstPairAlone : Round {
  static bool turn(const StepContext&, std::size_t i) { return i == 0; }
};
struct TwoPairsAlone : Round {
  static bool turn(const StepContext&, std::size_t i) { return i < 2; }
};
struct AllButTheLast : Round {
  static bool turn(const StepContext& step, std::size_t i) { return i == 0 || i + 1 < step.contacts.size(); }
};
struct FirstPairsForces : Round {
  static Real forces(const std::vector<Real>& by_forces, std::size_t) { return by_forces[0]; }
};
struct FixedThreshold : Round {
  static bool bounces(Real approach, Real) { return approach < -usual_threshold; }
};
struct MassForgotten : Round {
  static Real impulse(const Row&, Real e, Real approach) { return -(1 + e) * approach; }
};
struct LastPairs : Round {
  static Real restitution(const StepContext& step, std::size_t) { return step.contacts.back().restitution; }
};
struct FirstPairs : Round {
  static Real restitution(const StepContext& step, std::size_t) { return step.contacts.front().restitution; }
};
struct BeforeTheStep : Round {
  static Real approach(const StepContext& step, std::size_t i, Real) {
    return approach_speed(step.world, step.contacts[i]);
  }
};
struct ForcesCountedIn : Round {
  static Real approach(const StepContext& step, std::size_t i, Real) { return step.rows[i].speed(); }
};
struct ForcesTwice : Round {
  static Real approach(const StepContext& step, std::size_t i, Real by_forces) {
    return step.rows[i].speed() + by_forces;
  }
};
struct TakenBack : Round {
  static void apply(Row& row, Real lambda) { row.reach(row.impulse + lambda); }
};
struct SumReplaced : Round {
  static void apply(Row& row, Real lambda) {
    row.reach(lambda);
    row.lo = row.impulse;
  }
};
struct NotKept : Round {
  static void apply(Row& row, Real lambda) { row.apply(lambda); }
};
struct NoThreshold : Round {
  static bool bounces(Real approach, Real) { return approach < 0; }
};
struct AlwaysAgain : Round {
  static bool again(bool, bool) { return true; }
};
struct AgainForSlowOnes : Round {
  static bool again(bool, bool approached) { return approached; }
};
struct NeverAgain : Round {
  static bool again(bool, bool) { return false; }
};
struct EndsAtFirst : Round {
  static constexpr bool ends_at_first = true;
};

/// All approaches first, then all impulses.
bool speeds_of_before_the_round(StepContext& step, const std::vector<Real>& by_forces, Real limit) {
  std::vector<Real> approaches;
  for (std::size_t i = 0; i < step.contacts.size(); ++i) approaches.push_back(Round::approach(step, i, by_forces[i]));
  bool bounced = false;
  for (std::size_t i = 0; i < step.contacts.size(); ++i) {
    if (!Round::bounces(approaches[i], limit)) continue;
    Round::apply(step.rows[i], Round::impulse(step.rows[i], Round::restitution(step, i), approaches[i]));
    bounced = true;
  }
  return bounced;
}

std::vector<Mistake<Answer>> mistakes() {
  const std::string restitution =
      "it looks as if all pairs bounced with the same e, that of one of them or the mean. e belongs to the pair: "
      "step.contacts[i].restitution.";
  const std::string never =
      "it looks as if your rounds never ended by themselves. Give true back only if a pair has bounced in this round: "
      "a pair that rests, leaves, or approaches more slowly than the threshold has not.";
  const std::string some =
      "it looks as if some pairs never had their turn. A round visits each contact once: step.contacts.size() of them.";
  const std::string factor =
      "it looks as if the factor were another than 1 + e. The part v_n / K stops the approach, and e v_n / K makes the "
      "pair separate.";
  return {
      {"(1+e)²", factor, {round_of<TwiceOnePlusE>}},
      {"e left out", factor, {round_of<NoE>}},
      {"2e", factor, {round_of<TwoE>}},
      {"pairs left out", some, {round_of<FirstPairAlone>}},
      {"pairs left out", some, {round_of<TwoPairsAlone>}},
      {"pairs left out", some, {round_of<AllButTheLast>}},
      {"the first pair's forces",
       "it looks as if by_forces[0] counted for all pairs. What gravity adds differs from pair to pair: nothing where "
       "both fall, g h where one lies on the ground. It is by_forces[i].",
       {round_of<FirstPairsForces>}},
      {"a threshold of one's own",
       "it looks as if the threshold were a number of your own. It is given as `threshold`, and may be another in each "
       "world.",
       {round_of<FixedThreshold>}},
      {"forces in the threshold",
       "it looks as if the threshold were compared with a speed that has this step's gravity in it. What only gravity "
       "makes fast is no impact: compare v_n = row.speed() - by_forces[i].",
       {[](StepContext& step, const std::vector<Real>& by_forces, Real limit) {
         bool bounced = false;
         for (std::size_t i = 0; i < step.contacts.size(); ++i) {
           Row& row = step.rows[i];
           if (row.speed() >= -limit) continue;
           const Real approach = Round::approach(step, i, by_forces[i]);
           Round::apply(row, Round::impulse(row, Round::restitution(step, i), approach));
           bounced = true;
         }
         return bounced;
       }}},
      {"another pair's restitution", restitution, {round_of<MeanPairs>}},
      {"another pair's restitution", restitution, {round_of<LastPairs>}},
      {"another pair's restitution", restitution, {round_of<FirstPairs>}},
      {"never ending", never, {round_of<AlwaysAgain>}},
      {"never ending", never, {round_of<AgainForSlowOnes>}},
      {"taken back",
       "it looks as if the sweeps had taken the bounce back. They solve each row for J V = 0, and a pair that bounces "
       "separates faster. Set row.lo = row.impulse, so that they cannot lower the sum.",
       {round_of<TakenBack>}},
      {"the approach of before the step",
       "it looks as if the approach speed were that of before the step. The same approach then bounces again in every "
       "round, and a pair that only another impact makes approach never does. Take row.speed(), at the pair's turn.",
       {round_of<BeforeTheStep>}},
      {"the approach of before the round",
       "it looks as if all approach speeds were measured before the round's first impact. Impacts in sequence: each "
       "pair takes the speeds that the pair before it has left, also within a round.",
       {speeds_of_before_the_round}},
      {"ends after one round",
       "it looks as if there were one round only. A pair that has had its turn may approach again when its neighbour "
       "has bounced; the impact then stops half-way along the row. Give true back if a pair has bounced.",
       {round_of<NeverAgain>}},
      {"a round ends at the first bounce",
       "it looks as if a round ended at its first bounce. It visits all contacts, so an impact may run along the whole "
       "row in one round.",
       {round_of<EndsAtFirst>}},
      {"no threshold",
       "it looks as if there were no threshold. With e < 1 the bounces of a body that comes to rest become ever slower "
       "and have no end. The threshold leaves them to the sweeps.",
       {round_of<NoThreshold>}},
      {"forces counted in",
       "it looks as if this step's gravity were part of the approach. The ball has not fallen by it yet, and a ball at "
       "rest would bounce off the ground by itself. Subtract by_forces[i] from row.speed().",
       {round_of<ForcesCountedIn>}},
      {"sign of by_forces",
       "it looks as if by_forces had the wrong sign. row.speed() already has it in: subtract it.",
       {round_of<ForcesTwice>}},
      {"e for 1 + e",
       "it looks as if the impulse had the factor e. The part v_n / K stops the approach, and e v_n / K makes the pair "
       "separate: together 1 + e.",
       {round_of<EForOnePlusE>}},
      {"sign",
       "it looks as if the impulse had the wrong sign. v_n is negative while bodies approach, so that -(1 + e) v_n / K "
       "pushes them apart.",
       {round_of<Sign>}},
      {"mass forgotten",
       "it looks as if 1/K were forgotten. (1 + e) v_n is a change of speed; times the effective mass it is an "
       "impulse.",
       {round_of<MassForgotten>}},
      {"the sum replaced",
       "it looks as if the second impact of a pair replaced its first. row.reach takes the sum of all: row.impulse "
       "plus the new impulse.",
       {round_of<SumReplaced>}},
      {"not kept",
       "it looks as if the row did not know of its impact. The bodies have felt it, row.impulse says 0: friction and "
       "the next step read it there. Use row.reach.",
       {round_of<NotKept>}},
  };
}

}  // namespace

Numbers play(std::size_t check, Random& random, const Answer& answer) {
  return checks()[check].play(random, answer);
}

Exercise exercise() {
  return exercise_of<Answer>(
      "sequential impacts",
      {"Go over all contacts. v_n = row.speed() - by_forces[i]. Pass over those with v_n >= -threshold.",
       "The new sum is the old one plus the impulse of this impact: row.reach(row.impulse - row.effective_mass * (1 + "
       "e) * v_n). Then row.lo = row.impulse.",
       "A bool says whether any pair has bounced: false before the loop, true at each impact, and given back at the "
       "end."},
      checks(), {right}, mistakes());
}

}  // namespace pushback::exercise_09
