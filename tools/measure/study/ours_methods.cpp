/// The program `motion_methods`: methods of the literature that are no chapter play the motions. docs/methods.md says what came of it.
#include "pushback/tools/measure/results/built_by.h"
#include "pushback/tools/measure/study/every_motion.h"
#include "pushback/tools/measure/study/ours.h"
#include "pushback/tools/methods/methods.h"

using namespace pushback;

namespace {

template <class ContactSolver>
Method method(const std::string& name, const std::string& title) {
  constexpr bool bounces = requires(ContactSolver solver) { solver.threshold; };
  ContactSolver solver;
  if constexpr (bounces) solver.threshold = 0;                        // bounces are compared at every speed
  if constexpr (requires { solver.slop; }) solver.slop = Real(1e-4);  // as `slim` has it
  return {.name = name,
          .title = title,
          .plays =
              [holds = solver.supports_joints()](const Motion& motion) {
                return (motion.pins.empty() || holds) && (bounces || !has_bounces(motion));
              },
          .begin = by_ours(solver, !std::same_as<ContactSolver, Avbd> && !std::derived_from<ContactSolver, Sap>),
          .sweeps = !std::derived_from<ContactSolver, Sap>};
}

}  // namespace

int main(int argc, char** argv) {
  const std::vector<Method> methods{method<Xpbd>("xpbd", "positions corrected, velocities from them"),
                                    method<Avbd>("avbd", "a block of 6 x 6 for each body"),
                                    method<ConjugateSolver>("nncg", "conjugate gradients over sweeps"),
                                    method<Sap>("sap", "a convex function of all velocities, by Newton's method"),
                                    method<SapLagged>("sap-lagged", "the same with friction bounded a step late")};
  return play_program(argc, argv, "Plays a motion by methods of the literature that are no chapter.",
                      fmt::format("Pushback, other methods; {}", built_by()), methods);
}
