/// The same source does the same thing whatever built it, by g++ and by clang++, optimised or not, with sanitizers or without; and a
/// change that is to keep all bits keeps them. The hashes of motions stand in hashes.txt, a table for each of the two nets;
/// PUSHBACK_STORE_HASHES=1 writes that file anew.
#include <fmt/format.h>

#include <cstdlib>
#include <fstream>
#include <thread>

#include "pushback/chapters/10_position_correction/nonlinear_gauss_seidel.h"
#include "pushback/chapters/10_position_correction/split_impulse.h"
#include "pushback/chapters/14_joints_under_load/steady_jointed_solver.h"
#include "pushback/chapters/17_direct_contacts/direct_contacts.h"
#include "pushback/common/bodies/random.h"
#include "pushback/common/world/measure.h"
#include "pushback/common/world/situations.h"
#include "pushback/engine/direct/direct_joints.h"
#include "pushback/engine/direct/warm_direct_contacts.h"
#include "pushback/tools/catalogue/solvers.h"
#include "pushback/tools/measure/hard_cases/random_scene.h"
#include "pushback/tools/measure/hard_cases/stages.h"
#include "tests/support/catch.h"
#include "tests/support/substeps.h"
#include "tests/support/with_joints.h"
#include "tests/support/yardstick.h"

using namespace pushback;

