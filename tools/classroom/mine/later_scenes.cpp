/// Chapters 09 to 12, and 21: single steps of contacts that are made by hand, and whole steps of a ball, which touches in one point:
/// no order of rows changes a number.
#include <cmath>

#include "pushback/tools/classroom/mine/scenes.h"
#include "pushback/tools/classroom/mine/touching.h"

namespace pushback {

using namespace touching;

namespace {

constexpr Real dt = Real(1) / 60;
constexpr Range substeps{1900, 4000};     // 1/s
constexpr Range any_substeps{800, 4000};  // some so long that the spring of 12 has to be less stiff than its 240 Hz
constexpr Range little{0.003, 0.012};     // m, of depth

/// Whole steps of a ball over the ground.
struct Drop {
  Range speed;         ///< m/s, downwards
  Range gap = {};      ///< m, between both, negative if it has sunk in
  Range arrives = {};  ///< in this fraction of a step, whatever the gap
  Range bounce = {};
  int steps = 1;
  bool with_contact = false;  ///< what its contact says is measured, too

  std::vector<Quantity> quantities() const {
    std::vector<Quantity> all{{"your ball is above the ground by", "mm", exact},
                              {"your ball moves upwards at", "m/s", exact}};
    if (with_contact) {
      all.push_back({"the impulse that your contact stores, over all substeps, is", "N s", exact});
      all.push_back({"the depth that your contact stores is", "mm", exact});
    }
    return all;
  }
  Numbers operator()(Random& random, const WholeSolver& answer) const {
    World world;
    const Real fall = speed.draw(random), radius = random.between(Real(0.3), Real(0.8));
    const Real above = arrives.to > 0 ? arrives.draw(random) * fall * dt : gap.draw(random);
    world.add(ground());
    Body ball = sphere(radius, random.over_decades(1, 10));
    ball.at({0, radius + above, 0}).moving({0, -fall, 0}).rough(0);
    world.add(ball.bouncy(bounce.draw(random)));
    const auto solver = answer.make();
    for (int i = 0; i < steps; ++i) world.step(*solver, dt);
    Numbers numbers{1000 * (world.bodies[1].position.y() - radius), world.bodies[1].velocity.y()};
    if (with_contact) {
      const Contact none{}, &c = world.contacts.empty() ? none : world.contacts[0];
      numbers.insert(numbers.end(), {c.impulse.y(), 1000 * c.depth});
    }
    return numbers;
  }
};

/// A step of a pair: the distance of its bodies from where only their velocities would take them, and these velocities.
struct Corrected {
  Meeting meeting;
  std::vector<Quantity> quantities() const {
    std::vector<Quantity> all;
    for (const char* body : {"lower", "upper"}) {
      all.push_back({fmt::format("your correction moves the {} body by", body), "mm", exact});
      all.push_back({fmt::format("your correction rotates the {} body by", body), "mrad", 1e-4});
      all.push_back({fmt::format("after the correction, your {} body moves at", body), "m/s", exact});
    }
    return all;
  }
  Numbers operator()(Random& random, const WholeSolver& answer) const {
    Pair pair = meeting.pair(random);
    std::vector<Body> alone = pair.world.bodies;
    pair.solve(*answer.make(), few(random), true);
    Numbers numbers;
    for (std::size_t i = 0; i < 2; ++i) {
      const Body& body = pair.world.bodies[i];
      alone[i].velocity = body.velocity;
      alone[i].angular_velocity = body.angular_velocity;
      move(alone[i], pair.h);
      numbers.insert(numbers.end(),
                     {1000 * (body.position - alone[i].position).norm(),
                      1000 * body.orientation.angularDistance(alone[i].orientation), body.velocity.norm()});
    }
    return numbers;
  }
};

MeasuredScene plan_of_a_step() {
  return {{{"in a step of yours, the number of detections is", "", 0.5},
           {"in a step of yours, the number of substeps is", "", 0.5},
           {"in each substep of yours, the number of sweeps is", "", 0.5},
           {"whether your plan detects contacts that are still apart (1 or 0) is", "", 0.5}},
          [](Random&, const WholeSolver& answer) -> Numbers {
            const Plan plan = answer.make()->plan(dt);
            return {static_cast<Real>(plan.detections), static_cast<Real>(plan.all_substeps()),
                    static_cast<Real>(plan.sweeps), Real(plan.margin.least > 0 ? 1 : 0)};
          }};
}

Numbers slides(Random& random, const WholeSolver& answer) {
  World world;
  world.add(ground());
  Body ball = sphere(Real(0.5), random.over_decades(1, 10));
  world.add(ball.at({0, Real(0.5), 0}).moving({random.between(2, 4), 0, random.between(1, 2)}));
  const Real friction = random.between(Real(0.1), Real(0.3));
  for (Body& body : world.bodies) body.rough(friction);
  const auto solver = answer.make();
  for (int step = 0; step < 3; ++step) world.step(*solver, dt);
  const Vec3 along = world.contacts.empty() ? Vec3::Zero() : world.contacts[0].impulse;
  return {world.bodies[1].velocity.x(), world.bodies[1].angular_velocity.z(), std::hypot(along.x(), along.z())};
}

/// Two balls that graze each other in the middle of a step, so their rows differ in each substep.
Numbers graze(Random& random, const WholeSolver& answer) {
  World world;
  world.gravity.setZero();
  const Real speed = random.between(20, 30), radius = random.between(Real(0.1), Real(0.2));
  Body one = sphere(radius, random.between(1, 3)), other = sphere(radius, random.between(1, 3));
  world.add(one.at({0, 0, 0}).rough(1));
  const Real high = random.between(Real(0.5), Real(0.8)) * 2 * radius;
  const Real there = std::sqrt(4 * radius * radius - high * high) + random.between(Real(0.1), Real(0.2)) * speed * dt;
  world.add(other.at({there, high, 0}).moving({-speed, 0, 0}).rough(1));
  const Vec3 before = angular_momentum(world);
  const auto solver = answer.make();
  for (int step = 0; step < 2; ++step) world.step(*solver, dt);
  return {(angular_momentum(world) - before).norm(), world.bodies[0].velocity.norm(), world.bodies[1].velocity.norm(),
          world.bodies[1].angular_velocity.norm()};
}

/// In the second step the normal has turned, so that what was a push is friction now, and more than the cone holds.
Numbers turned_normal(Random& random, const WholeSolver& answer) {
  Pair pair = Meeting{.speed = fast, .friction = {0.1, 0.2}, .rate = substeps, .balls = true}.pair(random);
  const auto solver = answer.make();
  pair.solve(*solver, 1, true);
  pair.next(pair.h, {pair.contact()});
  Contact& c = pair.contact();
  const auto [aside, other] = tangents_of(c.normal);
  c.normal = (c.normal + random.between(Real(0.3), Real(0.5)) * (aside + other)).normalized();
  pair.world.bodies[1].velocity += random.vector(Real(0.2));
  pair.begin();
  pair.solve(*solver, 0);
  return {pair.world.bodies[0].velocity.norm(), pair.world.bodies[1].velocity.norm()};
}

constexpr double solved_impact = 1e-3;  // m/s, because each solver has its own precision for an impact

}  // namespace

std::vector<CheckOfChapter> checks_of_later_contacts() {
  return {
      {9, "a bounce is as fast as if it had begun at the surface",
       Meeting{.speed = fast, .depth = {0.005, 0.05}, .restitution = {0.2, 0.9}, .falls = true}},

      // A push-out of at least 0.2 · 0.1 m · 50 Hz is faster than this bounce.
      {9, "a body that bounces is not also pushed out",
       Meeting{.speed = {-0.4, -0.2}, .depth = {0.1, 0.2}, .restitution = {0.4, 0.9}}},

      // So deep, and so slow, that half the square of its speed at the surface would have been negative.
      {9, "a body that was pressed in, and did not fall in, is pushed out",
       Meeting{.speed = {-0.4, -0.2}, .depth = {0.1, 0.2}, .restitution = {0.4, 0.9}, .falls = true}},
      {9, "the speed added by forces is read before the initial guess",
       After{{.speed = {-0.5, -0.1}, .falls = true},
             {.speed = fast, .depth = {0.005, 0.05}, .restitution = {0.3, 0.9}}}},

      // One sweep, so that no later one finishes the bounce.
      {9, "a beam that lands flat has bounced flat after one sweep",
       Landing{.reach = {0.7, 0.9}, .restitution = {0.3, 0.9}, .sweeps = {1, 1}, .tolerance = solved_impact}},
      {10, "the push-out is no longer in the bias, so an overlap causes no speed",
       Meeting{.speed = slow, .depth = {0.02, 0.1}}},
      {10, "overlapping bodies are moved by the fraction β of the remaining overlap",
       Corrected{{.speed = {-0.3, -0.1}, .depth = {0.02, 0.1}}}},

      // They separate by themselves, so that less remains, but slowly enough that something does.
      {10, "the correction does not close again what the bodies' own velocities close",
       Corrected{{.speed = {0.4, 0.8}, .depth = {0.05, 0.1}}}},
      {10, "no contact corrects more than 50 mm", Corrected{{.speed = {-0.3, -0.1}, .depth = {0.4, 0.8}}}},
      {10, "bodies less deep than the slop are not moved", Corrected{{.speed = fast, .depth = {-0.01, 0.0045}}}},

      {11, "a ball falls as far as in 32 separate steps", Drop{.speed = {}, .gap = {5, 5}}},
      {11,
       "a ball that arrives in the middle of a step bounces in that step",
       Drop{.speed = {2, 6}, .arrives = {0.3, 0.6}, .bounce = {0.5, 0.9}},
       {21}},
      {11, "β/h uses the h of a substep", Drop{.speed = {}, .gap = {-0.03, -0.01}}, {12}},
      {11, "the plan: 32 detections, one sweep in each substep", plan_of_a_step(), {21}},
      {12,
       "an overlap acts like a spring with a damper",
       Meeting{.speed = slow, .depth = little, .rate = any_substeps, .sweeps = {2, 5.9}},
       {21}},
      {12,
       "bodies that are too deep are pushed out at 3 m/s",
       Meeting{.speed = slow, .depth = {0.04, 0.09}, .rate = substeps, .sweeps = {2, 5.9}},
       {21}},
      {12,
       "a bounce is neither soft nor pushed out",
       Meeting{.speed = fast, .depth = {0.01, 0.019}, .restitution = {0.1, 0.2}, .sweeps = {2, 5.9}, .falls = true},
       {21}},
      {12, "the speed of the push-out disappears once it has moved the bodies",
       Meeting{.speed = slow, .depth = little, .rate = any_substeps, .moves = true}},
      {12,
       "the speed of a bounce remains",
       Meeting{.speed = fast, .depth = little, .restitution = {0.3, 0.9}, .rate = any_substeps, .moves = true},
       {21}},
      {12, "rows are updated to the new positions of the bodies",
       Meeting{.speed = fast,
               .depth = little,
               .friction = {0.2, 0.8},
               .slip = {3, 6},
               .rate = any_substeps,
               .moves = true}},
      {12, "a ball that has sunk in comes up", Drop{.speed = {}, .gap = {-0.015, -0.005}, .steps = 4}},
  };
}

std::vector<CheckOfChapter> checks_of_detected_once() {
  return {
      {21, "the plan: one detection, with a margin, 32 substeps with one sweep each", plan_of_a_step()},
      {21, "a ball that arrives in the middle of a step stops at the surface",
       Drop{.speed = {2, 6}, .arrives = {0.3, 0.6}, .with_contact = true}},
      {21, "a ball that arrives in the middle of a step and bounces leaves at the end of the step",
       Drop{.speed = {2, 6}, .arrives = {0.3, 0.6}, .bounce = {0.4, 0.9}, .with_contact = true}},
      {21, "a ball at rest is supported, and its contact stores the impulse",
       Drop{.speed = {}, .gap = {-0.001, -0.0001}, .steps = 3, .with_contact = true}},

      // Near enough to be detected, and never there.
      {21, "a contact that was detected but never touched is removed",
       Drop{.speed = {-1, -0.5}, .gap = {0.005, 0.01}, .with_contact = true}},
      {21,
       "friction slows a sliding ball in every substep",
       {{{"your ball continues at", "m/s", exact},
         {"your ball rotates at", "rad/s", exact},
         {"the tangential impulse that your contact stores, over all substeps, is", "N s", exact}},
        slides}},
      {21,
       "balls that graze each other keep their angular momentum",
       {{{"your impulses change the angular momentum of both balls by", "N m s", exact},
         {"the ball that was hit leaves at", "m/s", exact},
         {"the other ball continues at", "m/s", exact},
         {"the other ball rotates at", "rad/s", exact}},
        graze}},

      // So many sweeps that it has converged, before it has moved, and one after.
      {21, "a pile of three boxes with any velocities", of_a_pile([](Random& random, const WholeSolver& answer) {
         Pile pile(random);
         pile.h = 1 / substeps.draw(random);
         pile.solve(*answer.make(), to_the_end, true);
         return pile.numbers();
       })},
      {21, "bodies of any shape slide as the friction cone requires, before and after they have moved",
       Meeting{.speed = fast, .friction = {0.2, 0.8}, .slip = {1, 6}, .rate = substeps, .moves = true}},
      {21, "each of several points starts with its own impulse", EachPointStarts{}},
      {21,
       "a guess stays within the friction cone of the current normal",
       {{{"your lower ball leaves at", "m/s", exact}, {"your upper ball leaves at", "m/s", exact}}, turned_normal}},
  };
}

}  // namespace pushback
