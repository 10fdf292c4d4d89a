/// A solver whose contacts may give way, and with one more sweep: once the bodies have moved.
#pragma once

#include "pushback/chapters/01_velocity_constraint/solver.h"

namespace pushback {

/// What an effect asks for in `build` that needs a RelaxingSolver. A normal that has softness wants
///
///   J V + b + gamma lambda = 0,   and its effective mass is 1 / (K + gamma)
struct RelaxingStep : Step {
  std::vector<Real>& softness;  ///< gamma of the first rows, 1/kg: 0 where the step begins

  Real speed_error(std::size_t i) const { return Step::speed_error(i) + yields(i); }
  void solve(std::size_t i) {
    Row& row = rows[i];
    row.reach(row.impulse - row.effective_mass * (row.speed() + (row.bias + yields(i))));
  }

 private:
  Real yields(std::size_t i) const { return i < softness.size() ? softness[i] * rows[i].impulse : 0; }
};

template <class E>
concept RelaxingEffect = requires(E& effect, RelaxingStep& step) { effect.relax(step); };

/// After the bodies have moved it calls, of the effects that have them,
///
///   void relax(RelaxingStep&)   the rows are to ask for something else: for no push-out any more
///   void moved(Step&)           the rows' geometry has changed: recompute anything derived from it
///
/// and then sweeps once more, and reports again.
template <class... Effects>
class RelaxingSolver : public Solver<Effects...> {
 public:
  void solve(World& world, Real dt, int sweeps) {
    softness_.assign(world.contacts.size(), 0);
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
  RelaxingStep step_of(World& world, Real dt) { return {{world, world.contacts, this->rows_, dt}, softness_}; }

  std::vector<Real> softness_;  // of the normals
};

}  // namespace pushback
