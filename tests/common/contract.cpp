/// What a step asks of solvers, and what every solver answers: directly, and from within whatever is around it.
#include "pushback/chapters/10_position_correction/split_impulse.h"
#include "pushback/chapters/11_substeps/substeps.h"
#include "pushback/chapters/14_joints_under_load/jointed_solver.h"
#include "pushback/chapters/21_detected_once/detected_once.h"
#include "pushback/common/basics/input.h"
#include "pushback/common/experiment/picture_of.h"
#include "pushback/common/world/any_solver.h"
#include "pushback/common/world/measure.h"
#include "pushback/common/world/situations.h"
#include "pushback/common/world/solver_from.h"
#include "pushback/engine/substeps/wide_solver.h"
#include "pushback/tools/catalogue/solvers.h"
#include "tests/support/catch.h"
#include "tests/support/complaint.h"
#include "tests/support/substeps.h"

using namespace pushback;

namespace {

constexpr Real h = Real(1) / 60;

/// Says of each call what it was asked, and has a plan like nobody else's.
struct TelltaleFunctions {
  std::shared_ptr<std::vector<std::string>> calls = std::make_shared<std::vector<std::string>>();
  Plan its_plan{.detections = 2, .substeps = 3, .sweeps = 7, .margin = {Real(0.5), Real(0.25)}, .moves_bodies = true};

  Plan plan(Real /*dt*/) const { return its_plan; }
  static bool supports_joints() { return true; }
  void check(World&, Real dt) { note("check", dt); }
  void after_detection(World&, Real dt) { note("after_detection", dt); }
  void solve(World&, Real dt, int sweeps) { note("solve " + std::to_string(sweeps), dt); }
  void integrate_positions(World&, Real dt) { note("integrate positions", dt); }
  void after_move(World&, Real dt) { note("after_move", dt); }
  void end_detection(World&) { calls->push_back("end_detection"); }
  static SolveStats stats() { return {11, 13}; }

 private:
  void note(const std::string& what, Real dt) { calls->push_back(fmt::format("{}, 1/{:g} s", what, 1 / dt)); }
};
using Telltale = SolverFrom<TelltaleFunctions>;

/// Leaves the motion of bodies to the step, although its plan says otherwise.
struct WithoutMotion {
  static Plan plan(Real /*dt*/) { return {.moves_bodies = true}; }
  static bool supports_joints() { return false; }
  static void check(World&, Real /*dt*/) {}
  static void after_detection(World&, Real /*dt*/) {}
  static void solve(World&, Real /*dt*/, int /*sweeps*/) {}
  static void after_move(World&, Real /*dt*/) {}
  static void end_detection(World&) {}
  static SolveStats stats() { return {}; }
};

using Pushing = Solver<Clamping>;  // the least that holds bodies

World falling_ball() {
  World world;
  world.add(sphere(1, 1).at({0, 10, 0}));
  return world;
}

std::vector<std::string> calls_of_a_step() {
  std::vector<std::string> calls;
  for (int detection = 0; detection < 2; ++detection) {
    calls.insert(calls.end(), {"check, 1/360 s", "after_detection, 1/360 s"});
    for (int substep = 0; substep < 3; ++substep)
      calls.insert(calls.end(), {"solve 7, 1/360 s", "integrate positions, 1/360 s", "after_move, 1/360 s"});
    calls.push_back("end_detection");
  }
  return calls;
}

/// A stack that has stood for a while, with a box that slides beside it.
World at_work(AnySolver& solver) {
  World world;
  stack(world, 3);
  world.add(box(Vec3::Constant(Real(0.5)), 50).at({4, Real(0.5), 0}).moving({3, 0, 1}));
  for (int step = 0; step < 20; ++step) world.step(solver, h);
  return world;
}

struct RelaxMisspelt : Effect, Relaxes {
  void build(RelaxingContext&) {}
  void relaxx(RelaxingContext&) {}
};
struct RelaxUnnamed : Effect {
  void relax(RelaxingContext&) {}
};
struct CorrectMisspelt : Effect, Corrects {
  void check(StepContext&) {}
  void corect(CorrectingContext&) {}
};
struct CorrectUnnamed : Effect {
  void correct(CorrectingContext&) {}
};
struct GeometryMisspelt : Effect, UpdatesGeometry {
  void build(StepContext&) {}
  void after_move(StepContext&) {}
};
struct GeometryUnnamed : Effect {
  void update_geometry(StepContext&) {}
};
static_assert(!SpellsRelax<RelaxMisspelt> && !SpellsRelax<RelaxUnnamed> && SpellsRelax<SoftContacts> &&
              SpellsRelax<Clamping>);
static_assert(!SpellsCorrect<CorrectMisspelt> && !SpellsCorrect<CorrectUnnamed> && SpellsCorrect<SplitImpulse> &&
              SpellsCorrect<Clamping>);
static_assert(!SpellsUpdateGeometry<GeometryMisspelt> && !SpellsUpdateGeometry<GeometryUnnamed> &&
              SpellsUpdateGeometry<SplitJoints> && SpellsUpdateGeometry<Clamping>);
static_assert(std::is_base_of_v<RequiredHook, SplitImpulse>, "Solver refuses what it would not call");

}  // namespace

TEST_CASE("contract: a step calls its solver in this order, in the parts that its plan says") {
  World world = falling_ball();
  Telltale solver;
  world.step(solver, h);
  CHECK(*solver.calls == calls_of_a_step());
  CHECK(std::abs(world.time - h) <= 8 * std::numeric_limits<Real>::epsilon());
}

