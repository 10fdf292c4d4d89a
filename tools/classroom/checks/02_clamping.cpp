#include "pushback/chapters/02_clamping/exercise/asked.h"
#include "pushback/common/exercise/shown.h"

namespace pushback::exercise_02 {

namespace {

/// The rows of what touches in this world, each solved `sweeps` times by the answer.
Rows solved(World& world, const Answer& answer, int sweeps, Real bias = 0,
            const std::vector<std::size_t>& quantities = {}) {
  world.find_contacts();
  Rows rows;
  for (std::size_t i = 0; i < world.contacts.size(); ++i) {
    rows.emplace_back(world, world.contacts[i], world.contacts[i].normal, i);
    rows.back().bias = bias;
  }
  for (int sweep = 0; sweep < sweeps; ++sweep)
    for (Row& row : rows) answer.solve(row);
  for (std::size_t i = 0; i < rows.size(); ++i) world.contacts[i].impulse = rows[i].impulse * rows[i].n;
  show(world, quantities);
  return rows;
}

Real sum_of(const Rows& rows) {
  Real sum = 0;
  for (const Row& row : rows) sum += row.impulse;
  return sum;
}

/// A ball that touches the ground and moves up or down: its speed after ten sweeps, and the impulse that was kept.
struct Ball {
  Real speed, impulse;
  Ball(Real mass, Real upwards, const Answer& answer, Real bias = 0, const std::vector<std::size_t>& quantities = {}) {
    World world;
    world.add(ground());
    world.add(sphere(Real(0.5), mass).at({0, Real(0.499), 0}).moving({0, upwards, 0}));
    impulse = sum_of(solved(world, answer, 10, bias, quantities));
    speed = world.bodies[1].velocity.y();
  }
};

/// The column of the page, 1 mm in the ground.
World column(Random& random) {
  World world;
  const Real width = random.between(Real(0.22), Real(0.28)), height = random.between(Real(0.75), Real(0.9));
  world.add(ground());
  world.add(box({width, height, width}, random.between(50, 150)).at({0, height - Real(0.001), 0}));
  return world;
}

std::vector<Check<Answer>> checks() {
  return {
      {"a ball that lands stops",
       1,
       {{"your ball, which lands alone on one point, leaves with", "m/s", 1e-6},
        {"its row keeps an impulse of", "N s", 1e-6}},
       [](Random& random, const Answer& answer) -> Numbers {
         const Real mass = random.between(5, 20), fall = random.between(1, 5);
         const Ball ball(mass, -fall, answer);
         return {ball.speed, ball.impulse};
       }},
      {"a ball that leaves is not held back, nor pushed",
       1,
       {{"your ball, which was leaving by itself, leaves with", "m/s", 1e-6},
        {"its row keeps an impulse of", "N s", 1e-6}},
       [](Random& random, const Answer& answer) -> Numbers {
         const Real mass = random.between(5, 20), leaves = random.between(1, 5);
         const Ball ball(mass, leaves, answer);
         return {ball.speed, ball.impulse};
       }},
      {"b is minus the speed that is wanted",
       1,
       {{"your ball, of which b asks a separating speed, leaves with", "m/s", 1e-6},
        {"your ball, which b lets come nearer, goes on with", "m/s", 1e-6}},
       [](Random& random, const Answer& answer) -> Numbers {
         const Real mass = random.between(5, 20), fall = random.between(1, 5), wanted = random.between(1, 3);
         const Real slower = random.between(Real(0.2), Real(0.8)) * fall;
         return {Ball(mass, -fall, answer, -wanted, {0}).speed, Ball(mass, -fall, answer, slower, {1}).speed};
       }},
      {"a column that lands flat comes to rest",
       2,
       {{"your column leaves with", "m/s", 1e-6},
        {"your column turns with", "rad/s", 1e-6},
        {"the impulses of its four rows add up to", "N s", 1e-4}},
       [](Random& random, const Answer& answer) -> Numbers {
         World world = column(random);
         Body& body = world.bodies[1];
         body.velocity.y() = -random.between(2, 4);
         const Real sum = sum_of(solved(world, answer, 60));
         return {body.velocity.y(), body.angular_velocity.norm(), sum};
       }},
      {"a column that turns is pushed on one side, and let go on the other",
       2,
       {{"your column leaves with", "m/s", 1e-6},
        {"your column turns on with", "rad/s", 1e-6},
        {"the least impulse of its four rows is", "N s", 1e-4}},
       [](Random& random, const Answer& answer) -> Numbers {
         World world = column(random);
         Body& body = world.bodies[1];
         body.velocity.y() = -random.between(Real(0.8), Real(1.2));
         body.angular_velocity.z() = random.between(5, 7);
         Real least = std::numeric_limits<Real>::infinity();
         for (const Row& row : solved(world, answer, 60)) least = std::min(least, row.impulse);
         return {body.velocity.y(), body.angular_velocity.z(), least};
       }},
  };
}

Real wanted(const Row& row) {
  return row.impulse - row.effective_mass * (row.speed() + row.bias);
}

void right(Row& row) {
  const Real sum = std::max(Real(0), wanted(row));
  row.apply(sum - row.impulse);
  row.impulse = sum;
}

std::vector<Mistake<Answer>> mistakes() {
  const std::string cut_off =
      "it looks as if a b of one sign did not count. A negative b asks for a separating speed, and a positive b lets "
      "the bodies come nearer at up to that speed: the row solves J V + b = 0 for both.";
  return {
      {"each correction clamped",
       "it looks as if each correction were clamped, not their sum. A correction that is negative takes back a push "
       "that was too large; without it nothing ever does.",
       {[](Row& row) {
         const Real lambda = std::max(Real(0), -row.effective_mass * (row.speed() + row.bias));
         row.impulse += lambda;
         row.apply(lambda);
       }}},
      {"the sum applied",
       "it looks as if the whole sum were applied each time. The bodies have had the old sum already: apply the "
       "difference.",
       {[](Row& row) {
         row.impulse = std::max(Real(0), wanted(row));
         row.apply(row.impulse);
       }}},
      {"stored unclamped",
       "it looks as if the row kept the sum from before it was clamped. The next sweep then takes a pull for granted "
       "that no body has felt.",
       {[](Row& row) {
         const Real sum = wanted(row);
         row.apply(std::max(Real(0), sum) - row.impulse);
         row.impulse = sum;
       }}},
      {"stored unclamped",
       "it looks as if the row kept the sum from before it was clamped. What is kept has to be what the bodies have "
       "felt.",
       {[](Row& row) {
         const Real sum = wanted(row);
         row.apply(std::max(Real(0), sum) - std::max(Real(0), row.impulse));
         row.impulse = sum;
       }}},
      {"not clamped",
       "it looks as if nothing were clamped. The ground pulls at what wants to leave, and it has no glue.",
       {[](Row& row) {
         const Real sum = wanted(row);
         row.apply(sum - row.impulse);
         row.impulse = sum;
       }}},
      {"the old sum clamped",
       "it looks as if the old sum were clamped, and the correction added after that. What is then kept and applied "
       "may be negative, a pull: clamp the new sum, max(0, Σλ + λ).",
       {[](Row& row) {
         const Real sum = std::max(Real(0), row.impulse) + wanted(row) - row.impulse;
         row.apply(sum - row.impulse);
         row.impulse = sum;
       }}},
      {"an upper limit for the lower one",
       "it looks as if the sum were kept below 0, by min. A contact pushes and never pulls: 0 is the least that the "
       "sum may be.",
       {[](Row& row) {
         const Real sum = std::min(Real(0), wanted(row));
         row.apply(sum - row.impulse);
         row.impulse = sum;
       }}},
      {"the correction applied as it was",
       "it looks as if only the kept sum were clamped, and the bodies got the whole correction. They get what the "
       "clamped sum differs from the old one.",
       {[](Row& row) {
         const Real sum = wanted(row);
         row.apply(sum - row.impulse);
         row.impulse = std::max(Real(0), sum);
       }}},
      {"the correction kept",
       "it looks as if the last correction were kept in the place of the sum. row.impulse is the sum of all of them.",
       {[](Row& row) {
         const Real correction = std::max(Real(0), wanted(row) - row.impulse);
         row.apply(correction - row.impulse);
         row.impulse = correction;
       }}},
      {"the difference turned round",
       "it looks as if the new sum were taken from the old one. The bodies get what is new: the new sum minus the old.",
       {[](Row& row) {
         const Real sum = std::max(Real(0), wanted(row));
         row.apply(row.impulse - sum);
         row.impulse = sum;
       }}},
      {"K for 1/K",
       "it looks as if J V + b were divided by row.effective_mass, or not multiplied by it. The effective mass is 1/K, "
       "in kg: times a speed it is an impulse.",
       {[](Row& row) {
         const Real sum = std::max(Real(0), row.impulse - (row.speed() + row.bias) / row.effective_mass);
         row.apply(sum - row.impulse);
         row.impulse = sum;
       }}},
      {"K for 1/K",
       "it looks as if J V + b were divided by row.effective_mass, or not multiplied by it. The effective mass is 1/K, "
       "in kg: times a speed it is an impulse.",
       {[](Row& row) {
         const Real sum = std::max(Real(0), row.impulse - (row.speed() + row.bias));
         row.apply(sum - row.impulse);
         row.impulse = sum;
       }}},
      {"b cut off", cut_off, {[](Row& row) {
         const Real b = std::min(Real(0), row.bias);
         const Real sum = std::max(Real(0), row.impulse - row.effective_mass * (row.speed() + b));
         row.apply(sum - row.impulse);
         row.impulse = sum;
       }}},
      {"b cut off", cut_off, {[](Row& row) {
         const Real b = std::max(Real(0), row.bias);
         const Real sum = std::max(Real(0), row.impulse - row.effective_mass * (row.speed() + b));
         row.apply(sum - row.impulse);
         row.impulse = sum;
       }}},
      {"nothing kept",
       "it looks as if the sum began anew in each sweep: row.impulse is never written, or set back to 0. Without the "
       "sum of the whole step nobody knows how much of a push can be taken back.",
       {[](Row& row) { row.apply(std::max(Real(0), wanted(row)) - row.impulse); }}},
      {"b left out", "it looks as if b were left out. The row solves J V + b = 0.", {[](Row& row) {
         const Real sum = std::max(Real(0), row.impulse - row.effective_mass * row.speed());
         row.apply(sum - row.impulse);
         row.impulse = sum;
       }}},
      {"sign of b",
       "it looks as if b had the wrong sign. The row solves J V + b = 0, so the wanted speed is -b.",
       {[](Row& row) {
         const Real sum = std::max(Real(0), row.impulse - row.effective_mass * (row.speed() - row.bias));
         row.apply(sum - row.impulse);
         row.impulse = sum;
       }}},
  };
}

}  // namespace

Numbers play(std::size_t check, Random& random, const Answer& answer) {
  return checks()[check].play(random, answer);
}

Exercise exercise() {
  return exercise_of<Answer>(
      "accumulate, clamp, apply the difference",
      {"If no other row existed, the row would want the sum Σλ - (J V + b) / K. Compute that first.",
       "A contact pushes and never pulls, over the whole step: the sum is at least 0.",
       "The bodies have already had row.impulse. What they get now is the new sum minus the old one: row.apply(new - "
       "old). Then row.impulse becomes the new sum."},
      checks(), {right}, mistakes());
}

}  // namespace pushback::exercise_02
