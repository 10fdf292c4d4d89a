#include "pushback/chapters/04_slop/exercise/asked.h"
#include "pushback/chapters/04_slop/slop.h"
#include "pushback/common/exercise/shown.h"

namespace pushback::exercise_04 {

namespace {

constexpr Real slop = Slop{}.slop;

using Pushing = Solver<Clamping, Baumgarte, AnyEffect>;

/// A ball so deep in the ground, under gravity; others may lie beside it. Steps are long enough for gravity to slow it as fast as
/// the push-out does: it does not fly past the slop.
struct Ball {
  World world;
  Real radius, h;

  Ball(Random& random, Real depth) : radius(random.between(Real(0.3), Real(0.5))), h(1 / random.between(70, 110)) {
    world.add(ground());
    add(random.between(5, 20), depth);
  }
  void add(Real mass, Real depth) {
    world.add(sphere(radius, mass).at({2 * static_cast<Real>(world.bodies.size()), radius - depth, 0}));
  }
  /// mm
  Real depth() const { return 1000 * (radius - world.bodies[1].position.y()); }
  /// mm, at the start and after each step.
  Numbers depths(const Answer& answer, int steps) {
    auto solver = with_effect<Pushing>(answer.allowance);
    Numbers found{depth()};
    for (int step = 0; step < steps; ++step) {
      world.step(solver, h, 4);
      show(world);
      found.push_back(depth());
    }
    return found;
  }
};

/// Its depth after thirty steps, then at the start and after each.
Numbers thirty_steps(Ball ball, const Answer& answer) {
  const Numbers depths = ball.depths(answer, 30);
  return with_record({depths.back()}, depths);
}

std::vector<Check<Answer>> checks() {
  return {
      {"a deep ball comes up at β (d − slop) / h",
       1,
       {{"your deep ball comes up with", "m/s", 1e-6},
        {"your second deep ball, beside it, comes up with", "m/s", 1e-6},
        {"your third deep ball comes up with", "m/s", 1e-6}},
       [](Random& random, const Answer& answer) -> Numbers {
         Ball balls(random, random.between(Real(0.012), Real(0.02)));
         for (int i = 0; i < 2; ++i) balls.add(random.between(5, 20), random.between(Real(0.012), Real(0.02)));
         balls.depths(answer, 1);
         const auto& bodies = balls.world.bodies;
         return {bodies[1].velocity.y(), bodies[2].velocity.y(), bodies[3].velocity.y()};
       }},
      {"a ball that is less deep than the slop stays where it is",
       1,
       {{"after thirty steps your shallow ball is deep by", "mm", 1e-6}},
       [](Random& random, const Answer& answer) -> Numbers {
         return thirty_steps(Ball(random, random.between(Real(0.001), Real(0.0025))), answer);
       }},
      {"a deep ball ends at the slop",
       1,
       {{"after thirty steps your deep ball is deep by", "mm", 1e-6}},
       [](Random& random, const Answer& answer) -> Numbers {
         return thirty_steps(Ball(random, random.between(Real(0.012), Real(0.02))), answer);
       }},
  };
}

/// A mistake is what it makes of C.
template <class Separation>
struct Mistaken : Effect {
  Separation separation;
  void adjust_separation(StepContext& step) {
    for (std::size_t i = 0; i < step.contacts.size(); ++i)
      step.rows[i].separation = separation(step.rows[i].separation);
  }
};
template <class Separation>
Answer mistaken(Separation separation) {
  return {Mistaken<Separation>{{}, separation}};
}

struct OfTheFirst : Effect {
  void adjust_separation(StepContext& step) {
    if (!step.contacts.empty()) step.rows[0].separation = std::min(Real(0), step.rows[0].separation + slop);
  }
};
struct TimesSixtyH : Effect {
  void adjust_separation(StepContext& step) {
    for (std::size_t i = 0; i < step.contacts.size(); ++i)
      step.rows[i].separation = std::min(Real(0), step.rows[i].separation + 60 * step.dt * slop);
  }
};

struct TimesH : Effect {
  void adjust_separation(StepContext& step) {
    for (std::size_t i = 0; i < step.contacts.size(); ++i)
      step.rows[i].separation = std::min(Real(0), step.rows[i].separation + step.dt * slop);
  }
};
/// C of the first step, for good.
struct OfTheFirstStep : Effect {
  std::vector<Real> first;
  void adjust_separation(StepContext& step) {
    for (std::size_t i = first.size(); i < step.contacts.size(); ++i)
      first.push_back(std::min(Real(0), step.rows[i].separation + slop));
    for (std::size_t i = 0; i < step.contacts.size(); ++i) step.rows[i].separation = first[i];
  }
};
/// C of the first contact, for all.
struct OneForAll : Effect {
  void adjust_separation(StepContext& step) {
    const Real counts = step.contacts.empty() ? 0 : std::min(Real(0), step.rows[0].separation + slop);
    for (std::size_t i = 0; i < step.contacts.size(); ++i) step.rows[i].separation = counts;
  }
};

std::vector<Mistake<Answer>> mistakes() {
  const std::string nothing =
      "it looks as if nothing were left to push out. C is negative where bodies overlap, and what is pushed out is "
      "what is negative: of 0 and C + slop, the lesser.";
  return {
      {"dead zone",
       "it looks as if the slop were a dead zone: all of C where it is deeper, nothing where it is not. Then what is "
       "pressed past the slop is kicked back at β slop / h. What counts is how much deeper it is, C + slop.",
       mistaken([](Real c) { return c > -slop ? 0 : c; })},
      {"sign",
       "it looks as if the slop had the wrong sign. C is negative where bodies overlap, so C + slop is the lesser "
       "overlap.",
       mistaken([](Real c) { return std::min(Real(0), c - slop); })},
      {"nothing to push out", nothing, mistaken([](Real c) { return std::max(Real(0), c + slop); })},
      {"the depth for C",
       "it looks as if the depth d were taken for C. C = -d: what is pushed out is a negative C, so with d - slop deep "
       "balls stay and shallow ones are pushed out.",
       mistaken([](Real c) { return std::min(Real(0), -c - slop); })},
      {"shallow ones as they were",
       "it looks as if C stayed as it is where the overlap is less than the slop. It still is an overlap that the bias "
       "takes away: there, nothing counts, and C becomes 0.",
       mistaken([](Real c) { return c < -slop ? c + slop : c; })},
      {"no slop",
       "it looks as if there were no slop: C is as it was when the bias is made of it. Is it row.separation that you "
       "set?",
       mistaken([](Real c) { return c; })},
      {"the first contact alone",
       "it looks as if only the first contact had a slop. Each of the first step.contacts.size() rows has a C of its "
       "own.",
       {OfTheFirst{}}},
      {"a slop that depends on the step",
       "it looks as if the slop were multiplied by 60 h. It is a length, and the same in steps of every length.",
       {TimesSixtyH{}}},
      {"slop times h",
       "it looks as if the slop were multiplied by h, so almost nothing is left of it. It is a length: C + slop, in "
       "steps of every length.",
       {TimesH{}}},
      {"the depth of the first step",
       "it looks as if C were that of the first step for good. A ball that comes up is less deep in each step: read "
       "row.separation in each, or it is pushed on past the slop.",
       {OfTheFirstStep{}}},
      {"one C for all",
       "it looks as if all contacts had the C of the first. Each ball has a depth of its own: row.separation of its "
       "own row.",
       {OneForAll{}}},
      {"at least the slop",
       "it looks as if every overlap counted as the slop, at least or at most. What counts is how much deeper it is "
       "than the slop.",
       mistaken([](Real c) { return std::min(c, -slop); })},
      {"at least the slop",
       "it looks as if every overlap counted as the slop, at least or at most. What counts is how much deeper it is "
       "than the slop.",
       mistaken([](Real c) { return std::max(c, -slop); })},
  };
}

}  // namespace

Numbers play(std::size_t check, Random& random, const Answer& answer) {
  return checks()[check].play(random, answer);
}

Exercise exercise() {
  return exercise_of<Answer>(
      "slop",
      {"A depth d up to the slop does not count. Of a greater one, only d - slop does.",
       "In C = -d: the separation that counts is C + slop, as long as that is negative.",
       "row.separation = min(0, C + slop), for each of the first step.contacts.size() rows."},
      checks(), {Slop{}}, mistakes(),
      {{1, {"depth of your shallow ball", "mm", "step"}}, {2, {"depth of your deep ball", "mm", "step"}}});
}

}  // namespace pushback::exercise_04
