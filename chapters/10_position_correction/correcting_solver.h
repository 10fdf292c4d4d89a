/// A solver with one more hook: the last of a step.
#pragma once

#include "pushback/chapters/01_velocity_constraint/solver.h"

namespace pushback {

/// What an effect asks for in `build` that needs a CorrectingSolver.
struct CorrectingStep : Step {};

/// Once the bodies have moved, and all velocities are what the step ends with, it calls  void correct(CorrectingStep&)  of the
/// effects that have it. There places may be changed, and nothing else.
template <class... Effects>
class CorrectingSolver : public Solver<Effects...> {
 public:
  void solve(World& world, Real dt, int sweeps) {
    CorrectingStep step = step_of(world, dt);
    Solver<Effects...>::solve(step, sweeps);
  }
  void after_move(World& world, Real dt) {
    CorrectingStep step = step_of(world, dt);
    [[maybe_unused]] const auto correct = [&step]<class E>(E& effect) {
      if constexpr (requires { effect.correct(step); }) effect.correct(step);
    };
    (correct(static_cast<Effects&>(*this)), ...);
  }

 private:
  CorrectingStep step_of(World& world, Real dt) { return {{world, world.contacts, this->rows_, dt}}; }
};

}  // namespace pushback
