#include "pushback/tools/measure/hard_cases/stages.h"

#include <memory>

#include "pushback/chapters/14_joints_under_load/split_joints.h"
#include "pushback/chapters/19_accuracy_and_time/rest_depth.h"
#include "pushback/common/basics/named.h"
#include "pushback/engine/direct/warm_direct_contacts.h"
#include "pushback/engine/islands/island_solver.h"

namespace pushback {

namespace {

/// Hands on the calls of a step, one by one: a solver with a step of its own (StepSolver::whole_step) solves as others do.
class CallByCall : public ForwardingSolver {
 public:
  explicit CallByCall(AnySolver solver) : solver_(std::move(solver)) {}

 protected:
  AnySolver solver_;

 private:
  StepSolver& inner() override { return solver_; }
  const StepSolver& inner() const override { return solver_; }
};

/// Hands every contact to the solver twice, each under an id of its own. In the world there is one, with the sum.
class Doubled : public CallByCall {
 public:
  using CallByCall::CallByCall;
  void after_detection(World& world, Real h) override {
    if (plan(Real(1) / 60).substeps > 1)
      for (Contact& contact : twice_) contact.impulse = contact.last_impulse;
    world.contacts_before = twice_;
    twice_.clear();
    for (const Contact& contact : world.contacts) {
      for (const std::uint32_t copy : {0U, 1U}) {  // side by side: the list still ascends
        twice_.push_back(contact);
        twice_.back().id.feature = 2 * contact.id.feature + copy;
      }
    }
    with_each_twice(world, [&] { solver_.after_detection(world, h); });
  }
  void solve(World& world, Real h, int sweeps) override {
    with_each_twice(world, [&] { solver_.solve(world, h, sweeps); });
  }
  void after_move(World& world, Real h) override {
    with_each_twice(world, [&] { solver_.after_move(world, h); });
  }
  /// A contact stays as long as one of its copies does.
  void end_detection(World& world) override {
    if (plan(Real(1) / 60).substeps == 1)
      for (Contact& contact : twice_) contact.last_impulse = contact.impulse;
    world.contacts.swap(twice_);
    solver_.end_detection(world);
    world.contacts.swap(twice_);
    auto copy = twice_.begin();  // both lists ascend
    std::erase_if(world.contacts, [&](Contact& contact) {
      contact.impulse.setZero();
      contact.last_impulse.setZero();
      bool stays = false;
      const auto is_of = [&contact](ContactId id) {
        id.feature /= 2;
        return id == contact.id;
      };
      for (; copy != twice_.end() && is_of(copy->id); ++copy, stays = true) {
        contact.normal = copy->normal;
        contact.depth = copy->depth;
        contact.impulse += copy->impulse;
        contact.last_impulse += copy->last_impulse;
        contact.state = copy->state;
      }
      return !stays;
    });
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
  Contacts twice_;
};

Stepper steps_by(AnySolver solver) {
  const auto held = std::make_shared<AnySolver>(std::move(solver));
  Stepper stepper{[held](World& world, Real dt) { world.step(*held, dt); }};
  if (const auto* by_island = held->as<IslandSolver>())
    stepper.half_steps = [held, by_island](int body) { return by_island->step_of(body) != StepType::substeps; };
  return stepper;
}

/// Of one world, in all of its steps: some minutes.
constexpr double most_multiplications = 4e10;

Stage direct_stage() {
  Solver<SplitJoints, Clamping, Baumgarte, RestDepth, Restitution, FrictionCone, WarmStart, WarmDirectContacts> solver;
  solver.WarmDirectContacts::tolerance = 1e-7;
  solver.fallback_tolerance = 1e-6;
  solver.rounds = 1;
  solver.work = most_multiplications;
  Stage stage{
      {"19 direct contacts",
       "08 friction cone on a rest depth, all contacts of a step solved directly: from one start, within 4·10¹⁰ "
       "multiplications",
       solver,
       {}}};
  stage.most_starts = 1;
  return stage;
}

}  // namespace

Stepper Stage::begin(GivenContacts given) const {
  if (given == GivenContacts::once) return steps_by(CallByCall(solver));
  if (given == GivenContacts::twice) return steps_by(Doubled(solver));
  return steps_by(solver);
}

const std::vector<Stage>& stages() {
  static const std::vector<Stage> all = [] {
    std::vector<Stage> list;
    for (const NamedSolver& solver : all_solvers()) {
      list.push_back({solver});
      list.back().half_steps = solver.solver.as<IslandSolver>() != nullptr;
    }
    return list;
  }();
  return all;
}

const std::vector<Stage>& table_stages() {
  static const std::vector<Stage> all = [] {
    std::vector<Stage> list = stages();
    list.push_back(direct_stage());
    return list;
  }();
  return all;
}

const Stage& stage_named(std::string_view name) {
  return named("stage", table_stages(), std::string(name));
}

}  // namespace pushback
