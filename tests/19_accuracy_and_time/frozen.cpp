/// Chapter 19: frozen problems, what is traced on them, and performance profiles. Nothing here depends on a clock.
#include <filesystem>

#include "pushback/chapters/17_direct_contacts/methods.h"
#include "pushback/common/basics/files.h"
#include "pushback/common/world/situations.h"
#include "pushback/engine/direct/row_matrix.h"
#include "pushback/engine/direct/smoothed_newton.h"
#include "pushback/tools/measure/frozen/frozen.h"
#include "tests/support/call.h"
#include "tests/support/catch.h"
#include "tests/support/complaint.h"

using namespace pushback;
using namespace pushback::frozen;

namespace {

/// As far as `sweeps` go, however long that takes.
TraceLimits limited_to(int sweeps) {
  return {.sweeps = sweeps, .seconds = 1e9, .enough = 0, .ladder = {1e-6}, .asked = {1e-6}};
}

const std::vector<FrozenProblem>& ours() {
  static const std::vector<FrozenProblem> problems = own_problems();  // a second's work
  return problems;
}

const FrozenProblem& named(const std::string& name) {
  for (const FrozenProblem& problem : ours())
    if (problem.name == name) return problem;
  throw std::runtime_error("no problem is called " + name);
}

}  // namespace

TEST_CASE("a profile of known costs is the known one") {
  const Costs costs{{1, 2}, {4, 1}, {not_reached, 3}, {not_reached, not_reached}};
  CHECK(part_within(costs, 0, 1) == 0.25);
  CHECK(part_within(costs, 0, 3.99) == 0.25);
  CHECK(part_within(costs, 0, 4) == 0.5);
  CHECK(part_within(costs, 0, 1e300) == 0.5);
  CHECK(part_within(costs, 1, 2) == 0.75);
  CHECK(part_within({}, 0, 2) == 0);
}

TEST_CASE("every frozen problem is symmetric, and the small ones can be solved") {
  for (const FrozenProblem& frozen : ours()) {
    INFO(frozen.name);
    const ContactProblem& problem = frozen.problem;
    CHECK(asymmetry(problem) <= 1e-12);
    if (problem.contacts() <= 60) CHECK(solve_best(problem, {.tolerance = 1e-10}).residual <= 1e-10);
  }
}

TEST_CASE("where bodies are known, W is B B^T, and the smoothed method solves between them") {
  for (const FrozenProblem& frozen : ours()) {
    INFO(frozen.name);
    const SparseMatrix transposed = frozen.factor.transpose(), product = frozen.factor * transposed;
    CHECK(SparseMatrix(product - frozen.problem.w).norm() <= 1e-12 * frozen.problem.w.norm());
  }
  const FrozenProblem& frozen = named("pyramid of 5");
  const double from_bodies = Trace(frozen.problem, "smoothed", limited_to(1), frozen.factor).points().back().residual;
  CHECK(from_bodies == solve_smoothed(frozen.problem, {.tolerance = 1e-6}, frozen.factor).residual);
  CHECK(from_bodies != solve_smoothed(frozen.problem, {.tolerance = 1e-6}).residual);  // rounded otherwise
}

TEST_CASE("a trace ends where the method itself ends, and passes where it passes") {
  for (const char* name : {"small pile after 1 s", "twelve planks sliding", "heavy on light 1:100"}) {
    const ContactProblem& problem = named(name).problem;
    for (const std::string& method : method_names()) {
      INFO(name << ", " << method);
      Trace trace(problem, method, limited_to(137));
      REQUIRE(!trace.points().empty());
      const FrozenPoint last = trace.points().back();
      if (counts_sweeps(method)) {  // stopped after single sweeps
        CHECK(last.sweeps == 137);
        for (const FrozenPoint& point : trace.points())
          CHECK(point.residual == solve(problem, method, point.sweeps, 0).residual);
      } else {
        CHECK(last.residual == solve(problem, method, 137, 1e-6).residual);
        CHECK(last.residual <= 1e-6);
      }
      CHECK(*last.row_solves == 3.0 * static_cast<double>(problem.contacts()) * last.sweeps);
    }
  }
}

