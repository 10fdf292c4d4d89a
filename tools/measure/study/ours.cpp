/// The program `motion`: our own solvers play motions. Built twice, with Real = double and with Real = float.
#include "pushback/tools/measure/study/ours.h"
#include "pushback/chapters/09_impacts/simultaneous.h"
#include "pushback/chapters/10_position_correction/nonlinear_gauss_seidel.h"
#include "pushback/chapters/10_position_correction/split_impulse.h"
#include "pushback/chapters/14_joints_under_load/steady_jointed_solver.h"
#include "pushback/chapters/19_accuracy_and_time/rest_depth.h"
#include "pushback/engine/direct/direct_joints.h"
#include "pushback/engine/direct/warm_direct_contacts.h"
#include "pushback/tools/measure/results/built_by.h"
#include "pushback/tools/measure/study/every_motion.h"

using namespace pushback;

namespace {

using FullCold = Solver<Clamping, Baumgarte, Slop, Restitution, Friction>;
using Slim = Solver<Clamping, Baumgarte, Slop, Restitution, FrictionCone, WarmStart>;
using SlimCold = Solver<Clamping, Baumgarte, Slop, Restitution, FrictionCone>;
using NoSlop = Solver<Clamping, Baumgarte, Restitution, FrictionCone, WarmStart>;
using Split = CorrectingSolver<Clamping, SplitImpulse, Restitution, FrictionCone, WarmStart>;
using Nonlinear = CorrectingSolver<Clamping, NonlinearGaussSeidel, Restitution, FrictionCone, WarmStart>;
using Soft = RelaxingSolver<Clamping, SoftContacts, Restitution, FrictionCone, WarmStart>;
using SteadyCold = RelaxingSolver<Clamping, SoftContacts, SimultaneousImpacts, FrictionCone>;
using Jointed = Solver<SplitJoints, Clamping, Baumgarte, Restitution, FrictionCone, WarmStart>;
using Direct = Solver<Clamping, Baumgarte, RestDepth, Restitution, FrictionCone, WarmStart, WarmDirectContacts>;

template <class ContactSolver>
Method method(const std::string& name, const std::string& title) {
  constexpr bool solves_systems =
      std::derived_from<ContactSolver, WarmDirectContacts> || std::derived_from<ContactSolver, DirectJoints>;
  ContactSolver solver;
  if constexpr (std::is_same_v<ContactSolver, Slim> || std::is_same_v<ContactSolver, SlimCold>)
    solver.slop = Real(1e-4);
  // Bounces are compared at every speed.
  if constexpr (requires { solver.threshold; }) solver.threshold = 0;
  return {.name = name,
          .title = title,
          .plays =
              [](const Motion& motion) {
                return motion.pins.empty() == !std::derived_from<ContactSolver, SupportsJoints> &&
                       has_contacts(motion) == std::derived_from<ContactSolver, Clamping>;
              },
          .begin = by_ours(solver, !solves_systems)};
}

}  // namespace

int main(int argc, char** argv) {
  const std::vector<Method> methods{
      method<FullSolver>("full", "all seven chapters"),
      method<FullCold>("full-cold", "all seven but the warm start"),
      method<Slim>("slim", "slop of 0.1 mm, cone"),
      method<SlimCold>("slim-cold", "slop of 0.1 mm, cone, cold"),
      method<NoSlop>("no-slop", "no slop, cone"),
      method<Split>("split", "split impulse, cone"),
      method<Nonlinear>("nonlinear", "positions corrected, cone"),
      method<Soft>("soft", "soft contacts, cone"),
      method<SteadySolver>("steady", "all together"),
      method<SteadyCold>("steady-cold", "all together, cold"),
      method<Direct>("direct-contacts", "all contacts solved directly, on a rest depth"),
      method<Solver<Joints>>("joints", "joints, cold"),
      method<Solver<WarmJoints>>("warm-joints", "joints, warm"),
      method<Solver<SplitJoints>>("split-joints", "joints, split impulse"),
      method<Solver<SteadyJoints>>("steady-joints", "joints, twenty passes"),
      method<Solver<DirectJoints>>("direct-joints", "all joints solved directly"),
      method<Jointed>("jointed", "joints, split impulse, and contacts"),
  };
  const std::string version =
      fmt::format("Pushback, {}; {}", std::is_same_v<Real, float> ? "float" : "double", built_by());
  return play_program(argc, argv, "Plays a motion by our own solvers: how far from the truth, in what time.", version,
                      methods);
}
