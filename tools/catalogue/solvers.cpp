#include "pushback/tools/catalogue/solvers.h"

#include <fmt/format.h>

#include "pushback/chapters/00_naive_impulses/naive.h"
#include "pushback/chapters/07_warm_start/scaled.h"
#include "pushback/chapters/08_friction_cone/friction_cone.h"
#include "pushback/chapters/09_impacts/sequential.h"
#include "pushback/chapters/10_position_correction/nonlinear_gauss_seidel.h"
#include "pushback/chapters/10_position_correction/split_impulse.h"
#include "pushback/chapters/11_substeps/substeps.h"
#include "pushback/chapters/14_joints_under_load/jointed_solver.h"
#include "pushback/chapters/14_joints_under_load/steady_jointed_solver.h"
#include "pushback/chapters/21_detected_once/detected_once.h"
#include "pushback/common/basics/input.h"
#include "pushback/engine/direct/direct_joints.h"
#include "pushback/engine/islands/island_solver.h"
#include "pushback/engine/substeps/wide_solver.h"

namespace pushback {

namespace {

template <class ContactSolver>
NamedSolver named(const char* name, const char* what) {
  const AnySolver solver = ContactSolver{};
  return {name, what, solver, [solver](const World& world, std::optional<Sleep> sleep) {
            return OnlyWhatIsNeeded(world, solver, std::move(sleep));
          }};
}
/// With a solver for each combination of effects that a world may need, which takes long to compile. A page does not select
/// by scene, so they would only make it larger.
template <class ContactSolver>
NamedSolver dispatched(const char* name, const char* what) {
  NamedSolver solver = named<ContactSolver>(name, what);
#ifndef __EMSCRIPTEN__
  solver.fitting = [](const World& world, std::optional<Sleep> sleep) {
    return OnlyWhatIsNeeded(world, ContactSolver{}, std::move(sleep));
  };
#endif
  return solver;
}

}  // namespace

// Before warm starting, joints have none either. From there on they have split impulses. Scenes without joints move in
// the same bits as without the effect.
const std::vector<NamedSolver>& all_solvers() {
  static const std::vector<NamedSolver> all{
      named<NaiveAveraged>("00 naive", "one impulse a pair, no sums"),
      named<Solver<Joints>>("01 velocity", "J V = 0 for contacts and joints, 10 sweeps"),
      named<Solver<Joints, Clamping>>("02 clamping", "+ the sum never pulls"),
      named<Solver<Joints, Clamping, Baumgarte>>("03 Baumgarte", "+ overlap fed back"),
      named<Solver<Joints, Clamping, Baumgarte, Slop>>("04 slop", "+ a slop of 5 mm"),
      named<Solver<Joints, Clamping, Baumgarte, Slop, Restitution>>("05 restitution", "+ bounce"),
      named<Solver<Joints, Clamping, Baumgarte, Slop, Restitution, Friction>>("06 friction", "+ friction"),
      dispatched<JointedSolver>("07 warm start", "+ last step's impulses: the full solver; joints with split impulses"),
      named<Solver<SplitJoints, Clamping, Baumgarte, Slop, RestitutionFromSurface, Friction, WarmStart>>(
          "09 from surface", "the full solver, bounces computed from the surface"),
      named<Solver<SplitJoints, Clamping, Baumgarte, Slop, Restitution, FrictionCone, WarmStart>>(
          "08 friction cone", "the full solver with a friction cone"),
      named<CorrectingSolver<SplitJoints, Clamping, SplitImpulse, Slop, Restitution, Friction, WarmStart>>(
          "10 split impulse", "the full solver, positions corrected by pseudo-velocities, not by Baumgarte"),
      named<CorrectingSolver<SplitJoints, Clamping, NonlinearGaussSeidel, Slop, Restitution, Friction, WarmStart>>(
          "10 non-linear Gauss-Seidel", "the full solver, positions corrected contact by contact, not by Baumgarte"),
      named<Substeps<JointedSolver>>("11 substeps", "the full solver, 32 substeps of one sweep"),
      named<Substeps<Solver<SplitJoints, Clamping, Baumgarte, Slop, SequentialImpacts, Friction, ScaledWarmStart>>>(
          "09 sequential", "11 substeps with sequential impacts and a scaled guess"),
      named<Substeps<RelaxingSolver<SplitJoints, Clamping, SoftContacts, Restitution, Friction, WarmStart>>>(
          "12 soft contacts", "soft contacts and a relaxing pass, 32 substeps of one sweep"),
      named<Substeps<RelaxingSolver<SteadyJoints, Clamping, SoftContacts, Restitution, Friction, WarmStart>>>(
          "14 joints 20 times", "12 soft contacts with 20 passes over the joints in each sweep"),
      named<Substeps<RelaxingSolver<Clamping, SoftContacts, Restitution, Friction, WarmStart, DirectJoints>>>(
          "18 direct joint solve", "12 soft contacts with all joints solved directly in each sweep, without a guess"),
      named<DetectedOnce>("21 detected once",
                          "14 joints 20 times with a friction cone, contacts detected and rows built once in a step"),
      named<WideSolver<Real>>("22 wide",
                              "21 detected once, contacts solved eight pairs of bodies at a time, joints directly"),
      named<IslandSolver>(
          "26 by island",
          "each island by its own step: flight, half steps where contacts are few or joints form a tree, else 22 wide"),
      dispatched<Substeps<SteadyJointedSolver>>(
          "all together",
          "soft contacts, a friction cone, simultaneous impacts, a scaled guess; 32 substeps "
          "of one sweep, 20 over joints"),
  };
  return all;
}

const NamedSolver& solver_named(const std::string& name) {
  std::string names;
  for (const NamedSolver& solver : all_solvers()) {
    if (solver.name == name) return solver;
    names += (names.empty() ? "" : ", ") + solver.name;
  }
  throw InvalidInput(fmt::format("solver is '{}': one of these is needed: {}", name, names));
}

}  // namespace pushback
