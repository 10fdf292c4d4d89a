#include "pushback/chapters/08_friction_cone/exercise/asked.h"
#include "pushback/chapters/08_friction_cone/friction_cone.h"
#include "pushback/chapters/08_friction_cone/scenes.h"
#include "pushback/common/exercise/shown.h"

namespace pushback::exercise_08 {

namespace {

/// Chapter 06's rows, solved by the answer.
struct Asked : Friction {
  Answer answer{};
  void sweep(StepContext& step) {
    for (std::size_t i = 0; i < mu_.size(); ++i) {
      Row &one = step.rows[first_ + 2 * i], &two = step.rows[first_ + 2 * i + 1];
      answer.solve(one, two, TangentBlock(one, two).k12, mu_[i] * step.rows[one.owner].impulse);
    }
  }
};

/// A board without weight that stands on edge, on a foot right below its middle. So friction and normal impulse do not act on
/// each other, and the disc is the same in every sweep. Turned by 14 to 26 degrees against the tangents.
class Board {
 public:
  Vec3 along, across;  ///< level; the foot is the easiest to push across the board

  explicit Board(Random& random) {
    const Real height = random.between(Real(0.4), Real(0.6)), length = height * random.between(Real(2.2), 3);
    const Real turn = (random.below(2) == 0 ? 1 : -1) * random.between(Real(0.25), Real(0.45));
    const auto [tangent1, tangent2] = tangents_of(Vec3::UnitY());
    along = std::cos(turn) * tangent1 + std::sin(turn) * tangent2;
    across = std::cos(turn) * tangent2 - std::sin(turn) * tangent1;
    world_.gravity.setZero();
    world_.add(ground());
    world_.add(box({length, height, height / 10}, random.between(5, 20))
                   .at({0, height, 0})
                   .turned(std::atan2(-along.z(), along.x()), Vec3::UnitY()));
    world_.contacts = {{.normal = {0, 1, 0}, .id = {0, 1, 0}}};
  }
  /// It comes down with 1 m/s, and slides.
  void solve(const Vec3& sliding, Real mu, int sweeps, const Answer& answer,
             const std::vector<std::size_t>& quantities = {}) {
    world_.bodies[1].velocity = sliding - Vec3::UnitY();
    world_.contacts[0].friction = mu;
    Solver<Clamping, Asked> solver;
    static_cast<Asked&>(solver).answer = answer;
    solver.solve(world_, Real(1) / 60, sweeps);
    show(world_, quantities);
  }
  /// The length of the sum, N s, after visits with these bounds, N s for each kg; no normal is solved.
  Real friction_after(const Vec3& sliding, const std::vector<Real>& bounds, const Answer& answer,
                      std::size_t quantity) {
    Body& body = world_.bodies[1];
    body.velocity = sliding;
    const auto [tangent1, tangent2] = tangents_of(Vec3::UnitY());
    Row one(world_, world_.contacts[0], tangent1, 0), two(world_, world_.contacts[0], tangent2, 0);
    for (const Real bound : bounds) answer.solve(one, two, TangentBlock(one, two).k12, bound / body.inverse_mass);
    world_.contacts[0].impulse = one.impulse * tangent1 + two.impulse * tangent2;
    show(world_, {quantity});
    return std::hypot(one.impulse, two.impulse);
  }
  Vec3 slip() const { return level(world_.bodies[1].velocity_at(Vec3::Zero())); }
  Vec3 friction() const { return level(world_.contacts[0].impulse); }
  /// Degrees; 0 where nothing slips.
  Real off_direction() const {
    return slip().norm() < Real(1e-6) ? 0 : friction_cone_scenes::direction_error(slip(), friction());
  }

