/// A solver with one more sweep: once the bodies have moved.
#pragma once

#include "pushback/chapters/01_velocity_constraint/solver.h"

namespace pushback {

/// What an effect asks for in `build` that needs a RelaxingSolver.
struct RelaxingStep : Step {};

template <class E>
concept RelaxingEffect = requires(E& effect, RelaxingStep& step) { effect.relax(step); };

/// After the bodies have moved it calls, of the effects that have them,
///
///   void relax(RelaxingStep&)   the rows are to ask for something else: for no push-out any more
///   void moved(Step&)           the rows have been placed anew, and what was made of them is to be made again
///
/// and then sweeps once more, and reports again.
template <class... Effects>
class RelaxingSolver : public Solver<Effects...> {
 public:
  void solve(World& world, Real dt, int sweeps) {
    RelaxingStep step = step_of(world, dt);
    Solver<Effects...>::solve(step, sweeps);
  }
  void after_move(World& world, Real dt) {
    RelaxingStep step = step_of(world, dt);
    [[maybe_unused]] const auto relax = [&step]<class E>(E& effect) {
      if constexpr (RelaxingEffect<E>) effect.relax(step);
    };
    [[maybe_unused]] const auto moved = [&step]<class E>(E& effect) {
      if constexpr (requires { effect.moved(step); }) effect.moved(step);
    };
    (relax(static_cast<Effects&>(*this)), ...);
    (moved(static_cast<Effects&>(*this)), ...);
    this->sweep(step);
    this->report(step);
  }

 private:
  RelaxingStep step_of(World& world, Real dt) { return {{world, world.contacts, this->rows_, dt}}; }
};

}  // namespace pushback