namespace {

/// A line for each scene, a column for each solver; "-" where a solver does not take a scene.
struct Table {
  std::vector<std::string> columns = {};
  std::vector<std::pair<std::string, std::vector<std::string>>> lines = {};
};

void heap(World& world) {
  Random random(7);
  world.add(ground());
  for (int i = 0; i < 15; ++i) {
    Body body = random.body(10);
    world.add(body.at({random.between(-1, 1), 1 + static_cast<Real>(i) * Real(0.7), random.between(-1, 1)}));
  }
}

/// Free, each about its middle axis and a little beside it; and two that meet.
void spinning(World& world) {
  world.gravity.setZero();
  for (int i = 0; i < 5; ++i) {
    const Real faster = static_cast<Real>(i + 1);
    world.add(box({1, Real(0.5), Real(0.2)}, 10).at({4 * faster, 0, 0}).spinning({Real(0.01), faster, 0}));
  }
  world.add(capsule(Real(0.2), 1, 5).at({-6, 0, 0}).moving({4, 0, 0}).spinning({0, 0, 7}));
}

/// A needle, a plate and a lump in turn, each of other points.
void hulls(World& world) {
  Random random(11);
  world.add(ground());
  for (int i = 0; i < 9; ++i) {
    const Vec3 size = i % 3 == 0 ? Vec3(1, Real(0.1), Real(0.1)) : i % 3 == 1 ? Vec3(1, Real(0.1), 1) : Vec3(1, 1, 1);
    std::vector<Vec3> points(8);
    for (Vec3& point : points) point = size.cwiseProduct(random.vector(Real(0.5)));
    Body body = hull(points, 10).at({random.between(-1, 1), 1 + static_cast<Real>(i) * Real(0.8), 0});
    world.add(body.bouncy(i % 2 == 0 ? 0 : Real(0.5)));
  }
}

struct Named {
  const char* name;
  void (*fill)(World&);
};
const Named scenes[] = {{"stack", [](World& world) { stack(world, 10); }},
                        {"pyramid", [](World& world) { pyramid(world, 5); }},
                        {"heap", heap},
                        {"hulls", hulls},
                        {"spinning", spinning},
                        {"random 3", [](World& world) { world = random_scene(3).world; }}};

std::string hash_after(const Named& scene, const Stage& stage) {
  World world;
  scene.fill(world);
  const Stepper step = stage.begin();
  try {
    for (int i = 0; i < 600; ++i) step.step(world, Real(1) / 60);
  } catch (const std::exception&) {
    return fmt::format("{:016x}", 0);  // no longer finite: naive solvers may do that, but then all builds do
  }
  return fmt::format("{:016x}", hash_of(world));
}

Table by_stages() {
  Table table;
  for (const Stage& stage : stages()) table.columns.emplace_back(stage.name);
  for (const Named& scene : scenes) {
    auto& [name, hashes] = table.lines.emplace_back(scene.name, std::vector<std::string>());
    for (const Stage& stage : stages()) hashes.push_back(hash_after(scene, stage));
  }
  return table;
}

using Step = std::function<void(World&)>;

Step steps_by(AnySolver solver, int count = 1, int sweeps = 10) {
  return [=](World& world) mutable { substeps(world, solver, h, count, sweeps); };
}

Step by(OnlyWhatIsNeeded solver) {
  return [solver = std::move(solver)](World& world) mutable { solver.step(world, h, 10); };
}

struct Way {
  const char* name;
  Step (*begin)(const World&);
  bool joints = true;   // it holds them
  bool direct = false;  // it solves all contacts directly
};

// Friction as a cone beside what needs it, and a warm start wherever one may be: each way takes all of a step's memory along.
const Way wide_ways[] = {
    {"07 with joints", [](const World&) { return steps_by(solver_named("07 warm start").solver); }},
    {"07 with warm joints", [](const World&) { return steps_by(WithJoints<WarmJoints, FullSolver>{}); }},
    {"all together", [](const World&) { return steps_by(SteadyJointedSolver{}, 8, 1); }},
    {"split impulse",
     [](const World&) {
       return steps_by(
           CorrectingSolver<SplitJoints, Clamping, SplitImpulse, Slop, Restitution, FrictionCone, WarmStart>{});
     }},
    {"non-linear Gauss-Seidel",
     [](const World&) {
       return steps_by(
           CorrectingSolver<SplitJoints, Clamping, NonlinearGaussSeidel, Slop, Restitution, FrictionCone, WarmStart>{});
     }},
    {"joints solved directly",
     [](const World&) {
       return steps_by(Solver<Clamping, Baumgarte, Slop, Restitution, Friction, WarmStart, DirectJoints>{});
     }},
    {"contacts solved directly",
     [](const World&) { return steps_by(Solver<Clamping, Baumgarte, Slop, FrictionCone, DirectContacts>{}); }, false,
     true},
    {"contacts solved directly, warm",
     [](const World&) {
       return steps_by(Solver<Clamping, Baumgarte, Slop, Restitution, FrictionCone, WarmStart, WarmDirectContacts>{});
     },
     false, true},
    {"dispatch", [](const World& world) { return by(solver_named("07 warm start").fitting(world, {})); }},
    {"dispatch and sleep",
     [](const World& world) { return by(solver_named("07 warm start").fitting(world, Sleep{})); }},
    {"dispatch of all together, and sleep",
     [](const World& world) { return by(OnlyWhatIsNeeded(world, SteadyJointedSolver{}, Sleep{})); }},
};

/// Of the states after every tenth of 60 steps: what comes to rest where it would have come to rest anyway is seen on its way.
std::string hash_of_motion(const NamedScene& scene, const Way& way) {
  World world;
  scene.fill(world);
  if (!way.joints && !world.joints.empty()) return "-";
  const Step step = way.begin(world);
  std::uint64_t hash = 0;
  for (int i = 1; i <= 60; ++i) {
    try {
      step(world);
    } catch (const InvalidInput&) {
      return "no longer finite";  // the step after it refuses the world
    }
    if (way.direct && world.contacts.size() > 20) return "too many contacts";
    if (i % 10 == 0) hash = hash * 1099511628211ULL + hash_of(world);
  }
  return fmt::format("{:016x}", hash);
}

Table by_ways() {
  Table table;
  for (const Way& way : wide_ways) table.columns.emplace_back(way.name);
  for (const NamedScene& scene : all_scenes_and_joints()) {
    auto& [name, hashes] = table.lines.emplace_back(scene.name, std::vector<std::string>());
    for (const Way& way : wide_ways) hashes.push_back(hash_of_motion(scene, way));
  }
  return table;
}

std::string text_of(const Table& table) {
  std::string text = fmt::format("scene | {}\n", fmt::join(table.columns, " | "));
  for (const auto& [scene, hashes] : table.lines) text += fmt::format("{} | {}\n", scene, fmt::join(hashes, " | "));
  return text;
}

}  // namespace

#ifndef PUSHBACK_FLOAT
TEST_CASE("every scene ends in the same bits in every build, under every solver", "[slow]") {
  const std::string now = text_of(by_stages()) + "\n" + text_of(by_ways()), file = "tests/hashes.txt";
  if (std::getenv("PUSHBACK_STORE_HASHES") != nullptr) std::ofstream(file) << now;
  std::ifstream stored(file);
  std::istringstream played(now);
  std::string line, was;
  while (std::getline(played, line)) {
    std::getline(stored, was);
    CHECK(line == was);
  }
  CHECK_FALSE(std::getline(stored, was));
}
#endif

TEST_CASE("two worlds stepped by two threads at once go as they do one after the other", "[slow]") {
  for (const char* name : {"07 warm start", "12 soft contacts", "all together"}) {
    const Stage& stage = stage_named(name);
    const std::string alone[2] = {hash_after(scenes[1], stage), hash_after(scenes[2], stage)};
    std::string together[2];
    std::thread first([&] { together[0] = hash_after(scenes[1], stage); });
    std::thread second([&] { together[1] = hash_after(scenes[2], stage); });
    first.join();
    second.join();
    CHECK(together[0] == alone[0]);
    CHECK(together[1] == alone[1]);
  }
}
