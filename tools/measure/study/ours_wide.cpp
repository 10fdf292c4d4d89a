/// The program `motion_wide`: the solvers that divide each step themselves play the motions.
#include "pushback/chapters/21_detected_once/detected_once.h"
#include "pushback/engine/half_step/at_impacts.h"
#include "pushback/engine/half_step/composition.h"
#include "pushback/engine/islands/within_error.h"
#include "pushback/engine/substeps/wide.h"
#include "pushback/tools/measure/study/every_motion.h"
#include "pushback/tools/measure/study/ours.h"

using namespace pushback;

namespace {

/// Springs that are as hard as the substeps allow, beyond 240 Hz.
struct WideAndStiff : Wide<double> {
  WideAndStiff() { spring.hertz = Real(1e6); }
};

template <class ContactSolver>
constexpr bool is_half_step = std::derived_from<ContactSolver, HalfStep>;

/// For so many substeps.
template <class ContactSolver>
ContactSolver divided(int substeps) {
  ContactSolver solver;
  if constexpr (std::derived_from<ContactSolver, ByIsland>) solver.many.threshold = solver.few.threshold = 0;
  else solver.threshold = 0;  // bounces are compared at every speed
  if constexpr (std::same_as<ContactSolver, WithinError>) solver.error = Real(1e-3) / static_cast<Real>(substeps);
  else if constexpr (std::same_as<ContactSolver, ByIsland>) solver.few.substeps = substeps;
  else solver.substeps = substeps;
  return solver;
}

template <class ContactSolver>
Method method(const std::string& name, const std::string& title) {
  return {.name = name,
          .title = title,
          .plays =
              [](const Motion& motion) {
                if constexpr (std::derived_from<ContactSolver, Composed<Suzuki>>) return !has_contacts(motion);
                return !std::same_as<ContactSolver, WideAndStiff> || motion.pins.empty();
              },
          .begin = [](const Motion& motion, const Setting& setting) -> std::unique_ptr<Player> {
            const bool sweeps_joints = motion.pins.empty() || std::is_same_v<ContactSolver, DetectedOnce>;
            return std::make_unique<Ours>(
                motion, setting, divided<ContactSolver>(setting.substeps),
                Stepping{.divides = true, .counts_rows = !is_half_step<ContactSolver> && sweeps_joints});
          },
          .sweeps = !is_half_step<ContactSolver>};
}

}  // namespace

int main(int argc, char** argv) {
  const std::vector<Method> methods{method<DetectedOnce>("once", "detected once"),
                                    method<Wide<double>>("wide", "detected once, wide"),
                                    method<Wide<float>>("wide-float", "detected once, wide, rows in float"),
                                    method<WideAndStiff>("wide-stiff", "detected once, wide, springs without a limit"),
                                    method<ByIsland>("by-island", "each island by what it calls for"),
                                    method<WithinError>("within", "within 1 mm, divided by these substeps"),
                                    method<HalfStep>("half-step", "kick, drift, kick"),
                                    method<Composed<Suzuki>>("order-4", "five of these, of fourth order"),
                                    method<AtImpacts>("impact", "kick, drift, kick, cut at impacts")};
  return play_program(argc, argv, "Plays a motion by the solvers that divide each 1/60 s themselves.",
                      fmt::format("Pushback, steps divided by the solver; {}", built_by()), methods);
}
