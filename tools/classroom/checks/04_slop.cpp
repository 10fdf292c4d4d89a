#include "pushback/chapters/04_slop/exercise/asked.h"
#include "pushback/chapters/04_slop/slop.h"

namespace pushback::exercise_04 {

namespace {

constexpr Real slop = Slop{}.slop;

/// Baumgarte's bias as the plain loop has it: whatever C is, also where it is positive.
struct Bias : Effect {
  Real beta = Real(0.2);
  void build(StepContext& step) {
    for (std::size_t i = 0; i < step.contacts.size(); ++i) step.rows[i].bias = beta / step.dt * step.rows[i].separation;
  }
};

using Pushing = Solver<Clamping, Bias, AnyEffect>;

/// A ball so deep in the ground, under gravity; others may lie beside it.
struct Ball {
  World world;
  Real radius, h;

  Ball(Random& random, Real depth) : radius(random.between(Real(0.3), Real(0.5))), h(1 / random.between(80, 240)) {
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
         return thirty_steps(Ball(random, random.between(Real(0.001), Real(0.004))), answer);
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

std::vector<Mistake<Answer>> mistakes() {
  return {
      {"dead zone",
       "it looks as if the slop were a dead zone: all of C where it is deeper, nothing where it is not. Then what is "
       "pressed past "
       "the slop is kicked back at β slop / h. What counts is how much deeper it is, C + slop.",
       mistaken([](Real c) { return c > -slop ? 0 : c; })},
      {"sign",
       "it looks as if the slop had the wrong sign. C is negative where bodies overlap, so C + slop is the lesser "
       "overlap.",
       mistaken([](Real c) { return std::min(Real(0), c - slop); })},
      {"min forgotten",
       "it looks as if min were forgotten. Where the overlap is less than the slop, C + slop is positive, and the row "
       "lets the "
       "body sink until it is as deep as the slop.",
       mistaken([](Real c) { return c + slop; })},
      {"max for min",
       "it looks as if the greater of 0 and C + slop were taken. What is pushed out is what is negative.",
       mistaken([](Real c) { return std::max(Real(0), c + slop); })},
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
