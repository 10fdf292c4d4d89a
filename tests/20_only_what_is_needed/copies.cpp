/// A world is a value: a copy of it and of its solver goes on as the original would have, to the last bit, whatever becomes of
/// the original. And what is refused has changed nothing.
#include "pushback/chapters/15_limits_motors_springs/piston.h"
#include "pushback/chapters/26_to_each_its_own/scenes.h"
#include "pushback/common/world/measure.h"
#include "pushback/engine/presets.h"
#include "pushback/tools/catalogue/solvers.h"
#include "tests/support/catch.h"
#include "tests/support/complaint.h"
#include "tests/support/with_joints.h"
#include "tests/support/yardstick.h"

using namespace pushback;

namespace {

/// Moves on by a step of h. A copy has a solver of its own.
using Step = std::function<void(World&)>;
Step by(AnySolver solver) {
  return [solver](World& world) mutable { world.step(solver, h); };
}
Step asleep_by(const NamedSolver& named, const World& world) {
  return [needed = named.fitting(world, Sleep{})](World& its) mutable { needed.step(its, h); };
}

/// Nothing in it is where it was: who still looks here gets other numbers.
void scatter(World& world) {
  for (Body& body : world.bodies) body.at({1000, 1000, 1000}).moving({7, 7, 7}).spinning({7, 7, 7});
  world.bodies.shrink_to_fit();
  world.contacts.clear();
  world.joints.clear();
}

/// The first of so many steps after which the copy has gone another way; -1: none.
int first_difference(World world, Step step, int before, int after) {
  for (int i = 0; i < before; ++i) step(world);
  auto original = std::make_unique<World>(world);
  auto its_step = std::make_unique<Step>(step);
  World copy = *original;
  Step copied_step = *its_step;
  scatter(*original);
  original.reset();
  its_step.reset();
  for (int i = 0; i < after; ++i) {
    step(world);
    copied_step(copy);
    if (hash_of(world) != hash_of(copy) || world.contacts.size() != copy.contacts.size()) return i;
  }
  return -1;
}

/// All that a step may change.
struct State {
  std::uint64_t bodies;
  std::size_t contacts;
  Real time, dt_before, impulses = 0;
  std::vector<Vec3> pulls;

  explicit State(const World& world)
      : bodies(hash_of(world)), contacts(world.contacts.size()), time(world.time), dt_before(world.dt_before) {
    for (const Contact& contact : world.contacts) impulses += contact.impulse.norm();
    for (const Joint& joint : world.joints)
      for (const Real impulse : joint.last_impulses) impulses += std::abs(impulse);
    for (const Body& body : world.bodies) pulls.push_back(body.force);
  }
  bool operator==(const State&) const = default;
};

template <class Full>
AnySolver with(const std::function<void(Full&)>& spoil) {
  Full solver;
  spoil(solver);
  return solver;
}

}  // namespace

TEST_CASE("a copied world and its solver go on in the same bits, under every solver") {
  World yard;
  to_each_its_own_scenes::Yard{}(yard);
  World struck;
  pyramid(struck, 4);
  struck_chain(struck);
  Recommended within;
  within.error = Real(1e-4);
  std::vector<std::pair<std::string, AnySolver>> all{{"within 0.1 mm", within}};
  for (const char* name : {"07 warm start", "all together"})
    CHECK(first_difference(struck, asleep_by(solver_named(name), struck), 30, 15) == -1);
  for (const NamedSolver& named : all_solvers())
    if (named.solver.supports_joints()) all.emplace_back(named.name, named.solver);
  for (const auto& [name, solver] : all) {
    INFO(name);
    CHECK(first_difference(struck, by(solver), 30, 15) == -1);
    for (const int before : {17, 54}) CHECK(first_difference(yard, by(solver), before, 15) == -1);
  }
}

TEST_CASE("what a solver refuses has changed nothing, and names the value") {
  World world;
  pyramid(world, 3);
  struck_chain(world);
  world.bodies[2].force = {1, 2, 3};
  JointedSolver before;
  for (int i = 0; i < 30; ++i) world.step(before, h);
  world.bodies[2].force = {1, 2, 3};
  const State state(world);
  const auto refused = [&](AnySolver solver, const std::string& what) {
    INFO(what);
    CHECK(complaint([&] { world.step(solver, h); }).find(what) != std::string::npos);
    CHECK(State(world) == state);
    OnlyWhatIsNeeded needed(world, solver);
    CHECK(complaint([&] { needed.step(world, h); }).find(what) != std::string::npos);
    CHECK(State(world) == state);
  };
  refused(with<JointedSolver>([](auto& s) { s.Baumgarte::beta = -1; }), "beta is -1");
  refused(with<JointedSolver>([](auto& s) { s.slop = -1; }), "slop is -1");
  refused(with<JointedSolver>([](auto& s) { s.threshold = -1; }), "threshold is -1");
  refused(with<JointedSolver>([](auto& s) { s.SplitJoints::beta = -1; }), "beta of the joints is -1");
  refused(with<JointedSolver>([](auto& s) { s.passes = 0; }), "passes is 0");
  refused(with<SteadyJointedSolver>([](auto& s) { s.hertz = 0; }), "hertz is 0");
  refused(with<SteadyJointedSolver>([](auto& s) { s.damping_ratio = -1; }), "damping ratio is -1");
  refused(with<SteadyJointedSolver>([](auto& s) { s.fastest_push_out = -1; }), "fastest push-out is -1");
  refused(with<SteadyJointedSolver>([](auto& s) { s.threshold = -1; }), "threshold is -1");
}

TEST_CASE("a joint that asks for what cannot be has stopped the step before anything changed") {
  World world;
  stack(world, 3);
  const int ball = world.add(sphere(Real(0.1), 1).at({5, 5, 0}));
  const auto shrinking = [](Real t) { return Real(0.21) - t; };  // not above 0 after 0.21 s
  world.joints = {piston(world, the_world, {5, Real(5.2), 0}, ball, {5, 5, 0}, shrinking)};
  JointedSolver solver;
  std::string said;
  int steps = 0;
  for (; said.empty() && steps < 60; ++steps) {
    const State before(world);
    said = complaint([&] { world.step(solver, h); });
    if (!said.empty()) CHECK(State(world) == before);
  }
  CHECK(steps == 13);
  CHECK(said.find("length of a piston is") != std::string::npos);
}
