#include "pushback/chapters/02_clamping/exercise/asked.h"
#include "pushback/common/exercise/shown.h"
#include "pushback/common/world/world.h"

namespace pushback::exercise_02 {

namespace {

/// What one step does to a magnet on the ground, which is iron.
struct Magnet {
  World world;
  Rows rows;
  Real force, h;

  /// A ball, which touches at one point, moves upwards with `share` of the speed from which the magnet can just stop it.
  static Magnet ball(Random& random, Real share) {
    return {random, sphere(Real(0.5), random.between(5, 20)).at({0, Real(0.499), 0}), share};
  }
  /// The column of the page, which touches at four.
  static Magnet column(Random& random, Real share) {
    const Real width = random.between(Real(0.22), Real(0.28)), height = random.between(Real(0.75), Real(0.9));
    return {random, box({width, height, width}, random.between(50, 150)).at({0, height - Real(0.001), 0}), share};
  }

  Body& body() { return world.bodies[1]; }
  /// m/s, from which the magnet can just stop the body in this step.
  Real can_stop() { return force * h * body().inverse_mass; }
  void play(const Answer& answer, const std::vector<std::size_t>& quantities = {}, Real bias = 0) {
    for (Row& row : rows) row.bias = bias;
    for (int sweep = 0; sweep < 100; ++sweep) answer.sweep(rows, force, h);
    for (std::size_t i = 0; i < std::min(rows.size(), world.contacts.size()); ++i)
      world.contacts[i].impulse = rows[i].impulse * rows[i].n;
    show(world, quantities);
  }
  Real upwards() { return body().velocity.y(); }
  Real impulse() const {
    Real sum = 0;
    for (const Row& row : rows) sum += row.impulse;
    return sum;
  }
  Real least_impulse() const {
    Real least = std::numeric_limits<Real>::infinity();
    for (const Row& row : rows) least = std::min(least, row.impulse);
    return least;
  }

  Magnet(const Magnet&) = delete;

