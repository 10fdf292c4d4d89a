/// A solver with one more hook, which runs at the end of a step and corrects positions.
#pragma once

#include "pushback/chapters/01_velocity_constraint/solver.h"

namespace pushback {

/// The argument of the hooks of a CorrectingSolver's effects.
struct CorrectingContext : StepContext {};

/// Declares the hook of a CorrectingSolver. An effect that derives from this type defines the hook.
struct Corrects : RequiredHook {
  /// Called once the bodies have moved and all velocities are final. May change only positions and orientations.
  void correct(CorrectingContext&) {}
};

/// An effect either derives from Corrects and defines the hook, or does neither.
template <class E>
concept SpellsCorrect =
    (std::derived_from<E, Corrects> && !std::same_as<decltype(&E::correct), decltype(&Corrects::correct)>) ||
    (!std::derived_from<E, Corrects> && !requires { &E::correct; });

/// Calls `correct` of the effects that define it, once the bodies have moved.
template <class... Effects>
class CorrectingSolver : public SequentialImpulses<Effects...> {
  static_assert((SpellsCorrect<Effects> && ...),
                "an effect with the hook `correct` derives from Corrects and defines it");

 public:
  void solve(World& world, Real dt, int sweeps) override {
    CorrectingContext step = step_of(world, dt);
    this->solve_rows(step, sweeps);
  }
  void after_move(World& world, Real dt) override {
    CorrectingContext step = step_of(world, dt);
    [[maybe_unused]] const auto correct = [&step]<class E>(E& effect) {
      if constexpr (std::derived_from<E, Corrects>) effect.correct(step);
    };
    (correct(static_cast<Effects&>(*this)), ...);
  }

 private:
  CorrectingContext step_of(World& world, Real dt) { return {{world, world.contacts, this->rows_, dt}}; }
};

}  // namespace pushback
