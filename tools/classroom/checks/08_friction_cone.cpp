#include "pushback/chapters/08_friction_cone/exercise/asked.h"
#include "pushback/tools/classroom/checks/scenes.h"

namespace pushback::exercise_08 {

namespace {

/// A board on edge, with a skate right below its middle, so friction and normal impulse do not affect each other. The blade is
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
    const Vec3 half{height * random.between(Real(1.2), Real(1.5)), height, height * Real(0.6)};
    world_ = on_the_ground(box(half, mass).at({0, height, 0}));
  }
  /// The board slides at this speed, m/s, at `heading` to the blade. The ground pushes with `normal` N s.
  void solve(Real speed, Real heading, Real normal, const Answer& answer) {
    world_.bodies[1].velocity = speed * (std::cos(heading) * blade_ + std::sin(heading) * aside_);
    const Contact& at = world_.contacts[0];
    Row along(world_, at, blade_, 0), across(world_, at, aside_, 0);
    skate.k12 = across.n.dot(along.dvb) + across.rb_n.dot(along.dwb);
    skate.normal = normal;
    for (int i = 0; i < 300; ++i) answer.solve(along, across, skate);
    friction_along = along.impulse;
    friction_across = across.impulse;
    slip_along = along.speed();
    slip_across = across.speed();
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

void right(Row& along, Row& across, const Skate& skate) {
  const Real a = skate.mu_along, b = skate.mu_across;
  const Real k11 = a * a / along.effective_mass, k12 = a * b * skate.k12, k22 = b * b / across.effective_mass;
  const Real k = (k11 + k22) / 2 + std::hypot((k11 - k22) / 2, k12);
  const Real moved_along = along.impulse - a * a / k * along.speed(),
             moved_across = across.impulse - b * b / k * across.speed();
  const Real needed = std::hypot(moved_along / a, moved_across / b);
  const Real kept = needed > skate.normal ? skate.normal / needed : 1;
  along.reach(kept * moved_along);
  across.reach(kept * moved_across);
}

}  // namespace

std::vector<Check<Answer>> checks_of(const Answer& /*any*/) {
  return {
      {"if μ is the same along and across, the ellipse is the disc of chapter 08", 1,
       [](Random& random, const Answer& answer) -> std::vector<Reading> {
         return {{"your skate, which is as rough along as across, continues along its blade at",
                  sliding(random, true, answer).slip_along, "m/s", 1e-5}};
       },
       "with μ₁ = μ₂ the ellipse is a disc of radius μ Σλₙ, and friction is opposite to the slip."},
      {"the friction of a sliding skate is on the edge of its ellipse", 2,
       [](Random& random, const Answer& answer) -> std::vector<Reading> {
         return {{"the friction of your sliding skate is on the edge of the ellipse for a normal impulse of",
                  sliding(random, false, answer).normal_needed(), "N s", 1e-5}};
       },
       "the friction of a sliding skate is on the edge of the ellipse with the semi-axes μ₁ Σλₙ and μ₂ Σλₙ, so "
       "(λ₁/μ₁)² + (λ₂/μ₂)² = Σλₙ²."},
      {"the slip is at a right angle to the edge of the ellipse", 2,
       [](Random& random, const Answer& answer) -> std::vector<Reading> {
         const Board board = sliding(random, false, answer);
         return {{"the angle between the slip of your skate and the normal of its ellipse is", board.off_normal(), "°",
                  1e-5},
                 {"your skate continues along its blade at", board.slip_along, "m/s", 1e-4}};
       },
       "friction dissipates as much energy as it can, so the slip is at a right angle to the edge. If the sums are "
       "measured in semi-axes, the slip is (μ₁u₁, μ₂u₂), and each k_ij is multiplied by μ_i μ_j."},
      {"a skate stops if friction can hold it", 1,
       [](Random& random, const Answer& answer) -> std::vector<Reading> {
         Board board(random);
         const Real speed = random.between(1, 2), heading = random.between(Real(0.5), Real(0.9));
         board.solve(speed, heading, 40 * board.mass, answer);
         return {{"your skate, which friction can hold, slips at", board.slip(), "m/s", 1e-5},
                 {"the friction of your skate, which it can hold, is", board.friction(), "N s", 1e-4}};
       },
       "inside the ellipse, friction is exactly the impulse that stops the slip. 300 calls are enough to get there if "
       "the step fits the block."},
  };
}

Exercise exercise() {
  return exercise_of("a skate: an ellipse instead of the disc",
                     {"Measured in its own semi-axes, the ellipse is a disc. What bounds (λ₁/μ₁, λ₂/μ₂)?",
                      "Write y = (λ₁/μ₁, λ₂/μ₂). If y₁ grows by 1, the impulse grows by μ₁. At which rate does the "
                      "energy change with y if the slip is u? And how does this rate change in turn, with K_t?",
                      "So take chapter 08's step in y, with the slip (μ₁u₁, μ₂u₂) and a block whose k_ij is μ_i μ_j "
                      "times the old one."},
                     Answer{right});
}

}  // namespace pushback::exercise_08
