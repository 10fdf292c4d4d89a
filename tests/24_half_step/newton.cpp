/// Chapter 24: the matrix between bodies, and Newton's method on it.
#include <Eigen/LU>

#include "pushback/common/bodies/random.h"
#include "pushback/engine/direct/row_matrix.h"
#include "pushback/engine/half_step/newton_from_guess.h"
#include "tests/24_half_step/order.h"
#include "tests/support/catch.h"

using namespace pushback;

namespace {

BodyMatrix::Block any_block(Random& random) {
  BodyMatrix::Block block;
  for (Eigen::Index i = 0; i < 36; ++i) block(i) = static_cast<double>(random.between(-1, 1));
  return block;
}

/// The rows of all contacts of a world: normals, then tangents.
Rows rows_of_contacts(World& world) {
  Rows rows;
  for (std::size_t k = 0; k < world.contacts.size(); ++k)
    rows.emplace_back(world, world.contacts[k], world.contacts[k].normal, k);
  for (std::size_t k = 0; k < world.contacts.size(); ++k) {
    const auto [one, two] = tangents_of(world.contacts[k].normal);
    rows.emplace_back(world, world.contacts[k], one, k);
    rows.emplace_back(world, world.contacts[k], two, k);
  }
  return rows;
}

}  // namespace

TEST_CASE("half step: a matrix between bodies is solved as a dense one is") {
  Random random(7);
  for (const int bodies : {1, 2, 5, 12}) {
    BodyMatrix::Pairs pairs;  // a ring, and some across it
    for (int i = 0; i + 1 < bodies; ++i) pairs.emplace_back(i, i + 1);
    if (bodies > 4) pairs.emplace_back(0, bodies - 1), pairs.emplace_back(1, bodies - 2);
    Eigen::MatrixXd dense = Eigen::MatrixXd::Identity(6 * bodies, 6 * bodies);
    BodyMatrix matrix;
    for (const double size : {0.3, 5.0}) {  // the second time on the pattern of the first
      dense.setIdentity();
      matrix.begin(bodies, pairs);
      const auto add = [&](int row, int column) {
        BodyMatrix::Block block = size * any_block(random);
        if (row == column) block += 40 * BodyMatrix::Block::Identity();
        matrix.add(row, column, block);
        dense.block<6, 6>(6 * row, 6 * column) += block;
      };
      for (int i = 0; i < bodies; ++i) add(i, i);
      for (const auto& [one, other] : pairs) add(one, other), add(other, one);
      REQUIRE(matrix.factor());
      std::vector<BodyMatrix::Six> x(std::size_t(bodies), BodyMatrix::Six::Ones());
      matrix.solve(x);
      const Eigen::VectorXd truth = dense.partialPivLu().solve(Eigen::VectorXd::Ones(6 * bodies));
      for (int i = 0; i < bodies; ++i) CHECK((x[std::size_t(i)] - truth.segment<6>(6 * i)).norm() < 1e-12);
    }
    matrix.begin(bodies, pairs);
    matrix.add(0, 0, -BodyMatrix::Block::Identity());
    CHECK_FALSE(matrix.factor());
  }
}

TEST_CASE("half step: contacts that stick, slide and part are all found, from nothing") {
  World world;
  world.add(ground());
  world.add(box(Vec3::Constant(Real(0.5)), 1).at({0, Real(0.499), 0}));
  world.add(box(Vec3::Constant(Real(0.5)), 5).at({0, Real(1.498), 0}).moving({3, 0, 1}));
  world.add(sphere(Real(0.5), 2).at({3, Real(0.499), 0}).moving({0, 1, 0}));
  world.begin_step(h);
  Rows rows = rows_of_contacts(world);
  const ContactProblem problem = problem_of(world.contacts, rows);
  NewtonFromGuess newton;
  const std::size_t count = world.contacts.size();
  for (std::size_t k = 0; k < count; ++k)
    newton.add_contact(rows[k], rows[count + 2 * k], rows[count + 2 * k + 1], world.contacts[k].friction);
  CHECK(newton.largest_error() > 0.1);
  CHECK(newton.solve(world, in_double ? 1e-12 : 1e-5));
  const std::vector<Eigen::Index> places = places_in_problem(world.contacts, rows);
  Vector impulses(problem.q.size());
  for (std::size_t i = 0; i < rows.size(); ++i) impulses[places[i]] = static_cast<double>(rows[i].impulse);
  CHECK(relative_residual(problem, impulses) < (in_double ? 1e-11 : 1e-4));
  CHECK(impulses.cwiseAbs().maxCoeff() > 0.1);
}

TEST_CASE("half step: rows with limits, and rows that give way, are solved as chapter 13 says") {
  World world;
  world.gravity.setZero();
  for (const Real x : {Real(0), Real(2), Real(4)})
    world.add(sphere(Real(0.1), 1).at({x, 0, 0}).moving({4 - 2 * x, 0, 0}));
  const auto between = [&world](int a, int b, Real softness) {
    Body &first = world.body(a), &second = world.body(b);
    return JointRow(first, second, Jacobian::along(Vec3::UnitX(), first, second, first.position), 0, softness);
  };
  JointRow soft = between(0, 1, Real(0.7)), held = between(1, 2, 0);
  held.lo = Real(-0.5);
  held.hi = Real(0.5);
  NewtonFromGuess newton;
  newton.add(soft);
  newton.add(held);
  CHECK(newton.solve(world, in_double ? 1e-13 : 1e-6));
  CHECK(held.impulse == Approx(0.5));  // u would be -4, and K is 2
  CHECK(std::abs(soft.speed_error()) < rounding);
  newton.sweep(20);  // it stays
  CHECK(newton.largest_error() < (in_double ? 1e-12 : 1e-5));
}
