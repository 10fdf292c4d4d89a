/// Chapter 21's solver for eight pairs of bodies at a time.
///
///   WideSolver<float> solver;
///   world.step(solver, 1.0 / 60);
#pragma once

#include <memory>
#include <optional>

#include "pushback/common/world/solver_from.h"
#include "pushback/engine/direct/direct_tree_joints.h"
#include "pushback/engine/substeps/contact_bundles.h"
#include "pushback/engine/substeps/substepping.h"

namespace pushback {

/// The fastest passes for this processor. If `lanes` is 1, 4 or 8, the passes use that number, with the same bits.
template <class Scalar>
Passes<Scalar> passes_of_this_processor(int lanes = 0);

/// Rows and impulses have the type Scalar, positions have the type Real. Defined for float and double.
///
/// If a contact normal turns with a face, or points from one round body to another, then n, both arms and C follow the bodies:
/// see NormalSource. Rows are rebuilt once a pair has moved far enough. For islands that touch nothing immovable they are
/// rebuilt in every substep, so that angular momentum is kept.
template <class Scalar, class JointEffect>
class WideSubsteps : public Substepping {
 public:
  JointEffect joints;
  Real rebuild_fraction = Real(1e-4);  ///< rows are rebuilt once a pair has moved by this fraction of its longest arm
  Passes<Scalar> passes = passes_of_this_processor<Scalar>();
  Passes<Real> body_passes = passes_of_this_processor<Real>();  ///< its `turn` rotates the bodies
  /// Divides the pairs into sets, which are solved one after the other.
  PairSets (*make_sets)(const std::vector<TouchingPair>& pairs, const World& world) = colour_pairs;
  /// The threads that share the bundles of a set and other independent work. Null: one thread.
  std::shared_ptr<Workers> workers;

  WideSubsteps() {
    reference_step = Real(1) / 60;
    recheck_speed = Real(0.5);
  }
  Plan plan(Real dt) const {
    Plan plan = Substepping::plan(dt);
    plan.moves_bodies = true;  // it refreshes I^-1 itself, before rows are rebuilt
    plan.workers = workers ? workers.get() : &alone();
    return plan;
  }
  void check(World& world, Real h) {
    check_settings(world, h);
    require_not_negative("rebuild_fraction", rebuild_fraction);
    StepContext step = joints_step(world, h);
    joints.check(step);
  }
  void after_detection(World& world, Real h);
  void solve(World& world, Real h, int sweeps);
  void integrate_positions(World& world, Real h);
  void after_move(World& world, Real h);
  void end_detection(World& world);
  SolveStats stats() const { return measured_.value_or(measure()); }

 protected:
  /// Writes the impulses since detection, the depth and the state of the i-th contact.
  void write_back(Contact& contact, std::size_t i) const;

 private:
  BundleRange<Scalar> bundles(std::size_t begin, std::size_t end);
  template <class Act>
  void each_body(const Act& act);
  template <class Act>
  Scalar each_bundle(const Act& act);
  template <class Act>
  Scalar set_by_set(const Act& act);
  template <class Act>
  Scalar largest_in(std::size_t begin, std::size_t end, const Act& act);
  void sweep(StepContext& step, void (*friction_pass)(const BundleRange<Scalar>&));
  void rebuild_rows();
  void forget_impacts();
  SolveStats measure() const;

  Workers* at_work_ = &alone();  // of this step
  ContactBundles<Scalar> packed_;
  std::vector<Twist<Scalar>> velocities_, velocities_before_, displacements_, impulse_velocities_;  // of packed_.bodies
  std::vector<Inertia<Scalar>> inertias_;             // for packed_.bodies
  std::vector<EightVectors<Scalar>> start_impulses_;  // for packed_.contacts
  std::vector<Scalar> largest_;                       // the value that each part of a pass returns
  std::optional<SolveStats> measured_;                // the state before the impulses of an impact were discarded
  bool bouncy_ = false;                               // whether any contact has a restitution above 0
  bool something_floats_ = false;                     // whether any body with contacts floats
  Real shortest_reach_ = 0;                           // m, of the movable bodies
  std::vector<Vec3> guesses_;                         // N s, for each contact of the world
};

template <class Scalar, class JointEffect = DirectTreeJoints>
using WideSolver = SolverFrom<WideSubsteps<Scalar, JointEffect>>;

extern template class WideSubsteps<float, DirectTreeJoints>;  // compiled once, in wide_solver.cpp
extern template class WideSubsteps<double, DirectTreeJoints>;
extern template class WideSubsteps<float, SteadyJoints>;
extern template class WideSubsteps<double, SteadyJoints>;

}  // namespace pushback
