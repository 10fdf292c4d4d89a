/// Chapter 17: contacts solved directly, those of others as well.
#include <random>

#include "pushback/chapters/16_whole_problem/problem_file.h"
#include "pushback/chapters/17_direct_contacts/direct_contacts.h"
#include "pushback/chapters/17_direct_contacts/iterated.h"
#include "pushback/chapters/17_direct_contacts/methods.h"
#include "pushback/chapters/17_direct_contacts/scenes.h"
#include "pushback/common/world/situations.h"
#include "tests/support/call.h"
#include "tests/support/catch.h"
#include "tests/support/foreign_problems.h"
#include "tests/support/frame.h"

using namespace pushback;

TEST_CASE("what is pushed out of an overlap leaves by beta of it a step, solved at once") {
  Frame frame([](World& world) {
    world.gravity.setZero();
    world.add(ground());
    world.add(sphere(Real(0.5), 100).at({0, Real(0.45), 0}));
  });
  Solver<Clamping, Baumgarte, FrictionCone, DirectContacts> solver;
  solver.solve(frame.world, h, 0);
  CHECK(frame.world.bodies[1].velocity.y() == Approx(solver.Baumgarte::beta * Real(0.05) / h).epsilon(1e-5));
}

TEST_CASE("the residual that is reported is that of the impulses, in whatever order the contacts were swept") {
  std::mt19937 random(5);
  std::uniform_real_distribution<Real> number(-1, 1);
  int reordered = 0;
  for (int i = 0; i < 6; ++i) {
    Frame frame([&](World& world) {
      stack(world, 1 + i % 2);
      for (Body& body : world.bodies)
        if (body.movable()) body.moving({number(random), -1, number(random)}).spinning({0, number(random), 0});
    });
    ContactProblem problem = problem_of(frame.world);
    problem.w *= 1e6;  // light bodies: small impulses, of which speeds that round are a large part
    const Solution found = solve_best(problem, {.tolerance = 0, .rounds = 3});  // goes on where it would stop else
    CHECK(relative_residual(problem, found.r) < found.residual + 1e-14);
    CHECK(found.residual < 1e-13);
    if (found.sweeps > 5000) ++reordered;
  }
  CHECK(reordered > 0);
}

TEST_CASE("problems that others wrote are solved") {
  int reached = 0, conjugate = 0, tried = 0;
  for (const fs::path& file : foreign_problems()) {
    INFO(file);
    const ContactProblem problem = read_problem_file(file);
    const ContactProblem again = read_problem(problem_text(problem));
    CHECK(Eigen::MatrixXd(again.w) == Eigen::MatrixXd(problem.w));
    ++tried;
    if (solve(problem, "cone", 1000, 1e-4).residual <= 1e-4) ++reached;
    if (solve(problem, "nscg", 1000, 1e-4).residual <= 1e-4) ++conjugate;
    if (file.stem() == "RockPile_tob1") continue;  // half a minute: the long test below
    const Solution found = solve_best(problem);
    CHECK(found.residual < 1e-12);
    CHECK(found.work < SolveLimits{}.work / 3);  // the limit is far off
  }
  INFO("the cone's sweeps reach 1e-4 within 1000 on " << reached << " of " << tried << ", conjugate ones on "
                                                      << conjugate);
  CHECK(10 * conjugate >= 9 * tried);
  CHECK(10 * reached >= 8 * tried);  // what is reached: nine in ten they do not
}

TEST_CASE("a thousand times heavier on four: Newton's method comes to rounding and ends, sweeps come nowhere") {
  const SharedProblem step = first_step(direct_contacts_scenes::HeavyOnFour{}, Real(1) / 60);
  IteratedProblem problem = swept_and_solved(step);
  REQUIRE(problem.methods.size() == 4);
  std::vector<double> left;
  std::vector<int> taken;
  for (IteratedProblem::Method& method : problem.methods) {
    INFO(method.name);
    Vector r = Vector::Zero(step->q.size());
    int k = 0;
    while (k < 250 && method.iterate(r)) {
      ++k;
      if (method.name.starts_with("best") && k == 200) CHECK(r == solve_by_sweeps(*step, "nscg", 200, 0).r);
      if (method.name.starts_with("smoothed") && k == 5)
        CHECK(r == solve_smoothed(*step, {.tolerance = 0, .systems = 5}).r);
    }
    const Vector at_end = r;
    if (k < 250) {
      CHECK_FALSE(method.iterate(r));
      CHECK(r == at_end);
    }
    left.push_back(problem.residual(r));
    taken.push_back(k);
  }
  CHECK(left[0] > 0.4);
  CHECK(left[1] > 0.1);
  CHECK(left[2] < 1e-12);
  CHECK(left[3] < 1e-12);
  CHECK(taken[0] == 250);
  CHECK(taken[2] > 200);
  CHECK(taken[2] < 250);
  CHECK(taken[3] < 50);
}
