/// A solver with one more hook: the last of a step.
#pragma once

#include "pushback/chapters/01_velocity_constraint/solver.h"

namespace pushback {

/// A step as effects of a CorrectingSolver see it.
struct CorrectingContext : StepContext {};

/// Declares the hook of a CorrectingSolver. The effects that derive from it define it.
struct Corrects : RequiredHook {
  /// The bodies have moved, and all velocities are what the step ends with. Only positions and orientations may be changed.
  void correct(CorrectingContext&) {}
};

/// An effect that has the hook, or derives from Corrects, does both.
template <class E>
concept SpellsCorrect =
    (std::derived_from<E, Corrects> && !std::same_as<decltype(&E::correct), decltype(&Corrects::correct)>) ||
    (!std::derived_from<E, Corrects> && !requires { &E::correct; });

/// Calls `correct` of the effects that have it, once the bodies have moved.
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
