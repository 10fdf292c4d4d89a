/// Solves each island of a world by the kind of step that suits it.
#pragma once

#include "pushback/common/world/forwarding_solver.h"
#include "pushback/engine/islands/energy_control.h"
#include "pushback/engine/islands/island_worlds.h"
#include "pushback/engine/islands/remaining_bodies.h"
#include "pushback/engine/islands/step_contacts.h"
#include "pushback/engine/islands/work_budgets.h"
#include "pushback/engine/substeps/fast.h"

namespace pushback {

/// Islands are solved independently, each by the cheapest step that is accurate enough. StepClassifier chooses:
///
///   flight       v += h/2 g,  x += h v,  v += h/2 g, which is exactly the parabola
///   half steps   `joint_half_step` if the island has joints, with or without contacts, otherwise `contact_half_step`
///   substeps     `pile_solver` for large piles that move, otherwise `substep_solver`
///
/// A step runs through these stages, which docs/engine.md draws:
///
///   detect → classify → step each island: StepOutcome → (if bodies met others: classify again) → fall back → piles → substeps → commit
///
/// Half steps of resting islands cost next to nothing, whatever the number of contacts. In a tumbling island they can cost a hundred
/// times as much as substeps. So if an island has many contacts, a work budget limits its half steps, see work_budget.h. The number of
/// half steps follows from the energy error (energy_control.h), or TwinSolver gives it. An island that half steps cannot move gets
/// substeps for a while.
///
/// Between steps the solver stores for each body how it was moved, and in how many substeps. A program that composes its own steps, such
/// as chapter 20's sleep, uses only `substep_solver`.
class IslandSolver : public ForwardingSolver, public IslandSettings {
 public:
  WideSolver<Real> substep_solver;
  Fast pile_solver;  ///< shares the workers of `substep_solver`

  /// Throws as World::step does, before anything has changed.
  void whole_step(World& world, Real dt, int sweeps) override;
  /// For programs that compose their own steps. Uses only `substep_solver`.
  void solve(World& world, Real h, int sweeps) override;
  /// Rows and residual of all islands together.
  SolveStats stats() const override { return call_by_call_ ? inner().stats() : solved_; }

  // ---- of the latest step ---------------------------------------------------------------------------------------------
  /// How a body was moved, or StepType::none for a body that the step did not contain.
  StepType step_of(int body) const { return classifier_.step_of(body); }
  /// The number of half steps of the body's island, or 0 for a body that was moved in another way.
  int half_steps_of(int body);
  const StepClassifier& classifier() const { return classifier_; }
  /// The islands that half steps moved, or were tried on, and those that Fast moved.
  const IslandWorlds& islands() const { return islands_; }

 private:
  StepSolver& inner() override { return substep_solver; }
  const StepSolver& inner() const override { return substep_solver; }

  void classify(World& world, bool too_many_meetings, Real dt);
  void step_islands(World& world, const Plan& plan, Real dt);
  double most_spent(const IslandWorld& island, const World& world) const;
  void step_island(IslandWorld& island, const IslandStep& step);
  bool others_were_met(const World& world, Real dt);
  void fall_back(const World& world);
  void step_piles(const World& world, Real dt, int sweeps);
  SolveStats step_remaining(World& world, Real dt, int sweeps);
  void commit(World& world, Real dt);
  void add_up(const SolveStats& solved);

  StepContacts contacts_;
  StepClassifier classifier_;
  WorkBudgets budgets_;
  IslandWorlds islands_;
  RemainingBodies remaining_;
  std::vector<IslandMemory> memory_;  // by the lowest body of each island
  std::vector<double> spent_;         // multiplications for each body in this step before it met others
  SolveStats solved_;                 // of all islands so far
  bool call_by_call_ = false;
};

}  // namespace pushback
