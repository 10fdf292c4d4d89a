/// A solver whose contacts may be soft, with one more sweep after the bodies have moved.
#pragma once

#include "pushback/chapters/01_velocity_constraint/solver.h"

namespace pushback {

/// The argument of the hooks of a RelaxingSolver's effects. A normal with softness solves
///
///   J V + b + gamma lambda = 0,   and its effective mass is 1 / (K + gamma)
struct RelaxingContext : StepContext {
  std::vector<Real>& softness;  ///< gamma of the first rows, 1/kg; 0 at the beginning of the step

  Real speed_error(std::size_t i) const { return StepContext::speed_error(i) + yields(i); }
  void solve(std::size_t i) {
    Row& row = rows[i];
    row.reach(row.impulse - row.effective_mass * (row.speed() + (row.bias + yields(i))));
  }

 private:
  Real yields(std::size_t i) const { return i < softness.size() ? softness[i] * rows[i].impulse : 0; }
};

/// Declares the hook of a RelaxingSolver. An effect that derives from this type defines the hook.
struct Relaxes : RequiredHook {
  /// Called once the bodies have moved. Removes the push-out from the target velocities.
  void relax(RelaxingContext&) {}
};
/// An effect either derives from Relaxes and defines the hook, or does neither.
template <class E>
concept SpellsRelax =
    (std::derived_from<E, Relaxes> && !std::same_as<decltype(&E::relax), decltype(&Relaxes::relax)>) ||
    (!std::derived_from<E, Relaxes> && !requires { &E::relax; });

/// Calls `relax` and then `update_geometry` of the effects that have them, once the bodies have moved. Then it sweeps once
/// more, and reports again.
template <class... Effects>
class RelaxingSolver : public SequentialImpulses<Effects...> {
  static_assert((SpellsRelax<Effects> && ...), "an effect with the hook `relax` derives from Relaxes and defines it");

 public:
  void solve(World& world, Real dt, int sweeps) override {
    softness_.assign(world.contacts.size(), 0);
    RelaxingContext step = step_of(world, dt);
    this->solve_rows(step, sweeps);
  }
  void after_move(World& world, Real dt) override {
    RelaxingContext step = step_of(world, dt);
    [[maybe_unused]] const auto relax = [&step]<class E>(E& effect) {
      if constexpr (std::derived_from<E, Relaxes>) effect.relax(step);
    };
    [[maybe_unused]] const auto update_geometry = [&step]<class E>(E& effect) {
      if constexpr (std::derived_from<E, UpdatesGeometry>) effect.update_geometry(step);
    };
    (relax(static_cast<Effects&>(*this)), ...);
    (update_geometry(static_cast<Effects&>(*this)), ...);
    this->sweep(step);
    this->report(step);
  }

 private:
  RelaxingContext step_of(World& world, Real dt) { return {{world, world.contacts, this->rows_, dt}, softness_}; }

  std::vector<Real> softness_;  // of the normals
};

}  // namespace pushback
