#include "pushback/chapters/08_friction_cone/exercise/asked.h"
#include "pushback/common/exercise/shown.h"

namespace pushback::exercise_08 {

namespace {

/// A board on edge, with a skate right below its middle: friction and normal impulse do not act on each other. The blade is
/// turned against the board by 14 to 26 degrees.
class Board {
 public:
  Real mass;
  Skate skate;

  explicit Board(Random& random)
      : mass(random.between(5, 20)),
        skate{0, random.between(Real(0.09), Real(0.11)), random.between(Real(0.28), Real(0.33)), 0} {
    const Real height = random.between(Real(0.4), Real(0.6));
    const Real turn = (random.below(2) == 0 ? 1 : -1) * random.between(Real(0.25), Real(0.45));
    blade_ = {std::cos(turn), 0, std::sin(turn)};
    aside_ = {-std::sin(turn), 0, std::cos(turn)};
    world_.add(ground());
    world_.add(
        box({height * random.between(Real(1.2), Real(1.5)), height, height * Real(0.6)}, mass).at({0, height, 0}));
    world_.contacts = {{.normal = {0, 1, 0}, .id = {0, 1, 0}}};
  }
  /// It slides with this speed, m/s, at `heading` to the blade; the ground pushes with `normal` N s.
  void solve(Real speed, Real heading, Real normal, const Answer& answer) {
    body().velocity = speed * (std::cos(heading) * blade_ + std::sin(heading) * aside_);
    const Contact& at = world_.contacts[0];
    Row along(world_, at, blade_, 0), across(world_, at, aside_, 0);
    skate.k12 = across.n.dot(along.dvb) + across.rb_n.dot(along.dwb);
    skate.normal = normal;
    for (int i = 0; i < 300; ++i) answer.solve(along, across, skate);
    friction_along = along.impulse;
    friction_across = across.impulse;
    slip_along = along.speed();
    slip_across = across.speed();
    world_.contacts[0].impulse = normal * at.normal + friction_along * blade_ + friction_across * aside_;
    show(world_);
  }
  Real slip_along = 0, slip_across = 0, friction_along = 0, friction_across = 0;
  Real friction() const { return std::hypot(friction_along, friction_across); }
  Real slip() const { return std::hypot(slip_along, slip_across); }
  /// On whose ellipse friction is, N s.
  Real normal_needed() const { return std::hypot(friction_along / skate.mu_along, friction_across / skate.mu_across); }
  /// Degrees between the slip and what is opposite to the ellipse's normal; 0 where nothing slips.
  Real off_normal() const {
    if (slip() < Real(1e-6)) return 0;
    const Real x = -friction_along / (skate.mu_along * skate.mu_along);
    const Real y = -friction_across / (skate.mu_across * skate.mu_across);
    return std::atan2(std::abs(slip_along * y - slip_across * x), slip_along * x + slip_across * y) * 180 / pi;
  }

