#include "tests/hard_cases/stages.h"

#include "pushback/chapters/00_naive_impulses/naive.h"
#include "pushback/chapters/05_restitution/in_turn.h"
#include "pushback/chapters/11_position_correction/nonlinear_gauss_seidel.h"
#include "pushback/chapters/11_position_correction/split_impulse.h"
#include "pushback/chapters/13_global_solve/global_joints.h"
#include "pushback/chapters/15_only_what_is_needed/dispatch.h"
#include "pushback/common/basics/named.h"
#include "tests/support/with_joints.h"

namespace pushback {

namespace {

constexpr int default_sweeps = 10;

/// Hands every contact to the solver twice, each under an id of its own. In the world there is one, with the sum.
template <class ContactSolver>
class Doubled : public StepSolver {
 public:
  void check(World& world, Real dt) { solver_.check(world, dt); }
  void solve(World& world, Real dt, int sweeps) {
    world.contacts_before = twice_;
    twice_.clear();
    for (const Contact& contact : world.contacts) {
      for (const std::uint32_t copy : {0U, 1U}) {  // side by side: the list still ascends
        twice_.push_back(contact);
        twice_.back().id.feature = 2 * contact.id.feature + copy;
      }
    }
    with_each_twice(world, [&] { solver_.solve(world, dt, sweeps); });
  }
  void after_move(World& world, Real dt) {
    with_each_twice(world, [&] { solver_.after_move(world, dt); });
  }

 private:
  template <class Work>
  void with_each_twice(World& world, const Work& work) {
    world.contacts.swap(twice_);
    work();
    world.contacts.swap(twice_);
    for (std::size_t i = 0; i < world.contacts.size(); ++i) {
      world.contacts[i].impulse = twice_[2 * i].impulse + twice_[2 * i + 1].impulse;
      world.contacts[i].state = twice_[2 * i].state;
    }
  }
  ContactSolver solver_;
  Contacts twice_;
};

template <class ContactSolver>
Stepper steps_of(int count, int sweeps) {
  return [count, sweeps, solver = ContactSolver{}](World& world, Real dt) mutable {
    small_steps(world, solver, dt, count, sweeps);
  };
}

template <class ContactSolver>
Stepper needed_steps_of(int count, int sweeps) {
  return [count, sweeps, solver = std::optional<OnlyWhatIsNeeded>{}](World& world, Real dt) mutable {
    if (!solver) solver.emplace(world, ContactSolver{});
    for (int i = 0; i < count; ++i) solver->step(world, dt / static_cast<Real>(count), sweeps);
  };
}

template <class ContactSolver>
Stage stage_of(const char* name, const char* what, int count, int sweeps) {
  return {name,
          what,
          [=] { return steps_of<ContactSolver>(count, sweeps); },
          [=] { return steps_of<Doubled<ContactSolver>>(count, sweeps); },
          count,
          [=] { return needed_steps_of<ContactSolver>(count, sweeps); },
          [=] { return needed_steps_of<Doubled<ContactSolver>>(count, sweeps); }};
}

template <class ContactSolver>
Stage sweeping(const char* name, const char* what) {
  return stage_of<ContactSolver>(name, what, 1, default_sweeps);
}

template <class ContactSolver>
Stage stepping(const char* name, const char* what, int count) {
  return stage_of<ContactSolver>(name, what, count, 1);
}

}  // namespace

// Before warm starting, joints have none either; from there on they keep their push apart. Scenes without joints move in
// the same bits as without the effect.
const std::vector<Stage>& stages() {
  static const std::vector<Stage> all{
      sweeping<NaiveAveraged>("00 naive", "one impulse a pair, no sums"),
      sweeping<WithJoints<Joints, Solver<>>>("01 velocity", "J V = 0 for contacts and joints, 10 sweeps"),
      sweeping<WithJoints<Joints, Solver<Clamping>>>("02 clamping", "+ the sum never pulls"),
      sweeping<WithJoints<Joints, Solver<Clamping, Baumgarte>>>("03 Baumgarte", "+ overlap fed back"),
      sweeping<WithJoints<Joints, Solver<Clamping, Baumgarte, Slop>>>("04 slop", "+ 5 mm left alone"),
      sweeping<WithJoints<Joints, Solver<Clamping, Baumgarte, Slop, Restitution>>>("05 restitution", "+ bounce"),
      sweeping<WithJoints<Joints, Solver<Clamping, Baumgarte, Slop, Restitution, Friction>>>("06 friction",
                                                                                             "+ friction"),
      sweeping<JointedSolver>("07 warm start", "+ last step's impulses: the full solver; joints keep their push apart"),
      sweeping<WithJoints<SplitJoints, Solver<Clamping, Baumgarte, Slop, RestitutionFromSurface, Friction, WarmStart>>>(
          "05 from surface", "the full solver, bounces reckoned from the surface"),
      sweeping<WithJoints<SplitJoints, Solver<Clamping, Baumgarte, Slop, Restitution, FrictionCone, WarmStart>>>(
          "08 friction cone", "the full solver with a cone of friction"),
      sweeping<
          WithJoints<SplitJoints, CorrectingSolver<Clamping, SplitImpulse, Slop, Restitution, Friction, WarmStart>>>(
          "11 split impulse", "the full solver, overlap corrected by pseudo-velocities in the place of Baumgarte"),
      sweeping<WithJoints<SplitJoints,
                          CorrectingSolver<Clamping, NonlinearGaussSeidel, Slop, Restitution, Friction, WarmStart>>>(
          "11 non-linear Gauss-Seidel", "the full solver, positions corrected contact by contact, not by Baumgarte"),
      stepping<JointedSolver>("12 small steps", "the full solver, 32 small steps of one sweep", 32),
      stepping<WithJoints<SplitJoints, Solver<Clamping, Baumgarte, Slop, ImpactsInTurn, Friction, ScaledWarmStart>>>(
          "05 in turn", "12 small steps with impacts in turn and a scaled guess", 32),
      stepping<WithJoints<SplitJoints, SoftSolver>>(
          "12 soft contacts", "soft contacts and a relaxing pass, 32 small steps of one sweep", 32),
      stepping<WithJoints<SteadyJoints, SoftSolver>>(
          "12 joints 20 times", "12 soft contacts with 20 passes over the joints in each sweep", 32),
      stepping<RelaxingSolver<Clamping, SoftContacts, Restitution, Friction, WarmStart, GlobalJoints>>(
          "13 direct joint solve", "12 soft contacts with all joints solved at once in each sweep, without a guess",
          32),
      stepping<SteadyJointedSolver>(
          "all together",
          "soft contacts, a cone, impacts at once, a scaled guess; 32 small steps of one sweep, 20 over joints", 32),
  };
  return all;
}

Stage only_what_is_needed(Stage stage) {
  stage.begin = stage.begin_only_needed;
  stage.begin_doubled = stage.begin_doubled_only_needed;
  return stage;
}

const Stage& stage_named(const std::string& name) {
  return named("stage", stages(), name);
}

}  // namespace pushback
