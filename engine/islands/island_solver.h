/// Each island of a world by the step that fits it.
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
///   flight       v += h/2 g,  x += h v,  v += h/2 g: the parabola itself
///   half steps   contacts by `contact_half_step`, and joints by `joint_half_step`, with contacts or without
///   substeps     `substep_solver`, and large piles that move by `pile_solver`
///
/// A step runs through these stages, which docs/engine.md draws:
///
///   detect → classify → step each island: StepOutcome → (if bodies met others: classify again) → fall back → piles → substeps → commit
///
/// Half steps of resting islands cost next to nothing, however many contacts there are. In a tumbling island they can cost a hundred times
/// as much as substeps. So if contacts are many, half steps are paid for from savings: see work_budget.h. The number of half steps follows
/// from the energy (energy_control.h), or TwinSolver gives it. An island that half steps cannot move gets substeps, for a while.
///
/// Between steps the solver remembers for each body how it was moved, and in how many substeps. A program that composes its steps itself,
/// as chapter 20's sleep does, uses `substep_solver` only.
class IslandSolver : public ForwardingSolver, public IslandSettings {
 public:
  WideSolver<Real> substep_solver;
  Fast pile_solver;  ///< it has the workers of `substep_solver`

  /// Throws as World::step does, before anything has changed.
  void whole_step(World& world, Real dt, int sweeps) override;
  /// Call by call: `substep_solver` only.
  void solve(World& world, Real h, int sweeps) override;
  /// Rows and residual of all islands together.
  SolveStats stats() const override { return call_by_call_ ? inner().stats() : solved_; }

  // ---- of the latest step ---------------------------------------------------------------------------------------------
  /// The way in which a body was moved, or none for a body that the step did not contain.
  StepType step_of(int body) const { return classifier_.step_of(body); }
  /// The half steps of its island; 0 for a body that was moved otherwise.
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
  std::vector<IslandMemory> memory_;  // of each body that is the lowest of its island
  std::vector<double> spent_;         // on each body in this step, before it met others; multiplications
  SolveStats solved_;                 // of all islands so far
  bool call_by_call_ = false;
};

}  // namespace pushback
