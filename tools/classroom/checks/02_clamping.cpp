#include "pushback/chapters/02_clamping/exercise/asked.h"
#include "pushback/common/world/world.h"

namespace pushback::exercise_02 {

namespace {

/// What one step does to a magnet on the ground, which is iron.
struct Magnet {
  World world;
  Rows rows;
  Real force, h;

  /// It moves upwards with `share` of the speed from which the magnet can just stop it.
  Magnet(Random& random, const Body& made, Real share)
      : force(random.between(40, 80) / made.inverse_mass), h(1 / random.between(50, 80)) {
    world.add(ground());
    world.add(made);
    body().velocity.y() = share * can_stop();
    world.find_contacts();
    for (std::size_t i = 0; i < world.contacts.size(); ++i)
      rows.emplace_back(world, world.contacts[i], world.contacts[i].normal, i);
  }
  Magnet(const Magnet&) = delete;

  Body& body() { return world.bodies[1]; }
  /// m/s, from which the magnet can just stop the body in this step.
  Real can_stop() { return force * h * body().inverse_mass; }
  Real upwards() { return body().velocity.y(); }
  /// Returns the sum of all impulses, N s.
  Real play(const Answer& answer, Real bias = 0) {
    for (Row& row : rows) row.bias = bias;
    for (int sweep = 0; sweep < 100; ++sweep) answer.sweep(rows, force, h);
    Real sum = 0;
    for (const Row& row : rows) sum += row.impulse;
    return sum;
  }
};

/// Touches at one point.
Body ball(Random& random) {
  return sphere(Real(0.5), random.between(5, 20)).at({0, Real(0.499), 0});
}

/// The column of the page, which touches at four.
Body column(Random& random) {
  const Real width = random.between(Real(0.22), Real(0.28)), height = random.between(Real(0.75), Real(0.9));
  return box({width, height, width}, random.between(50, 150)).at({0, height - Real(0.001), 0});
}

void right(Rows& rows, Real force, Real h) {
  const Real least = -force * h / static_cast<Real>(rows.size());
  for (Row& row : rows) {
    const Real sum = std::max(least, row.impulse - row.effective_mass * (row.speed() + row.bias));
    row.apply(sum - row.impulse);
    row.impulse = sum;
  }
}

}  // namespace

std::vector<Check<Answer>> checks_of(const Answer& /*any*/) {
  return {
      {"a ball that the magnet can hold stays", 1,
       [](Random& random, const Answer& answer) -> std::vector<Reading> {
         Magnet held(random, ball(random), random.between(Real(0.3), Real(0.9)));
         const Real impulse = held.play(answer);
         return {{"your ball, which the magnet can hold, leaves at", held.upwards(), "m/s"},
                 {"the accumulated impulse of your ball's row is", impulse, "N s", 1e-4}};
       },
       "the magnet pulls until the ball stops. The accumulated impulse may be negative, down to -F h, the impulse of F "
       "in one step."},
      {"a ball that is too fast leaves, but slower by F h / m", 2,
       [](Random& random, const Answer& answer) -> std::vector<Reading> {
         Magnet fast(random, ball(random), random.between(Real(1.5), 4));
         const Real impulse = fast.play(answer);
         return {{"your ball, which is too fast for the magnet, leaves at", fast.upwards(), "m/s"},
                 {"the accumulated impulse of your ball's row is", impulse, "N s", 1e-4}};
       },
       "the magnet pulls with at most F for h seconds. The accumulated impulse is at least -F h. This is not a bound "
       "on each correction."},
      {"a ball that lands stops, however hard it lands", 1,
       [](Random& random, const Answer& answer) -> std::vector<Reading> {
         Magnet one(random, ball(random), -random.between(Real(1.5), 4));
         Magnet four(random, column(random), -random.between(8, 12));
         const Real impulse = one.play(answer);
         four.play(answer);
         return {{"your ball, which lands on the magnet, leaves at", one.upwards(), "m/s"},
                 {"the accumulated impulse of your ball's row is", impulse, "N s", 1e-4},
                 {"your column, which lands flat and hard, leaves at", four.upwards(), "m/s"}};
       },
       "only the pull is limited. The iron pushes back at all of its points, as hard as it takes to stop the body."},
      {"b is minus the target speed", 1,
       [](Random& random, const Answer& answer) -> std::vector<Reading> {
         Magnet asked(random, ball(random), random.between(Real(0.4), Real(0.9)));
         asked.play(answer, -random.between(Real(0.1), Real(0.3)) * asked.can_stop());
         return {{"your ball, for which b sets a target speed, leaves at", asked.upwards(), "m/s"}};
       },
       "the row makes J V + b = 0, so the target speed is -b."},
      {"the four points of a column hold F together", 2,
       [](Random& random, const Answer& answer) -> std::vector<Reading> {
         Magnet fast(random, column(random), random.between(Real(1.3), 3));
         Magnet slow(random, column(random), random.between(Real(0.3), Real(0.7)));
         fast.play(answer);
         slow.play(answer);
         return {{"your column, which is too fast for four points, leaves at", fast.upwards(), "m/s"},
                 {"your column, which four points can hold, leaves at", slow.upwards(), "m/s"}};
       },
       "the magnet can pull with F in total, so each of its n points can pull with F/n."},
      {"a column that lands while it rotates is pushed on one side and held on the other", 1,
       [](Random& random, const Answer& answer) -> std::vector<Reading> {
         Magnet lands(random, column(random), -random.between(1, 2));
         lands.body().angular_velocity.z() = random.between(8, 12) * lands.can_stop();
         lands.play(answer);
         return {{"your column, which lands while it rotates, leaves at", lands.upwards(), "m/s"},
                 {"your column continues to rotate at", lands.body().angular_velocity.z(), "rad/s"}};
       },
       "each point has its own accumulated impulse: a push of any size, or a pull of at most F h / n."},
  };
}

Exercise exercise() {
  return exercise_of("a magnet that holds up to F",
                     {"Chapter 02 keeps the sum of each row in [0, ∞). Only one end of that interval changes.",
                      "Compare impulses with impulses. Which impulse can the magnet give in h seconds, and which "
                      "fraction of it can each point give?",
                      "The accumulated impulse is at least -F h / n for a magnet with n points. Clamp it, apply the "
                      "difference from the old one, and store it."},
                     Answer{right});
}

}  // namespace pushback::exercise_02