 private:
  static Vec3 level(const Vec3& v) { return {v.x(), 0, v.z()}; }
  World world_;
};

std::vector<Check<Answer>> checks() {
  return {
      {"a foot that friction can hold is held",
       1,
       {{"your foot, which friction can hold, slips on with", "m/s", 1e-6},
        {"friction gives your foot, which it can hold,", "N s", 1e-5}},
       [](Random& random, const Answer& answer) -> Numbers {
         Board board(random);
         const Real heading = random.between(Real(0.5), Real(0.9)), speed = random.between(1, 2);
         board.solve(speed * (std::cos(heading) * board.along + std::sin(heading) * board.across), 4, 100, answer);
         return {board.slip().norm(), board.friction().norm()};
       }},
      {"on a foot that slides, friction is opposite to the slip",
       2,
       {{"friction on your sliding foot is off the direction opposite to its slip by", "°", 1e-5},
        {"your sliding foot slips on with", "m/s", 1e-4},
        {"friction gives your sliding foot", "N s", 1e-3},
        {"after a single sweep friction gives your sliding foot", "N s", 1e-3}},
       [](Random& random, const Answer& answer) -> Numbers {
         Board board(random), once = board;
         const Real heading = random.between(Real(0.5), Real(0.9)), speed = random.between(3, 4);
         const Real mu = random.between(Real(0.2), Real(0.3));
         const Vec3 sliding = speed * (std::cos(heading) * board.along + std::sin(heading) * board.across);
         board.solve(sliding, mu, 100, answer, {0, 1, 2});
         once.solve(sliding, mu, 1, answer, {3});
         return {board.off_direction(), board.slip().norm(), board.friction().norm(), once.friction().norm()};
       }},
      {"across the board, where it is the easiest to push, a foot stops within one sweep",
       1,
       {{"after one sweep your foot, which slid across the board, slips on with", "m/s", 1e-6},
        {"in one sweep friction gives your foot", "N s", 1e-5}},
       [](Random& random, const Answer& answer) -> Numbers {
         Board board(random);
         const Real speed = random.between(Real(0.5), 1);
         board.solve(speed * board.across, 4, 1, answer);
         return {board.slip().norm(), board.friction().norm()};
       }},
      {"the disc is that of this sweep, though the normal impulse changes from sweep to sweep",
       1,
       {{"friction gives your foot, which has been pressed on more,", "N s", 1e-5},
        {"friction gives your foot, which has been pressed on less,", "N s", 1e-5}},
       [](Random& random, const Answer& answer) -> Numbers {
         Board more(random), less = more;
         const Real heading = random.between(Real(0.5), Real(0.9)), speed = random.between(3, 4);
         const Real bound = random.between(Real(0.1), Real(0.15)), ratio = random.between(Real(1.5), Real(2.5));
         const Vec3 sliding = speed * (std::cos(heading) * more.along + std::sin(heading) * more.across);
         return {more.friction_after(sliding, {ratio * bound, bound}, answer, 0),
                 less.friction_after(sliding, {bound / ratio, bound}, answer, 1)};
       }},
  };
}

/// The chapter's own step and projection.
struct Chapters : FrictionCone {
  using FrictionCone::reach_in_disc;
};

void step_of(Real mass, Row& one, Row& two, Real bound) {
  const Real total1 = one.impulse - mass * one.speed(), total2 = two.impulse - mass * two.speed();
  Chapters::reach_in_disc(one, two, total1, total2, bound);
}

void right(Row& one, Row& two, Real, Real bound) {
  step_of(1 / TangentBlock(one, two).larger_eigenvalue(), one, two, bound);
}

Real mass_of(const Row& one, const Row& two) {
  return 1 / TangentBlock(one, two).larger_eigenvalue();
}

/// The disc of a bound made of this one, that of the visit before and that of the first. The row's separation and bias, which
/// friction has no use for, keep them.
template <auto bound_of>
void by_disc(Row& one, Row& two, Real k12, Real bound) {
  if (one.separation == 0) one.separation = one.bias = bound;
  const Real before = one.separation, first = one.bias;
  one.separation = bound;
  right(one, two, k12, bound_of(bound, before, first));
}

std::vector<Mistake<Answer>> mistakes() {
  const std::string late =
      "it looks as if the second slip were read when the first tangent had acted already. Then it is no longer the "
      "slip that both started from, and the step has another direction.";
  const std::string square =
      "it looks as if each tangent were clamped by itself. That allows a square, and friction is carried to its "
      "corner; |λ_t| ≤ bound is a disc.";
  const std::string other_disc =
      "it looks as if the disc were not that of this sweep. The normal is solved before its tangents and its sum "
      "changes, so friction may be no more, and no less, than μ times that sum as it is now: `bound`, as it comes.";
  const std::string too_far =
      "it looks as if the step were 1 over the smaller eigenvalue, or friction always of full size against the slip. "
      "Across the board that is far too much: the foot is thrown back faster than it came, which feeds in energy.";
  const std::string root =
      "it looks as if there were a slip under the root. There stand two squares: of k₁₂, and of (k₁₁ − k₂₂)/2, which "
      "is a difference, and halved.";
  return {
      {"solved and scaled back",
       "it looks as if the 2×2 block were solved, and the result scaled back to the disc. At its fixed point friction "
       "is opposite to K_t⁻¹u, not to u, whatever the number of sweeps.",
       {[](Row& one, Row& two, Real k12, Real bound) {
         const Real k11 = 1 / one.effective_mass, k22 = 1 / two.effective_mass, u1 = one.speed(), u2 = two.speed();
         const Real determinant = k11 * k22 - k12 * k12;
         Chapters::reach_in_disc(one, two, one.impulse - (k22 * u1 - k12 * u2) / determinant,
                                 two.impulse - (k11 * u2 - k12 * u1) / determinant, bound);
       }}},
      {"1/k for each tangent",
       "it looks as if each tangent took a step of its own 1/k. Friction is then opposite to (u₁/k₁₁, u₂/k₂₂); only "
       "with the same step for both is it opposite to u.",
       {[](Row& one, Row& two, Real, Real bound) {
         Chapters::reach_in_disc(one, two, one.impulse - one.effective_mass * one.speed(),
                                 two.impulse - two.effective_mass * two.speed(), bound);
       }}},
      {"the second slip read late", late, {[](Row& one, Row& two, Real, Real bound) {
         const Real mass = mass_of(one, two);
         one.reach(one.impulse - mass * one.speed());
         two.reach(two.impulse - mass * two.speed());
         Chapters::reach_in_disc(one, two, one.impulse, two.impulse, bound);
       }}},
      {"the smaller eigenvalue", too_far, {[](Row& one, Row& two, Real, Real bound) {
         const TangentBlock k(one, two);
         step_of(1 / (k.k11 + k.k22 - k.larger_eigenvalue()), one, two, bound);
       }}},
      {"the smaller eigenvalue", too_far, {[](Row& one, Row& two, Real, Real bound) {
         const Real u1 = one.speed(), u2 = two.speed(), slip = std::hypot(u1, u2);
         one.reach(-bound * u1 / slip);
         two.reach(-bound * u2 / slip);
       }}},
      {"a square", square, {[](Row& one, Row& two, Real, Real bound) {
         const Real mass = mass_of(one, two);
         const Real total1 = one.impulse - mass * one.speed(), total2 = two.impulse - mass * two.speed();
         one.reach(std::clamp(total1, -bound, bound));
         two.reach(std::clamp(total2, -bound, bound));
       }}},
      {"a square", square, {[](Row& one, Row& two, Real, Real bound) {
         for (Row* row : {&one, &two})
           row->reach(std::clamp(row->impulse - row->effective_mass * row->speed(), -bound, bound));
       }}},
      {"the disc of another sweep",
       other_disc,
       {by_disc<[](Real now, Real before, Real) { return (now + before) / 2; }>}},
      {"the disc of another sweep", other_disc, {by_disc<[](Real, Real before, Real) { return before; }>}},
      {"the disc of another sweep", other_disc, {by_disc<[](Real, Real, Real first) { return first; }>}},
      {"the 1-norm",
       "it looks as if |λ₁| + |λ₂| were taken for the length of the sum. That allows a square on its tip, which is no "
       "wider than the disc along the tangents and too narrow in between: the length is the root of λ₁² + λ₂².",
       {[](Row& one, Row& two, Real, Real bound) {
         const Real mass = mass_of(one, two);
         const Real total1 = one.impulse - mass * one.speed(), total2 = two.impulse - mass * two.speed();
         const Real kept = std::min(Real(1), bound / (std::abs(total1) + std::abs(total2)));
         one.reach(kept * total1);
         two.reach(kept * total2);
       }}},
      {"the square of the length",
       "it looks as if the square of the length were compared with the bound, or divided by. Both sums are multiplied "
       "by bound / |λ_t|, and |λ_t| is the root of λ₁² + λ₂².",
       {[](Row& one, Row& two, Real, Real bound) {
         const Real mass = mass_of(one, two);
         const Real total1 = one.impulse - mass * one.speed(), total2 = two.impulse - mass * two.speed();
         const Real kept = std::min(Real(1), bound / (total1 * total1 + total2 * total2));
         one.reach(kept * total1);
         two.reach(kept * total2);
       }}},
      {"the square of the length",
       "it looks as if the square of the length were compared with the bound, or divided by. Both sums are multiplied "
       "by bound / |λ_t|, and |λ_t| is the root of λ₁² + λ₂².",
       {[](Row& one, Row& two, Real, Real bound) {
         const Real mass = mass_of(one, two);
         const Real total1 = one.impulse - mass * one.speed(), total2 = two.impulse - mass * two.speed();
         const Real kept = std::min(Real(1), bound * bound / (total1 * total1 + total2 * total2));
         one.reach(kept * total1);
         two.reach(kept * total2);
       }}},
      {"what the first tangent leaves",
       "it looks as if the first tangent took what it wants of the disc, and the second what is left. Friction then "
       "leans towards the first tangent: the nearest point of the disc shortens both by the same factor.",
       {[](Row& one, Row& two, Real, Real bound) {
         const Real mass = mass_of(one, two);
         const Real total1 = one.impulse - mass * one.speed(), total2 = two.impulse - mass * two.speed();
         const Real sum1 = std::clamp(total1, -bound, bound), left = std::sqrt(bound * bound - sum1 * sum1);
         one.reach(sum1);
         two.reach(std::clamp(total2, -left, left));
       }}},
      {"the whole sum applied",
       "it looks as if the bodies felt the whole sum in each sweep. They have felt the earlier sum already: what acts "
       "is the difference, and reach sees to that.",
       {[](Row& one, Row& two, Real, Real bound) {
         const Real mass = mass_of(one, two);
         const Real total1 = one.impulse - mass * one.speed(), total2 = two.impulse - mass * two.speed();
         const Real kept = std::min(Real(1), bound / std::hypot(total1, total2));
         one.apply(kept * total1);
         two.apply(kept * total2);
         one.impulse = kept * total1;
         two.impulse = kept * total2;
       }}},
      {"no bound",
       "it looks as if there were no disc. Friction can be no more than μ times the normal impulse.",
       {[](Row& one, Row& two, Real, Real) { step_of(mass_of(one, two), one, two, 1e9); }}},
      {"always at the edge",
       "it looks as if the sums were brought to the edge of the disc from inside, too. What is within the disc stays "
       "as it is: the factor is min(1, bound / |λ_t|).",
       {[](Row& one, Row& two, Real, Real bound) {
         const Real mass = mass_of(one, two);
         const Real total1 = one.impulse - mass * one.speed(), total2 = two.impulse - mass * two.speed();
         const Real kept = bound / std::hypot(total1, total2);
         one.reach(kept * total1);
         two.reach(kept * total2);
       }}},
      {"the correction drawn back",
       "it looks as if the disc bounded each correction, not the sum. So many small ones add up to any friction.",
       {[](Row& one, Row& two, Real, Real bound) {
         const Real mass = mass_of(one, two), u1 = one.speed(), u2 = two.speed();
         const Real kept = std::min(Real(1), bound / (mass * std::hypot(u1, u2)));
         one.reach(one.impulse - kept * mass * u1);
         two.reach(two.impulse - kept * mass * u2);
       }}},
      {"the sum forgotten",
       "it looks as if the correction took the place of the sum. reach makes its argument the new sum: λ_t - u / k.",
       {[](Row& one, Row& two, Real, Real bound) {
         const Real mass = mass_of(one, two), u1 = one.speed(), u2 = two.speed();
         Chapters::reach_in_disc(one, two, -mass * u1, -mass * u2, bound);
       }}},
      {"sign",
       "it looks as if the sums were moved along the slip. Friction acts against it: λ_t - u / k.",
       {[](Row& one, Row& two, Real, Real bound) { step_of(-mass_of(one, two), one, two, bound); }}},
      {"k12 forgotten",
       "it looks as if the step were 1 over the larger of k₁₁ and k₂₂. The foot is the easiest to push in a direction "
       "between the tangents, and only k₁₂ knows of it.",
       {[](Row& one, Row& two, Real, Real bound) {
         step_of(std::min(one.effective_mass, two.effective_mass), one, two, bound);
       }}},
      {"the root forgotten",
       "it looks as if the step were 1 over the mean of k₁₁ and k₂₂. That is the mean of the two eigenvalues; the "
       "larger one is greater by the root.",
       {[](Row& one, Row& two, Real, Real bound) {
         const TangentBlock k(one, two);
         step_of(2 / (k.k11 + k.k22), one, two, bound);
       }}},
      {"a slip under the root", root, {[](Row& one, Row& two, Real k12, Real bound) {
         const TangentBlock k(one, two);
         step_of(1 / ((k.k11 + k.k22) / 2 + std::hypot((k.k11 + k.k22) / 2, k12)), one, two, bound);
       }}},
      {"a slip under the root", root, {[](Row& one, Row& two, Real k12, Real bound) {
         const TangentBlock k(one, two);
         step_of(1 / ((k.k11 + k.k22) / 2 + std::hypot(k.k11 - k.k22, k12)), one, two, bound);
       }}},
      {"a slip under the root", root, {[](Row& one, Row& two, Real k12, Real bound) {
         const TangentBlock k(one, two);
         step_of(1 / ((k.k11 + k.k22) / 2 + std::sqrt((k.k11 - k.k22) * (k.k11 - k.k22) / 4 + std::abs(k12))), one, two,
                 bound);
       }}},
      {"the sum of both eigenvalues",
       "it looks as if the step were 1 / (k₁₁ + k₂₂). That arrives as well, but more slowly: it is the sum of both "
       "eigenvalues.",
       {[](Row& one, Row& two, Real, Real bound) {
         const TangentBlock k(one, two);
         step_of(1 / (k.k11 + k.k22), one, two, bound);
       }}},
      {"k for 1/k",
       "it looks as if k₁₁ were one.effective_mass. That is 1/k₁₁, a mass in kg.",
       {[](Row& one, Row& two, Real k12, Real bound) {
         const Real m1 = one.effective_mass, m2 = two.effective_mass;
         step_of(1 / ((m1 + m2) / 2 + std::hypot((m1 - m2) / 2, k12)), one, two, bound);
       }}},
  };
}

}  // namespace

Numbers play(std::size_t check, Random& random, const Answer& answer) {
  return checks()[check].play(random, answer);
}

Exercise exercise() {
  return exercise_of<Answer>(
      "the tangents' step that is exact at its fixed point",
      {"Both tangents take a step of the same size, 1/k_max. k11 and k22 are 1 / effective_mass.",
       "Read both slips before either tangent acts: first both new sums, then both calls of reach.",
       "The length of both sums together is at most `bound`. Where it is more, multiply both by bound / length; where "
       "it is not, leave them as they are."},
      checks(), {right}, mistakes());
}

}  // namespace pushback::exercise_08
