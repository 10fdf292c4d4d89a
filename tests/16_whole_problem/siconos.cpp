/// Chapter 16's residual and chapter 19's frozen problems, held against Siconos. Skipped where it is not built in.
#include <random>

#include "pushback/chapters/16_whole_problem/problem_file.h"
#include "pushback/common/world/situations.h"
#include "pushback/engine/direct/row_matrix.h"
#include "pushback/tools/measure/frozen/siconos.h"
#include "tests/support/call.h"
#include "tests/support/catch.h"
#include "tests/support/foreign_problems.h"

using namespace pushback;
using namespace pushback::frozen;

namespace {

struct Named {
  std::string name;
  ContactProblem problem;
};

template <class Fill>
Named step_of(const std::string& name, const Fill& fill) {
  World world;
  fill(world);
  world.begin_step(Real(1) / 60);
  return {name, problem_of(world)};
}

std::vector<Named> own() {
  const auto sliding = [](World& world) {
    stack(world, 3);
    for (std::size_t i = 1; i < world.bodies.size(); ++i) world.bodies[i].velocity += Vec3(Real(0.4), 0, Real(0.1));
  };
  const auto thrown = [](World& world) {
    pyramid(world, 3);
    world.bodies.back().velocity += Vec3(2, -3, 1);
  };
  std::vector<Named> all{step_of("a stack of five", [](World& world) { stack(world, 5); }),
                         step_of("a stack that slides", sliding), step_of("a pyramid that is hit", thrown)};
  all.push_back(all[1]);
  all.back().name = "the same without friction";
  all.back().problem.mu.setZero();
  all.push_back(all[1]);
  all.back().name = "the same with q = 0";
  all.back().problem.q.setZero();
  return all;
}

bool built_in() {
  if (siconos_methods().empty()) WARN("skipped: this build is without PUSHBACK_SICONOS");
  return !siconos_methods().empty();
}

}  // namespace

TEST_CASE("our residual is Siconos' own error, of whatever r, once both are relative to the same") {
  if (!built_in()) return;
  std::mt19937 random(11);
  std::normal_distribution<double> number;
  std::vector<Named> all = own();
  for (const auto& file : foreign_problems()) all.push_back({file.stem().string(), read_problem_file(file)});
  for (const auto& [name, problem] : all) {
    std::vector<Vector> tried{Vector::Zero(problem.q.size())};
    for (const char* method : {"pgs", "scaled-back", "cone"})
      for (const int sweeps : {1, 30}) tried.push_back(solve(problem, method, sweeps, 0).r);
    Vector anything = tried.back();  // of the size of impulses there, and outside of every cone
    const double size = anything.norm() / std::sqrt(static_cast<double>(anything.size()));
    for (double& each : anything) each += (size > 0 ? size : 1) * number(random);
    tried.push_back(anything);
    for (const Vector& r : tried) {
      const double ours = relative_residual(problem, r), theirs = siconos_error(problem, r);
      INFO(name << ": ours " << ours << ", Siconos " << theirs);
      const double unit = problem.q.norm() > 0 ? problem.q.norm() : 1;
      const double rounding = 1e-14 * (r.norm() + (problem.w * r).norm());  // what W r may be wrong by
      CHECK(std::abs(ours * unit - theirs * siconos_unit(problem, r)) <= 1e-12 * ours * unit + rounding);
      CHECK(theirs <= ours * (1 + 1e-12) + rounding / unit);
    }
  }
}

TEST_CASE("what Siconos solves is solved by our residual, and what we solve by its error") {
  if (!built_in()) return;
  for (const auto& [name, problem] : own()) {
    for (const std::string& method : siconos_methods()) {
      const SiconosAnswer found = solve_by_siconos(problem, method, 1e-8, 100000);
      INFO(name << ", " << method << ": " << found.iterations << " iterations");
      const double unit = problem.q.norm() > 0 ? problem.q.norm() : 1;
      if (found.reached)
        CHECK(relative_residual(problem, found.r) * unit <= 1.0001e-8 * siconos_unit(problem, found.r));
      CHECK(found.seconds >= 0);
    }
    CHECK(siconos_error(problem, solve_best(problem).r) <= 1e-12);
  }
}
