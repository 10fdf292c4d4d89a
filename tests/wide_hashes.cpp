/// The net under a change that is to keep all bits: every scene of the chapters, and every joint, under the solvers that
/// reference_hashes does not know. The hashes of their motions stand in wide_hashes.txt; PUSHBACK_STORE_HASHES=1 writes it.
#include <fmt/format.h>

#include <map>

#include "pushback/chapters/10_position_correction/nonlinear_gauss_seidel.h"
#include "pushback/chapters/10_position_correction/split_impulse.h"
#include "pushback/chapters/14_joints_under_load/steady_joints.h"
#include "pushback/chapters/17_direct_contacts/direct_contacts.h"
#include "pushback/chapters/17_direct_contacts/warm_direct_contacts.h"
#include "pushback/chapters/18_direct_joints/direct_joints.h"
#include "pushback/common/basics/input.h"
#include "pushback/common/world/measure.h"
#include "pushback/tools/catalogue/solvers.h"
#include "tests/support/catch.h"
#include "tests/support/stored_hashes.h"
#include "tests/support/substeps.h"
#include "tests/support/with_joints.h"
#include "tests/support/yardstick.h"

using namespace pushback;

namespace {

constexpr int steps = 60;
constexpr std::size_t few = 20;  // contacts: what solves them all directly takes no more

using Stepper = std::function<void(World&)>;

Stepper steps_by(AnySolver solver, int count = 1, int sweeps = 10) {
  return [=](World& world) mutable { substeps(world, solver, h, count, sweeps); };
}

Stepper needed(const char* name, const World& world, std::optional<Sleep> sleep) {
  return [solver = solver_named(name).fitting(world, std::move(sleep))](World& world_now) mutable {
    solver.step(world_now, h);
  };
}

struct Way {
  const char* name;
  Stepper (*begin)(const World&);
  bool joints = true;   // it holds them
  bool direct = false;  // it solves all contacts directly
};

// Friction as a cone beside what needs it, and a warm start wherever one may be: each way takes all of a step's memory along.
const Way ways[] = {
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
    {"dispatch", [](const World& world) { return needed("07 warm start", world, {}); }},
    {"dispatch and sleep", [](const World& world) { return needed("07 warm start", world, Sleep{}); }},
    {"dispatch of all together, and sleep",
     [](const World& world) -> Stepper {
       return [solver = OnlyWhatIsNeeded(world, SteadyJointedSolver{}, Sleep{})](World& now) mutable {
         solver.step(now, h, 10);
       };
     }},
};

/// Of the states after every tenth step: what comes to rest where it would have come to rest anyway is seen on its way.
std::string hash_of_motion(const NamedScene& scene, const Way& way) {
  World world;
  scene.fill(world);
  const Stepper step = way.begin(world);
  std::uint64_t hash = 0;
  for (int i = 1; i <= steps; ++i) {
    try {
      step(world);
    } catch (const InvalidInput&) {
      return "no longer finite";  // the step after it refuses the world
    }
    if (way.direct && world.contacts.size() > few) return "too many contacts";
    if (i % 10 == 0) hash = hash * 1099511628211ULL + hash_of(world);
  }
  return fmt::format("{:016x}", hash);
}

std::map<std::string, std::string> all_hashes() {
  std::map<std::string, std::string> hashes;
  for (const NamedScene& scene : all_scenes_and_joints()) {
    World world;
    scene.fill(world);
    for (const Way& way : ways) {
      if (!way.joints && !world.joints.empty()) continue;
      hashes[fmt::format("{}, {}", scene.name, way.name)] = hash_of_motion(scene, way);
    }
  }
  return hashes;
}

}  // namespace

TEST_CASE("every scene moves in the same bits under joints, sleep, corrections and direct solves", "[slow]") {
  check_stored("tests/wide_hashes.txt", all_hashes());
}
