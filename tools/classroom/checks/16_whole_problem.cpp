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

double friction(Random& random) {
  return between(random, 0.3, 0.9);
}

/// So much along the normal, and so much across it in some direction.
Three with(Random& random, double normal, double tangential) {
  const double angle = between(random, -3, 3);
  return {normal, tangential * std::cos(angle), tangential * std::sin(angle)};
}

State separating(Random& random) {
  return {friction(random), Three::Zero(), with(random, between(random, 1, 2), 1)};
}

State sticking(Random& random) {
  const double mu = friction(random), push = between(random, 2, 4);
  return {mu, with(random, push, mu * push * between(random, 0.1, 0.6)), Three::Zero()};
}

State sliding(Random& random) {
  const double mu = friction(random), push = between(random, 2, 4);
  const Three slip = with(random, 0, between(random, 0.5, 1));
  return {mu, Three(push, 0, 0) - mu * push * slip.normalized(), slip};
}

/// It separates, and is pushed all the same.
State pushed_apart(Random& random) {
  return {friction(random), {between(random, 0.3, 0.6), 0, 0}, with(random, between(random, 2, 3), 0.3)};
}

/// It rests, and is rubbed beyond its bound.
State rubbed(Random& random, double push) {
  return {friction(random), with(random, push, between(random, 4, 6)), Three::Zero()};
}

/// A contact that slides without friction.
State unrubbed(Random& random) {
  return {friction(random), {between(random, 5, 8), 0, 0}, with(random, 0, between(random, 0.5, 1))};
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
  Reading residual(const std::string& what, const Answer& answer) const {
    return {"of " + what + ", your residual is", answer.residual(problem, r)};
  }
};

}  // namespace

std::vector<Check<Answer>> checks_of(const Answer& /*any*/) {
  return {
      {"the residual is 0 only for a solved step", 2,
       [](Random& random, const Answer& answer) -> std::vector<Reading> {
         Step step(random, {separating(random), sticking(random), sliding(random)});
         const Reading solved =
             step.residual("three solved contacts, one separating, one sticking and one sliding", answer);
         step.r *= 1.1;
         return {solved, step.residual("the same contacts with impulses that are one tenth too large", answer)};
       },
       "if a step is solved, r itself is the point of the cone nearest to r - (u + μ |u_t| n). Otherwise the residual "
       "is the distance between the two, divided by |q|. Both lengths are Euclidean."},
      {"a contact that separates has no impulse", 1,
       [](Random& random, const Answer& answer) -> std::vector<Reading> {
         const Step step(random, {pushed_apart(random)});
         return {step.residual("a contact that separates but still pushes", answer)};
       },
       "a contact that separates has no impulse. Its error is the distance from r to the point of the cone nearest to "
       "r - (u + μ |u_t| n)."},
      {"friction stays within its cone", 1,
       [](Random& random, const Answer& answer) -> std::vector<Reading> {
         const Step step(random, {rubbed(random, -between(random, 0.2, 0.8))});
         return {step.residual("a resting contact that pulls a little and has a lot of friction", answer)};
       },
       "friction is at most μ times the normal impulse. Then the nearest point is on the edge of the cone, with the "
       "normal impulse (x_n + μ |x_t|) / (1 + μ²), even if x pulls a little."},
      {"friction opposes the slip", 1,
       [](Random& random, const Answer& answer) -> std::vector<Reading> {
         const Step step(random, {unrubbed(random)});
         return {step.residual("a contact that slides without friction", answer)};
       },
       "friction opposes the slip. With μ |u_t| added to the normal speed, a contact that slides without friction is "
       "not solved."},
      {"the residual covers all contacts together", 1,
       [](Random& random, const Answer& answer) -> std::vector<Reading> {
         const State apart = pushed_apart(random), rests = rubbed(random, between(random, 1, 2));
         const Step step(random, {apart, rests, unrubbed(random)});
         return {step.residual("three contacts, each wrong in another way", answer)};
       },
       "all contacts form one vector, each with its own μ. The error is the root of the sum of their squares."},
  };
}

Exercise exercise() {
  return rebuild_of(
      "the residual by the natural map",
      {"For each contact, s is u with μ |u_t| added to its first component. Which point of the cone is nearest to x = "
       "r - s? If it is r itself, the contact is solved.",
       "There are three cases. If |x_t| ≤ μ x_n, x is in the cone and is the nearest point itself. If μ |x_t| ≤ -x_n, "
       "the nearest point is 0. Otherwise the nearest point lies on the edge, in the direction of x_t.",
       "On the edge, x_n' = (x_n + μ |x_t|) / (1 + μ²), and x_t' has the length μ x_n'. Add the squares of r - x' over "
       "all contacts. The residual is the root of this sum, divided by problem.q.norm()."},
      Answer{relative_residual});
}

}  // namespace pushback::exercise_16
