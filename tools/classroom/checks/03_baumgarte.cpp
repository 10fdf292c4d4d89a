#include "pushback/chapters/02_clamping/clamping.h"
#include "pushback/chapters/03_baumgarte/exercise/asked.h"
#include "pushback/common/exercise/shown.h"

namespace pushback::exercise_03 {

namespace {

struct Capped : Effect {
  Answer answer{};
  Real beta = Real(0.2), cap = 3, asked = 0;
  void build(StepContext& step) {
    for (Row& row : step.rows) {
      row.bias = -asked;
      answer.push_out(row, beta, cap, step.dt);
    }
  }
};

/// A ball without weight, `depth` deep in the ground, and above it where that is negative: its speed after the step, m/s.
struct Ball {
  Real depth, h, beta, cap, asked = 0, speed = 0;

  Real solved(Random& random, const Answer& answer, std::size_t quantity) const {
    World world;
    const Real radius = random.between(Real(0.3), Real(0.5));
    world.gravity.setZero();
    world.add(ground());
    world.add(sphere(radius, random.between(5, 20)).at({0, radius - depth, 0}).moving({0, speed, 0}));
    world.contacts = {{.point = {0, -depth / 2, 0}, .normal = {0, 1, 0}, .depth = depth, .id = {0, 1, 0}}};
    Solver<Clamping, Capped> solver;
    static_cast<Capped&>(solver) = {{}, answer, beta, cap, asked};
    solver.solve(world, h, 1);
    show(world, {quantity});
    return world.bodies[1].velocity.y();
  }
};

/// With β d / h = `speed`.
Ball ball_wanting(Random& random, Real speed, Real cap) {
  const Real h = 1 / random.between(50, 240), beta = random.between(Real(0.1), Real(0.3));
  return {speed * h / beta, h, beta, cap};
}

std::vector<Check<Answer>> checks() {
  return {
      {"a shallow ball leaves at β d / h, as without a cap",
       1,
       {{"your shallow ball leaves with", "m/s", 1e-6},
        {"your very shallow ball leaves with", "m/s", 1e-6},
        {"your shallow ball leaves in a long step with", "m/s", 1e-6}},
       [](Random& random, const Answer& answer) -> Numbers {
         const Real cap = random.between(1, 3);
         Ball shallow = ball_wanting(random, cap * random.between(Real(0.2), Real(0.8)), cap);
         shallow.speed = -random.between(1, 3);
         const Ball very = ball_wanting(random, cap * random.between(Real(0.001), Real(0.003)), cap);
         // In metres it is less deep than the cap is fast in m/s.
         Ball slow = ball_wanting(random, cap * random.between(Real(0.2), Real(0.3)), cap);
         const Real longer = random.between(Real(0.2), Real(0.3));
         slow.depth *= longer / slow.h;
         slow.h = longer;
         return {shallow.solved(random, answer, 0), very.solved(random, answer, 1), slow.solved(random, answer, 2)};
       }},
      {"a deep ball leaves at the cap",
       2,
       {{"your deep ball leaves with", "m/s", 1e-6},
        {"your ball, which is more than a metre deep, leaves with", "m/s", 1e-6}},
       [](Random& random, const Answer& answer) -> Numbers {
         const Real cap = random.between(Real(0.5), 1);
         const Ball deep = ball_wanting(random, cap * random.between(Real(1.5), 3), cap);
         Ball lost = deep;
         lost.depth = random.between(Real(1.2), 2);
         return {deep.solved(random, answer, 0), lost.solved(random, answer, 1)};
       }},
      {"a ball that is to bounce faster than the cap does",
       2,
       {{"your ball, which is to bounce faster than the cap, leaves with", "m/s", 1e-6},
        {"your ball, which is to bounce more slowly than it is pushed out, leaves with", "m/s", 1e-6},
        {"your ball, which is to bounce below the cap and is hardly deep, leaves with", "m/s", 1e-6}},
       [](Random& random, const Answer& answer) -> Numbers {
         const Real cap = random.between(Real(0.5), 1);
         Ball fast = ball_wanting(random, cap * 2, cap), slow = ball_wanting(random, cap * Real(0.8), cap);
         Ball shallow = ball_wanting(random, cap * random.between(Real(0.1), Real(0.3)), cap);
         fast.asked = cap * random.between(Real(2.5), 4);
         slow.asked = cap * random.between(Real(0.1), Real(0.6));
         shallow.asked = cap * random.between(Real(0.4), Real(0.9));
         return {fast.solved(random, answer, 0), slow.solved(random, answer, 1), shallow.solved(random, answer, 2)};
       }},
      {"a ball that is still apart goes its way, and is not let in",
       1,
       {{"your ball, which is still above the ground and leaving, leaves with", "m/s", 1e-6},
        {"your ball, which is still above the ground and coming nearer, goes on with", "m/s", 1e-6},
        {"your ball, which is still above the ground and is to bounce, leaves with", "m/s", 1e-6}},
       [](Random& random, const Answer& answer) -> Numbers {
         const Real cap = random.between(Real(0.5), 1);
         Ball leaving = ball_wanting(random, -cap * 2, cap), coming = leaving;
         leaving.speed = cap * random.between(Real(0.1), Real(0.4));
         coming.speed = -cap * 5;
         Ball bouncing = leaving;
         bouncing.speed = 0;
         bouncing.asked = cap * random.between(Real(0.5), 2);
         return {leaving.solved(random, answer, 0), coming.solved(random, answer, 1),
                 bouncing.solved(random, answer, 2)};
       }},
  };
}

std::vector<Mistake<Answer>> mistakes() {
  const std::string everything =
      "it looks as if the cap were on all of b. It is for the push-out alone: a bounce is as fast as it is.";
  const std::string apart =
      "it looks as if points that are still apart were pushed, too. Where C > 0 there is no overlap to undo.";
  const std::string lost =
      "it looks as if b were simply overwritten. Cap the push-out first, then keep the lesser of it and of the b that "
      "is there.";
  return {
      {"h for 1/h",
       "it looks as if β d were multiplied by h. A distance divided by a time is a speed: β d / h.",
       {[](Row& row, Real beta, Real cap, Real h) {
         row.bias = std::min(row.bias, std::max(-cap, beta * h * row.separation));
       }}},
      {"1/h forgotten",
       "it looks as if 1/h were forgotten. β d is a distance; to cover it within one step, the speed is β d / h.",
       {[](Row& row, Real beta, Real cap, Real) {
         row.bias = std::min(row.bias, std::max(-cap, beta * row.separation));
       }}},
      {"β/h²",
       "it looks as if β d were divided by h twice, so that nearly all is at the cap. A distance divided by a time is "
       "a speed: β d / h.",
       {[](Row& row, Real beta, Real cap, Real h) {
         row.bias = std::min(row.bias, std::max(-cap, beta / (h * h) * row.separation));
       }}},
      {"β forgotten",
       "it looks as if β were forgotten. One step is to take away the part β of the overlap, not all of it.",
       {[](Row& row, Real, Real cap, Real h) { row.bias = std::min(row.bias, std::max(-cap, row.separation / h)); }}},
      {"wishes added",
       "it looks as if the wishes were added up. Each is a speed that is enough for its effect: keep the lesser b, by "
       "min.",
       {[](Row& row, Real beta, Real cap, Real h) {
         row.bias += std::min(Real(0), std::max(-cap, beta / h * row.separation));
       }}},
      {"max for min",
       "it looks as if the greater b were kept, by max. b is minus a speed: of two wishes the lesser b is the one for "
       "more speed.",
       {[](Row& row, Real beta, Real cap, Real h) {
         row.bias = std::max(row.bias, std::max(-cap, beta / h * row.separation));
       }}},
      {"sign of the push-out",
       "it looks as if the push-out had the wrong sign. C is negative where bodies overlap, and so is b = β/h C: minus "
       "the wanted speed.",
       {[](Row& row, Real beta, Real cap, Real h) {
         row.bias = std::min(row.bias, std::max(-cap, -beta / h * row.separation));
       }}},
      {"the cap by h",
       "it looks as if the cap were multiplied by h. It is a speed already, in m/s, as β d / h is.",
       {[](Row& row, Real beta, Real cap, Real h) {
         row.bias = std::min(row.bias, std::max(-cap * h, beta / h * row.separation));
       }}},
      {"the speed taken off",
       "it looks as if the ball's own speed were taken off b. The solver compares b with J V by itself: b is minus the "
       "speed that is wanted, however fast the ball is.",
       {[](Row& row, Real beta, Real cap, Real h) {
         row.bias = std::min(row.bias, std::max(-cap, beta / h * row.separation - row.speed()));
       }}},
      {"no b for points that are apart",
       "it looks as if b became 0 where the points are apart. A bounce may have asked for a speed there: leave its b "
       "as it is.",
       {[](Row& row, Real beta, Real cap, Real h) {
         row.bias = row.separation < 0 ? std::min(row.bias, std::max(-cap, beta / h * row.separation)) : 0;
       }}},
      {"a push-out only where nothing else is asked",
       "it looks as if the push-out counted only where no other effect asks for a speed. Of two wishes, the one for "
       "more speed stays: the lesser b, by min.",
       {[](Row& row, Real beta, Real cap, Real h) {
         if (row.bias == 0) row.bias = std::min(row.bias, std::max(-cap, beta / h * row.separation));
       }}},
      {"cap forgotten",
       "it looks as if there were no cap. Below it all is as in chapter 03, above it the speed is the cap's.",
       {[](Row& row, Real beta, Real, Real h) { row.bias = std::min(row.bias, beta / h * row.separation); }}},
      {"cap on everything", everything, {[](Row& row, Real beta, Real cap, Real h) {
         row.bias = std::max(-cap, std::min(row.bias, beta / h * row.separation));
       }}},
      {"a depth capped",
       "it looks as if the cap were compared with a depth. It is a speed: cap β d / h, not d.",
       {[](Row& row, Real beta, Real cap, Real h) {
         row.bias = std::min(row.bias, beta / h * std::max(-cap, row.separation));
       }}},
      {"always at the cap",
       "it looks as if every push-out were at least as fast as the cap. A cap is the most: the greater of two negative "
       "b.",
       {[](Row& row, Real beta, Real cap, Real h) {
         row.bias = std::min({row.bias, -cap, beta / h * row.separation});
       }}},
      {"always at the cap",
       "it looks as if every push-out were as fast as the cap. A cap is the most: below it, the speed is β d / h.",
       {[](Row& row, Real, Real cap, Real) { row.bias = row.separation < 0 ? std::min(row.bias, -cap) : row.bias; }}},
      {"sign of the cap",
       "it looks as if the cap had the wrong sign. b is minus a speed: it is capped at -cap.",
       {[](Row& row, Real beta, Real cap, Real h) {
         row.bias = std::min(row.bias, std::max(cap, beta / h * row.separation));
       }}},
      {"deep ones left in",
       "it looks as if what would be too fast were not pushed at all. It is to be pushed at the cap.",
       {[](Row& row, Real beta, Real cap, Real h) {
         const Real b = beta / h * row.separation;
         if (b >= -cap) row.bias = std::min(row.bias, b);
       }}},
      {"min forgotten", lost, {[](Row& row, Real beta, Real cap, Real h) {
         row.bias = std::max(-cap, beta / h * row.separation);
       }}},
      {"min forgotten", lost, {[](Row& row, Real beta, Real cap, Real h) {
         row.bias = std::max(-cap, beta / h * std::min(Real(0), row.separation));
       }}},
      {"a push on points that are apart", apart, {[](Row& row, Real beta, Real cap, Real h) {
         row.bias = std::min(row.bias, std::max(-cap, -beta / h * std::abs(row.separation)));
       }}},
  };
}

void right(Row& row, Real beta, Real cap, Real h) {
  row.bias = std::min(row.bias, std::max(-cap, beta / h * row.separation));
}

}  // namespace

Numbers play(std::size_t check, Random& random, const Answer& answer) {
  return checks()[check].play(random, answer);
}

Exercise exercise() {
  return exercise_of<Answer>(
      "a push-out with a cap on its speed",
      {"A cap is the most that the push-out may ask for. Which of the two speeds, β d / h and the cap, is it?",
       "b is minus a speed, so the lesser of two speeds is the greater of two negative b.",
       "The cap is on the push-out alone. First cap it, then compare it with the b that is there."},
      checks(), {right}, mistakes());
}

}  // namespace pushback::exercise_03
