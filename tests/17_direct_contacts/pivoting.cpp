/// Chapter 17: contacts without friction, solved by pivoting, beside what CGAL finds in rational numbers.
#include <random>

#include "pushback/chapters/17_direct_contacts/pivoting.h"
#include "pushback/common/world/situations.h"
#include "pushback/engine/direct/row_matrix.h"
#include "tests/support/catch.h"

#ifdef PUSHBACK_CGAL
#include <CGAL/Gmpq.h>
#include <CGAL/QP_functions.h>
#include <CGAL/QP_models.h>
#endif

using namespace pushback;

namespace {

using Eigen::Index;

struct Frictionless {
  SparseMatrix a;
  Vector b;
};
template <class Fill>
Frictionless frictionless(Fill fill) {
  World world;
  fill(world);
  world.begin_step(Real(1) / 60);
  Rows rows;
  for (std::size_t i = 0; i < world.contacts.size(); ++i)
    rows.emplace_back(world, world.contacts[i], world.contacts[i].normal, i);
  return {matrix_of(rows), speeds_of(rows)};
}

/// A = G G^T with few columns in G and small whole numbers, so that A is exact and far from full rank.
Frictionless random_problem(unsigned seed, Index rows, Index rank) {
  std::mt19937 random(seed);
  Eigen::MatrixXd g(rows, rank);
  for (Index i = 0; i < rows; ++i)
    for (Index j = 0; j < rank; ++j) g(i, j) = static_cast<double>(random() % 7) - 3;
  Vector v(rank);
  for (Index j = 0; j < rank; ++j) v[j] = static_cast<double>(random() % 15) - 7;
  return {SparseMatrix((g * g.transpose()).sparseView(0, 0)), g * v};  // b = G v: as JV is, so that there is a solution
}

}  // namespace

TEST_CASE("pivoting: stacks and pyramids to rounding, whatever the rank") {
  for (const int count : {1, 2, 5, 20}) {
    const Frictionless of_stack = frictionless([&](World& world) { stack(world, count); });
    const auto found = solve_by_pivoting(of_stack.a, of_stack.b);
    REQUIRE(found);
    INFO(count << " boxes, " << found->pivots << " pivots");
    CHECK(complementarity_error(of_stack.a, of_stack.b, found->impulses) <
          (std::is_same_v<Real, float> ? 1e-4 : 1e-10));
    double on_ground = 0;  // the ground carries them all: the sum of its contacts is n m g h
    for (Index i = 0; i < 4; ++i) on_ground += found->impulses[i];
    CHECK(on_ground == Approx(count * 100 * 9.81 / 60).epsilon(std::is_same_v<Real, float> ? 1e-4 : 1e-9));
  }
  const Frictionless of_pyramid = frictionless([](World& world) { pyramid(world, 6); });
  const auto found = solve_by_pivoting(of_pyramid.a, of_pyramid.b);
  REQUIRE(found);
  CHECK(complementarity_error(of_pyramid.a, of_pyramid.b, found->impulses) <
        (std::is_same_v<Real, float> ? 1e-3 : 1e-9));
}

TEST_CASE("pivoting: random problems of low rank, all solved") {
  for (unsigned seed = 1; seed <= 200; ++seed) {
    const Frictionless problem = random_problem(seed, 5 + seed % 20, 2 + seed % 6);
    const auto found = solve_by_pivoting(problem.a, problem.b);
    INFO("seed " << seed);
    REQUIRE(found);
    CHECK(complementarity_error(problem.a, problem.b, found->impulses) < 1e-9 * problem.b.cwiseAbs().maxCoeff());
  }
}

TEST_CASE("pivoting: nothing is returned where there is no solution") {
  SparseMatrix a(2, 2);  // the second row cannot be moved, and closes
  a.insert(0, 0) = 1;
  Vector b(2);
  b << -1, -1;
  CHECK(!solve_by_pivoting(a, b));
}

TEST_CASE("pivoting finds the speeds that CGAL finds in rational numbers") {
#ifdef PUSHBACK_CGAL
  for (unsigned seed = 1; seed <= 40; ++seed) {
    const Frictionless problem = random_problem(seed, 4 + seed % 9, 2 + seed % 4);
    // The least 1/2 l^T A l + b^T l with l >= 0. CGAL is given twice the matrix, and of that the lower half.
    const int n = static_cast<int>(problem.b.size());
    CGAL::Quadratic_program<CGAL::Gmpq> program(CGAL::SMALLER, true, CGAL::Gmpq(0), false, CGAL::Gmpq(0));
    for (int i = 0; i < n; ++i) {
      program.set_c(i, CGAL::Gmpq(problem.b[i]));
      for (int j = 0; j <= i; ++j) program.set_d(i, j, CGAL::Gmpq(problem.a.coeff(i, j)));
    }
    auto exact = CGAL::solve_nonnegative_quadratic_program(program, CGAL::Gmpq());
    REQUIRE(exact.is_optimal());
    REQUIRE(exact.solves_quadratic_program(program));
    Vector exact_impulses(n);
    int i = 0;
    for (auto it = exact.variable_values_begin(); it != exact.variable_values_end(); ++it)
      exact_impulses[i++] = CGAL::to_double(*it);
    const auto found = solve_by_pivoting(problem.a, problem.b);
    REQUIRE(found);
    // The impulses need not be the same where A is singular; the speeds and the energy are.
    const Vector exact_speeds = problem.a * exact_impulses + problem.b,
                 speeds = problem.a * found->impulses + problem.b;
    INFO("seed " << seed);
    CHECK((speeds - exact_speeds).cwiseAbs().maxCoeff() < 1e-10 * problem.b.cwiseAbs().maxCoeff());
    const double energy = found->impulses.dot(problem.a * found->impulses) / 2 + problem.b.dot(found->impulses);
    CHECK(energy == Approx(CGAL::to_double(exact.objective_value())).epsilon(1e-11).margin(1e-9));
  }
#else
  WARN("skipped: built without CGAL (libcgal-dev)");
#endif
}
