#include "pushback/chapters/05_restitution/exercise/asked.h"
#include "pushback/common/exercise/shown.h"

namespace pushback::exercise_05 {

namespace {

constexpr Real threshold = Real(0.1), yield = 2;  // m/s

/// What the push-out has asked for.
struct Asking : Effect {
  Real speed = 0;  // m/s
  void build(StepContext& step) {
    for (Row& row : step.rows) row.bias = -speed;
  }
};

using Bouncing = Solver<Clamping, Asking, AnyEffect>;

/// A ball that lands.
struct Ball {
  Real e, arrives;  // of slow impacts, of 0 ... 1; m/s
  Real slides = 0, gravity = 0, h = Real(1) / 60, asked = 0;

  /// Its speed upwards after the step, m/s.
  Real solved(const Answer& answer, std::size_t quantity = 0) const {
    World world;
    world.gravity = {0, -gravity, 0};
    world.add(ground());
    world.add(sphere(Real(0.3), 10).at({0, Real(0.299), 0}).moving({slides, -arrives, 0}).bouncy(e));
    auto solver = with_effect<Bouncing>(answer.bounce);
    solver.speed = asked;
    world.step(solver, h, 1);
    show(world, {quantity});
    return world.bodies[1].velocity.y();
  }
  /// Of its kinetic energy.
  Real kept(const Answer& answer) const {
    const Real speed = solved(answer) / arrives;
    return speed * speed;
  }
};

/// A ball of which gravity adds 0.15 to 0.25 m/s in a step, which is more than the threshold.
Ball heavy(Random& random, Real e, Real arrives) {
  return {e, arrives, 0, World::g, 1 / random.between(40, 65)};
}

Real some_e(Random& random) {
  return random.between(Real(0.7), Real(0.9));
}

/// The first is too slow to bounce, the second lands slowly on a ground that is bouncier than it is. Its speed upwards, m/s.
Real second_of_two(Random& random, const Answer& answer) {
  World world;
  world.gravity.setZero();
  world.add(ground().bouncy(some_e(random)));
  for (const bool first : {true, false}) {
    const Real arrives = first ? random.between(Real(0.03), Real(0.09)) : yield * random.between(Real(0.6), Real(0.9));
    Body ball = sphere(Real(0.3), 10);
    ball.at({first ? Real(0) : Real(1), Real(0.299), 0}).moving({0, -arrives, 0});
    world.add(ball.bouncy(first ? Real(0.8) : random.between(Real(0.3), Real(0.5))));
  }
  auto solver = with_effect<Bouncing>(answer.bounce);
  world.step(solver, Real(1) / 60, 1);
  show(world, {2});
  return world.bodies[2].velocity.y();
}

std::vector<Check<Answer>> checks() {
  return {
      {"a slow impact has the restitution of its contact, and gains no energy",
       2,
       {{"of each joule your slow ball keeps", "J", 1e-6},
        {"your ball, which lands a little more slowly than the yield speed, leaves with", "m/s", 1e-6},
        {"your second of two balls, whose ground is bouncier than it is, leaves with", "m/s", 1e-6}},
       [](Random& random, const Answer& answer) -> Numbers {
         const Ball slow{some_e(random), random.between(Real(0.16), Real(0.4))},
             less{some_e(random), yield * random.between(Real(0.6), Real(0.9))};
         return {slow.kept(answer), less.solved(answer, 1), second_of_two(random, answer)};
       }},
      {"above the yield speed e falls with the fourth root of the speed",
       2,
       {{"your fast ball leaves with", "m/s", 1e-6}, {"your very fast ball leaves with", "m/s", 1e-6}},
       [](Random& random, const Answer& answer) -> Numbers {
         const Ball fast{some_e(random), random.between(4, 8)}, faster{some_e(random), random.between(20, 40)};
         return {fast.solved(answer, 0), faster.solved(answer, 1)};
       }},
      {"this step's gravity is no part of the approach",
       2,
       {{"your fast ball, which gravity accelerates as it lands, leaves with", "m/s", 1e-6},
        {"your ball, which lies still, leaves with", "m/s", 1e-6},
        {"your ball, which lands more slowly than the threshold but for gravity, leaves with", "m/s", 1e-6}},
       [](Random& random, const Answer& answer) -> Numbers {
         const Ball lands = heavy(random, some_e(random), random.between(4, 8)),
                    rests = heavy(random, some_e(random), 0),
                    creeps = heavy(random, some_e(random), random.between(Real(0.04), Real(0.09)));
         return {lands.solved(answer, 0), rests.solved(answer, 1), creeps.solved(answer, 2)};
       }},
      {"only the motion along the normal counts",
       1,
       {{"your ball, which slides fast and lands gently, leaves with", "m/s", 1e-6}},
       [](Random& random, const Answer& answer) -> Numbers {
         return {Ball{some_e(random), random.between(Real(0.5), Real(0.9)), random.between(6, 12)}.solved(answer)};
       }},
      {"of the bounce and the push-out, the one for more speed stays",
       2,
       {{"your ball, which is pushed out faster than it bounces, leaves with", "m/s", 1e-6},
        {"your ball, which bounces faster than it is pushed out, leaves with", "m/s", 1e-6},
        {"your ball, which is too slow to bounce and is pushed out, leaves with", "m/s", 1e-6}},
       [](Random& random, const Answer& answer) -> Numbers {
         Ball more{some_e(random), random.between(4, 8)}, less{some_e(random), random.between(4, 8)};
         more.asked = more.arrives * random.between(Real(1.2), 2);
         less.asked = less.arrives * random.between(Real(0.05), Real(0.2));
         Ball slow{some_e(random), random.between(Real(0.03), Real(0.09))};
         slow.asked = random.between(Real(0.3), Real(0.6));
         return {more.solved(answer, 0), less.solved(answer, 1), slow.solved(answer, 2)};
       }},
      {"what arrives more slowly than the threshold stays, what arrives faster bounces",
       1,
       {{"your ball, which arrives more slowly than the threshold, leaves with", "m/s", 1e-6},
        {"your ball, which slides fast and arrives more slowly than the threshold, leaves with", "m/s", 1e-6},
        {"your ball, which arrives a little faster than the threshold, leaves with", "m/s", 1e-6}},
       [](Random& random, const Answer& answer) -> Numbers {
         const Ball slow{some_e(random), random.between(Real(0.03), Real(0.09))},
             faster{some_e(random), threshold * random.between(Real(1.02), Real(1.1))};  // whose e v is below it
         Ball sliding = slow;
         sliding.slides = random.between(2, 4);
         return {slow.solved(answer, 0), sliding.solved(answer, 1), faster.solved(answer, 2)};
       }},
  };
}

/// A bounce is which speed is that of the approach, on which speed e depends, by which law, and what it makes of b.
struct Bounce : Effect {
  using Speed = Real (*)(const StepContext&, const Row&, const Contact&);  // m/s
  Speed approach, impact;  // the first is negative where bodies approach
  Real (*law)(Real e, Real speed);
  Real (*bias)(Real b, Real bounce);  // `bounce`: e v_n
  Real limit = threshold;

