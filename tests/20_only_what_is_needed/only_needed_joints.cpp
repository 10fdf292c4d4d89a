/// Joints through what a scene calls for: the same bits as World::step, and nothing where nothing is joined.
#include <fmt/format.h>

#include "pushback/chapters/00_naive_impulses/naive.h"
#include "pushback/chapters/13_joints/distance.h"
#include "pushback/chapters/13_joints/weld.h"
#include "pushback/chapters/20_only_what_is_needed/dispatch.h"
#include "pushback/common/world/measure.h"
#include "tests/support/catch.h"
#include "tests/support/complaint.h"
#include "tests/support/with_joints.h"
#include "tests/support/yardstick.h"

using namespace pushback;

namespace {

void hanging_chain_of_eight(World& world) {
  hanging_chain(world);
}

World filled(const std::function<void(World&)>& fill) {
  World world;
  fill(world);
  return world;
}

std::vector<Real> impulses_of(const JointRows& rows) {
  std::vector<Real> impulses;
  for (const JointRow& row : rows) impulses.push_back(row.impulse);
  return impulses;
}

/// A world stepped as World does it and one stepped by what it calls for, always alike.
template <class Full>
struct Both {
  World whole, fitted;
  Full full;
  OnlyWhatIsNeeded needed;

  explicit Both(const World& before_it, const Full& solver = {})
      : whole(before_it), fitted(before_it), full(solver), needed(before_it, solver) {}
  void step(int count, Real dt = h, int sweeps = 10) {
    for (int i = 0; i < count; ++i) {
      INFO("step " << i);
      whole.step(full, dt, sweeps);
      needed.step(fitted, dt, sweeps);
      REQUIRE(hash_of(whole) == hash_of(fitted));
      REQUIRE(whole.time == fitted.time);
      REQUIRE(impulses_of(full.joint_rows()) == impulses_of(needed.joint_rows()));
    }
  }
  void change(const std::function<void(World&)>& how) {
    how(whole);
    how(fitted);
  }
};

}  // namespace

// ---- what is read off a scene ------------------------------------------------------------------------------------------

TEST_CASE("a joint that holds a body that is not there is refused, and nothing has moved") {
  for (const int body : {-2, 1, 7}) {
    World world = filled(lone_pendulum);
    OnlyWhatIsNeeded needed(world, JointedSolver{}), with_sleep(world, JointedSolver{}, Sleep{});
    needed.step(world, h);
    with_sleep.step(world, h);
    world.joints.push_back(world.joints.front());
    world.joints.back().b = body;
    const std::uint64_t before = hash_of(world);
    const Real time = world.time;
    for (OnlyWhatIsNeeded* solver : {&needed, &with_sleep}) {
      for (int twice = 0; twice < 2; ++twice) {
        CHECK(complaint([&] { solver->step(world, h); }) ==
              fmt::format("a ball and socket holds body {}: of 1 bodies, the first is 0", body));
      }
    }
    CHECK(hash_of(world) == before);
    CHECK(world.time == time);
  }
}

// ---- solvers that hold none --------------------------------------------------------------------------------------------

TEST_CASE("a solver without joints is refused as World::step does, and nothing has moved") {
  const auto refused = [](auto solver) {
    World world = filled(hanging_chain_of_eight);
    world.joints.clear();
    OnlyWhatIsNeeded needed(world, solver), with_sleep(world, solver, Sleep{});
    FittingSolver fitting(world, solver);
    world = filled(hanging_chain_of_eight);
    const std::uint64_t before = hash_of(world);
    const std::string said = complaint([&] { world.step(solver, h); });
    CHECK(said.find("joints") != std::string::npos);
    CHECK(complaint([&] { OnlyWhatIsNeeded(world, solver); }) == said);
    for (int twice = 0; twice < 2; ++twice) {
      CHECK(complaint([&] { needed.step(world, h); }) == said);
      CHECK(complaint([&] { with_sleep.step(world, h); }) == said);
    }
    Sleep sleep;
    CHECK(complaint([&] { pushback::step(world, solver, h, 10, sleep); }) == said);
    CHECK(hash_of(world) == before);
    CHECK(world.time == 0);
    CHECK(complaint([&] { world.step(fitting, h); }) == said);  // not fitted: it learns of them only when they are held
    world.joints.clear();
    CHECK(complaint([&] { needed.step(world, h); }).empty());
  };
  refused(FullSolver{});
  refused(SteadySolver{});
  refused(NaiveAveraged{});
}

// ---- the scene changes -------------------------------------------------------------------------------------------------

TEST_CASE("joints come and go: the same bits, with the same settings and memory") {
  JointedSolver solver;
  solver.Joints::beta = Real(0.35);
  World before_it = filled(hanging_chain_of_eight);
  const std::vector<Joint> chain = before_it.joints;
  Both<JointedSolver> both(before_it, solver);
  both.step(30);
  both.change([](World& world) { world.joints.resize(4); });  // the lower half falls
  both.step(30);
  both.change([](World& world) { world.joints.clear(); });
  both.step(20);
  CHECK(both.needed.joint_rows().empty());
  both.change([](World& world) {
    for (int i = 1; i < 4; ++i) world.joints.push_back(weld(world, i, i + 1, world.bodies[std::size_t(i)].position));
  });
  both.step(30);
  both.change([](World& world) {
    const Vec3 above = world.bodies[8].position + Vec3(0, 2, 0);
    world.joints.push_back(distance(world, the_world, above, 8, world.bodies[8].position));
  });
  both.step(30);
}

TEST_CASE("one and the same pendulum: what joins it comes back, and does not start from what it once bore") {
  World before_it = filled(lone_pendulum);
  before_it.bodies[0].position = {0, -1, 0};  // at rest, bearing its weight
  before_it.joints = {ball_and_socket(before_it, the_world, 0, {0, 0, 0})};
  Both<JointedSolver> both(before_it);
  both.step(10);
  const std::vector<Joint> joints = before_it.joints;
  both.change([](World& world) { world.joints.clear(); });
  both.step(1);
  both.change([&joints](World& world) {
    world.joints = joints;
    world.gravity.setZero();
    world.bodies[0].velocity.setZero();
    world.bodies[0].position = {0, -1, 0};
  });
  both.step(1, h, 0);  // no sweep: what it starts from is all that it gets
  CHECK(both.whole.bodies[0].velocity.isZero(0));
}
