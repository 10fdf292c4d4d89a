#include "pushback/chapters/13_joints/distance.h"
#include "pushback/chapters/14_joints_under_load/exercise/asked.h"
#include "pushback/chapters/14_joints_under_load/split_joints.h"
#include "pushback/common/exercise/shown.h"

namespace pushback::exercise_14 {

namespace {

struct Held : AnyEffect, HoldsJoints {};

/// Loads below each other on rods of 1 m, at rest, each rod too long by its gap.
struct Chain {
  World world;
  Solver<Held> solver;
  Real h;

  Chain(Random& random, const Answer& answer)
      : solver(with_effect<Solver<Held>>(answer.joints)), h(1 / random.between(25, 40)) {}
  void hang(Real mass, Real gap) {
    const int above = static_cast<int>(world.bodies.size()) - 1;
    const Vec3 from = above < 0 ? Vec3::Zero() : world.bodies.back().position, to = from - Vec3(0, 1 + gap, 0);
    const int load = world.add(sphere(Real(0.1), mass).at(to));
    world.joints.push_back(distance(world, above < 0 ? the_world : above, from, load, to, 1));
  }
  void step(Real seconds, int sweeps, const std::vector<std::size_t>& quantities = {}) {
    world.step(solver, seconds, sweeps);
    show(world, quantities);
  }
  Real rises(std::size_t load) const { return world.bodies[load].velocity.y(); }
  /// What the next step starts from, N s.
  Real remembered(std::size_t joint) const {
    const std::vector<Real>& kept = world.joints[joint].impulses;
    return kept.empty() ? 0 : -kept[0];
  }
  /// By how much the last load hangs too low, m.
  Real too_low() const { return -world.bodies.back().position.y() - static_cast<Real>(world.bodies.size()); }
};

std::vector<Check<Answer>> checks() {
  return {
      {"a load that hangs too low comes up at β C / h",
       1,
       {{"your load, which hangs too low, comes up with", "m/s", 1e-6},
        {"your load, which hangs too high, goes down with", "m/s", 1e-6}},
       [](Random& random, const Answer& answer) -> Numbers {
         Chain chain(random, answer), high(random, answer);
         chain.hang(random.between(5, 20), random.between(Real(0.01), Real(0.05)));
         high.hang(random.between(5, 20), -random.between(Real(0.01), Real(0.05)));
         chain.step(chain.h, 5, {0});
         high.step(high.h, 5, {1});
         return {chain.rises(0), -high.rises(0)};
       }},
      {"the next step starts from the impulse that carries the load",
       2,
       {{"your rod carries its load and closes a gap; the next step starts from an impulse of", "N s", 1e-6},
        {"your rod is too short and carries its load; the next step starts from an impulse of", "N s", 1e-6},
        {"your rod carries its load in a second, longer step; the next starts from an impulse of", "N s", 1e-6}},
       [](Random& random, const Answer& answer) -> Numbers {
         Chain chain(random, answer), high(random, answer);
         chain.hang(random.between(5, 20), random.between(Real(0.03), Real(0.06)));
         high.hang(random.between(5, 20), -random.between(Real(0.03), Real(0.06)));
         chain.step(chain.h, 5, {0});
         high.step(high.h, 5, {1});
         const Real first = chain.remembered(0);
         chain.step(chain.h * random.between(Real(1.2), Real(1.5)), 5, {2});
         return {first, high.remembered(0), chain.remembered(0)};
       }},
      {"a gap is closed by as many sweeps as a load is carried",
       2,
       {{"the upper one of your two loads comes up with", "m/s", 1e-6},
        {"the lower one of your two loads comes up with", "m/s", 1e-6},
        {"for your upper rod the next step starts from an impulse of", "N s", 1e-5}},
       [](Random& random, const Answer& answer) -> Numbers {
         Chain chain(random, answer);
         const Real upper = random.between(2, 4);
         chain.hang(upper, random.between(Real(0.01), Real(0.05)));
         chain.hang(upper * random.between(2, 4), random.between(Real(0.01), Real(0.05)));
         chain.step(chain.h, 3);
         return {chain.rises(0), chain.rises(1), chain.remembered(0)};
       }},
      {"a chain with a heavy load holds",
       1,
       {{"after half a second your heavy load hangs too low by", "mm", 1e-3}},
       [](Random& random, const Answer& answer) -> Numbers {
         Chain chain(random, answer);
         for (int link = 0; link < 3; ++link) chain.hang(1, 0);
         chain.hang(random.between(10, 20), random.between(Real(0.02), Real(0.04)));
         Numbers too_low{1000 * chain.too_low()};
         for (int step = 0; step < 15; ++step) {
           chain.step(chain.h, 5);
           too_low.push_back(1000 * chain.too_low());
         }
         return with_record({too_low.back()}, too_low);
       }},
  };
}

/// A mistake: the part of b that it takes out at first, the part that it puts in then, how many sweeps it adds, and which
/// impulses it remembers.
enum class Remembers { load, all, nothing };
struct Mistaken : WarmJoints {
  std::function<Real(Real beta, Real h, Real c)> out, in;
  std::function<int(int)> again;
  Remembers remembers = Remembers::load;
  int rounds = 0;

