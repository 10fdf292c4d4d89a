/// Sequential Impulses solves one row after the other, repeatedly, each as if it were alone.
///
/// The template arguments of a solver are its effects. Solver<> only solves J V = 0. Solver<Clamping, Baumgarte, Friction> also
/// runs these three effects.
#pragma once

#include <algorithm>
#include <concepts>
#include <type_traits>

#include "pushback/chapters/01_velocity_constraint/row.h"
#include "pushback/chapters/01_velocity_constraint/rows_solved.h"
#include "pushback/common/world/step_solver.h"

namespace pushback {

/// The argument of the hooks of effects. The first contacts.size() rows are the normals, where rows[i] belongs to contacts[i].
struct StepContext {
  World& world;
  Contacts& contacts;
  Rows& rows;
  Real dt;  ///< s

  /// Solves one row as if it were alone.
  void solve(std::size_t i) { rows[i].solve(); }
  /// J V + b of a row, m/s, which an impulse should make 0.
  Real speed_error(std::size_t i) const { return rows[i].speed() + rows[i].bias; }
};

/// The hooks of a step, in their order. An effect is a type that derives from this one and defines the hooks that it needs.
/// An effect that appends its own rows solves them in `sweep`. One that solves normals calls `step.solve`. Both add the number
/// of solved rows to rows_solved.
struct Effect {
  /// Throws InvalidInput if a number cannot be used. Called before the step changes anything.
  void check(StepContext&) {}
  /// Changes Row::separation, from which `build` computes biases.
  void adjust_separation(StepContext&) {}
  /// Sets limits and biases, and appends rows. No impulse of this step has changed a velocity yet.
  void build(StepContext&) {}
  /// Applies the initial impulses.
  void start(StepContext&) {}
  /// Called in every sweep, after the normals.
  void sweep(StepContext&) {}
  /// Called after the last sweep.
  void finish(StepContext&) {}
  /// Sets Contact::state. The impulses of contacts are final.
  void report(StepContext&) {}
};

/// Base of a type that declares one more hook, called by the solvers of a later chapter.
struct LaterHook {};
/// Base of a type that declares a hook without which its effects would do nothing. `Solver` refuses such effects.
struct RequiredHook : LaterHook {};

/// For an effect that stores numbers computed from the rows' geometry, such as Friction's step sizes or joints' axes.
struct UpdatesGeometry : LaterHook {
  /// Computes those numbers again. Called when the bodies have moved and the rows are solved once more (chapter 12).
  void update_geometry(StepContext&) {}
};
/// An effect either derives from UpdatesGeometry and defines the hook, or does neither.
template <class E>
concept SpellsUpdateGeometry =
    (std::derived_from<E, UpdatesGeometry> &&
     !std::same_as<decltype(&E::update_geometry), decltype(&UpdatesGeometry::update_geometry)>) ||
    (!std::derived_from<E, UpdatesGeometry> && !requires { &E::update_geometry; });

/// A misspelt hook would never be called, so require that at least one is defined. (A template counts.)
template <class E>
concept AnEffect = std::derived_from<E, Effect> && (std::is_base_of_v<LaterHook, E> || !requires {
                     requires std::same_as<decltype(&E::check), decltype(&Effect::check)>;
                     requires std::same_as<decltype(&E::adjust_separation), decltype(&Effect::adjust_separation)>;
                     requires std::same_as<decltype(&E::build), decltype(&Effect::build)>;
                     requires std::same_as<decltype(&E::start), decltype(&Effect::start)>;
                     requires std::same_as<decltype(&E::sweep), decltype(&Effect::sweep)>;
                     requires std::same_as<decltype(&E::finish), decltype(&Effect::finish)>;
                     requires std::same_as<decltype(&E::report), decltype(&Effect::report)>;
                   });

/// The common part of the solvers of all chapters. Later chapters derive theirs from it, with one more hook each.
template <class... Effects>
class SequentialImpulses : public StepSolver, public Effects... {
  static_assert((AnEffect<Effects> && ...), "an effect derives from Effect and defines at least one of its hooks");
  static_assert((SpellsUpdateGeometry<Effects> && ...),
                "an effect with the hook `update_geometry` derives from UpdatesGeometry and defines it");

 public:
  bool supports_joints() const override { return (std::derived_from<Effects, SupportsJoints> || ...); }
  void check(World& world, Real dt) override {
    [[maybe_unused]] StepContext step{world, world.contacts, rows_, dt};
    (Effects::check(step), ...);
  }
  SolveStats stats() const override {
    SolveStats sum;
    const auto add = [&sum](const auto& rows) {
      sum.rows += static_cast<int>(rows.size());
      for (const auto& row : rows) sum.residual = std::max(sum.residual, row.error());
    };
    add(rows_);
    if constexpr (requires { this->joint_rows(); }) add(this->joint_rows());
    return sum;
  }
  /// The rows of the latest substep.
  const Rows& rows() const { return rows_; }

 protected:
  /// `step`: a StepContext, or a type of a later chapter that derives from it.
  void solve_rows(auto& step, int sweeps) {
    rows_.clear();
    for (std::size_t i = 0; i < step.contacts.size(); ++i) {
      rows_.emplace_back(step.world, step.contacts[i], step.contacts[i].normal, i);
      rows_.back().separation = -step.contacts[i].depth;
    }
    (Effects::adjust_separation(step), ...);
    (Effects::build(step), ...);
    (Effects::start(step), ...);
    for (int i = 0; i < sweeps; ++i) sweep(step);
    (Effects::finish(step), ...);
    report(step);
  }
  void sweep(auto& step) {
    const std::size_t normals = step.contacts.size();
    for (std::size_t i = 0; i < normals; ++i) step.solve(i);
    rows_solved += normals;
    (Effects::sweep(step), ...);
  }
  void report(auto& step) {
    for (Contact& contact : step.contacts) contact.impulse.setZero();
    for (const Row& row : rows_) step.contacts[row.owner].impulse += row.impulse * row.n;
    (Effects::report(step), ...);
  }

  Rows rows_;
};

template <class... Effects>
class Solver : public SequentialImpulses<Effects...> {
  static_assert((!std::is_base_of_v<RequiredHook, Effects> && ...),
                "this effect needs a solver that calls its hook: RelaxingSolver or CorrectingSolver");

 public:
  void solve(World& world, Real dt, int sweeps) override {
    StepContext step{world, world.contacts, this->rows_, dt};
    this->solve_rows(step, sweeps);
  }
};

}  // namespace pushback
