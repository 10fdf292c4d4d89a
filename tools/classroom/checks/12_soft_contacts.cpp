#include "pushback/chapters/12_soft_contacts/exercise/asked.h"
#include "pushback/chapters/12_soft_contacts/soft_contacts.h"
#include "pushback/common/exercise/shown.h"

namespace pushback::exercise_12 {

namespace {

/// A ball in the ground, on a spring.
struct Ball {
  World world;
  Real radius;
  Spring spring;

  Ball(Random& random, Real depth) : radius(random.between(Real(0.3), Real(0.5))) {
    spring.h = 1 / random.between(240, 480);
    spring.hertz = random.between(Real(0.5), Real(0.9)) / (8 * spring.h);
    spring.zeta = random.between(1, 5);
    world.add(ground());
    world.add(sphere(radius, random.between(5, 20)).at({0, radius - depth, 0}));
    world.find_contacts();
  }
  Real speed() const { return world.bodies[1].velocity.y(); }
  /// mm
  Real depth() const { return 1000 * (radius - world.bodies[1].position.y()); }
  /// Of the contact that there is.
  Row row() {
    Row row(world, world.contacts[0], world.contacts[0].normal, 0);
    row.separation = -world.contacts[0].depth;
    row.lo = 0;
    return row;
  }
  void visit(Row& row, const Answer& answer, bool relaxing = false) { answer.solve(row, spring, relaxing); }
  /// With the relaxing pass.
  void step(const Answer& answer, const std::vector<std::size_t>& quantities = {}) {
    world.begin_step(spring.h);
    std::vector<Row> rows;
    if (!world.contacts.empty()) rows.push_back(row());
    for (Row& one : rows) visit(one, answer);
    world.move(spring.h);
    for (Row& one : rows) visit(one, answer, true);
    show(world, quantities);
  }
};

Real some_depth(Random& random) {
  return random.between(Real(0.01), Real(0.03));
}

std::vector<Check<Answer>> checks() {
  return {
      {"a ball that is too deep leaves as fast as spring and damper let it",
       1,
       {{"your ball, which weighs nothing and is too deep, leaves with", "m/s", 1e-6},
        {"your ball, which is very deep, leaves with", "m/s", 1e-6},
        {"your ball, which leaves by itself faster than it is pushed, goes on with", "m/s", 1e-6}},
       [](Random& random, const Answer& answer) -> Numbers {
         const Real depth = some_depth(random), leaves = random.between(5, 8);
         Ball ball(random, depth), deep(random, Real(0.25)), leaving(random, depth);
         leaving.world.bodies[1].velocity.y() = leaves;
         for (Ball* one : {&ball, &deep, &leaving}) {
           Row row = one->row();
           one->visit(row, answer);
         }
         show(ball.world, {0});
         show(deep.world, {1});
         show(leaving.world, {2});
         return {ball.speed(), deep.speed(), leaving.speed()};
       }},
      {"more sweeps do not change that, and neither does an initial guess that was too large",
       1,
       {{"after eight sweeps your ball, which weighs nothing and is too deep, leaves with", "m/s", 1e-6},
        {"after an initial guess that was too large your ball leaves with", "m/s", 1e-6}},
       [](Random& random, const Answer& answer) -> Numbers {
         const Real depth = some_depth(random), guess = random.between(1, 2);
         Random again = random;
         Ball ball(random, depth), guessed(again, depth);
         Row row = ball.row(), guessed_row = guessed.row();
         for (int i = 0; i < 8; ++i) ball.visit(row, answer);
         guessed_row.reach(guess * guessed_row.effective_mass * depth / guessed.spring.h);
         guessed.visit(guessed_row, answer);
         show(ball.world, {0});
         show(guessed.world, {1});
         return {ball.speed(), guessed.speed()};
       }},
      {"the relaxing pass takes the push-out back from the velocity, not from the position",
       2,
       {{"when it has moved and relaxed, your ball moves on with", "m/s", 1e-6},
        {"when it has moved and relaxed, your ball has come up by", "mm", 1e-5},
        {"in the relaxing pass your ball, which leaves by itself, goes on with", "m/s", 1e-6},
        {"in the relaxing pass your ball, which falls, goes on with", "m/s", 1e-6}},
       [](Random& random, const Answer& answer) -> Numbers {
         Ball ball(random, some_depth(random));
         ball.world.gravity.setZero();
         const Real before = ball.depth();
         ball.step(answer, {0, 1});
         Numbers numbers{ball.speed(), before - ball.depth()};
         for (const Real upwards : {random.between(1, 2), -random.between(1, 2)}) {
           Ball by_itself(random, some_depth(random));
           by_itself.world.bodies[1].velocity.y() = upwards;
           Row row = by_itself.row();
           by_itself.visit(row, answer, true);
           show(by_itself.world, {numbers.size()});
           numbers.push_back(by_itself.speed());
         }
         return numbers;
       }},
      {"a ball comes to rest at a depth of g/Ω²",
       1,
       {{"your ball, which comes to rest under gravity, ends deep by", "mm", 1e-5},
        {"your ball, which comes to rest, still moves with", "m/s", 1e-6}},
       [](Random& random, const Answer& answer) -> Numbers {
         Ball ball(random, Real(0.001));
         Numbers depths{ball.depth()};
         for (int step = 0; step < 400; ++step) {
           ball.step(answer);
           depths.push_back(ball.depth());
         }
         return with_record({ball.depth(), ball.speed()}, depths);
       }},
  };
}

/// The chapter's own effect, made to solve one row.
void right(Row& row, const Spring& spring, bool relaxing) {
  World world;
  Contacts contacts(1);
  Rows rows{row};
  std::vector<Real> softness(1);
  RelaxingContext step{{world, contacts, rows, spring.h}, softness};
  SoftContacts soft;
  soft.hertz = spring.hertz;
  soft.damping_ratio = spring.zeta;
  soft.fastest_push_out = std::numeric_limits<Real>::infinity();
  soft.build(step);
  soft.start(step);
  if (relaxing) soft.relax(step);
  step.solve(0);
  row.impulse = rows[0].impulse;
}

/// The row of the page, and what can be done wrong in it.
struct Wrong {
  Real b = 1, gamma = 1, relaxed_b = 0, relaxed_gamma = 0;   ///< times the right ones
  Real above = 1, below = 1, relaxed_below = relaxed_gamma;  ///< times gamma, in the numerator and in the denominator
  Real w = 1, zeta = 1;
  bool b_without_h = false, gamma_without_h = false, gamma_without_inner_h = false;
  bool sum_forgotten = false, mass_for_K = false, not_clamped = false;
};

void visit(Row& row, const Spring& spring, bool relaxing, const Wrong& wrong) {
  const Real K = wrong.mass_for_K ? row.effective_mass : 1 / row.effective_mass;
  const Real h = spring.h, w = wrong.w * 2 * pi * spring.hertz, zeta = wrong.zeta * spring.zeta;
  const Real b = w / (2 * zeta + (wrong.b_without_h ? 1 : h) * w) * row.separation;
  const Real gamma = K / ((wrong.gamma_without_h ? 1 : h) * w * (2 * zeta + (wrong.gamma_without_inner_h ? 1 : h) * w));
  const Real asked = row.speed() + (relaxing ? wrong.relaxed_b : wrong.b) * b +
                     (relaxing ? wrong.relaxed_gamma : wrong.gamma * wrong.above) * gamma * row.impulse;
  const Real below = K + (relaxing ? wrong.relaxed_below : wrong.gamma * wrong.below) * gamma;
  const Real sum = (wrong.sum_forgotten ? 0 : row.impulse) - asked / below;
  if (!wrong.not_clamped) return row.reach(sum);
  row.apply(sum - row.impulse);
  row.impulse = sum;
}

std::vector<Mistake<Answer>> mistakes() {
  const std::string h_forgotten =
      "it looks as if the h of 2ζ + hΩ were forgotten. Ω is in 1/s, and 2ζ is a number: without h the push-out takes "
      "about a second, however fast the spring is.";
  const std::string hard =
      "it looks as if there were no γ, or next to none: without its first h it is that small. The contact is hard "
      "then, with a push-out: nothing yields under a load.";
  const std::string one_way =
      "it looks as if the relaxing pass treated a ball that leaves, or one that falls, another way. It is the visit of "
      "a hard contact: J V = 0 with a sum that is 0 or more, so one that falls is stopped, and one that leaves by "
      "itself goes on.";
  return {
      {"not clamped",
       "it looks as if the sum could become negative. Spring and damper of a contact push and never pull: Σλ ≥ 0, as "
       "reach has it.",
       {[](Row& row, const Spring& spring, bool relaxing) { visit(row, spring, relaxing, {.not_clamped = true}); }}},
      {"each correction clamped",
       "it looks as if each correction were clamped, not their sum. What was too much is then never taken back, not "
       "even by the relaxing pass.",
       {[](Row& row, const Spring& spring, bool relaxing) {
         const Real before = row.impulse;
         Row copy = row;
         visit(copy, spring, relaxing, {});
         row.impulse = copy.impulse;
         if (copy.impulse < before) row.reach(before);
       }}},
      {"relaxed in part", one_way, {[](Row& row, const Spring& spring, bool relaxing) {
         if (!relaxing) return visit(row, spring, relaxing, {});
         row.apply(-row.effective_mass * row.speed());
       }}},
      {"relaxed in part", one_way, {[](Row& row, const Spring& spring, bool relaxing) {
         if (!relaxing || row.speed() >= 0) visit(row, spring, relaxing, {});
       }}},
      {"γ in the denominator only",
       "it looks as if γ stood in the denominator only. Then each sweep pushes as if there had been none before, and "
       "many of them make the contact hard. The spring has yielded to the whole sum so far: JV + b + γ Σλ.",
       {[](Row& row, const Spring& spring, bool relaxing) { visit(row, spring, relaxing, {.above = 0}); }}},
      {"γ in the numerator only",
       "it looks as if γ stood in the numerator only. An impulse changes JV by K λ and what the spring asks for by γ "
       "λ: divide by K + γ.",
       {[](Row& row, const Spring& spring, bool relaxing) { visit(row, spring, relaxing, {.below = 0}); }}},
      {"γ forgotten", hard, {[](Row& row, const Spring& spring, bool relaxing) {
         visit(row, spring, relaxing, {.gamma = 0});
       }}},
      {"γ forgotten", hard, {[](Row& row, const Spring& spring, bool relaxing) {
         visit(row, spring, relaxing, {.gamma_without_h = true});
       }}},
      {"h forgotten", h_forgotten, {[](Row& row, const Spring& spring, bool relaxing) {
         visit(row, spring, relaxing, {.b_without_h = true});
       }}},
      {"h forgotten", h_forgotten, {[](Row& row, const Spring& spring, bool relaxing) {
         visit(row, spring, relaxing, {.b_without_h = true, .gamma_without_inner_h = true});
       }}},
      {"h forgotten", h_forgotten, {[](Row& row, const Spring& spring, bool relaxing) {
         visit(row, spring, relaxing, {.b_without_h = true, .gamma_without_h = true, .gamma_without_inner_h = true});
       }}},
      {"1/h for the spring's rate",
       "it looks as if b were C/h: all of the overlap in one step. A spring takes its time: b = Ω / (2ζ + hΩ) C.",
       {[](Row& row, const Spring& spring, bool relaxing) {
         const Real w = 2 * pi * spring.hertz;
         visit(row, spring, relaxing, {.b = (2 * spring.zeta + spring.h * w) / (spring.h * w)});
       }}},
      {"K forgotten in γ",
       "it looks as if K were missing in γ. γ λ is a speed, so γ is in 1/kg, like K. Without it a heavy ball is on a "
       "softer spring than a light one.",
       {[](Row& row, const Spring& spring, bool relaxing) {
         visit(row, spring, relaxing, {.gamma = row.effective_mass});
       }}},
      {"2π forgotten",
       "it looks as if Ω were the hertz. An oscillation goes through an angle of 2π: Ω = 2π hertz, in rad/s.",
       {[](Row& row, const Spring& spring, bool relaxing) { visit(row, spring, relaxing, {.w = 1 / (2 * pi)}); }}},
      {"ζ for 2ζ",
       "it looks as if the damper were half as strong: ζ in the place of 2ζ. c = 2ζΩ/K.",
       {[](Row& row, const Spring& spring, bool relaxing) { visit(row, spring, relaxing, {.zeta = Real(0.5)}); }}},
      {"sign of b",
       "it looks as if b had the wrong sign, or were left out. C is negative where the bodies overlap, and so is b: "
       "the row wants JV = -b.",
       {[](Row& row, const Spring& spring, bool relaxing) { visit(row, spring, relaxing, {.b = -1}); }}},
      {"1/K for K",
       "it looks as if K were row.effective_mass. That is 1/K, in kg.",
       {[](Row& row, const Spring& spring, bool relaxing) { visit(row, spring, relaxing, {.mass_for_K = true}); }}},
      {"the sum forgotten",
       "it looks as if the correction took the place of the sum. reach makes its argument the new sum: Σλ + λ.",
       {[](Row& row, const Spring& spring, bool relaxing) { visit(row, spring, relaxing, {.sum_forgotten = true}); }}},
      {"not relaxed",
       "it looks as if the relaxing pass asked for the same as a sweep. The body keeps the push-out's speed, and a "
       "velocity stays.",
       {[](Row& row, const Spring& spring, bool relaxing) {
         visit(row, spring, relaxing, {.relaxed_b = 1, .relaxed_gamma = 1});
       }}},
      {"the push-out kept",
       "it looks as if the relaxing pass kept b. The bodies have moved by it; what is left of it is energy fed in: b = "
       "0.",
       {[](Row& row, const Spring& spring, bool relaxing) { visit(row, spring, relaxing, {.relaxed_b = 1}); }}},
      {"the softness kept",
       "it looks as if the relaxing pass kept γ. A spring that yields lets a part of the load through: relaxing is for "
       "a hard contact, γ = 0.",
       {[](Row& row, const Spring& spring, bool relaxing) { visit(row, spring, relaxing, {.relaxed_gamma = 1}); }}},
      {"the effective mass not put back",
       "it looks as if the relaxing pass divided by K + γ. A part of the push-out's speed stays then: with γ = 0 the "
       "effective mass is 1/K again.",
       {[](Row& row, const Spring& spring, bool relaxing) { visit(row, spring, relaxing, {.relaxed_below = 1}); }}},
      {"the sum given back",
       "it looks as if relaxing took back all of the sum. Only the push-out's part of it is to go; the rest carries "
       "the ball.",
       {[](Row& row, const Spring& spring, bool relaxing) {
         if (relaxing) row.reach(0);
         else visit(row, spring, relaxing, {});
       }}},
  };
}

}  // namespace

Numbers play(std::size_t check, Random& random, const Answer& answer) {
  return checks()[check].play(random, answer);
}

Exercise exercise() {
  return exercise_of<Answer>(
      "γ and b from hertz and ζ, and the relaxing pass",
      {"Ω = 2π hertz, and K = 1 / row.effective_mass. b = Ω / (2ζ + hΩ) C and γ = K / (hΩ (2ζ + hΩ)).",
       "When relaxing, b = 0 and γ = 0. The rest is the same for both.",
       "The new sum is Σλ + λ, with Σλ = row.impulse and λ = -(JV + b + γ Σλ) / (K + γ): row.reach of that."},
      checks(), {right}, mistakes(), {{3, {"depth of your ball", "mm", "step"}}});
}

}  // namespace pushback::exercise_12
