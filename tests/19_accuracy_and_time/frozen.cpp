/// Chapter 19: frozen problems, and how far each method comes on them. Nothing here depends on a clock.
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
  const double from_bodies = solve_smoothed(frozen.problem, {.tolerance = 1e-6}, frozen.factor).residual;
  CHECK(from_bodies <= 1e-6);
  CHECK(from_bodies != solve_smoothed(frozen.problem, {.tolerance = 1e-6}).residual);  // rounded otherwise
}

TEST_CASE("a method reaches a residual where it does by itself, and not at the stop before") {
  for (const char* name : {"small pile after 1 s", "twelve planks sliding", "heavy on light 1:100"}) {
    const FrozenProblem& frozen = named(name);
    for (const std::string& method : method_names()) {
      INFO(name << ", " << method);
      const Progress progress = progress_of(frozen, method, {.sweeps = 137, .seconds = 1e9});
      for (std::size_t i = 0; i < tolerances.size(); ++i) {
        const auto residual = [&](int sweeps) { return solve(frozen.problem, method, sweeps, 0).residual; };
        if (!counts_sweeps(method)) {
          REQUIRE(progress[i]);
          CHECK(solve(frozen.problem, method, 0, tolerances[i]).residual <= tolerances[i]);
        } else if (!progress[i]) {
          CHECK(residual(137) > tolerances[i]);
        } else {
          const int sweeps = progress[i]->sweeps;  // at most a quarter too many
          CHECK(residual(sweeps) <= tolerances[i]);
          if (sweeps > 0) CHECK(residual(std::min(sweeps - 1, 4 * sweeps / 5)) > tolerances[i]);
        }
      }
    }
  }
}

TEST_CASE("only what is reached is in the tables, and the fastest is bold") {
  Compared row{"a", 4, std::vector<Progress>(method_names().size())};
  row.of_method[0][0] = Reached{.sweeps = 10, .seconds = 2e-3};
  row.of_method[1][0] = Reached{.sweeps = 1000, .systems = 5, .seconds = 1e-3};
  const std::vector<Compared> rows{row};
  CHECK(contains(tables_of(rows), "| a | 4 | 2 / 120 | **1** / 12k + 5 | - | - | - | - |\n"));
  const std::string reached = reached_of(rows);
  CHECK(contains(reached, "| pgs | 1, 0, 2 x | 0, – | 0, – |\n"));
  CHECK(contains(reached, "| scaled-back | 1, 1, 1 x | 0, – | 0, – |\n"));
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
