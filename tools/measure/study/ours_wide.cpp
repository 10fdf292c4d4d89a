/// The program `motion_wide`: the solvers that divide each step themselves play the motions.
#include "pushback/chapters/21_detected_once/detected_once.h"
#include "pushback/engine/half_step/half_step.h"
#include "pushback/engine/presets.h"
#include "pushback/engine/substeps/wide_solver.h"
#include "pushback/tools/measure/results/built_by.h"
#include "pushback/tools/measure/study/every_motion.h"
#include "pushback/tools/measure/study/ours.h"

using namespace pushback;

namespace {

/// A solver that is to divide each 1/60 s by itself, for so many substeps.
using Divided = std::function<AnySolver(int substeps)>;

template <class ContactSolver>
Divided divided(ContactSolver solver) {
  return [solver](int substeps) mutable {
    solver.threshold = 0;  // bounces are compared at every speed
    solver.substeps = substeps;
    return AnySolver(solver);
  };
}
IslandSolver islands() {
  IslandSolver solver;
  solver.substep_solver.threshold = solver.contact_half_step.threshold = 0;
  return solver;
}
AnySolver by_island(int substeps) {
  IslandSolver solver = islands();
  solver.contact_half_step.substeps = substeps;
  return solver;
}
/// As a user has it: with an error, and nothing else set.
AnySolver within(int substeps) {
  Recommended solver;
  solver.error = Real(1e-3) / static_cast<Real>(substeps);
  return solver;
}
/// Springs that are as stiff as the substeps allow, beyond 240 Hz.
WideSolver<double> stiff() {
  WideSolver<double> solver;
  solver.spring.hertz = Real(1e6);
  return solver;
}

bool without_pins(const Motion& motion) {
  return motion.pins.empty();
}
bool without_contacts(const Motion& motion) {
  return !has_contacts(motion);
}

/// `joints`: whether it sweeps over them. `half_steps`: it has no sweeps at all.
Method method(const std::string& name, const std::string& title, const Divided& solver, bool joints = false,
              bool (*plays)(const Motion&) = plays_all, bool half_steps = false) {
  return {.name = name,
          .title = title,
          .plays = plays,
          .begin = [=](const World& world, const Setting& setting) -> std::unique_ptr<Player> {
            return std::make_unique<Ours>(world, solver(setting.substeps), setting.sweeps,
                                          !half_steps && (world.joints.empty() || joints));
          },
          .sweeps = !half_steps,
          .divides = true};
}
Method half_steps(const std::string& name, const std::string& title, const HalfStep& solver,
                  bool (*plays)(const Motion&) = plays_all) {
  return method(name, title, divided(solver), false, plays, true);
}

}  // namespace

int main(int argc, char** argv) {
  const std::vector<Method> methods{
      method("once", "detected once", divided(DetectedOnce{}), true),
      method("wide", "detected once, wide", divided(WideSolver<double>{})),
      method("wide-float", "detected once, wide, rows in float", divided(WideSolver<float>{})),
      method("wide-stiff", "detected once, wide, springs without a limit", divided(stiff()), false, without_pins),
      method("by-island", "each island by what it calls for", by_island),
      method("within", "within 1 mm, divided by these substeps", within),
      half_steps("half-step", "kick, drift, kick", HalfStep{}),
      half_steps("order-4", "five of these, of fourth order", composed(), without_contacts),
      half_steps("impact", "kick, drift, kick, cut at impacts", at_impacts())};
  return play_program(argc, argv, "Plays a motion by the solvers that divide each 1/60 s themselves.",
                      fmt::format("Pushback, steps divided by the solver; {}", built_by()), methods);
}
