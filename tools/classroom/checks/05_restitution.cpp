#include "pushback/chapters/05_restitution/exercise/asked.h"
#include "pushback/chapters/05_restitution/restitution.h"
#include "pushback/common/exercise/shown.h"

namespace pushback::exercise_05 {

namespace {

/// What the push-out has asked for.
struct Asking : Effect {
  Real speed = 0;  // m/s
  void build(StepContext& step) {
    for (Row& row : step.rows) row.bias = -speed;
  }
};

using Bouncing = Solver<Clamping, Asking, AnyEffect>;

/// A ball that touches the ground and moves up or down.
struct Ball {
  Real e, upwards;  // of 0 ... 1; m/s
  Real gravity = 0, h = Real(1) / 60, asked = 0, slides = 0;

  /// Its speed after the step, m/s.
  Real solved(const Answer& answer, std::size_t quantity = 0) const {
    World world;
    world.gravity = {0, -gravity, 0};
    world.add(ground());
    world.add(sphere(Real(0.3), 10).at({0, Real(0.299), 0}).moving({slides, upwards, 0}).bouncy(e));
    auto solver = with_effect<Bouncing>(answer.bounce);
    solver.speed = asked;
    world.step(solver, h, 1);
    show(world, {quantity});
    return world.bodies[1].velocity.y();
  }
};

/// A ball of which gravity adds 0.15 to 0.25 m/s in a step, which is more than the threshold.
Ball heavy(Random& random, Real e, Real upwards) {
  return {e, upwards, World::g, 1 / random.between(40, 65)};
}

std::vector<Check<Answer>> checks() {
  return {
      {"a ball leaves e times as fast as it arrives",
       1,
       {{"your ball leaves with", "m/s", 1e-6}},
       [](Random& random, const Answer& answer) -> Numbers {
         const Real e = random.between(Real(0.3), Real(0.9)), arrives = random.between(1, 5);
         return {Ball{e, -arrives}.solved(answer)};
       }},
      {"this step's gravity is no part of the approach",
       2,
       {{"your ball, which gravity accelerates as it lands, leaves with", "m/s", 1e-6},
        {"your ball, which lies still, leaves with", "m/s", 1e-6},
        {"your ball, which was leaving by itself, goes on with", "m/s", 1e-6},
        {"your ball, which lands more slowly than the threshold but for gravity, leaves with", "m/s", 1e-6}},
       [](Random& random, const Answer& answer) -> Numbers {
         const Real e = random.between(Real(0.8), Real(0.95));
         const Ball lands = heavy(random, e, -random.between(1, 5)), rests = heavy(random, e, 0),
                    leaves = heavy(random, e, random.between(Real(0.4), Real(0.6))),
                    creeps = heavy(random, e, -random.between(Real(0.04), Real(0.09)));
         return {lands.solved(answer, 0), rests.solved(answer, 1), leaves.solved(answer, 2), creeps.solved(answer, 3)};
       }},
      {"of the bounce and the push-out, the one for more speed stays",
       2,
       {{"your ball, which is pushed out faster than it bounces, leaves with", "m/s", 1e-6},
        {"your ball, which bounces faster than it is pushed out, leaves with", "m/s", 1e-6},
        {"your ball, which is too slow to bounce and is pushed out, leaves with", "m/s", 1e-6}},
       [](Random& random, const Answer& answer) -> Numbers {
         Ball more{random.between(Real(0.3), Real(0.9)), -random.between(1, 5)}, less = more;
         more.asked = -more.e * more.upwards * random.between(Real(1.3), 2);
         less.asked = -less.e * less.upwards * random.between(Real(0.2), Real(0.7));
         Ball slow{more.e, -random.between(Real(0.03), Real(0.09))};
         slow.asked = random.between(Real(0.3), Real(0.6));
         return {more.solved(answer, 0), less.solved(answer, 1), slow.solved(answer, 2)};
       }},
      {"what arrives more slowly than the threshold stays, what arrives faster bounces",
       1,
       {{"your ball, which arrives more slowly than the threshold, leaves with", "m/s", 1e-6},
        {"your ball, which slides fast and arrives more slowly than the threshold, leaves with", "m/s", 1e-6},
        {"your ball, which arrives a little faster than the threshold, leaves with", "m/s", 1e-6}},
       [](Random& random, const Answer& answer) -> Numbers {
         const Real e = random.between(Real(0.2), Real(0.45));
         const Ball slow{e, -random.between(Real(0.03), Real(0.09))}, fast{e, -random.between(Real(0.12), Real(0.2))};
         Ball sliding = slow;
         sliding.slides = random.between(2, 4);
         return {slow.solved(answer, 0), sliding.solved(answer, 1), fast.solved(answer, 2)};
       }},
      {"each contact bounces by its own e, that of both its bodies",
       2,
       {{"your first ball, which is bouncier than its ground, leaves with", "m/s", 1e-6},
        {"your second ball, whose ground is bouncier than it is, leaves with", "m/s", 1e-6},
        {"your third ball, which is too slow to bounce, leaves with", "m/s", 1e-6},
        {"your fourth ball, which is as bouncy as the first, leaves with", "m/s", 1e-6}},
       [](Random& random, const Answer& answer) -> Numbers {
         World world;
         world.gravity.setZero();
         const Real of_ground = random.between(Real(0.4), Real(0.6)), more = random.between(Real(0.75), Real(0.95)),
                    less = random.between(Real(0.1), Real(0.3));
         world.add(ground().bouncy(of_ground));
         const auto add = [&](Real arrives, Real e) {
           const Real x = static_cast<Real>(world.bodies.size());
           world.add(sphere(Real(0.3), 10).at({x, Real(0.299), 0}).moving({0, -arrives, 0}).bouncy(e));
         };
         add(random.between(1, 5), more);
         add(random.between(1, 5), less);
         add(random.between(Real(0.03), Real(0.09)), more);
         add(random.between(1, 5), more);
         auto solver = with_effect<Bouncing>(answer.bounce);
         world.step(solver, Real(1) / 60, 1);
         show(world);
         Numbers speeds;
         for (std::size_t ball = 1; ball <= 4; ++ball) speeds.push_back(world.bodies[ball].velocity.y());
         return speeds;
       }},
      {"of two boxes that turn, the points that touch bounce",
       2,
       {{"the points at which your boxes meet separate with", "m/s", 1e-6}},
       [](Random& random, const Answer& answer) -> Numbers {
         // Each moves and turns towards the other, somewhere in space. A force and a torque have acted in this step already.
         World world;
         const Real half = random.between(Real(0.3), Real(0.5)), e = random.between(Real(0.3), Real(0.9));
         const Real aside_a = half * random.between(Real(0.4), Real(0.8)), turn_a = random.between(2, 3);
         const Real aside_b = half * random.between(Real(0.4), Real(0.8)), turn_b = random.between(2, 3);
         const Real up = random.between(Real(0.5), 1), down = random.between(2, 3);
         const Real tilt = random.between(Real(0.4), Real(0.8)), heading = random.between(0, 2 * pi);
         const Vec3 axis(std::cos(heading), 0, std::sin(heading)), place = random.vector(2);
         const Quat turned(Eigen::AngleAxis<Real>(tilt, axis));
         const auto cube = [&](Real x, Real y, Real velocity, Real turn) {
           Body made = box(Vec3::Constant(half), random.between(5, 20));
           return made.at(place + turned * Vec3(x, y, 0))
               .turned(tilt, axis)
               .moving(turned * Vec3(0, velocity, 0))
               .spinning(turned * Vec3(0, 0, turn));
         };
         world.add(cube(aside_a, -half, up, -turn_a));
         world.add(cube(-aside_b, half, -down, -turn_b));
         world.contacts = {{.point = place, .normal = turned * Vec3(0, 1, 0), .restitution = e, .id = {0, 1, 0}}};
         for (Body& body : world.bodies) {
           keep_velocity(body);
           body.velocity += turned * Vec3(0, -random.between(Real(0.1), Real(0.2)), 0);
           body.angular_velocity *= random.between(Real(1.1), Real(1.2));
         }
         with_effect<Bouncing>(answer.bounce).solve(world, Real(1) / 60, 1);
         show(world);
         return {separating_speed(world, world.contacts[0])};
       }},
  };
}

constexpr Real threshold = Restitution{}.threshold;

/// A mistake is which speed it takes, and what it makes of b, of e and of that speed.
struct Mistaken : Effect {
  Real (*speed)(const StepContext&, const Row&, const Contact&);
  Real (*bias)(Real b, Real e, Real v);
  void build(StepContext& step) {
    for (std::size_t i = 0; i < step.contacts.size(); ++i) {
      Row& row = step.rows[i];
      row.bias = bias(row.bias, step.contacts[i].restitution, speed(step, row, step.contacts[i]));
    }
  }
};

Real before(const StepContext& step, const Row&, const Contact& at) {
  return approach_speed(step.world, at);
}
Real larger(Real b, Real e, Real v) {
  return v < -threshold ? std::min(b, e * v) : b;
}
Answer mistaken(Real (*speed)(const StepContext&, const Row&, const Contact&)) {
  return {Mistaken{{}, speed, larger}};
}
Answer mistaken(Real (*bias)(Real b, Real e, Real v)) {
  return {Mistaken{{}, before, bias}};
}

/// Of B's point against A's, before the step, m/s.
Vec3 velocity_before(const StepContext& step, const Contact& at) {
  const auto [a, b] = step.world.bodies_of(at);
  return b.velocity_before + b.angular_velocity_before.cross(at.point - b.position) - a.velocity_before -
         a.angular_velocity_before.cross(at.point - a.position);
}
Real whole_speed(const StepContext& step, const Contact& at) {
  return velocity_before(step, at).norm();
}

/// Which e it makes of those of the bodies.
struct OwnE : Effect {
  Real (*e)(Real of_a, Real of_b);
  void build(StepContext& step) {
    for (std::size_t i = 0; i < step.contacts.size(); ++i) {
      const auto [a, b] = step.world.bodies_of(step.contacts[i]);
      Row& row = step.rows[i];
      row.bias = larger(row.bias, e(a.restitution, b.restitution), before(step, row, step.contacts[i]));
    }
  }
};
/// Where it ends its loop.
struct Ending : Effect {
  bool (*ends)(std::size_t i, Real v);
  void build(StepContext& step) {
    for (std::size_t i = 0; i < step.contacts.size(); ++i) {
      const Real v = approach_speed(step.world, step.contacts[i]);
      if (ends(i, v)) return;
      step.rows[i].bias = larger(step.rows[i].bias, step.contacts[i].restitution, v);
    }
  }
};
/// Which speed it compares with the threshold.
struct ByThreshold : Effect {
  Real (*speed)(const StepContext&, const Row&, const Contact&);
  void build(StepContext& step) {
    for (std::size_t i = 0; i < step.contacts.size(); ++i) {
      Row& row = step.rows[i];
      const Contact& at = step.contacts[i];
      if (speed(step, row, at) < -threshold)
        row.bias = std::min(row.bias, at.restitution * approach_speed(step.world, at));
    }
  }
};

std::vector<Mistake<Answer>> mistakes() {
  const std::string of_bodies =
      "it looks as if e were made of the bodies' own values. A contact has the e of its pair, and that is the one with "
      "which its points separate: step.contacts[i].restitution.";
  const std::string sign =
      "it looks as if the bounce had the wrong sign. v_n is negative while bodies approach, and the b that asks for a "
      "separating speed is negative, too: b = e v_n, where v_n < -threshold.";
  return {
      {"gravity counted in",
       "it looks as if the approach were measured after this step's gravity. The ball has not fallen by this gravity "
       "yet: a ball at rest then bounces off the ground by itself, and with e = 1 each bounce gains g h. Measure with "
       "velocity_before.",
       mistaken([](const StepContext&, const Row& row, const Contact&) { return row.speed(); })},
      {"sum with the push-out",
       "it looks as if bounce and push-out were added up. Each is a least speed, and the larger satisfies both. Their "
       "sum gains energy in every bounce.",
       mistaken([](Real b, Real e, Real v) { return v < -threshold ? b + e * v : b; })},
      {"no threshold",
       "it looks as if there were no threshold. The bounces of a body that comes to rest then never end, each slower "
       "than the one before. The threshold ends them.",
       mistaken([](Real b, Real e, Real v) { return std::min(b, e * v); })},
      {"max for min",
       "it looks as if the greater b were kept, by max. b is minus a speed: of two wishes, the lesser b is the one for "
       "more speed.",
       mistaken([](Real b, Real e, Real v) { return v < -threshold ? std::max(b, e * v) : b; })},
      {"overwritten",
       "it looks as if b were simply overwritten. The push-out had asked for more speed: keep the lesser b, by min.",
       mistaken([](Real, Real e, Real v) { return v < -threshold ? e * v : 0; })},
      {"overwritten",
       "it looks as if b were simply overwritten. The push-out had asked for more speed: keep the lesser b, by min.",
       mistaken([](Real b, Real e, Real v) { return v < -threshold ? e * v : b; })},
      {"sign", sign, mistaken([](Real b, Real e, Real v) { return v < -threshold ? std::min(b, -e * v) : b; })},
      {"sign", sign, mistaken([](Real b, Real e, Real v) { return v < -threshold ? -e * v : b; })},
      {"1 + e for e",
       "it looks as if b were (1 + e) v_n. The factor 1 + e belongs to an impulse, which first has to stop the "
       "approach. The row does that by itself: b asks only for the speed afterwards, e v_n.",
       mistaken([](Real b, Real e, Real v) { return v < -threshold ? std::min(b, (1 + e) * v) : b; })},
      {"(1 + e)² for e",
       "it looks as if b were (1 + e)² v_n. The factor 1 + e belongs to an impulse, which first has to stop the "
       "approach. The row does that by itself: b asks only for the speed afterwards, e v_n.",
       mistaken([](Real b, Real e, Real v) { return v < -threshold ? std::min(b, (1 + e) * (1 + e) * v) : b; })},
      {"e squared",
       "it looks as if b were e² v_n. e is the ratio of the two speeds; its square is that of the energies.",
       mistaken([](Real b, Real e, Real v) { return v < -threshold ? std::min(b, e * e * v) : b; })},
      {"e of the bodies", of_bodies, {OwnE{{}, [](Real a, Real) { return a; }}}},
      {"e of the bodies", of_bodies, {OwnE{{}, [](Real, Real b) { return b; }}}},
      {"e of the bodies", of_bodies, {OwnE{{}, [](Real a, Real b) { return (a + b) / 2; }}}},
      {"e of the bodies", of_bodies, {OwnE{{}, [](Real a, Real b) { return a * b; }}}},
      {"the first contact alone",
       "it looks as if only the first contact could bounce. Each of the step.contacts.size() rows has an approach "
       "speed and an e of its own.",
       {Ending{{}, [](std::size_t i, Real) { return i > 0; }}}},
      {"the loop ends early",
       "it looks as if nobody bounced after the first contact that is too slow for it. Such a contact is to be passed "
       "over (continue), and those after it have their own approach (return or break ends them all).",
       {Ending{{}, [](std::size_t, Real v) { return v >= -threshold; }}}},
      {"the push-out taken away",
       "it looks as if b became 0 where nothing bounces. What is too slow to bounce still has to be pushed out: there, "
       "b stays as it is.",
       mistaken([](Real b, Real e, Real v) { return v < -threshold ? std::min(b, e * v) : 0; })},
      {"threshold with gravity",
       "it looks as if the threshold were compared with a speed that has this step's gravity in it. A body that creeps "
       "then bounces, since gravity adds g h to every contact in every step: compare v_n of velocity_before.",
       {ByThreshold{{}, [](const StepContext&, const Row& row, const Contact&) { return row.speed(); }}}},
      {"threshold on the whole speed",
       "it looks as if the threshold were compared with the whole speed. How fast a body slides along does not press "
       "it on: the approach is the part along the normal, v_n.",
       {ByThreshold{{},
                    [](const StepContext& step, const Row&, const Contact& at) { return -whole_speed(step, at); }}}},
      {"the whole speed",
       "it looks as if the length of the velocity were taken for the approach. A length has no sign, so what leaves "
       "bounces as well, and what slides along counts too: v_n is the part along the normal.",
       mistaken([](const StepContext& step, const Row&, const Contact& at) { return -whole_speed(step, at); })},
      {"along y",
       "it looks as if v_n were the part of the velocity along y. A normal may point anywhere: take the part along the "
       "contact's own, by dot(at.normal).",
       mistaken([](const StepContext& step, const Row&, const Contact& at) { return velocity_before(step, at).y(); })},
      {"this step's turn counted in",
       "it looks as if the turn were measured after this step's torques. Like the velocity, it counts as the step "
       "began: angular_velocity_before.",
       mistaken([](const StepContext& step, const Row&, const Contact& at) {
         const auto [a, b] = step.world.bodies_of(at);
         return (b.velocity_before + b.angular_velocity.cross(at.point - b.position) - a.velocity_before -
                 a.angular_velocity.cross(at.point - a.position))
             .dot(at.normal);
       })},
      {"r × ω for ω × r",
       "it looks as if the cross product had its factors the other way round. A point at r moves with ω × r; r × ω is "
       "minus that, as if both bodies turned backwards.",
       mistaken([](const StepContext& step, const Row&, const Contact& at) {
         const auto [a, b] = step.world.bodies_of(at);
         return (b.velocity_before - b.angular_velocity_before.cross(at.point - b.position) - a.velocity_before +
                 a.angular_velocity_before.cross(at.point - a.position))
             .dot(at.normal);
       })},
      {"the arm from the origin",
       "it looks as if r led from the origin of the world to the contact. A body turns about its own centre: r = point "
       "- position.",
       mistaken([](const StepContext& step, const Row&, const Contact& at) {
         const auto [a, b] = step.world.bodies_of(at);
         return (b.velocity_before + b.angular_velocity_before.cross(at.point) - a.velocity_before -
                 a.angular_velocity_before.cross(at.point))
             .dot(at.normal);
       })},
      {"e forgotten",
       "it looks as if e were forgotten. The bodies separate e times as fast as they approached; without e nothing "
       "ever comes to rest.",
       mistaken([](Real b, Real, Real v) { return v < -threshold ? std::min(b, v) : b; })},
      {"a push on what leaves",
       "it looks as if |v_n| were taken. A ball that leaves has v_n > 0. It has nothing to bounce off, yet the ground "
       "pushes it on.",
       mistaken([](Real b, Real e, Real v) { return std::abs(v) > threshold ? std::min(b, -e * std::abs(v)) : b; })},
      {"A and B swapped",
       "it looks as if A and B were swapped in v_n. The normal points from A to B, so bodies approach where (v_B - "
       "v_A) . n is negative. With the other sign a ball that lands is not seen, and one that leaves bounces.",
       mistaken(
           [](const StepContext& step, const Row&, const Contact& at) { return -approach_speed(step.world, at); })},
      {"threshold on the departure",
       "it looks as if the threshold were compared with e v_n. It is for the speed of the approach, v_n.",
       mistaken([](Real b, Real e, Real v) { return e * v < -threshold ? std::min(b, e * v) : b; })},
      {"threshold taken off",
       "it looks as if the threshold were taken off the speed, as slop is off a depth. It only says who bounces: who "
       "does leaves with the whole of e v_n.",
       mistaken([](Real b, Real e, Real v) { return std::min(b, e * std::min(Real(0), v + threshold)); })},
      {"only slow ones bounce",
       "it looks as if only those bounced that are slower than the threshold. v_n is negative: faster than the "
       "threshold is v_n < -threshold.",
       mistaken([](Real b, Real e, Real v) { return v > -threshold ? std::min(b, e * v) : b; })},
      {"turning left out",
       "it looks as if the velocities of the centres were taken. The points that touch also move with ω × r as their "
       "bodies turn.",
       mistaken([](const StepContext& step, const Row&, const Contact& at) {
         const auto [a, b] = step.world.bodies_of(at);
         return (b.velocity_before - a.velocity_before).dot(at.normal);
       })},
      {"A left out",
       "it looks as if only B moved. The ground does not, but other bodies do: v_n is the velocity of B's point minus "
       "that of A's.",
       mistaken([](const StepContext& step, const Row&, const Contact& at) {
         const Body& b = step.world.bodies_of(at).second;
         return (b.velocity_before + b.angular_velocity_before.cross(at.point - b.position)).dot(at.normal);
       })},
  };
}

}  // namespace

Numbers play(std::size_t check, Random& random, const Answer& answer) {
  return checks()[check].play(random, answer);
}

Exercise exercise() {
  return exercise_of<Answer>(
      "the bias of a bounce",
      {"A point at r from the centre of its body moves with v + ω × r: angular_velocity_before.cross(r) in code. v_n "
       "is how fast B's point moves along the normal, minus how fast A's does.",
       "The row makes the separating speed -b. Newton's rule wants -e v_n. So b = e v_n, which is negative while the "
       "bodies approach.",
       "Only where v_n < -threshold. There the new b is the lesser of the old one and e v_n: std::min."},
      checks(), {Restitution{}}, mistakes());
}

}  // namespace pushback::exercise_05
