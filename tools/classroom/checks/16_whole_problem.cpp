#include <algorithm>
#include <cmath>

#include "pushback/chapters/16_whole_problem/exercise/asked.h"
#include "pushback/tools/classroom/checks/scenes.h"

namespace pushback::exercise_16 {

namespace {

using Three = Eigen::Vector3d;

/// A contact with these impulses (N s) and speeds (m/s).
struct State {
  double mu;
  Three r, u;
};

Eigen::Vector2d heading(Random& random) {
  const double angle = between(random, -3, 3);
  return {std::cos(angle), std::sin(angle)};
}

double friction(Random& random) {
  return between(random, 0.3, 0.9);
}

State separating(Random& random) {
  const Eigen::Vector2d slip = heading(random);
  return {friction(random), Three::Zero(), {between(random, 1, 2), slip.x(), slip.y()}};
}

State sticking(Random& random) {
  const double mu = friction(random), push = between(random, 2, 4);
  const Eigen::Vector2d rub = mu * push * between(random, 0.1, 0.6) * heading(random);
  return {mu, {push, rub.x(), rub.y()}, Three::Zero()};
}

State sliding(Random& random) {
  const double mu = friction(random), push = between(random, 2, 4);
  const Eigen::Vector2d ahead = heading(random), slip = between(random, 0.5, 1) * ahead, rub = -mu * push * ahead;
  return {mu, {push, rub.x(), rub.y()}, {0, slip.x(), slip.y()}};
}

/// It separates, and is pushed all the same.
State pushed_apart(Random& random) {
  const Eigen::Vector2d slip = 0.3 * heading(random);
  return {friction(random), {between(random, 0.3, 0.6), 0, 0}, {between(random, 2, 3), slip.x(), slip.y()}};
}

/// It rests, and is rubbed beyond its bound.
State rubbed(Random& random, double push) {
  const Eigen::Vector2d rub = between(random, 4, 6) * heading(random);
  return {friction(random), {push, rub.x(), rub.y()}, Three::Zero()};
}

/// It slides, and nothing rubs.
State unrubbed(Random& random) {
  const Eigen::Vector2d slip = between(random, 0.5, 1) * heading(random);
  return {friction(random), {between(random, 5, 8), 0, 0}, {0, slip.x(), slip.y()}};
}

/// Contacts that feel each other, in these states.
struct Step {
  ContactProblem problem;
  Vector r;

  Step(Random& random, const std::vector<State>& states) {
    const Eigen::Index rows = 3 * std::ssize(states);
    Eigen::MatrixXd mixed(rows, rows);
    for (double& entry : mixed.reshaped()) entry = between(random, -1, 1);
    const Eigen::MatrixXd w = (0.05 * mixed * mixed.transpose()).eval() + 0.5 * Eigen::MatrixXd::Identity(rows, rows);
    problem.w = w.sparseView();
    problem.mu.resize(std::ssize(states));
    r.resize(rows);
    Vector u(rows);
    for (Eigen::Index c = 0; const State& state : states) {
      problem.mu[c] = state.mu;
      r.segment<3>(3 * c) = state.r;
      u.segment<3>(3 * c) = state.u;
      ++c;
    }
    problem.q = u - problem.w * r;
  }
  Real residual(const Answer& answer) const { return static_cast<Real>(answer.residual(problem, r)); }
};

Quantity residual_of(const std::string& what) {
  return {"of " + what + ", your residual is", "", 1e-6};
}

}  // namespace

std::vector<Check<Answer>> checks_of(const Answer& /*any*/) {
  return {
      {"a step that is solved has the residual 0, and no other has",
       2,
       {residual_of("three solved contacts, one separating, one sticking and one sliding"),
        residual_of("the same contacts with impulses that are a tenth too large")},
       [](Random& random, const Answer& answer) -> Numbers {
         Step step(random, {separating(random), sticking(random), sliding(random)});
         const Real solved = step.residual(answer);
         step.r *= 1.1;
         return {solved, step.residual(answer)};
       },
       "where a step is solved, the point of the cone nearest to r - (u + μ |u_t| n) is r itself. How far it is "
       "otherwise is divided by |q|, and both lengths are Euclid's."},
      {"a contact that separates has no impulse",
       1,
       {residual_of("a contact that separates and is pushed all the same")},
       [](Random& random, const Answer& answer) -> Numbers {
         return {Step(random, {pushed_apart(random)}).residual(answer)};
       },
       "a contact that separates has no impulse. Its error is how far r is from the point of the cone nearest to r - "
       "(u + μ |u_t| n)."},
      {"friction is within its cone",
       1,
       {residual_of("a resting contact that pulls a little, and rubs a lot")},
       [](Random& random, const Answer& answer) -> Numbers {
         return {Step(random, {rubbed(random, -between(random, 0.2, 0.8))}).residual(answer)};
       },
       "friction is at most μ times the push. The nearest point is on the edge of the cone then, with the normal "
       "impulse (x_n + μ |x_t|) / (1 + μ²), also where x pulls a little."},
      {"friction opposes the slip",
       1,
       {residual_of("a contact that slides without friction")},
       [](Random& random, const Answer& answer) -> Numbers {
         return {Step(random, {unrubbed(random)}).residual(answer)};
       },
       "friction opposes the slip. With μ |u_t| in the normal speed, a contact that slides without friction is not "
       "solved."},
      {"all contacts are one error",
       1,
       {residual_of("three contacts, each wrong in another way")},
       [](Random& random, const Answer& answer) -> Numbers {
         const State apart = pushed_apart(random), rests = rubbed(random, between(random, 1, 2));
         return {Step(random, {apart, rests, unrubbed(random)}).residual(answer)};
       },
       "all contacts are one vector, each with its own μ. The error is the root of the sum of their squares."},
  };
}

Exercise exercise() {
  return rebuild_of(
      "the residual by the natural map",
      {"Contact by contact: s is u with μ |u_t| added to its first number. Which point of the cone is nearest to x = r "
       "- s? If that is r itself, the contact is solved.",
       "Three cases. x is in the cone if |x_t| ≤ μ x_n: it is the nearest point itself. If μ |x_t| ≤ -x_n, it is 0. "
       "Otherwise the nearest point lies on the edge, in the direction of x_t.",
       "On the edge: x_n' = (x_n + μ |x_t|) / (1 + μ²), and x_t' has the length μ x_n'. Add the squares of r - x' over "
       "all contacts; the residual is the root of the sum, divided by problem.q.norm()."},
      Answer{relative_residual});
}

}  // namespace pushback::exercise_16