 private:
  Body& body() { return world_.bodies[1]; }
  World world_;
  Vec3 blade_, aside_;
};

Board sliding(Random& random, bool round, const Answer& answer) {
  Board board(random);
  if (round) board.skate.mu_along = board.skate.mu_across;
  const Real speed = random.between(4, 5), heading = random.between(Real(0.5), Real(0.9));
  board.solve(speed, heading, board.mass * random.between(Real(0.8), Real(1.2)), answer);
  return board;
}

std::vector<Check<Answer>> checks() {
  return {
      {"where μ is the same along and across, it is the disc of chapter 08",
       1,
       {{"your skate, which is as rough along as across, slips on along its blade with", "m/s", 1e-5},
        {"your skate, which is as rough along as across, slips on across its blade with", "m/s", 1e-5}},
       [](Random& random, const Answer& answer) -> Numbers {
         const Board board = sliding(random, true, answer);
         return {board.slip_along, board.slip_across};
       }},
      {"friction on a skate that slides is on the edge of its ellipse",
       2,
       {{"friction on your sliding skate is what the ellipse allows for a normal impulse of", "N s", 1e-5}},
       [](Random& random, const Answer& answer) -> Numbers {
         return {sliding(random, false, answer).normal_needed()};
       }},
      {"the slip is at a right angle to the edge of the ellipse",
       2,
       {{"the slip of your skate is off the right angle to the edge of its ellipse by", "°", 1e-5},
        {"your skate slips on along its blade with", "m/s", 1e-4},
        {"your skate slips on across its blade with", "m/s", 1e-4}},
       [](Random& random, const Answer& answer) -> Numbers {
         const Board board = sliding(random, false, answer);
         return {board.off_normal(), board.slip_along, board.slip_across};
       }},
      {"a skate that friction can hold is held",
       1,
       {{"your skate, which friction can hold, slips on with", "m/s", 1e-5},
        {"friction gives your skate, which it can hold,", "N s", 1e-4}},
       [](Random& random, const Answer& answer) -> Numbers {
         Board board(random);
         const Real speed = random.between(1, 2), heading = random.between(Real(0.5), Real(0.9));
         board.solve(speed, heading, 40 * board.mass, answer);
         return {board.slip(), board.friction()};
       }},
  };
}

// What is right, and what is not, is a way to move the sums (`moved`), and a way back (`within`).

struct Sums {
  Real along, across;
};

/// The larger eigenvalue of a block.
Real largest(Real k11, Real k12, Real k22) {
  return (k11 + k22) / 2 + std::hypot((k11 - k22) / 2, k12);
}
Real largest(const Row& along, const Row& across, const Skate& skate) {
  return largest(1 / along.effective_mass, skate.k12, 1 / across.effective_mass);
}
/// Of the block in which sums are measured in semi-axes.
Real largest_stretched(const Row& along, const Row& across, const Skate& skate) {
  const Real a = skate.mu_along, b = skate.mu_across;
  return largest(a * a / along.effective_mass, a * b * skate.k12, b * b / across.effective_mass);
}
/// Both at once.
void reach(Row& along, Row& across, const Sums& sums) {
  along.reach(sums.along);
  across.reach(sums.across);
}
/// Towards the centre, as far as the ellipse.
Sums drawn_back(const Sums& sums, Real mu_along, Real mu_across, Real normal) {
  const Real needed = std::hypot(sums.along / mu_along, sums.across / mu_across);
  const Real kept = needed > normal ? normal / needed : 1;
  return {kept * sums.along, kept * sums.across};
}
/// Steps of each their own size, kg; then drawn back.
void step_of(Row& along, Row& across, const Skate& skate, Real mass_along, Real mass_across) {
  const Sums moved{along.impulse - mass_along * along.speed(), across.impulse - mass_across * across.speed()};
  reach(along, across, drawn_back(moved, skate.mu_along, skate.mu_across, skate.normal));
}

void right(Row& along, Row& across, const Skate& skate) {
  const Real a = skate.mu_along, b = skate.mu_across, k = largest_stretched(along, across, skate);
  step_of(along, across, skate, a * a / k, b * b / k);
}

/// Chapter 08's, with a disc.
void disc(Row& along, Row& across, const Skate& skate, Real mu) {
  const Real k = largest(along, across, skate);
  const Sums moved{along.impulse - along.speed() / k, across.impulse - across.speed() / k};
  reach(along, across, drawn_back(moved, mu, mu, skate.normal));
}

/// The right step, drawn back by another length.
template <class Length>
void bounded(Row& along, Row& across, const Skate& skate, Length length) {
  const Real a = skate.mu_along, b = skate.mu_across, k = largest_stretched(along, across, skate);
  const Sums moved{along.impulse - a * a / k * along.speed(), across.impulse - b * b / k * across.speed()};
  const Real kept = std::min(Real(1), skate.normal / length(moved.along / a, moved.across / b, skate.normal));
  reach(along, across, {kept * moved.along, kept * moved.across});
}

std::vector<Mistake<Answer>> mistakes() {
  const std::string round =
      "it looks as if the bound were a disc. Along the blade friction can be μ₁ Σλₙ, across it μ₂ Σλₙ, and in between "
      "the ellipse decides.";
  const std::string opposite =
      "it looks as if friction were opposite to the slip, only shortened to the ellipse. Where it slips along as fast "
      "as across, the blade takes more energy across: the slip is at a right angle to the edge.";
  const std::string metric =
      "it looks as if sums were measured in semi-axes, but the slip were not. If y = λ/μ, an impulse y is worth μ y N "
      "s, so the slip that goes with it is μ u.";
  const std::string bounded_sum =
      "it looks as if no ellipse bounded the sum: without one, or with one around each correction, many calls add up "
      "to any friction. Friction of the whole step can be no more than the ellipse, however fast the skate slips.";
  const std::string slow =
      "it looks as if your step were made for the wrong block: it is far too short to arrive in 300 calls. Where sums "
      "are measured in semi-axes, each k is stretched as well, k₁₂ by both μ.";
  return {
      {"a disc", round, {[](Row& along, Row& across, const Skate& skate) {
         disc(along, across, skate, skate.mu_across);
       }}},
      {"a disc", round, {[](Row& along, Row& across, const Skate& skate) {
         disc(along, across, skate, skate.mu_along);
       }}},
      {"a disc", round, {[](Row& along, Row& across, const Skate& skate) {
         disc(along, across, skate, std::sqrt(skate.mu_along * skate.mu_across));
       }}},
      {"a disc", round, {[](Row& along, Row& across, const Skate& skate) {
         disc(along, across, skate, (skate.mu_along + skate.mu_across) / 2);
       }}},
      {"a rectangle",
       "it looks as if each tangent were clamped by itself. That allows a rectangle, and friction is carried to its "
       "corner.",
       {[](Row& along, Row& across, const Skate& skate) {
         const Real k = largest(along, across, skate), u = along.speed(), v = across.speed();
         const Real a = skate.mu_along * skate.normal, b = skate.mu_across * skate.normal;
         reach(along, across, {std::clamp(along.impulse - u / k, -a, a), std::clamp(across.impulse - v / k, -b, b)});
       }}},
      {"a rectangle",
       "it looks as if each tangent were clamped by itself. That allows a rectangle, and friction is carried to its "
       "corner.",
       {[](Row& along, Row& across, const Skate& skate) {
         const Real a = skate.mu_along * skate.normal, b = skate.mu_across * skate.normal;
         along.reach(std::clamp(along.wanted(), -a, a));
         across.reach(std::clamp(across.wanted(), -b, b));
       }}},
      {"opposite to the slip", opposite, {[](Row& along, Row& across, const Skate& skate) {
         const Real mass = 1 / largest(along, across, skate);
         step_of(along, across, skate, mass, mass);
       }}},
      {"1/k for each tangent",
       "it looks as if each tangent took a step of its own 1/k. At its fixed point friction is along (u₁/k₁₁, u₂/k₂₂): "
       "the masses decide on its direction, and they have no say in it.",
       {[](Row& along, Row& across, const Skate& skate) {
         step_of(along, across, skate, along.effective_mass, across.effective_mass);
       }}},
      {"solved and drawn back",
       "it looks as if the 2×2 block were solved, and the result drawn back to the ellipse. At its fixed point "
       "friction is along K_t⁻¹u: the masses decide on its direction, and they have no say in it.",
       {[](Row& along, Row& across, const Skate& skate) {
         const Real k11 = 1 / along.effective_mass, k22 = 1 / across.effective_mass, k12 = skate.k12;
         const Real u = along.speed(), v = across.speed(), determinant = k11 * k22 - k12 * k12;
         const Sums moved{along.impulse - (k22 * u - k12 * v) / determinant,
                          across.impulse - (k11 * v - k12 * u) / determinant};
         reach(along, across, drawn_back(moved, skate.mu_along, skate.mu_across, skate.normal));
       }}},
      {"the slip not stretched", metric, {[](Row& along, Row& across, const Skate& skate) {
         const Real k = largest_stretched(along, across, skate);
         step_of(along, across, skate, skate.mu_along / k, skate.mu_across / k);
       }}},
      {"the slip not stretched", metric, {[](Row& along, Row& across, const Skate& skate) {
         const Real k = largest(along, across, skate);
         step_of(along, across, skate, skate.mu_along / k, skate.mu_across / k);
       }}},
      {"a step for another block", slow, {[](Row& along, Row& across, const Skate& skate) {
         const Real a = skate.mu_along, b = skate.mu_across, k = largest(along, across, skate);
         step_of(along, across, skate, a * a / k, b * b / k);
       }}},
      {"the smaller eigenvalue",
       "it looks as if your step were too long, as 1 over the smaller eigenvalue is, or always as long as the ellipse "
       "lets it. What is thrown back further than it came never arrives.",
       {[](Row& along, Row& across, const Skate& skate) {
         const Real a = skate.mu_along, b = skate.mu_across;
         const Real k =
             a * a / along.effective_mass + b * b / across.effective_mass - largest_stretched(along, across, skate);
         step_of(along, across, skate, a * a / k, b * b / k);
       }}},
      {"the axes swapped",
       "it looks as if the semi-axes were swapped: your skate glides across its blade and grips along it.",
       {[](Row& along, Row& across, const Skate& skate) {
         Skate turned = skate;
         std::swap(turned.mu_along, turned.mu_across);
         right(along, across, turned);
       }}},
      {"the second slip read late",
       "it looks as if the second slip were read when the first tangent had acted already. The step then has another "
       "direction than the slip.",
       {[](Row& along, Row& across, const Skate& skate) {
         const Real a = skate.mu_along, b = skate.mu_across, k = largest_stretched(along, across, skate);
         along.reach(along.impulse - a * a / k * along.speed());
         across.reach(across.impulse - b * b / k * across.speed());
         reach(along, across, drawn_back({along.impulse, across.impulse}, a, b, skate.normal));
       }}},
      {"no bound", bounded_sum, {[](Row& along, Row& across, const Skate& skate) {
         Skate bound = skate;
         bound.normal = 1e9;
         right(along, across, bound);
       }}},
      {"the normal impulse forgotten",
       "it looks as if the semi-axes were μ₁ and μ₂ alone. A skate that is pressed twice as hard can be held twice as "
       "hard: they are μ₁ Σλₙ and μ₂ Σλₙ.",
       {[](Row& along, Row& across, const Skate& skate) {
         Skate bound = skate;
         bound.normal = 1;
         right(along, across, bound);
       }}},
      {"the 1-norm",
       "it looks as if the bound were |λ₁|/μ₁ + |λ₂|/μ₂ ≤ Σλₙ. That is a rhombus: the ellipse bounds the root of the "
       "sum of the squares.",
       {[](Row& along, Row& across, const Skate& skate) {
         bounded(along, across, skate, [](Real x, Real y, Real) { return std::abs(x) + std::abs(y); });
       }}},
      {"the square of the length",
       "it looks as if (λ₁/μ₁)² + (λ₂/μ₂)² were compared with Σλₙ, without its square, or divided by. Both sums are "
       "multiplied by Σλₙ over the root of that.",
       {[](Row& along, Row& across, const Skate& skate) {
         bounded(along, across, skate, [](Real x, Real y, Real) { return x * x + y * y; });
       }}},
      {"the square of the length",
       "it looks as if (λ₁/μ₁)² + (λ₂/μ₂)² were compared with Σλₙ, without its square, or divided by. Both sums are "
       "multiplied by Σλₙ over the root of that.",
       {[](Row& along, Row& across, const Skate& skate) {
         bounded(along, across, skate, [](Real x, Real y, Real normal) { return (x * x + y * y) / normal; });
       }}},
      {"the sum forgotten",
       "it looks as if the correction took the place of the sum. reach makes its argument the new sum: the old one "
       "counts.",
       {[](Row& along, Row& across, const Skate& skate) {
         const Real a = skate.mu_along, b = skate.mu_across, k = largest_stretched(along, across, skate);
         reach(along, across,
               drawn_back({-a * a / k * along.speed(), -b * b / k * across.speed()}, a, b, skate.normal));
       }}},
      {"no bound", bounded_sum, {[](Row& along, Row& across, const Skate& skate) {
         const Real a = skate.mu_along, b = skate.mu_across, k = largest_stretched(along, across, skate);
         const Sums change = drawn_back({-a * a / k * along.speed(), -b * b / k * across.speed()}, a, b, skate.normal);
         reach(along, across, {along.impulse + change.along, across.impulse + change.across});
       }}},
      {"sign",
       "it looks as if the sums were moved along the slip. Friction acts against it, and takes energy.",
       {[](Row& along, Row& across, const Skate& skate) {
         const Real a = skate.mu_along, b = skate.mu_across, k = -largest_stretched(along, across, skate);
         step_of(along, across, skate, a * a / k, b * b / k);
       }}},
      {"always at the edge",
       "it looks as if friction were brought to the edge of the ellipse from inside, too. Inside, it stays as it is.",
       {[](Row& along, Row& across, const Skate& skate) {
         const Real a = skate.mu_along, b = skate.mu_across, k = largest_stretched(along, across, skate);
         const Sums moved{along.impulse - a * a / k * along.speed(), across.impulse - b * b / k * across.speed()};
         const Real kept = skate.normal / std::hypot(moved.along / a, moved.across / b);
         reach(along, across, {kept * moved.along, kept * moved.across});
       }}},
  };
}

}  // namespace

Numbers play(std::size_t check, Random& random, const Answer& answer) {
  return checks()[check].play(random, answer);
}

Exercise exercise() {
  return exercise_of<Answer>(
      "a skate: an ellipse for the disc",
      {"Measured in its own semi-axes, the ellipse is a disc: what is (λ₁/μ₁, λ₂/μ₂) bounded by?",
       "Write y = (λ₁/μ₁, λ₂/μ₂). If y₁ grows by 1, the impulse grows by μ₁. By how much does the energy change, if "
       "the slip is u? And by how much does that change again, with K_t?",
       "So chapter 08's step is made in y: with the slip (μ₁u₁, μ₂u₂), and with a block whose k_ij is μ_i μ_j times "
       "the old one."},
      checks(), {right}, mistakes());
}

}  // namespace pushback::exercise_08