TEST_CASE("what pgs leaves of a pyramid at rest is impulses in the corners of the friction pyramid, and nothing else") {
  const ContactProblem& problem = named("pyramid of 10").problem;
  const Solution found = solve(problem, "pgs", 10000, 0);
  const Vector u = problem.speeds(found.r);
  CHECK(u.cwiseAbs().maxCoeff() < 1e-8);  // m/s: nothing slides
  int outside = 0;
  double inside_error = 0, all_error = 0, farthest = 0;  // squares of the natural map's error; |r_t| / (mu r_n)
  for (Eigen::Index i = 0; i < problem.contacts(); ++i) {
    const Eigen::Vector3d r = found.r.segment<3>(3 * i), v = u.segment<3>(3 * i);
    const double bound = problem.mu[i] * r[0], tangential = r.tail<2>().norm();
    CHECK(r.tail<2>().cwiseAbs().maxCoeff() <= bound + 1e-9);  // each tangent by itself is as the pyramid allows
    const Eigen::Vector3d lifted(v[0] + problem.mu[i] * v.tail<2>().norm(), v[1], v[2]);
    const double error = (r - projected_to_cone(r - lifted, problem.mu[i])).squaredNorm();
    all_error += error;
    if (tangential > bound + 1e-9) {
      ++outside;
      farthest = std::max(farthest, tangential / bound);
    } else {
      inside_error += error;
    }
  }
  CHECK(outside == 49);  // of 400: the page says so
  CHECK(farthest == Approx(std::sqrt(2.0)));
  CHECK(std::sqrt(all_error) / problem.q.norm() == Approx(0.125).margin(0.001));
  CHECK(std::sqrt(inside_error) / problem.q.norm() < 1e-7);
}

TEST_CASE("points are read as they were written, and what is no line of them is refused, with the line") {
  const std::string heading = lines_of(csv_of({}))[0] + "\n";
  CHECK(read_frozen_csv(heading).problems.empty());
  const std::string text = heading + "a,3,pgs,1,9,0,1.000000e-03,2.000e-06,1.000e-06,4.000e-06\n" +
                           "b,4,cone,2,-,5,1.000000e-04,1.000e+00,1.000e+00,1.000e+00\n";
  const FrozenPoints two = read_frozen_csv(text);
  CHECK(csv_of(two) == text);
  CHECK((two.problems.at(1).of_method[0].empty() && !two.problems[1].of_method[1][0].row_solves));
  CHECK(contains(complaint([] { read_frozen_csv("problem\n"); }), "'problem'"));
  for (const std::string line : {"a,3,pgs,1,9,0,1e-3", "a,x,pgs,1,9,0,1e-3,1,1,1", "a,3,,1,9,0,1e-3,1,1,1",
                                 "a,3,pgs,1,nine,0,1e-3,1,1,1", "a,3,pgs,1,,0,1e-3,1,1,1", ""})
    CHECK(contains(complaint([&] { read_frozen_csv(heading + line + "\n"); }), "'" + line + "'"));
}

TEST_CASE("a folder of problems that is none is refused by name") {
  const Scratch scratch;
  const fs::path empty = scratch / "no_problems";
  make_writable_folder(empty);
  const std::string missing = complaint([&] { foreign_problems(empty / "nowhere"); });
  CHECK(contains(missing, (empty / "nowhere").string()));
  CHECK(!contains(missing, ".dat"));  // not as if there were a folder, with nothing in it
  CHECK(contains(complaint([&] { foreign_problems(empty); }), empty.string()));
  const Ended ended =
      call_program(FROZEN_PROGRAM, fmt::format("--quick --problems '{0}/nowhere' --out '{0}'", empty.string()));
  CHECK(ended.status == 2);
  CHECK(contains(ended.err, "nowhere"));
  CHECK(fs::is_empty(empty));
  write_text_file(empty / "bad.dat", "3 1 oops");
  CHECK(contains(complaint([&] { foreign_problems(empty); }), "bad.dat"));
}