TEST_CASE("contract: a class without integrate_positions has its bodies moved as by any solver") {
  World world = falling_ball();
  SolverFrom<WithoutMotion> solver;
  world.step(solver, h);
  CHECK(world.bodies[0].velocity.y() == Approx(-World::g * h));
  CHECK(world.bodies[0].position.y() == Approx(10 - World::g * h * h));
  CHECK_FALSE(solver.supports_joints());
}

TEST_CASE("contract: what is around a solver hands everything on") {
  const auto same_plan = [](const StepSolver& around) {
    const Plan plan = around.plan(h), its = Telltale{}.its_plan;
    return plan.detections == its.detections && plan.substeps == its.substeps && plan.sweeps == its.sweeps &&
           plan.margin.least == its.margin.least && plan.margin.ahead == its.margin.ahead &&
           plan.moves_bodies == its.moves_bodies && plan.workers == its.workers;
  };
  struct Few : Workers {
    Few() : Workers(2) {}
  } few;
  Telltale told;
  World world = falling_ball();
  const auto check = [&](StepSolver& around) {
    CHECK(same_plan(around));
    CHECK(around.supports_joints());
    CHECK((around.stats().rows == 11 && around.stats().residual == 13));
    told.calls->clear();
    world.step(around, h);
    CHECK(*told.calls == calls_of_a_step());
  };
  AnySolver any = told;
  check(any);
  AnySolver twice_around = AnySolver(FittingSolver(world, told));
  check(twice_around);
  FittingSolver fitting(world, told);
  check(fitting);

  OnlyWhatIsNeeded needed(world, told);
  told.calls->clear();
  needed.step(world, h);
  CHECK(*told.calls == calls_of_a_step());

  told.its_plan.workers = &few;
  CHECK(AnySolver(told).plan(h).workers == &few);
  CHECK(FittingSolver(world, told).plan(h).workers == &few);
}

TEST_CASE("contract: the impulse of a contact is the sum over the step, whatever the solver") {
  for (const NamedSolver& named : all_solvers()) {
    if (named.name == "00 naive") continue;  // it also moves bodies apart, so that contacts come and go
    INFO(named.name);
    AnySolver solver = named.solver;
    World world = at_work(solver);
    if (solver.plan(h).detections >
        1) {  // a contact of what slides may end between two detections, and is in no list then
      world.bodies.back().velocity.setZero();
      for (int step = 0; step < 30; ++step) world.step(solver, h);
    }
    for (int step = 0; step < 10; ++step) {
      const Vec3 before = momentum(world);
      world.step(solver, h);
      const Vec3 given = momentum(world) - before - 350 * h * world.gravity;
      Vec3 sum = Vec3::Zero();
      for (const Contact& contact : world.contacts)
        if (contact.id.body_a == 0) sum += contact.impulse;
      REQUIRE((given - sum).norm() <= 1e-5 * 350 * h * World::g);  // some rows are solved in float
    }
  }
}

TEST_CASE("contract: contacts_before has the impulses of the latest substep, from which a solver starts") {
  Substeps<Pushing> solver({}, 4);
  World world;
  stack(world, 2);
  for (int step = 0; step < 60; ++step) world.step(solver, h);
  const Contacts after = world.contacts;
  world.begin_step(h / 4);
  REQUIRE(world.contacts_before.size() == after.size());
  for (std::size_t i = 0; i < after.size(); ++i) CHECK(world.contacts_before[i].impulse == after[i].last_impulse);
  CHECK_FALSE(world.last_impulses_known);
}

TEST_CASE("contract: the residual is what the sweeps leave") {
  for (const std::string name : {"05 restitution", "07 warm start", "21 detected once", "22 wide"}) {
    INFO(name);
    AnySolver solver = solver_named(name).solver;
    World world = at_work(solver);
    world.bodies[1].velocity.y() = -1;  // an impact on the lowest box
    std::vector<Real> residuals;
    for (const int sweeps : {0, 1, 400}) {
      AnySolver its_solver = solver;
      World its_world = world;
      its_world.step(its_solver, h, sweeps);
      residuals.push_back(its_solver.stats().residual);
    }
    CHECK(residuals[0] > 1e-3);
    if (solver.plan(h).all_substeps() == 1) CHECK(residuals[1] > residuals[2]);  // no relaxing sweep follows
    CHECK(residuals[2] < 1e-3);
  }
}

TEST_CASE("contract: a step in substeps has the bits of so many steps") {
  World divided;
  pyramid(divided, 3);
  World stepped = divided;
  Substeps<Pushing> solver({}, 7, 2);
  Pushing each;
  for (int step = 0; step < 20; ++step) {
    divided.step(solver, h);
    substeps(stepped, each, h, 7, 2);
  }
  CHECK(hash_of(divided) == hash_of(stepped));
  CHECK(complaint([&] {
          solver.count = 0;
          divided.step(solver, h);
        }).find("substeps is 0") != std::string::npos);
}

TEST_CASE("contract: who does not hold joints refuses them, in every wrapping") {
  World world = falling_ball();
  world.joints.push_back({.name = "a thread", .a = the_world, .b = 0, .ask = [](auto&&...) {}});
  Pushing solver;
  AnySolver any = solver, jointed = solver_named("07 warm start").solver;
  CHECK(complaint([&] { world.step(solver, h); }).find("joint") != std::string::npos);
  CHECK(complaint([&] { world.step(any, h); }).find("joint") != std::string::npos);
  CHECK(complaint([&] { world.step(jointed, h); }).empty());
  CHECK(world.time == h);
}

TEST_CASE("contract: a solver's name that there is not is refused with those that there are") {
  const std::string said = complaint([] { solver_named("03"); });
  CHECK(said.find("solver is '03': one of these is needed: 00 naive, ") != std::string::npos);
  CHECK(said.find(", all together") != std::string::npos);
}
