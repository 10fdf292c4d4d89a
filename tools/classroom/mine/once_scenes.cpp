/// 21: whole steps of balls, which touch in one point, and a guess for a normal that has turned.
#include <cmath>

#include "pushback/tools/classroom/mine/scenes.h"
#include "pushback/tools/classroom/mine/touching.h"

namespace pushback {

using namespace touching;

namespace {

Numbers planned_once(Random&, const WholeSolver& answer) {
  const Plan plan = answer.make()->plan(dt);
  return {static_cast<Real>(plan.detections), static_cast<Real>(plan.substeps), static_cast<Real>(plan.sweeps),
          Real(plan.margin.least > 0 ? 1 : 0)};
}

/// It arrives in the midst of a step, at a third to two thirds.
Ball arriving(Random& random) {
  const Real speed = random.between(2, 6);
  return {random, random.between(Real(0.3), Real(0.6)) * speed * dt, speed};
}

Numbers stops(Random& random, const WholeSolver& answer) {
  Ball ball = arriving(random);
  ball.step(*answer.make(), 1);
  return {ball.height(), ball.body().velocity.y(), ball.pushed()};
}

Numbers bounces_once(Random& random, const WholeSolver& answer) {
  Ball ball = arriving(random);
  ball.body().bouncy(random.between(Real(0.4), Real(0.9)));
  ball.step(*answer.make(), 1);
  return {ball.height(), ball.body().velocity.y(), ball.pushed()};
}

Numbers bears(Random& random, const WholeSolver& answer) {
  Ball ball(random, -random.between(Real(0.0001), Real(0.001)), 0);
  ball.step(*answer.make(), 3);
  const Real depth = ball.world.contacts.empty() ? 0 : 1000 * ball.world.contacts[0].depth;
  return {ball.height(), ball.pushed(), depth};
}

/// Near enough to be detected, and never there.
Numbers misses(Random& random, const WholeSolver& answer) {
  Ball ball(random, random.between(Real(0.005), Real(0.01)), -random.between(Real(0.5), 1));
  ball.step(*answer.make(), 1);
  return {static_cast<Real>(ball.world.contacts.size()), ball.height(), ball.body().velocity.y()};
}

Numbers slides(Random& random, const WholeSolver& answer) {
  Ball ball(random, 0, 0);
  const Real friction = random.between(Real(0.1), Real(0.3));
  for (Body& body : ball.world.bodies) body.rough(friction);
  ball.body().moving({random.between(2, 4), 0, random.between(1, 2)});
  ball.step(*answer.make(), 3);
  const Vec3 along = ball.world.contacts.empty() ? Vec3::Zero() : ball.world.contacts[0].impulse;
  return {ball.body().velocity.x(), ball.body().angular_velocity.z(), std::hypot(along.x(), along.z())};
}

/// Two balls that graze each other in the midst of a step: their rows are somewhere else in each substep.
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

/// So many sweeps that it has converged, before it has moved, and one after.
Numbers pile_meets(Random& random, const WholeSolver& answer) {
  Pile pile(random);
  for (std::size_t i = 1; i < pile.world.bodies.size(); ++i)
    pile.world.bodies[i].moving(random.vector(3)).spinning(random.vector(3));
  pile.h = 1 / random.between(1900, 4000);
  pile.begin();
  pile.substep(*answer.make(), to_the_end);
  return numbers_of(pile);
}

Numbers lumps_slide_on(Random& random, const WholeSolver& answer) {
  Pair pair(random, meeting(random));
  pair.h = 1 / random.between(1900, 4000);
  pair.slide(random.between(1, 6) * random.direction().cross(pair.contact().normal).normalized());
  pair.contact().friction = random.between(Real(0.2), Real(0.8));
  pair.substep(*answer.make(), few(random));
  Numbers numbers = numbers_of(pair);
  numbers.push_back(pair.slip().norm());
  return numbers;
}

/// In the second step the normal has turned, so that what was a push is friction now, and more than the cone holds.
Numbers turned_guess(Random& random, const WholeSolver& answer) {
  Pair pair(random, meeting(random), true);
  pair.h = 1 / random.between(1900, 4000);
  pair.contact().friction = random.between(Real(0.1), Real(0.2));
  const auto solver = answer.make();
  pair.substep(*solver, 1);
  pair.next(pair.h, {pair.contact()});
  Contact& c = pair.contact();
  const auto [aside, other] = tangents_of(c.normal);
  c.normal = (c.normal + random.between(Real(0.3), Real(0.5)) * (aside + other)).normalized();
  pair.world.bodies[1].velocity += random.vector(Real(0.2));
  pair.begin();
  pair.substep(*solver, 0);
  return {pair.world.bodies[0].velocity.norm(), pair.world.bodies[1].velocity.norm()};
}

}  // namespace

std::vector<CheckOfChapter> checks_of_detected_once() {
  const std::vector<int> all{};
  const Quantity height{"your ball is over the ground by", "mm", exact};
  const Quantity speed{"your ball goes up with", "m/s", exact};
  const Quantity pushed{"over all substeps, your contact keeps an impulse of", "N s", exact};
  std::vector<Quantity> sliding = of_a_pair;
  sliding.push_back({"along the surface, the points at which your bodies touched slip with", "m/s", exact});
  return {
      {21,
       all,
       {"the plan: one detection, with a margin, 32 substeps of one sweep",
        1,
        {{"a step of yours has so many detections:", "", 0.5},
         {"and after each so many substeps:", "", 0.5},
         {"and in each so many sweeps:", "", 0.5},
         {"that it detects what is still apart, 1 or 0, your plan says with", "", 0.5}},
        planned_once}},
      {21, all, {"a ball that arrives in the midst of a step stops at the surface", 1, {height, speed, pushed}, stops}},
      {21, all, {"a ball that bounces in the midst of a step does so once", 1, {height, speed, pushed}, bounces_once}},
      {21,
       all,
       {"a ball at rest is borne, and its contact says by how much",
        1,
        {height, pushed, {"your contact says that it is deep by", "mm", exact}},
        bears}},
      {21,
       all,
       {"what was detected and did not touch is no contact",
        1,
        {{"after a step, the contacts of a ball that went up are", "", 0.5}, height, speed},
        misses}},
      {21,
       all,
       {"a ball that slides is braked in every substep",
        1,
        {{"your ball goes on with", "m/s", exact},
         {"your ball turns with", "rad/s", exact},
         {"over all substeps, along the surface, your contact keeps", "N s", exact}},
        slides}},
      {21,
       all,
       {"balls that graze each other keep their angular momentum",
        1,
        {{"your impulses change the angular momentum of both balls by", "N m s", exact},
         {"the ball that was hit leaves with", "m/s", exact},
         {"the other one goes on with", "m/s", exact},
         {"and turns with", "rad/s", exact}},
        graze}},
      {21, all, {"a pile of three boxes that meet with any velocities", 1, of_a_pile(), pile_meets}},
      {21,
       all,
       {"bodies of any shape slide as the cone says, before and after they have moved", 1, sliding, lumps_slide_on}},
      {21, all, {"of several points, each starts from its own impulse", 1, of_many_points(), each_point_starts}},
      {21,
       all,
       {"a guess stays within the cone of the normal of now",
        1,
        {{"your lower ball leaves with", "m/s", exact}, {"your upper ball leaves with", "m/s", exact}},
        turned_guess}},
  };
}

}  // namespace pushback
