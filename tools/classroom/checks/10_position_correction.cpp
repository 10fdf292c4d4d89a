#include "pushback/chapters/02_clamping/clamping.h"
#include "pushback/chapters/10_position_correction/exercise/asked.h"
#include "pushback/chapters/10_position_correction/split_impulse.h"
#include "pushback/common/exercise/shown.h"

namespace pushback::exercise_10 {

namespace {

struct Asked : Effect, Corrects {
  Answer answer{};
  void correct(CorrectingContext& step) { answer.correct(step); }
};

void step(World& world, Real h, const Answer& answer, const std::vector<std::size_t>& quantities = {}) {
  CorrectingSolver<Clamping, Asked> solver;
  static_cast<Asked&>(solver).answer = answer;
  world.step(solver, h, 60);
  show(world, quantities);
}

/// A ball without weight, some way in the ground.
struct Ball {
  World world;
  Real h, depth;
  Vec3 start;

  explicit Ball(Random& random) : h(1 / random.between(5, 9)), depth(random.between(Real(0.01), Real(0.03))) {
    const Real radius = random.between(Real(0.3), Real(0.5));
    world.gravity.setZero();
    world.add(ground());
    start = {0, radius - depth, 0};
    world.add(sphere(radius, random.between(5, 20)).at(start));
  }
  Body& body() { return world.bodies[1]; }
  /// Where it has come to, mm.
  Vec3 moved() { return 1000 * (body().position - start); }
};

/// Two pairs of balls that overlap and touch nothing else: how far the first and the last of the four have moved, mm.
std::pair<Real, Real> in_the_air(Random& random, const Answer& answer) {
  World world;
  world.gravity.setZero();
  for (const Real x : {Real(0), Real(5)}) {
    const Vec3 n = random.direction(), at(x, 5, 0);
    const Real depth = random.between(Real(0.01), Real(0.03));
    world.add(sphere(Real(0.5), random.between(5, 20)).at(at));
    world.add(sphere(Real(0.5), random.between(5, 20)).at(at + (1 - depth) * n));
  }
  const Vec3 first = world.bodies.front().position, last = world.bodies.back().position;
  step(world, 1 / random.between(5, 9), answer, {2, 3});
  return {1000 * (world.bodies.front().position - first).norm(), 1000 * (world.bodies.back().position - last).norm()};
}

/// A plate that lies too deep, and turns so that one side stays while the other leaves the ground in this step: by how much it
/// has turned, mrad.
Real one_side_up(Random& random, const Answer& answer) {
  World world;
  world.gravity.setZero();
  const Real width = random.between(Real(0.4), Real(0.6)), depth = random.between(Real(0.01), Real(0.02)),
             h = Real(1) / 60;
  world.add(ground());
  world.add(box({width, Real(0.1), width}, random.between(50, 150)).at({0, Real(0.1) - depth, 0}));
  Body& body = world.bodies[1];
  body.angular_velocity.z() = random.between(Real(1.2), Real(1.4)) * depth / (2 * width * h);
  body.velocity.y() = width * body.angular_velocity.z();
  body.velocity.x() = -Real(0.1) * body.angular_velocity.z();
  step(world, h, answer, {2});
  return 1000 * body.orientation.angularDistance(Quat::Identity());
}

std::vector<Check<Answer>> checks() {
  return {
      {"a ball that is too deep comes up by β d, and does not move on",
       1,
       {{"your ball, which is too deep, moves on with", "m/s", 1e-6},
        {"your ball has come up by", "mm", 1e-5},
        {"of two balls that overlap in the air, the first has moved by", "mm", 1e-5},
        {"of two more, the second has moved by", "mm", 1e-5}},
       [](Random& random, const Answer& answer) -> Numbers {
         Ball ball(random);
         step(ball.world, ball.h, answer, {0, 1});
         const auto [first, last] = in_the_air(random, answer);
         return {ball.body().velocity.y(), ball.moved().y(), first, last};
       }},
      {"a ball that comes up by itself is helped only over what is left",
       1,
       {{"your ball, which comes up by itself, has come up by", "mm", 1e-5},
        {"your ball, which comes up by itself, moves on with", "m/s", 1e-6}},
       [](Random& random, const Answer& answer) -> Numbers {
         Ball ball(random);
         ball.body().velocity.y() = random.between(Real(0.3), Real(0.7)) * ball.depth / ball.h;
         step(ball.world, ball.h, answer);
         return {ball.moved().y(), ball.body().velocity.y()};
       }},
      {"a ball that is too deep goes on sideways, and spins on",
       1,
       {{"your ball, which is too deep and moves sideways, goes on with", "m/s", 1e-6},
        {"your ball, which spins about the vertical, spins on with", "rad/s", 1e-6},
        {"your ball, which moves sideways, has gone by", "mm", 1e-5},
        {"your ball, which spins about the vertical, has turned by", "mrad", 0.1}},
       [](Random& random, const Answer& answer) -> Numbers {
         Ball ball(random);
         ball.body().velocity.x() = random.between(1, 3);
         ball.body().angular_velocity.y() = random.between(1, 3);
         step(ball.world, ball.h, answer);
         return {ball.body().velocity.x(), ball.body().angular_velocity.y(), ball.moved().x(),
                 1000 * ball.body().orientation.angularDistance(Quat::Identity())};
       }},
      {"a column that leans is lifted on its deeper side, and let go on the other",
       2,
       {{"your column, which leans by some mrad, is set upright by", "mrad", 1e-4},
        {"the middle of your column, which leans, has come up by", "mm", 1e-4}},
       [](Random& random, const Answer& answer) -> Numbers {
         World world;
         const Real width = random.between(Real(0.22), Real(0.28)), height = random.between(Real(0.75), Real(0.9));
         const Real lean = random.between(Real(0.02), Real(0.04));
         // Three millimetres deep where it is the least deep.
         const Real middle = height * std::cos(lean) - width * std::sin(lean) - Real(0.003);
         world.add(ground());
         world.add(box({width, height, width}, random.between(50, 150)).at({0, middle, 0}).turned(lean, Vec3::UnitZ()));
         step(world, Real(1) / 60, answer);
         const Body& body = world.bodies[1];
         return {1000 * (lean - body.orientation.angularDistance(Quat::Identity())),
                 1000 * (body.position.y() - middle)};
       }},
      {"a plate that is too deep comes up level",
       1,
       {{"your plate, which lies flat and is too deep, has come up by", "mm", 0.01},
        {"your plate, which lies flat, has turned by", "mrad", 0.01},
        {"your plate, one side of which comes up by itself, has turned by", "mrad", 0.01}},
       [](Random& random, const Answer& answer) -> Numbers {
         World world;
         const Real width = random.between(Real(0.4), Real(0.6)), depth = random.between(Real(0.01), Real(0.03));
         world.add(ground());
         world.add(box({width, Real(0.1), width}, random.between(50, 150)).at({0, Real(0.1) - depth, 0}));
         step(world, Real(1) / 60, answer, {0, 1});
         const Body& body = world.bodies[1];
         return {1000 * (body.position.y() - Real(0.1) + depth),
                 1000 * body.orientation.angularDistance(Quat::Identity()), one_side_up(random, answer)};
       }},
  };
}

void right(CorrectingContext& step) {
  SplitImpulse split;
  split.beta = beta;
  split.rounds = rounds;
  split.correct(step);
}

/// Split impulse, and what can be done wrong in it.
struct Wrong {
  Real beta = exercise_10::beta;
  Real speed = 1;                ///< times J V, in C + h J V
  bool speed_without_h = false;  ///< C + J V
  bool push_without_h = false;   ///< b' without 1/h
  bool move_without_h = false;   ///< x += v'
  bool sums_kept = false, increments = false;
  bool not_aside = false, spin_not_aside = false, turned = true, min_forgotten = false, min_of_C = false,
       push_by_h = false;
  bool second_body_only = false;
  std::size_t pushes = std::numeric_limits<std::size_t>::max(), left_out = 0;
  int rounds = exercise_10::rounds;
  Real old = 1, old_spin = 1, pseudo = 0;  ///< what each body goes on with
};

void correct(CorrectingContext& step, const Wrong& wrong) {
  Rows pushes(step.rows.begin(), step.rows.begin() + std::ssize(step.contacts));
  const Real h = step.dt;
  for (Row& push : pushes) {
    const Real way = wrong.speed * (wrong.speed_without_h ? 1 : h) * push.speed();
    const Real over = wrong.push_without_h ? 1 : wrong.push_by_h ? 1 / h : h;
    const Real left = wrong.min_of_C ? std::min(Real(0), push.separation) + way : push.separation + way;
    push.bias = wrong.beta / over * (wrong.min_forgotten || wrong.min_of_C ? left : std::min(Real(0), left));
    if (!wrong.sums_kept) push.impulse = 0;
  }
  const std::vector<Body> before = step.world.bodies;
  for (Body& body : step.world.bodies) {
    if (wrong.not_aside) break;
    body.velocity.setZero();
    if (!wrong.spin_not_aside) body.angular_velocity.setZero();
  }
  const std::size_t kept =
      std::min(pushes.size() > wrong.left_out ? pushes.size() - wrong.left_out : pushes.size(), wrong.pushes);
  pushes.erase(pushes.begin() + static_cast<std::ptrdiff_t>(kept), pushes.end());
  for (int round = 0; round < wrong.rounds; ++round) {
    for (Row& push : pushes) {
      if (wrong.increments) push.impulse = 0;
      push.solve();
    }
  }
  for (std::size_t i = 0; i < before.size(); ++i) {
    Body& body = step.world.bodies[i];
    const Real time = wrong.move_without_h ? 1 : h;
    if (!wrong.second_body_only || i > 0)
      displace(body, time * body.velocity, wrong.turned ? Vec3(time * body.angular_velocity) : Vec3::Zero());
    body.velocity = wrong.old * before[i].velocity + wrong.pseudo * body.velocity;
    body.angular_velocity = wrong.old_spin * before[i].angular_velocity + wrong.pseudo * body.angular_velocity;
  }
}

std::vector<Mistake<Answer>> mistakes() {
  const std::string left =
      "it looks as if the pseudo-velocity were left in the body. It is for one move only; then v and ω are what they "
      "were.";
  const std::string lost =
      "it looks as if the body's own velocity had not been put back. What was set aside before V' took its place "
      "returns when the body has been moved.";
  const std::string from_before =
      "it looks as if b' were made of C alone. C is of before the move; the body has come up by h J V since, and only "
      "C + h J V is left. With every bounce a push that is not needed adds height, and height is energy.";
  const std::string min =
      "it looks as if the min were not around all of C + h J V. A point that comes out of the overlap by itself in "
      "this step has nothing to undo: b' = 0, also where C was negative.";
  const std::string some =
      "it looks as if some pushes were left out. Every normal has its own, and in each round all of them have their "
      "turn.";
  return {
      {"min forgotten", min, {[](CorrectingContext& step) { correct(step, {.min_forgotten = true}); }}},
      {"min forgotten", min, {[](CorrectingContext& step) { correct(step, {.min_of_C = true}); }}},
      {"h for 1/h in b'",
       "it looks as if b' were multiplied by h. β (C + h J V) is a distance; to cover it within h, the speed is that "
       "over h.",
       {[](CorrectingContext& step) { correct(step, {.push_by_h = true}); }}},
      {"spin not set aside",
       "it looks as if the bodies had kept their spins while the pushes were solved. V' has a part ω', too: it starts "
       "from 0, or each body turns by h ω a second time.",
       {[](CorrectingContext& step) { correct(step, {.spin_not_aside = true}); }}},
      {"the first body left out",
       "it looks as if the first body were not moved. Not every world has a ground: each body is moved by its own h "
       "V'.",
       {[](CorrectingContext& step) { correct(step, {.second_body_only = true}); }}},
      {"pushes left out", some, {[](CorrectingContext& step) { correct(step, {.pushes = 1}); }}},
      {"pushes left out", some, {[](CorrectingContext& step) { correct(step, {.pushes = 2}); }}},
      {"pushes left out", some, {[](CorrectingContext& step) { correct(step, {.left_out = 1}); }}},
      {"C for C + h J V", from_before, {[](CorrectingContext& step) { correct(step, {.speed = 0}); }}},
      {"pseudo-velocity left in the body", left, {[](CorrectingContext& step) {
         correct(step, {.old = 0, .old_spin = 0, .pseudo = 1});
       }}},
      {"pseudo-velocity left in the body", left, {[](CorrectingContext& step) { correct(step, {.pseudo = 1}); }}},
      {"velocity not put back", lost, {[](CorrectingContext& step) { correct(step, {.old = 0, .old_spin = 0}); }}},
      {"velocity not put back", lost, {[](CorrectingContext& step) { correct(step, {.old_spin = 0}); }}},
      {"increments clamped",
       "it looks as if each increment were clamped, not their sum. What one corner is lifted too far, because the next "
       "one lifts it as well, is then never taken back.",
       {[](CorrectingContext& step) { correct(step, {.increments = true}); }}},
      {"sums not reset",
       "it looks as if the pushes went on from the impulses of the step. Down to -Σλ they could then pull: the lighter "
       "side is held to the ground. Σλ' starts from 0.",
       {[](CorrectingContext& step) { correct(step, {.sums_kept = true}); }}},
      {"not set aside",
       "it looks as if the bodies had kept their own velocities while the pushes were solved. V' starts from 0; or "
       "else each body moves by h V a second time.",
       {[](CorrectingContext& step) { correct(step, {.not_aside = true}); }}},
      {"not turned",
       "it looks as if the bodies were shifted, but not turned. V' has a part ω' as well.",
       {[](CorrectingContext& step) { correct(step, {.turned = false}); }}},
      {"one round",
       "it looks as if each push were solved only once. What one corner does, another one undoes: it takes all "
       "`rounds` rounds.",
       {[](CorrectingContext& step) { correct(step, {.rounds = 1}); }}},
      {"1/h forgotten in b'",
       "it looks as if 1/h were missing in b'. β (C + h J V) is a distance; to cover it within h, the speed is that "
       "over h.",
       {[](CorrectingContext& step) { correct(step, {.push_without_h = true}); }}},
      {"moved without h",
       "it looks as if h were missing in the move, or 1/h stood twice in b'. b' is a speed, β/h times a distance, and "
       "in a step of h seconds v' covers h v'.",
       {[](CorrectingContext& step) { correct(step, {.move_without_h = true}); }}},
      {"β forgotten",
       "it looks as if β were missing: all of the overlap is gone after one step, where the part β is asked for.",
       {[](CorrectingContext& step) { correct(step, {.beta = 1}); }}},
      {"h of J V forgotten",
       "it looks as if C and J V were added. J V is a speed: in the step it has changed the separation by h J V.",
       {[](CorrectingContext& step) { correct(step, {.speed_without_h = true}); }}},
      {"nothing pushed",
       "it looks as if nothing were pushed at all. Is b' negative where the bodies overlap, and are they moved by h "
       "V'?",
       {[](CorrectingContext& step) { correct(step, {.beta = -1}); }}},
      {"sign of h J V",
       "it looks as if h J V were taken off C. Bodies that separate have J V > 0, and C grows by h J V.",
       {[](CorrectingContext& step) { correct(step, {.speed = -1}); }}},
  };
}

}  // namespace

Numbers play(std::size_t check, Random& random, const Answer& answer) {
  return checks()[check].play(random, answer);
}

Exercise exercise() {
  return exercise_of<Answer>(
      "split impulse's correct",
      {"First make b' of all pushes, as long as speed() is J V: b' = β/h min(0, C + h J V). Their sums start from 0.",
       "A copy of step.world.bodies keeps the velocities. Then set both velocities of each body to 0: V' starts there.",
       "After `rounds` times over all pushes, body.velocity and body.angular_velocity are v' and ω'. displace(body, h "
       "v', h ω'), and the velocities from the copy."},
      checks(), {right}, mistakes());
}

}  // namespace pushback::exercise_10