  Mistaken(auto takes_out, auto puts_in, std::function<int(int)> how_often, Remembers what)
      : out(takes_out), in(puts_in), again(std::move(how_often)), remembers(what) {}
  void build(StepContext& step) {
    WarmJoints::build(step);
    rounds = 0;
    for (JointRow& row : joint_rows_) row.bias -= out(beta, step.dt, row.separation);
  }
  void sweep(StepContext& step) {
    WarmJoints::sweep(step);
    ++rounds;
  }
  void finish(StepContext& step) {
    if (remembers == Remembers::load) remember(step);
    for (JointRow& row : joint_rows_) row.bias += in(beta, step.dt, row.separation);
    for (int i = 0; i < again(rounds); ++i) WarmJoints::sweep(step);
  }
  void report(StepContext& step) {
    if (remembers == Remembers::all) remember(step);
  }
};

std::vector<Mistake<Answer>> mistakes() {
  const auto push = [](Real beta, Real h, Real c) { return beta / h * c; };
  const auto none = [](Real, Real, Real) { return Real(0); };
  const auto negative = [](Real beta, Real h, Real c) { return -beta / h * c; };
  const auto as_often = [](int rounds) { return rounds; };
  const auto never = [](int) { return 0; };
  const auto answer = [](const auto& out, const auto& in, const auto& again, Remembers remembers) {
    return Answer{Mistaken(out, in, again, remembers)};
  };
  const std::string remembered =
      "it looks as if the push were remembered. The push closes its gap within this step; the next step would begin "
      "with the same push, and throw the load up once more.";
  const std::string left_out =
      "it looks as if the sweeps of the push were left out. The load is carried, but nothing closes a gap.";
  const std::string sign =
      "it looks as if the push had the wrong sign. build takes β/h C out of b, and finish puts it back.";
  const auto absolute = [](Real beta, Real h, Real c) { return beta / h * std::abs(c); };
  const auto twice = [](Real beta, Real h, Real c) { return beta / (h * h) * c; };
  const auto only_low = [](Real beta, Real h, Real c) { return beta / h * std::max(Real(0), c); };
  const std::string another =
      "it looks as if the push had not as many sweeps as the load. It has to go along the whole chain as the load did: "
      "rounds_ times.";
  return {
      {"a push of |C|",
       "it looks as if the push did not ask whether a rod is too long or too short. C has a sign, and the push goes "
       "back by it.",
       answer(absolute, absolute, as_often, Remembers::load)},
      {"only rods that are too long",
       "it looks as if only rods that are too long were pushed back. A rod is an equality: too short is an error as "
       "well.",
       answer(push, only_low, as_often, Remembers::load)},
      {"β/h² in b", "it looks as if C were divided by h twice. In b there is β/h C, a speed: take out just that.",
       answer(twice, twice, as_often, Remembers::load)},
      {"β/h² in b", "it looks as if C were divided by h twice. In b there is β/h C, a speed: put back just that.",
       answer(push, twice, as_often, Remembers::load)},
      {"another number of rounds", another,
       answer(
           push, push, [](int rounds) { return 2 * rounds; }, Remembers::load)},
      {"another number of rounds", another,
       answer(
           push, push, [](int) { return 5; }, Remembers::load)},
      {"another number of rounds", another,
       answer(
           push, push, [](int) { return 10; }, Remembers::load)},
      {"the push remembered", remembered, answer(none, none, never, Remembers::all)},
      {"the push remembered", remembered, answer(push, push, as_often, Remembers::all)},
      {"the push remembered", remembered, answer(none, none, as_often, Remembers::load)},
      {"its rounds left out", left_out, answer(push, push, never, Remembers::load)},
      {"one round only",
       "it looks as if the push had one sweep only. A push has to go along the whole chain as the load did: by as many "
       "sweeps as there have been.",
       answer(
           push, push, [](int) { return 1; }, Remembers::load)},
      {"the push not put back",
       "it looks as if b stayed without its push. The second half of the sweeps then solves the same equations once "
       "more.",
       answer(push, none, as_often, Remembers::load)},
      {"sign of the push", sign, answer(push, negative, as_often, Remembers::load)},
      {"sign of the push", sign, answer(negative, negative, as_often, Remembers::load)},
      {"nothing remembered",
       "it looks as if nothing were remembered. Each step then carries the load from the beginning, and a heavy one is "
       "too much for its few sweeps.",
       answer(push, push, as_often, Remembers::nothing)},
      {"1/h forgotten",
       "it looks as if 1/h were forgotten: β C is a length. Nearly all of the push β/h C stays in b, and is "
       "remembered.",
       answer([](Real beta, Real, Real c) { return beta * c; }, [](Real beta, Real, Real c) { return beta * c; },
              as_often, Remembers::load)},
      {"β forgotten",
       "it looks as if β were forgotten in what is taken out of b. In b there is β/h C: with C/h out, it asks for the "
       "gap to grow.",
       answer([](Real, Real h, Real c) { return c / h; }, [](Real, Real h, Real c) { return c / h; }, as_often,
              Remembers::load)},
  };
}

}  // namespace

Numbers play(std::size_t check, Random& random, const Answer& answer) {
  return checks()[check].play(random, answer);
}

Exercise exercise() {
  return exercise_of<Answer>(
      "a split impulse for a chain",
      {"The push of a row is beta / step.dt * row.separation. Without it, b asks only that the gap grow no more.",
       "finish has two parts of an impulse to keep apart: the impulses that the rows have now carry the load. All that "
       "is added once the push is back in b closes the gap.",
       "finish: remember; put the push back; WarmJoints::sweep(step) rounds_ times. report: nothing, or it would "
       "remember once more."},
      checks(), {SplitJoints{}}, mistakes(), {{3, {"how much too low your heavy load hangs", "mm", "step"}}});
}

}  // namespace pushback::exercise_14
