/// The effects of chapters 01 to 08 as a list that is chosen while the program runs.
#pragma once

#include <array>
#include <vector>

#include "pushback/chapters/01_velocity_constraint/any_effect.h"
#include "pushback/chapters/07_warm_start/full_solver.h"
#include "pushback/chapters/08_friction_cone/friction_cone.h"

namespace pushback {

/// Calls each hook of its effects in their order, as Solver<...> does.
struct ChosenEffects : Effect {
  std::vector<AnyEffect> effects;

  void check(StepContext& step) { each(&AnyEffect::check, step); }
  void adjust_separation(StepContext& step) { each(&AnyEffect::adjust_separation, step); }
  void build(StepContext& step) { each(&AnyEffect::build, step); }
  void start(StepContext& step) { each(&AnyEffect::start, step); }
  void sweep(StepContext& step) { each(&AnyEffect::sweep, step); }
  void finish(StepContext& step) { each(&AnyEffect::finish, step); }
  void report(StepContext& step) { each(&AnyEffect::report, step); }

 private:
  void each(void (AnyEffect::*hook)(StepContext&), StepContext& step) {
    for (AnyEffect& effect : effects) (effect.*hook)(step);
  }
};

/// The switches of the sandbox, in the order of the chapters that add them.
enum Switch { velocity_constraint, clamping, baumgarte, slop, restitution, friction, warm_start, cone, switch_count };
using Switches = std::array<bool, switch_count>;

/// All effects that are switched on, in the order of chapter 08's solver.
inline std::vector<AnyEffect> effects_of(const Switches& on) {
  std::vector<AnyEffect> effects;
  if (on[clamping]) effects.emplace_back(Clamping{});
  if (on[baumgarte]) effects.emplace_back(Baumgarte{});
  if (on[slop]) effects.emplace_back(Slop{});
  if (on[restitution]) effects.emplace_back(Restitution{});
  if (on[friction] && on[cone]) effects.emplace_back(FrictionCone{});
  else if (on[friction]) effects.emplace_back(Friction{});
  if (on[warm_start]) effects.emplace_back(WarmStart{});
  return effects;
}

}  // namespace pushback
