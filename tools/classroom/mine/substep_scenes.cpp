/// 11 and 12: whole steps of a ball, and single substeps of contacts that are made by hand.
#include "pushback/tools/classroom/mine/scenes.h"
#include "pushback/tools/classroom/mine/touching.h"

namespace pushback {

using namespace touching;

namespace {

// ---- 11 --------------------------------------------------------------------------------------------------------------

Numbers falls(Random& random, const WholeSolver& answer) {
  Ball ball(random, 5, 0);
  const Real before = ball.height();
  ball.step(*answer.make(), 1);
  return {before - ball.height(), ball.body().velocity.y()};
}

/// It arrives in the midst of a step.
Numbers arrives(Random& random, const WholeSolver& answer) {
  const Real speed = random.between(2, 6), gap = random.between(Real(0.3), Real(0.6)) * speed * dt;
  Ball ball(random, gap, speed);
  ball.body().bouncy(random.between(Real(0.5), Real(0.9)));
  ball.step(*answer.make(), 1);
  return {ball.height(), ball.body().velocity.y()};
}

Numbers pushed_out(Random& random, const WholeSolver& answer) {
  Ball ball(random, -random.between(Real(0.01), Real(0.03)), 0);
  const Real before = ball.height();
  ball.step(*answer.make(), 1);
  return {ball.height() - before, ball.body().velocity.y()};
}

Numbers planned(Random&, const WholeSolver& answer) {
  const Plan plan = answer.make()->plan(dt);
  return {static_cast<Real>(plan.detections), static_cast<Real>(plan.all_substeps()), static_cast<Real>(plan.sweeps)};
}

// ---- 12 --------------------------------------------------------------------------------------------------------------

/// s: some so long that the spring has to be less stiff than its 240 Hz.
Real substep_of(Random& random) {
  return 1 / random.between(800, 4000);
}
Real little(Random& random) {
  return random.between(Real(0.003), Real(0.012));
}

Numbers yields(Random& random, const WholeSolver& answer) {
  Pair pair(random, slow(random));
  pair.h = substep_of(random);
  pair.contact().depth = little(random);
  return solved(pair, answer, 1 + few(random));
}

Numbers too_deep(Random& random, const WholeSolver& answer) {
  Pair pair(random, slow(random));
  pair.h = 1 / random.between(1900, 4000);
  pair.contact().depth = random.between(Real(0.04), Real(0.09));
  return solved(pair, answer, 1 + few(random));
}

Numbers bounces_rigid(Random& random, const WholeSolver& answer) {
  Falling pair(random, meeting(random));
  pair.contact().restitution = random.between(Real(0.1), Real(0.2));
  pair.contact().depth = random.between(Real(0.01), Real(0.019));
  return solved(pair, answer, 1 + few(random));
}

Numbers relaxes(Random& random, const WholeSolver& answer) {
  Pair pair(random, slow(random));
  pair.h = substep_of(random);
  pair.contact().depth = little(random);
  pair.substep(*answer.make(), few(random));
  return numbers_of(pair);
}

Numbers relaxes_bounce(Random& random, const WholeSolver& answer) {
  Pair pair(random, meeting(random));
  pair.contact().restitution = random.between(Real(0.3), Real(0.9));
  pair.contact().depth = little(random);
  pair.h = substep_of(random);
  pair.substep(*answer.make(), few(random));
  return numbers_of(pair);
}

/// Bodies that slide while they meet: their rows are somewhere else once they have moved.
Numbers carried(Random& random, const WholeSolver& answer) {
  Pair pair(random, meeting(random));
  pair.h = substep_of(random);
  pair.slide(random.between(3, 6) * random.direction().cross(pair.contact().normal).normalized());
  pair.contact().depth = little(random);
  pair.contact().friction = random.between(Real(0.2), Real(0.8));
  pair.substep(*answer.make(), few(random));
  Numbers numbers = numbers_of(pair);
  numbers.push_back(pair.rubbed());
  numbers.push_back(pair.slip().norm());
  return numbers;
}

Numbers rises(Random& random, const WholeSolver& answer) {
  Ball ball(random, -random.between(Real(0.005), Real(0.015)), 0);
  ball.step(*answer.make(), 4);
  return {ball.height(), ball.body().velocity.y()};
}

}  // namespace

std::vector<CheckOfChapter> checks_of_substeps() {
  const std::vector<int> all{};
  const Quantity height{"your ball is over the ground by", "mm", exact};
  const Quantity speed{"your ball goes up with", "m/s", exact};
  std::vector<Quantity> sliding = of_a_pair;
  sliding.push_back({"your contact keeps an impulse along the surface of", "N s", exact});
  sliding.push_back({"along the surface, the points at which your bodies touched slip with", "m/s", exact});
  return {
      {11,
       all,
       {"a ball falls as far as in 32 steps", 1, {{"in a step, your ball falls by", "mm", exact}, speed}, falls}},
      {11, {21}, {"a ball that arrives in the midst of a step bounces then", 1, {height, speed}, arrives}},
      {11,
       {12},
       {"β/h with the h of a substep", 1, {{"in a step, your ball is pushed out by", "mm", exact}, speed}, pushed_out}},
      {11,
       {21},
       {"the plan: 32 detections, one sweep in each substep",
        1,
        {{"of contacts, a step of yours has so many detections:", "", 0.5},
         {"and so many substeps:", "", 0.5},
         {"and in each so many sweeps:", "", 0.5}},
        planned}},
      {12, {21}, {"an overlap gives way as a spring with a damper does", 1, of_a_pair, yields}},
      {12, {21}, {"who is too deep is pushed out with 3 m/s", 1, of_a_pair, too_deep}},
      {12, {21}, {"who bounces is neither soft nor pushed out", 1, of_a_pair, bounces_rigid}},
      {12, all, {"once it has moved the bodies, the speed of the push-out is gone", 1, of_a_pair, relaxes}},
      {12, all, {"and that of a bounce is not", 1, of_a_pair, relaxes_bounce}},
      {12, all, {"rows are carried to where the bodies are", 1, sliding, carried}},
      {12, all, {"a ball that has sunk in rises", 1, {height, speed}, rises}},
  };
}

}  // namespace pushback
