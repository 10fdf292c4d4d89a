/// Chapter 17: Coulomb's law with its kinks rounded, solved in systems between bodies or between contacts.
#include <array>
#include <random>

#include "pushback/chapters/12_soft_contacts/steady_solver.h"
#include "pushback/chapters/16_whole_problem/problem_file.h"
#include "pushback/common/world/situations.h"
#include "pushback/engine/direct/newton_system.h"
#include "pushback/engine/direct/row_matrix.h"
#include "pushback/engine/direct/smoothed_newton.h"
#include "pushback/engine/direct/solve_best.h"
#include "tests/support/catch.h"
#include "tests/support/foreign_problems.h"
#include "tests/support/frame.h"

using namespace pushback;

namespace {

ContactProblem problem_with(const Eigen::MatrixXd& w, const Vector& q, double mu) {
  return {SparseMatrix(w.sparseView(0, 0)), q, Vector::Constant(q.size() / 3, mu)};
}

/// Boxes of different sides, turned, each on the one below or beside it, thrown.
void thrown(World& world) {
  world.add(ground());
  for (int i = 0; i < 4; ++i)
    world.add(box({Real(0.5), Real(0.3), Real(0.4)}, 100 + 50 * i)
                  .turned(Real(0.3) * static_cast<Real>(i), {0, 1, 0})
                  .at({Real(0.1) * static_cast<Real>(i), Real(0.299) + Real(0.598) * static_cast<Real>(i), 0})
                  .moving({static_cast<Real>(i), -1, Real(0.5)}));
}

constexpr double rounding = std::is_same_v<Real, float> ? 1e-6 : 1e-13;

}  // namespace

TEST_CASE("W is B B^T, whatever the bodies' sides and turns") {
  for (void (*fill)(World&) : {+[](World& world) { pyramid(world, 4); }, thrown}) {
    Frame frame(fill);
    const ContactProblem problem = problem_of(frame.world);
    REQUIRE(problem.contacts() > 12);
    const SparseMatrix b = factor_of(frame.world), transposed = b.transpose(), product = b * transposed;
    CHECK(SparseMatrix(product - problem.w).norm() < rounding * problem.w.norm());
  }
}

TEST_CASE("systems between bodies and between contacts lead to the same speeds") {
  for (void (*fill)(World&) : {+[](World& world) { pyramid(world, 6); }, thrown}) {
    Frame frame(fill);
    const ContactProblem problem = problem_of(frame.world);
    const SmoothedSolution contacts = solve_smoothed(problem, {.tolerance = 1e-9}),
                           bodies = solve_smoothed(problem, {.tolerance = 1e-9}, factor_of(frame.world));
    CHECK(contacts.residual <= 1e-9);
    CHECK(bodies.residual <= (std::is_same_v<Real, float> ? 1e-5 : 1e-9));
    CHECK((problem.speeds(contacts.r) - problem.speeds(bodies.r)).norm() < 1e6 * rounding * problem.q.norm());
    CHECK(bodies.fill < contacts.fill / 3);  // six rows a body, twelve a face
  }
}

TEST_CASE("random problems with W positive definite are solved, and what is reported is true") {
  std::mt19937 random(7);
  std::normal_distribution<double> number;
  int missed = 0;
  for (int trial = 0; trial < 200; ++trial) {
    const Eigen::Index size = 3 * (1 + trial % 4);
    Eigen::MatrixXd root(size, size);
    for (double& each : root.reshaped()) each = number(random);
    Vector q(size);
    for (double& each : q) each = number(random);
    const double mu = std::array{0.0, 0.3, 0.7, 1.0}[static_cast<std::size_t>(trial / 4 % 4)];
    const ContactProblem problem =
        problem_with(root * root.transpose() + 0.05 * Eigen::MatrixXd::Identity(size, size), q, mu);
    const SmoothedSolution found = solve_smoothed(problem, {.tolerance = 1e-10});
    CHECK(found.residual == relative_residual(problem, found.r));
    CHECK(found.systems <= SmoothedLimits{}.systems);
    CHECK(solve_best(problem).residual < 1e-12);
    if (!(found.residual <= 1e-10)) ++missed;
    if (mu == 0)
      for (Eigen::Index i = 0; i < size; ++i)
        if (i % 3 > 0) CHECK(found.r[i] == 0);
  }
  CHECK(missed == 0);
}

TEST_CASE("each r is within its cone, to rounding, however early it ends") {
  Frame frame(thrown);
  const ContactProblem problem = problem_of(frame.world);
  for (const int systems : {1, 2, 5, 100}) {
    const Vector r = solve_smoothed(problem, {.systems = systems}, factor_of(frame.world)).r;
    for (Eigen::Index c = 0; c < problem.contacts(); ++c) {
      CHECK(r[3 * c] >= 0);
      CHECK(r.segment<2>(3 * c + 1).norm() <= problem.mu[c] * r[3 * c] * (1 + 1e-12));
    }
  }
}

TEST_CASE("the smoothed method stops after counted work, in the same bits, and never worse for more of it") {
  Frame frame([](World& world) { pyramid(world, 6); });
  const ContactProblem problem = problem_of(frame.world);
  const SparseMatrix factor = factor_of(frame.world);
  const SmoothedSolution whole = solve_smoothed(problem, {}, factor);
  REQUIRE(whole.residual <= 1e-8);
  double last = relative_residual(problem, Vector::Zero(problem.q.size()));
  for (const double part : {0.0, 0.01, 0.3, 0.6, 0.99}) {
    const SmoothedSolution one = solve_smoothed(problem, {.work = part * whole.work}, factor),
                           two = solve_smoothed(problem, {.work = part * whole.work}, factor);
    CHECK(one.r == two.r);
    CHECK(one.work >= part * whole.work);
    CHECK(one.work <= (part + 0.5) * whole.work);
    CHECK(one.residual <= last);
    last = one.residual;
  }
  CHECK(solve_smoothed(problem, {.systems = 3}, factor).systems == 3);
}

TEST_CASE(
    "where there is no solution, as a body is squeezed by two that do not give way, both methods end and say so") {
  Eigen::MatrixXd w = Eigen::MatrixXd::Zero(6, 6);
  for (const Eigen::Index tangent : {0, 1, 2})
    for (const Eigen::Index a : {0, 3})
      for (const Eigen::Index b : {0, 3}) w(tangent + a, tangent + b) = tangent == 0 && a != b ? -1 : 1;
  Vector q = Vector::Zero(6);
  q[0] = q[3] = -1;  // a body between two walls that both come closer
  const SmoothedSolution driven = solve_smoothed(problem_with(w, q, 0.5));
  CHECK(driven.residual > 0.5);
  CHECK(driven.systems <= SmoothedLimits{}.systems);
  CHECK(solve_best(problem_with(w, q, 0.5), {.rounds = 2}).residual > 0.5);
  q[0] = 1;  // q = H v now: one comes, one goes, no impulse is needed but on one side
  CHECK(solve_smoothed(problem_with(w, q, 0.5)).residual <= 1e-8);
  CHECK(solve_best(problem_with(w, q, 0.5)).residual < 1e-12);
}
