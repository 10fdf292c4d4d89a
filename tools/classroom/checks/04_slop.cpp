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

/// A ball so deep in the ground, under gravity.
struct Ball {
  World world;
  Real radius;

  Ball(Random& random, Real depth) : radius(random.between(Real(0.3), Real(0.5))) {
    world.add(ground());
    world.add(sphere(radius, random.between(5, 20)).at({0, -depth, 0}));
    world.bodies[1].position.y() += radius;
  }
  /// mm
  Real depth() const { return 1000 * (radius - world.bodies[1].position.y()); }
  /// mm, at the start and after each step.
  Numbers depths(const Answer& answer, int steps) {
    auto solver = with_effect<Pushing>(answer.allowance);
    Numbers found{depth()};
    for (int step = 0; step < steps; ++step) {
      world.step(solver, Real(1) / 60, 4);
      found.push_back(depth());
    }
    return found;
  }
};

/// Its depth after half a second, then at the start and after each step.
Numbers half_a_second(Ball ball, const Answer& answer) {
  const Numbers depths = ball.depths(answer, 30);
  return with_record({depths.back()}, depths);
}

std::vector<Check<Answer>> checks() {
  return {
      {"a deep ball comes up at β (d − slop) / h",
       1,
       {{"your deep ball comes up with", "m/s", 1e-6}},
       [](Random& random, const Answer& answer) -> Numbers {
         Ball ball(random, random.between(Real(0.012), Real(0.02)));
         ball.depths(answer, 1);
         return {ball.world.bodies[1].velocity.y()};
       }},
      {"a ball that is less deep than the slop stays where it is",
       1,
       {{"after half a second your shallow ball is deep by", "mm", 1e-6}},
       [](Random& random, const Answer& answer) -> Numbers {
         return half_a_second(Ball(random, random.between(Real(0.001), Real(0.004))), answer);
       }},
      {"a deep ball ends at the slop",
       1,
       {{"after half a second your deep ball is deep by", "mm", 1e-6}},
       [](Random& random, const Answer& answer) -> Numbers {
         return half_a_second(Ball(random, random.between(Real(0.012), Real(0.02))), answer);
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