 private:
  Magnet(Random& random, const Body& made, Real share)
      : force(random.between(40, 80) / made.inverse_mass), h(1 / random.between(50, 80)) {
    world.add(ground());
    world.add(made);
    body().velocity.y() = share * can_stop();
    world.find_contacts();
    for (std::size_t i = 0; i < world.contacts.size(); ++i)
      rows.emplace_back(world, world.contacts[i], world.contacts[i].normal, i);
  }
};

std::vector<Check<Answer>> checks() {
  return {
      {"a ball that the magnet can hold stays",
       1,
       {{"your ball, which the magnet can hold, leaves with", "m/s", 1e-6},
        {"the row of your ball keeps an impulse of", "N s", 1e-4}},
       [](Random& random, const Answer& answer) -> Numbers {
         Magnet ball = Magnet::ball(random, random.between(Real(0.3), Real(0.9)));
         ball.play(answer);
         return {ball.upwards(), ball.impulse()};
       }},
      {"a ball that is too fast leaves, slower by F h / m",
       2,
       {{"your ball, which is too fast for the magnet, leaves with", "m/s", 1e-6},
        {"your ball, which is shot off the magnet, leaves with", "m/s", 1e-6},
        {"the row of the shot ball keeps an impulse of", "N s", 1e-4}},
       [](Random& random, const Answer& answer) -> Numbers {
         Magnet ball = Magnet::ball(random, random.between(Real(1.5), 4));
         Magnet shot = Magnet::ball(random, random.between(150, 300));
         ball.play(answer, {0});
         shot.play(answer, {1, 2});
         return {ball.upwards(), shot.upwards(), shot.impulse()};
       }},
      {"a ball that lands is stopped, however hard",
       1,
       {{"your ball, which lands on the magnet, leaves with", "m/s", 1e-6},
        {"the row of your ball keeps an impulse of", "N s", 1e-4},
        {"your column, which lands flat and hard, leaves with", "m/s", 1e-6},
        {"your column, which lands flat and hard, turns with", "rad/s", 1e-6}},
       [](Random& random, const Answer& answer) -> Numbers {
         Magnet ball = Magnet::ball(random, -random.between(Real(1.5), 4));
         Magnet column = Magnet::column(random, -random.between(8, 12));
         ball.play(answer, {0, 1});
         column.play(answer, {2, 3});
         return {ball.upwards(), ball.impulse(), column.upwards(), column.body().angular_velocity.norm()};
       }},
      {"b is minus the speed that is wanted",
       1,
       {{"your ball, of which b asks a separating speed, leaves with", "m/s", 1e-6}},
       [](Random& random, const Answer& answer) -> Numbers {
         Magnet ball = Magnet::ball(random, random.between(Real(0.4), Real(0.9)));
         ball.play(answer, {}, -random.between(Real(0.1), Real(0.3)) * ball.can_stop());
         return {ball.upwards()};
       }},
      {"the four points of a column hold F together",
       2,
       {{"your column, which is too fast for four points, leaves with", "m/s", 1e-6},
        {"your column, which four points can hold, leaves with", "m/s", 1e-6},
        {"the impulses of the latter's four rows add up to", "N s", 1e-4}},
       [](Random& random, const Answer& answer) -> Numbers {
         Magnet fast = Magnet::column(random, random.between(Real(1.3), 3));
         Magnet slow = Magnet::column(random, random.between(Real(0.3), Real(0.7)));
         fast.play(answer, {0});
         slow.play(answer, {1, 2});
         return {fast.upwards(), slow.upwards(), slow.impulse()};
       }},
      {"a column that lands turning is pushed on one side, and held on the other",
       1,
       {{"your column, which lands turning, leaves with", "m/s", 1e-6},
        {"your column turns on with", "rad/s", 1e-6},
        {"the least impulse of its four rows is", "N s", 1e-4}},
       [](Random& random, const Answer& answer) -> Numbers {
         Magnet column = Magnet::column(random, -random.between(1, 2));
         column.body().angular_velocity.z() = random.between(8, 12) * column.can_stop();
         column.play(answer);
         return {column.upwards(), column.body().angular_velocity.z(), column.least_impulse()};
       }},
  };
}

Real wanted(const Row& row) {
  return row.impulse - row.effective_mass * (row.speed() + row.bias);
}

/// What each of the points can pull in a step, N s.
Real pull(const Rows& rows, Real force, Real h) {
  return force * h / static_cast<Real>(rows.size());
}

void reach(Row& row, Real sum) {
  row.apply(sum - row.impulse);
  row.impulse = sum;
}

void right(Rows& rows, Real force, Real h) {
  for (Row& row : rows) reach(row, std::max(-pull(rows, force, h), wanted(row)));
}

std::vector<Mistake<Answer>> mistakes() {
  const std::string lets_go =
      "it looks as if the magnet let go at once of what it cannot hold. It still pulls with all of F and slows it "
      "down.";
  const std::string points =
      "it looks as if some points were left out. The magnet holds at all n of them, each with F/n.";
  return {
      {"no magnet",
       "it looks as if nothing pulled. The sum may be negative, down to what the magnet can give.",
       {[](Rows& rows, Real, Real) {
         for (Row& row : rows) reach(row, std::max(Real(0), wanted(row)));
       }}},
      {"glue",
       "it looks as if the magnet held whatever comes. It can give F for h seconds, and no more.",
       {[](Rows& rows, Real, Real) {
         for (Row& row : rows) reach(row, wanted(row));
       }}},
      {"h forgotten",
       "it looks as if the impulse were compared with the force. A force of F gives F h newton seconds in a step.",
       {[](Rows& rows, Real force, Real) {
         for (Row& row : rows) reach(row, std::max(-pull(rows, force, 1), wanted(row)));
       }}},
      {"sign of F",
       "it looks as if the magnet pushed with F, or more. A pull is a negative impulse: the sum is at least -F h.",
       {[](Rows& rows, Real force, Real h) {
         for (Row& row : rows) reach(row, std::max(pull(rows, force, h), wanted(row)));
       }}},
      {"each correction limited",
       "it looks as if each correction were limited, not their sum. A magnet that pulls with F h again in each of a "
       "hundred sweeps holds a hundred times its force.",
       {[](Rows& rows, Real force, Real h) {
         for (Row& row : rows) reach(row, row.impulse + std::max(-pull(rows, force, h), wanted(row) - row.impulse));
       }}},
      {"the push limited as well",
       "it looks as if the push had a limit, too. F is the most that the magnet pulls; iron that is landed on pushes "
       "back as hard as it takes.",
       {[](Rows& rows, Real force, Real h) {
         for (Row& row : rows) reach(row, std::clamp(wanted(row), -pull(rows, force, h), pull(rows, force, h)));
       }}},
      {"the old sum limited",
       "it looks as if the old sum were limited, and the correction added after that. Then the sum itself may pull by "
       "any amount: limit the new sum, max(-F h / n, Σλ + λ).",
       {[](Rows& rows, Real force, Real h) {
         for (Row& row : rows) reach(row, std::max(-pull(rows, force, h), row.impulse) + wanted(row) - row.impulse);
       }}},
      {"a limit on what is applied",
       "it looks as if what is applied at a time were limited as well. A push that was too large is taken back whole, "
       "however large: only the sum is limited.",
       {[](Rows& rows, Real force, Real h) {
         for (Row& row : rows) {
           const Real sum = std::max(-pull(rows, force, h), wanted(row));
           row.apply(std::max(-pull(rows, force, h), sum - row.impulse));
           row.impulse = sum;
         }
       }}},
      {"points left out", points, {[](Rows& rows, Real force, Real h) {
         reach(rows[0], std::max(-pull(rows, force, h), wanted(rows[0])));
       }}},
      {"points left out", points, {[](Rows& rows, Real force, Real h) {
         for (std::size_t i = 0; i < std::min<std::size_t>(2, rows.size()); ++i)
           reach(rows[i], std::max(-pull(rows, force, h), wanted(rows[i])));
       }}},
      {"always four points",
       "it looks as if F were always shared by four points. A ball touches at one: n is rows.size().",
       {[](Rows& rows, Real force, Real h) {
         for (Row& row : rows) reach(row, std::max(-force * h / 4, wanted(row)));
       }}},
      {"sign of b",
       "it looks as if b had the wrong sign. The row solves J V + b = 0, so the wanted speed is -b.",
       {[](Rows& rows, Real force, Real h) {
         for (Row& row : rows)
           reach(row, std::max(-pull(rows, force, h), row.impulse - row.effective_mass * (row.speed() - row.bias)));
       }}},
      {"lets go", lets_go, {[](Rows& rows, Real force, Real h) {
         for (Row& row : rows) reach(row, wanted(row) < -pull(rows, force, h) ? 0 : wanted(row));
       }}},
      {"F at each point",
       "it looks as if each of the four points held F. The magnet has F in all, and each point an equal part.",
       {[](Rows& rows, Real force, Real h) {
         for (Row& row : rows) reach(row, std::max(-force * h, wanted(row)));
       }}},
      {"always pulled",
       "it looks as if the magnet pulled with F beside what the row wants. The row already has what it takes to reach "
       "J V + b = 0; F is only how far its sum may go.",
       {[](Rows& rows, Real force, Real h) {
         for (Row& row : rows) reach(row, std::max(Real(0), wanted(row)) - pull(rows, force, h));
       }}},
      {"the sum applied",
       "it looks as if the whole sum were applied each time. The bodies have had the old sum already: apply the "
       "difference.",
       {[](Rows& rows, Real force, Real h) {
         for (Row& row : rows) {
           row.impulse = std::max(-pull(rows, force, h), wanted(row));
           row.apply(row.impulse);
         }
       }}},
      {"stored unlimited",
       "it looks as if the row kept the sum from before it was limited. The next sweep then takes a pull for granted "
       "that no body has felt.",
       {[](Rows& rows, Real force, Real h) {
         for (Row& row : rows) {
           const Real sum = wanted(row);
           row.apply(std::max(-pull(rows, force, h), sum) - row.impulse);
           row.impulse = sum;
         }
       }}},
      {"nothing kept",
       "it looks as if the sum began anew in each sweep: row.impulse is never written, or set back to 0. Without the "
       "sum nobody knows how much has been pulled already.",
       {[](Rows& rows, Real force, Real h) {
         for (Row& row : rows) row.apply(std::max(-pull(rows, force, h), wanted(row)) - row.impulse);
       }}},
      {"b left out",
       "it looks as if b were left out. The row solves J V + b = 0.",
       {[](Rows& rows, Real force, Real h) {
         for (Row& row : rows)
           reach(row, std::max(-pull(rows, force, h), row.impulse - row.effective_mass * row.speed()));
       }}},
  };
}

}  // namespace

Numbers play(std::size_t check, Random& random, const Answer& answer) {
  return checks()[check].play(random, answer);
}

Exercise exercise() {
  return exercise_of<Answer>("a magnet that holds up to F",
                             {"Chapter 02 keeps the sum of each row in [0, ∞). Only one end of that interval changes.",
                              "An impulse is compared with impulses. Which impulse can the magnet give in h seconds, "
                              "and which part of it one of its points?",
                              "The sum is at least -F h / n for a magnet of n points. Clamp it, apply what it differs "
                              "from the old one, keep it."},
                             checks(), {right}, mistakes());
}

}  // namespace pushback::exercise_02
