/// Solvers by their names, and as one type.
#include <fmt/format.h>

#include <set>

#include "pushback/chapters/07_warm_start/full_solver.h"
#include "pushback/chapters/13_joints/ball_and_socket.h"
#include "pushback/common/world/measure.h"
#include "pushback/common/world/situations.h"
#include "pushback/tools/catalogue/solvers.h"
#include "tests/support/catch.h"
#include "tests/support/complaint.h"

using namespace pushback;

namespace {

constexpr Real h = Real(1) / 60;

World pyramid_of_four() {
  World world;
  pyramid(world, 4);
  return world;
}

/// Notes what it is asked, and where the first body is then.
struct Watching : StepSolver {
  std::vector<std::string>& asked;

  explicit Watching(std::vector<std::string>& where) : asked(where) {}
  void check(World& world, Real) override { note("check", world); }
  void solve(World& world, Real, int sweeps) override { note("solve", world, fmt::format(", {} sweeps", sweeps)); }
  void moved(World& world, Real) override { note("moved", world); }
  void note(const char* what, const World& world, const std::string& more = "") {
    asked.push_back(fmt::format("{} at {}{}", what, world.bodies[0].position.x() == h ? "1/60" : "0", more));
  }
};

}  // namespace

TEST_CASE("named solvers: each has a name of its own, and says what it is made of") {
  std::set<std::string> names;
  for (const NamedSolver& solver : all_solvers()) CHECK(names.insert(solver.name).second);
  CHECK(solver_named("00 naive").made_of() == "NaiveAveraged");
  CHECK(solver_named("03 Baumgarte").made_of() == "Solver<Joints, Clamping, Baumgarte>");
  CHECK(solver_named("all together").made_of() ==
        "Substeps<RelaxingSolver<SteadyJoints, Clamping, SoftContacts, SimultaneousImpacts, FrictionCone, "
        "ScaledWarmStart> >");
}

TEST_CASE("named solvers: a name that there is not is refused with those that there are") {
  const std::string said = complaint([] { solver_named("03"); });
  CHECK(said.find("solver is '03': one of these is needed: 00 naive, ") != std::string::npos);
  CHECK(said.find(", all together") != std::string::npos);
}

TEST_CASE("any solver: steps in the bits of the solver in it, says how many rows that took, and copies go on alike") {
  World world = pyramid_of_four(), erased_world = world;
  FullSolver full;
  AnySolver any = full;
  for (int step = 0; step < 60; ++step) {
    world.step(full, h);
    erased_world.step(any, h);
  }
  REQUIRE(hash_of(erased_world) == hash_of(world));
  Real worst = 0;
  for (const Row& row : full.rows()) worst = std::max(worst, row.error());
  CHECK(any.solved().rows == static_cast<int>(3 * world.contacts.size()));
  CHECK(any.solved().residual == worst);
  CHECK(any.type() == typeid(FullSolver));

  World copied_world = erased_world;
  AnySolver copy = any;
  for (int step = 0; step < 60; ++step) {
    world.step(full, h);
    copied_world.step(copy, h);
  }
  CHECK(hash_of(copied_world) == hash_of(world));
  CHECK(hash_of(erased_world) != hash_of(world));
}

TEST_CASE("any solver: is asked before the step, in it, and after the bodies have moved, and and may refuse") {
  World world;
  const int ball = world.add(sphere(1, 1).moving({1, 0, 0}));
  std::vector<std::string> asked;
  AnySolver any = Watching(asked);
  world.step(any, h, 7);
  CHECK(asked == std::vector<std::string>{"check at 0", "solve at 0, 7 sweeps", "moved at 1/60"});
  world.joints = {ball_and_socket(world, the_world, ball, {0, 0, 0})};
  AnySolver without_joints = FullSolver{};
  CHECK(complaint([&] { world.step(without_joints, h); }).find("holds no joints") != std::string::npos);
}