  void build(StepContext& step) {
    for (std::size_t i = 0; i < step.contacts.size(); ++i) {
      Row& row = step.rows[i];
      const Contact& at = step.contacts[i];
      const Real v = approach(step, row, at);
      if (v < -limit) row.bias = bias(row.bias, law(at.restitution, std::abs(impact(step, row, at))) * v);
    }
  }
};

Real before(const StepContext& step, const Row&, const Contact& at) {
  return approach_speed(step.world, at);
}
Real falling(Real e, Real speed) {
  return e * std::min(Real(1), std::pow(yield / speed, Real(0.25)));
}
Real larger(Real b, Real bounce) {
  return std::min(b, bounce);
}
const Bounce right{{}, before, before, falling, larger};

Answer with_law(Real (*law)(Real e, Real speed)) {
  return {Bounce{{}, before, before, law, larger}};
}
Answer with_bias(Real (*bias)(Real b, Real bounce)) {
  return {Bounce{{}, before, before, falling, bias}};
}

Real bounce_of(const StepContext& step, std::size_t i) {
  const Real v = approach_speed(step.world, step.contacts[i]);
  return falling(step.contacts[i].restitution, std::abs(v)) * v;
}
/// B's e.
struct OwnE : Effect {
  void build(StepContext& step) {
    for (std::size_t i = 0; i < step.contacts.size(); ++i) {
      const Real v = approach_speed(step.world, step.contacts[i]);
      const Real e = step.world.bodies_of(step.contacts[i]).second.restitution;
      if (v < -threshold) step.rows[i].bias = std::min(step.rows[i].bias, falling(e, std::abs(v)) * v);
    }
  }
};
/// Ends at the first contact that is too slow.
struct Ending : Effect {
  void build(StepContext& step) {
    for (std::size_t i = 0; i < step.contacts.size(); ++i) {
      if (approach_speed(step.world, step.contacts[i]) >= -threshold) return;
      step.rows[i].bias = std::min(step.rows[i].bias, bounce_of(step, i));
    }
  }
};
/// b is 0 where nothing bounces.
struct TakingAway : Effect {
  Real (*bias)(Real b, Real bounce) = larger;
  void build(StepContext& step) {
    for (std::size_t i = 0; i < step.contacts.size(); ++i) {
      const bool bounces = approach_speed(step.world, step.contacts[i]) < -threshold;
      step.rows[i].bias = bounces ? bias(step.rows[i].bias, bounce_of(step, i)) : 0;
    }
  }
};
/// Which speed it compares with the threshold.
struct ByThreshold : Effect {
  Real (*speed)(const StepContext&, const Row&, const Contact&);
  void build(StepContext& step) {
    for (std::size_t i = 0; i < step.contacts.size(); ++i)
      if (speed(step, step.rows[i], step.contacts[i]) < -threshold)
        step.rows[i].bias = std::min(step.rows[i].bias, bounce_of(step, i));
  }
};

std::vector<Mistake<Answer>> mistakes() {
  const std::string power =
      "it looks as if e fell by another power of the speed. Sixteen times the yield speed halves e.";
  const Bounce::Speed with_gravity = [](const StepContext&, const Row& row, const Contact&) { return row.speed(); };
  const Bounce::Speed in_all = [](const StepContext& step, const Row&, const Contact& at) {
    const auto [a, b] = step.world.bodies_of(at);
    return (b.velocity_before - a.velocity_before).norm();
  };
  return {
      {"the yield speed forgotten",
       "it looks as if e fell with v to the power of -1/4 in m/s, whatever the yield speed. At v = v_y both laws "
       "agree, so it is v / v_y that counts: e = e_0 (v_y / v)^(1/4).",
       with_law([](Real e, Real speed) { return e * std::min(Real(1), std::pow(speed, Real(-0.25))); })},
      {"the yield speed forgotten",
       "it looks as if e fell with v to the power of -1/4 in m/s, whatever the yield speed. At v = v_y both laws "
       "agree, so it is v / v_y that counts: e = e_0 (v_y / v)^(1/4).",
       with_law([](Real e, Real speed) { return speed > yield ? e * std::pow(speed, Real(-0.25)) : e; })},
      {"what exceeds the yield speed",
       "it looks as if e fell with the part of the speed that exceeds v_y. The law is of the whole speed, and both "
       "laws agree at v = v_y: e = e_0 (v_y / v)^(1/4).",
       with_law([](Real e, Real speed) { return speed > yield ? e * std::pow(1 + speed - yield, Real(-0.25)) : e; })},
      {"what exceeds the yield speed",
       "it looks as if e fell with the part of the speed that exceeds v_y. The law is of the whole speed, and both "
       "laws agree at v = v_y: e = e_0 (v_y / v)^(1/4).",
       with_law([](Real e, Real speed) { return speed > yield ? e * std::pow(speed - yield, Real(-0.25)) : e; })},
      {"the factor alone",
       "it looks as if e_0 were left out. Above the yield speed e falls from that of the contact: e = e_0 (v_y / "
       "v)^(1/4).",
       with_law([](Real e, Real speed) { return speed > yield ? std::pow(yield / speed, Real(0.25)) : e; })},
      {"not limited",
       "it looks as if the law for fast impacts were used for slow ones, too. There e is above 1: the ball leaves "
       "faster than it came, and each bounce makes energy.",
       with_law([](Real e, Real speed) { return e * std::pow(yield / speed, Real(0.25)); })},
      {"limited at 1",
       "it looks as if e were limited at 1. That gains no energy, but loses none either: up to the yield speed, e is "
       "that of the contact.",
       with_law([](Real e, Real speed) { return std::min(Real(1), e * std::pow(yield / speed, Real(0.25))); })},
      {"the greater of the two laws",
       "it looks as if the greater of the two laws were taken. Then slow impacts gain energy and fast ones do not "
       "yield: take the lesser.",
       with_law([](Real e, Real speed) { return e * std::max(Real(1), std::pow(yield / speed, Real(0.25))); })},
      {"e does not fall",
       "it looks as if e did not fall. Two reasons are hard to see in C++: 1 / 4 is a division of whole numbers, which "
       "gives 0, and the root of a negative number is none. v_n is negative while bodies approach.",
       with_law([](Real e, Real) { return e; })},
      {"grows with the speed",
       "it looks as if e grew with the speed. A negative exponent turns the fraction round: v_y / v, less than 1 for "
       "fast impacts.",
       with_law([](Real e, Real speed) { return e * std::min(Real(1), std::pow(speed / yield, Real(0.25))); })},
      {"grows with the speed",
       "it looks as if e grew with the speed. A negative exponent turns the fraction round: v_y / v, less than 1 for "
       "fast impacts.",
       with_law([](Real e, Real speed) { return e * std::max(Real(1), std::pow(speed / yield, Real(0.25))); })},
      {"another power", power, with_law([](Real e, Real speed) { return e * std::min(Real(1), yield / speed); })},
      {"another power", power,
       with_law([](Real e, Real speed) { return e * std::min(Real(1), std::sqrt(yield / speed)); })},
      {"another power", power,
       with_law([](Real e, Real speed) { return e * std::min(Real(1), std::pow(yield / speed, Real(4))); })},
      {"gravity counted in",
       "it looks as if the approach were measured after this step's gravity. The ball has not fallen by this gravity "
       "yet: a ball at rest then bounces off the ground by itself, which gains energy.",
       {Bounce{{}, with_gravity, with_gravity, falling, larger}}},
      {"sliding counted in",
       "it looks as if e depended on the whole velocity. How fast the ball slides along the ground does not press into "
       "it: take the speed along the normal.",
       {Bounce{{}, before, in_all, falling, larger}}},
      {"sum with the push-out",
       "it looks as if bounce and push-out were added up. Each is a least speed, and the larger satisfies both. Their "
       "sum gains energy in every bounce.",
       with_bias([](Real b, Real bounce) { return b + bounce; })},
      {"max for min",
       "it looks as if the greater b were kept, by max. b is minus a speed: of two wishes, the lesser b is the one for "
       "more speed.",
       with_bias([](Real b, Real bounce) { return std::max(b, bounce); })},
      {"e of the bodies",
       "it looks as if e_0 were that of one body. A contact has the e of its pair, step.contacts[i].restitution.",
       {OwnE{}}},
      {"the first contact alone",
       "it looks as if the loop ended at the first contact, or at the first that is too slow. Each of the "
       "step.contacts.size() rows has an approach of its own: what does not bounce is to be passed over.",
       {Ending{}}},
      {"the push-out taken away",
       "it looks as if b became 0 where nothing bounces. What is too slow to bounce still has to be pushed out: there, "
       "b stays as it is.",
       {TakingAway{}}},
      {"threshold on the departure",
       "it looks as if the threshold were compared with e v_n. It is for the speed of the approach, v_n.",
       {ByThreshold{{},
                    [](const StepContext& step, const Row&, const Contact& at) {
                      const Real v = approach_speed(step.world, at);
                      return falling(at.restitution, std::abs(v)) * v;
                    }}}},
      {"threshold with gravity",
       "it looks as if the threshold were compared with a speed that has this step's gravity in it. A body that creeps "
       "then bounces, since gravity adds g h to every contact in every step: compare v_n of before the step.",
       {ByThreshold{{}, [](const StepContext&, const Row& row, const Contact&) { return row.speed(); }}}},
      {"overwritten",
       "it looks as if b were simply overwritten. The push-out had asked for more speed: keep the lesser b, by min.",
       {TakingAway{{}, [](Real, Real bounce) { return bounce; }}}},
      {"overwritten",
       "it looks as if b were simply overwritten. The push-out had asked for more speed: keep the lesser b, by min.",
       with_bias([](Real, Real bounce) { return bounce; })},
      {"sign",
       "it looks as if the bounce had the wrong sign. v_n is negative while bodies approach, and the b that asks for a "
       "separating speed is negative, too: b = e v_n.",
       with_bias([](Real b, Real bounce) { return std::min(b, -bounce); })},
      {"no threshold",
       "it looks as if there were no threshold. The bounces of a body that comes to rest then never end, each slower "
       "than the one before. The threshold ends them.",
       {Bounce{{}, before, before, falling, larger, 0}}},
  };
}

}  // namespace

Numbers play(std::size_t check, Random& random, const Answer& answer) {
  return checks()[check].play(random, answer);
}

Exercise exercise() {
  return exercise_of<Answer>(
      "a restitution that falls with the speed",
      {"Two laws agree at v = v_y, where e = e_0, and one is proportional to v to the power of -1/4. Which power of "
       "v_y / v is that?",
       "Below the yield speed this law gives more than e_0, above it less. Which of the two laws is right is a min or "
       "a max.",
       "The rest is chapter 05's: where v_n < -threshold, b becomes the lesser of the old b and e v_n, with your e."},
      checks(), {right}, mistakes());
}

}  // namespace pushback::exercise_05
