#include <algorithm>
#include <cmath>

#include "pushback/chapters/16_whole_problem/exercise/asked.h"

namespace pushback::exercise_16 {

namespace {

using Three = Eigen::Vector3d;

/// A contact with these impulses (N s) and speeds (m/s).
struct State {
  double mu;
  Three r, u;
};

double between(Random& random, double low, double high) {
  return static_cast<double>(random.between(static_cast<Real>(low), static_cast<Real>(high)));
}

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

std::vector<Check<Answer>> checks() {
  return {
      {"a step that is solved has the residual 0, and no other has",
       2,
       {residual_of("two solved contacts, one separating and one sticking"),
        residual_of("two solved contacts, one separating and one sliding"),
        residual_of("the same two contacts with impulses that are a tenth too large")},
       [](Random& random, const Answer& answer) -> Numbers {
         const Step sticks(random, {separating(random), sticking(random)});
         Step slides(random, {separating(random), sliding(random)});
         Numbers numbers{sticks.residual(answer), slides.residual(answer)};
         slides.r *= 1.1;
         numbers.push_back(slides.residual(answer));
         return numbers;
       }},
      {"a contact that separates has no impulse",
       1,
       {residual_of("a contact that separates and is pushed all the same")},
       [](Random& random, const Answer& answer) -> Numbers {
         return {Step(random, {pushed_apart(random)}).residual(answer)};
       }},
      {"friction is within its cone",
       1,
       {residual_of("a resting contact whose friction is beyond its bound"),
        residual_of("a resting contact that pulls a little, and rubs a lot")},
       [](Random& random, const Answer& answer) -> Numbers {
         const State pushes = rubbed(random, between(random, 1, 2));
         const State pulls = rubbed(random, -between(random, 0.2, 0.8));
         return {Step(random, {pushes}).residual(answer), Step(random, {pulls}).residual(answer)};
       }},
      {"friction opposes the slip",
       1,
       {residual_of("a contact that slides without friction")},
       [](Random& random, const Answer& answer) -> Numbers {
         return {Step(random, {unrubbed(random)}).residual(answer)};
       }},
      {"all contacts are one error",
       1,
       {residual_of("three contacts, each wrong in another way")},
       [](Random& random, const Answer& answer) -> Numbers {
         const State apart = pushed_apart(random), rests = rubbed(random, between(random, 1, 2));
         return {Step(random, {apart, rests, unrubbed(random)}).residual(answer)};
       }},
  };
}

Three with_slip(const Three& u, double mu) {
  return {u[0] + mu * u.tail<2>().norm(), u[1], u[2]};
}

/// |r - Pi(r - s)| of each contact.
template <class Projected, class Speed>
Vector errors(const ContactProblem& problem, const Vector& r, const Projected& projected, const Speed& s) {
  const Vector u = problem.speeds(r);
  Vector found(problem.contacts());
  for (Eigen::Index c = 0; c < problem.contacts(); ++c) {
    const Three at = r.segment<3>(3 * c);
    found[c] = (at - projected(at - s(u.segment<3>(3 * c), problem.mu[c]), problem.mu[c])).norm();
  }
  return found;
}

Vector errors(const ContactProblem& problem, const Vector& r) {
  return errors(problem, r, projected_to_cone, with_slip);
}

template <class Projected>
double projected_by(const ContactProblem& problem, const Vector& r, const Projected& projected) {
  return errors(problem, r, projected, with_slip).norm() / problem.q.norm();
}

template <class Speed>
double moved_by(const ContactProblem& problem, const Vector& r, const Speed& s) {
  return errors(problem, r, projected_to_cone, s).norm() / problem.q.norm();
}

double with_mu(ContactProblem problem, const Vector& r, double mu) {
  problem.mu.setConstant(mu);
  return errors(problem, r).norm() / problem.q.norm();
}

Three to_disc(const Three& x, double mu) {
  const double push = std::max(0.0, x[0]), bound = mu * push, length = x.tail<2>().norm();
  const double part = length > bound ? bound / length : 1;
  return {push, part * x[1], part * x[2]};
}

Three to_edge(const Three& x, double mu) {
  const double length = x.tail<2>().norm(), push = (x[0] + mu * length) / (1 + mu * mu);
  return {push, mu * push * x[1] / length, mu * push * x[2] / length};
}

bool is_inside(const Three& x, double mu) {
  return x.tail<2>().norm() <= mu * x[0];
}

std::vector<Mistake<Answer>> mistakes() {
  const std::string edge =
      "it looks as if all that pulls were projected to 0. That is right below the cone's apex, where μ |x_t| ≤ -x_n; "
      "beside it, the nearest point is still on the cone's edge.";
  const std::string one_mu =
      "it looks as if all contacts had the μ of one of them. Each has its own cone: problem.mu[c].";
  const std::string some = "it looks as if some contacts were left out. The error is one number over all of them.";
  return {
      {"1-norm",
       "it looks as if sizes were added up, without squares. The norm is Euclid's, as the length of a vector: the root "
       "of the sum of squares.",
       {[](const ContactProblem& problem, const Vector& r) {
         const Vector u = problem.speeds(r);
         double sum = 0;
         for (Eigen::Index c = 0; c < problem.contacts(); ++c) {
           const Three at = r.segment<3>(3 * c), s = with_slip(u.segment<3>(3 * c), problem.mu[c]);
           sum += (at - projected_to_cone(at - s, problem.mu[c])).lpNorm<1>();
         }
         return sum / problem.q.lpNorm<1>();
       }}},
      {"1-norm",
       "it looks as if |q| were the sum of sizes. The norm is Euclid's, as the length of a vector: the root of the sum "
       "of squares.",
       {[](const ContactProblem& problem, const Vector& r) {
         return errors(problem, r).norm() / problem.q.lpNorm<1>();
       }}},
      {"another contact's μ", one_mu, {[](const ContactProblem& problem, const Vector& r) {
         return with_mu(problem, r, problem.mu[0]);
       }}},
      {"another contact's μ", one_mu, {[](const ContactProblem& problem, const Vector& r) {
         return with_mu(problem, r, problem.mu[problem.contacts() - 1]);
       }}},
      {"contacts left out", some, {[](const ContactProblem& problem, const Vector& r) {
         return errors(problem, r)[0] / problem.q.norm();
       }}},
      {"contacts left out", some, {[](const ContactProblem& problem, const Vector& r) {
         return errors(problem, r).head(std::min<Eigen::Index>(2, problem.contacts())).norm() / problem.q.norm();
       }}},
      {"a mean of all contacts",
       "it looks as if the squares were divided by how many contacts there are. The norms are over all contacts "
       "together, above and below.",
       {[](const ContactProblem& problem, const Vector& r) {
         return errors(problem, r).norm() / std::sqrt(static_cast<double>(problem.contacts())) / problem.q.norm();
       }}},
      {"disc for cone",
       "it looks as if friction were drawn back to its disc, with the normal impulse as it is. The nearest point of "
       "the cone has a larger normal impulse: (x_n + μ |x_t|) / (1 + μ²).",
       {[](const ContactProblem& problem, const Vector& r) { return projected_by(problem, r, to_disc); }}},
      {"disc for cone",
       "it looks as if friction were drawn back to its disc, and μ |u_t| were left out. That, too, is 0 where the step "
       "is solved (chapter 17 uses it), but it is not the distance to the nearest point of the cone.",
       {[](const ContactProblem& problem, const Vector& r) {
         return errors(problem, r, to_disc, [](const Three& u, double) { return u; }).norm() / problem.q.norm();
       }}},
      {"μ |u_t| forgotten",
       "it looks as if μ |u_t| were left out. Without it, a contact that slides is solved only where it separates with "
       "μ |u_t|: every sliding body would hop.",
       {[](const ContactProblem& problem, const Vector& r) {
         return moved_by(problem, r, [](const Three& u, double) { return u; });
       }}},
      {"|u_t| without μ",
       "it looks as if the slip were added to the normal speed as it is. What is added is μ |u_t|: a contact without "
       "friction hinders nothing.",
       {[](const ContactProblem& problem, const Vector& r) {
         return moved_by(problem, r, [](const Three& u, double) { return with_slip(u, 1); });
       }}},
      {"divided by the impulse",
       "it looks as if the error were divided by |r|. The impulses are what is asked for; how large a number is fair "
       "is told by q, the speeds before any impulse.",
       {[](const ContactProblem& problem, const Vector& r) { return errors(problem, r).norm() / r.norm(); }}},
      {"not divided",
       "it looks as if the error were not divided by |q|. A heavy pile would be wrong just for being heavy.",
       {[](const ContactProblem& problem, const Vector& r) { return errors(problem, r).norm(); }}},
      {"root forgotten",
       "it looks as if squares were left. The error is a length as a part of a length: take the root.",
       {[](const ContactProblem& problem, const Vector& r) {
         return errors(problem, r).squaredNorm() / problem.q.squaredNorm();
       }}},
      {"root forgotten",
       "it looks as if the root of the error were forgotten, and the sum of squares divided by |q|.",
       {[](const ContactProblem& problem, const Vector& r) {
         return errors(problem, r).squaredNorm() / problem.q.norm();
       }}},
      {"only the worst contact",
       "it looks as if only the contact with the largest error counted. All contacts together are one vector: the root "
       "of the sum of their squares.",
       {[](const ContactProblem& problem, const Vector& r) {
         return errors(problem, r).maxCoeff() / problem.q.norm();
       }}},
      {"lengths added",
       "it looks as if the lengths of all contacts were added up. All contacts together are one vector: add their "
       "squares, then take the root.",
       {[](const ContactProblem& problem, const Vector& r) { return errors(problem, r).sum() / problem.q.norm(); }}},
      {"sign",
       "it looks as if r + (u + μ |u_t| n) were projected. An impulse works against a speed: a contact that closes "
       "needs more, r - (...).",
       {[](const ContactProblem& problem, const Vector& r) {
         return moved_by(problem, r, [](const Three& u, double mu) { return Three(-with_slip(u, mu)); });
       }}},
      {"no apex",
       "it looks as if what is far below the cone were projected to the prolongation of its edge. There is no cone: a "
       "contact cannot pull, and the nearest point is 0.",
       {[](const ContactProblem& problem, const Vector& r) {
         return projected_by(problem, r,
                             [](const Three& x, double mu) { return is_inside(x, mu) ? x : to_edge(x, mu); });
       }}},
      {"every pull to 0", edge, {[](const ContactProblem& problem, const Vector& r) {
         return projected_by(problem, r, [](const Three& x, double mu) {
           return x[0] <= 0 ? Three(Three::Zero()) : projected_to_cone(x, mu);
         });
       }}},
      {"1 + μ² forgotten",
       "it looks as if 1 + μ² were forgotten. The edge's direction (1, μ) is not of unit length: what is projected to "
       "it is divided by 1 + μ².",
       {[](const ContactProblem& problem, const Vector& r) {
         return projected_by(problem, r, [](const Three& x, double mu) {
           return is_inside(x, mu) || mu * x.tail<2>().norm() <= -x[0] ? projected_to_cone(x, mu)
                                                                       : Three((1 + mu * mu) * to_edge(x, mu));
         });
       }}},
  };
}

}  // namespace

Numbers play(std::size_t check, Random& random, const Answer& answer) {
  return checks()[check].play(random, answer);
}

Exercise exercise() {
  return rebuild_of<Answer>(
      "the residual by the natural map",
      {"Contact by contact: s is u with μ |u_t| added to its first number. Which point of the cone is nearest to x = r "
       "- s? If that is r itself, the contact is solved.",
       "Three cases. x is in the cone if |x_t| ≤ μ x_n: it is the nearest point itself. If μ |x_t| ≤ -x_n, it is 0. "
       "Otherwise the nearest point lies on the edge, in the direction of x_t.",
       "On the edge: x_n' = (x_n + μ |x_t|) / (1 + μ²), and x_t' has the length μ x_n'. Add the squares of r - x' over "
       "all contacts; the residual is the root of the sum, divided by problem.q.norm()."},
      checks(), {relative_residual}, mistakes());
}

}  // namespace pushback::exercise_16
