/// 09: bounces as if from the surface, and a row of balls that touch.
#include "pushback/tools/classroom/mine/scenes.h"
#include "pushback/tools/classroom/mine/touching.h"

namespace pushback {

using namespace touching;

namespace {

Numbers from_the_surface(Random& random, const WholeSolver& answer) {
  Falling pair(random, meeting(random));
  pair.contact().restitution = random.between(Real(0.2), Real(0.9));
  pair.contact().depth = random.between(Real(0.005), Real(0.05));
  pair.solve(*answer.make(), few(random));
  return numbers_of_fall(pair);
}

/// A push-out of at least 0.2 · 0.1 m · 50 Hz is faster than this bounce.
Numbers bounces_only(Random& random, const WholeSolver& answer) {
  Pair pair(random, -random.between(Real(0.2), Real(0.4)));
  pair.contact().restitution = random.between(Real(0.4), Real(0.9));
  pair.contact().depth = random.between(Real(0.1), Real(0.2));
  return solved(pair, answer, few(random));
}

/// So deep, and so slow, that half the square of its speed at the surface would have been negative.
Numbers pressed_in(Random& random, const WholeSolver& answer) {
  Falling pair(random, -random.between(Real(0.2), Real(0.4)));
  pair.contact().restitution = random.between(Real(0.4), Real(0.9));
  pair.contact().depth = random.between(Real(0.1), Real(0.2));
  pair.solve(*answer.make(), few(random));
  return numbers_of_fall(pair);
}

/// A bounce in a step that begins with a guess, under gravity.
Numbers falls_on_a_guess(Random& random, const WholeSolver& answer) {
  Falling pair(random, -random.between(Real(0.1), Real(0.5)));
  const auto solver = answer.make();
  pair.solve(*solver, few(random));
  pair.next(pair.h, pair.world.contacts);
  pair.contact().restitution = random.between(Real(0.3), Real(0.9));
  pair.contact().depth = random.between(Real(0.005), Real(0.05));
  pair.meet(meeting(random));
  integrate_velocity(pair.world.bodies[1], pair.world.gravity, pair.h);
  pair.solve(*solver, few(random));
  return numbers_of_fall(pair);
}

/// One sweep: nothing of a bounce is left to a later one.
Numbers flat_beam_bounces(Random& random, const WholeSolver& answer) {
  const Real speed = random.between(1, 4);
  Beam beam(random, random.between(Real(0.7), Real(0.9)), speed);
  const Real e = random.between(Real(0.3), Real(0.9));
  for (Contact& c : beam.world.contacts) c.restitution = e;
  beam.solve(*answer.make(), 1);
  return {beam.world.bodies[1].velocity.y(), std::abs(beam.world.bodies[1].angular_velocity.z())};
}

/// Four to six balls in a line, of which the first hits the others.
Numbers row_of_balls(Random& random, const WholeSolver& answer) {
  Touching row(random);
  const auto balls = 4 + static_cast<std::uint32_t>(random.below(3));
  const Real radius = random.between(Real(0.2), Real(0.4)), e = random.between(Real(0.4), 1);
  for (std::uint32_t i = 0; i < balls; ++i) {
    const Real x = 2 * radius * static_cast<Real>(i);
    row.world.add(sphere(radius, random.between(5, 10)).at({x, 0, 0}));
    if (i > 0) row.touch(i - 1, i, {x - radius, 0, 0}, Vec3::UnitX()).restitution = e;
  }
  row.world.bodies[0].moving({random.between(2, 6), 0, 0});
  row.begin();
  row.solve(*answer.make(), 1);
  return {row.world.bodies.front().velocity.x(), row.world.bodies[balls - 2].velocity.x(),
          row.world.bodies.back().velocity.x()};
}

}  // namespace

std::vector<CheckOfChapter> checks_of_impacts() {
  const std::vector<int> all{};
  const double solved_impact = 1e-3;  // m/s: an impact is solved to a precision, which is each solver's own
  return {
      {9, all, {"a bounce is as fast as if it had begun at the surface", 1, of_a_fall, from_the_surface}},
      {9, all, {"a body that bounces is not pushed out besides", 1, of_a_pair, bounces_only}},
      {9, all, {"a body that is pressed in, and has not fallen in, is pushed out", 1, of_a_fall, pressed_in}},
      {9, all, {"what forces have added is read before the initial guess", 1, of_a_fall, falls_on_a_guess}},
      {9,
       all,
       {"after one sweep, a beam that lands flat has bounced flat",
        1,
        {{"your beam moves upwards with", "m/s", solved_impact}, {"your beam turns with", "rad/s", solved_impact}},
        flat_beam_bounces}},
      {9,
       all,
       {"after one sweep, a row of balls has passed the impact on",
        1,
        {{"the ball that hits the row goes on with", "m/s", solved_impact},
         {"the last but one leaves with", "m/s", solved_impact},
         {"the last ball leaves with", "m/s", solved_impact}},
        row_of_balls}},
  };
}

}  // namespace pushback
