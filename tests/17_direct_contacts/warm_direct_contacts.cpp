/// Chapter 17: contacts solved directly from a guess, and a handful of them without an allocation.
#include "pushback/engine/direct/warm_direct_contacts.h"

#include <functional>

#include "pushback/chapters/03_baumgarte/baumgarte.h"
#include "pushback/chapters/04_slop/slop.h"
#include "pushback/common/bodies/random.h"
#include "pushback/common/world/situations.h"
#include "pushback/engine/direct/row_matrix.h"
#include "pushback/engine/direct/small_contact_problem.h"
#include "pushback/engine/direct/solve_best.h"
#include "tests/support/catch.h"
#include "tests/support/complaint.h"
#include "tests/support/frame.h"

using namespace pushback;

namespace {

using Warm = Solver<Clamping, Baumgarte, Slop, FrictionCone, WarmStart, WarmDirectContacts>;

/// Two boxes on each other on the ground, up to a hundred times heavier than each other, thrown.
Frame two_boxes(Random& random) {
  return Frame([&](World& world) {
    world.add(ground());
    for (int i = 0; i < 2; ++i)
      world.add(box(Vec3::Constant(Real(0.5)), random.over_decades(10, 1000))
                    .at({Real(0.3) * static_cast<Real>(i), Real(0.499) + Real(0.998) * static_cast<Real>(i), 0})
                    .moving(random.vector(3))
                    .spinning(random.vector(1))
                    .rough(random.between(0, 1)));
  });
}

Rows rows_of(World& world) {
  Rows rows;
  Contacts& contacts = world.contacts;
  for (std::size_t i = 0; i < contacts.size(); ++i) rows.emplace_back(world, contacts[i], contacts[i].normal, i);
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    const Tangents tangents = tangents_of(contacts[i].normal);
    for (const Vec3& along : {tangents.tangent1, tangents.tangent2}) rows.emplace_back(world, contacts[i], along, i);
  }
  return rows;
}

constexpr double solved_to = std::is_same_v<Real, float> ? 1e-5 : 1e-10;

/// Small and sparse systems on 200 of these, made `stiffer` by that part of W's largest number on its diagonal: both solve,
/// and in the same speeds where there is one answer. Returns how many solve_small has solved.
int solved_alike(const std::function<double(double)>& friction, double stiffer, bool one_answer) {
  Random random(7);
  int solved = 0;
  for (int i = 0; i < 200; ++i) {
    Frame frame = two_boxes(random);
    const Rows rows = rows_of(frame.world);
    ContactProblem problem = problem_of(frame.world);
    REQUIRE(problem.contacts() == SmallContactProblem::most_contacts);
    SmallContactProblem small{small_matrix_of(rows, places_in_problem(frame.world.contacts, rows)), problem.q, {}};
    CHECK((small.w - Eigen::MatrixXd(problem.w)).norm() <= solved_to * problem.w.norm());
    const double more = stiffer * small.w.maxCoeff();
    for (Eigen::Index row = 0; row < small.w.rows(); ++row) {
      small.w(row, row) += more;
      problem.w.coeffRef(row, row) += more;
    }
    for (double& mu : problem.mu) mu = friction(mu);
    small.mu = problem.mu;
    SmallContactProblem::Impulses r = Vector::Zero(problem.q.size());
    if (!solve_small(small, r, solved_to)) {
      CHECK(r.isZero(0));
      continue;
    }
    ++solved;
    const Solution sparse = solve_best(problem, {.tolerance = solved_to});
    INFO(i);
    CHECK(relative_residual(problem, r) <= 2 * solved_to);
    REQUIRE(sparse.residual <= solved_to);
    if (one_answer) CHECK((problem.speeds(r) - problem.speeds(sparse.r)).norm() < 1e4 * solved_to * problem.q.norm());
  }
  return solved;
}

}  // namespace

TEST_CASE(
    "a handful of contacts is solved to the tolerance of sparse systems, and in the same speeds where these are "
    "unique") {
  CHECK(solved_alike([](double mu) { return mu; }, 0, false) > 170);  // with friction, speeds have more than one answer
  CHECK(solved_alike([](double) { return 0.0; }, 0, true) > 170);
  CHECK(solved_alike([](double mu) { return mu / 4; }, 0.1, true) > 170);
}

TEST_CASE("what rests as the guess says takes no system, and once the multiplications are spent a system is refused") {
  World world;
  stack(world, 4);
  Warm solver;
  solver.fallback_tolerance = 1e-5;
  for (int step = 0; step < 120; ++step) world.step(solver, h, 10);
  const double before = -solver.work;
  CHECK(std::isinf(before));
  solver.work = 0;
  const Real height = world.bodies[4].position.y();
  for (int step = 0; step < 10; ++step) world.step(solver, h, 10);
  CHECK(world.bodies[4].position.y() == Approx(height).margin(1e-6));
  world.bodies[4].moving({0, -1, 2});
  CHECK(complaint([&] { world.step(solver, h, 10); }) ==
        "16 contacts are too large a problem for the multiplications that are left");
  solver.work = 1e12;
  world.step(solver, h, 10);
  CHECK(solver.work < 1e12);
}
