#include "pushback/tools/hard_cases/stages.h"

#include "pushback/chapters/11_substeps/substeps.h"
#include "pushback/chapters/14_joints_under_load/split_joints.h"
#include "pushback/chapters/17_direct_contacts/warm_direct_contacts.h"
#include "pushback/common/basics/named.h"
#include "pushback/tools/study/seat.h"

namespace pushback {

namespace {

/// Hands every contact to the solver twice, each under an id of its own. In the world there is one, with the sum.
class Doubled : public StepSolver {
 public:
  explicit Doubled(AnySolver solver) : solver_(std::move(solver)) {}
  void check(World& world, Real dt) { solver_.check(world, dt); }
  Division division(Real dt) const { return solver_.division(dt); }
  void detected(World& world, Real dt) {
    world.contacts_before = twice_;
    twice_.clear();
    for (const Contact& contact : world.contacts) {
      for (const std::uint32_t copy : {0U, 1U}) {  // side by side: the list still ascends
        twice_.push_back(contact);
        twice_.back().id.feature = 2 * contact.id.feature + copy;
      }
    }
    with_each_twice(world, [&] { solver_.detected(world, dt); });
  }
  void solve(World& world, Real dt, int sweeps) {
    with_each_twice(world, [&] { solver_.solve(world, dt, sweeps); });
  }
  void displace(World& world, Real dt) { solver_.displace(world, dt); }
  void after_move(World& world, Real dt) {
    with_each_twice(world, [&] { solver_.after_move(world, dt); });
  }
  /// A contact stays as long as one of its copies does.
  void done(World& world) {
    world.contacts.swap(twice_);
    solver_.done(world);
    world.contacts.swap(twice_);
    auto copy = twice_.begin();  // both lists ascend
    std::erase_if(world.contacts, [&](Contact& contact) {
      contact.impulse.setZero();
      bool stays = false;
      const auto is_of = [&contact](ContactId id) {
        id.feature /= 2;
        return id == contact.id;
      };
      for (; copy != twice_.end() && is_of(copy->id); ++copy, stays = true) {
        contact.depth = copy->depth;
        contact.impulse += copy->impulse;
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
  AnySolver solver_;
  Contacts twice_;
};

Stepper steps_by(AnySolver solver, int count, int sweeps) {
  return [solver, count, sweeps](World& world, Real dt) mutable { substeps(world, solver, dt, count, sweeps); };
}

/// `choose` sees the world before its first step.
template <class Choose>
Stepper needed_steps_by(const Choose& choose, int count, int sweeps) {
  return [choose, count, sweeps, solver = std::optional<OnlyWhatIsNeeded>{}](World& world, Real dt) mutable {
    if (!solver) solver.emplace(choose(world));
    for (int i = 0; i < count; ++i) solver->step(world, dt / static_cast<Real>(count), sweeps);
  };
}

/// Of one world, in all of its steps: some minutes.
constexpr double most_multiplications = 4e10;

Stage direct_stage() {
  Solver<SplitJoints, Clamping, Baumgarte, Seat, Restitution, FrictionCone, WarmStart, WarmDirectContacts> solver;
  solver.WarmDirectContacts::tolerance = 1e-7;
  solver.too_far = 1e-6;
  solver.rounds = 1;
  solver.work = most_multiplications;
  const AnySolver any = solver;
  const auto fitting = [any](const World& world, std::optional<Sleep> sleep) {
    return OnlyWhatIsNeeded(world, any, std::move(sleep));
  };
  Stage stage{{"19 direct contacts",
               "08 friction cone on a seat, all contacts of a step solved directly: from one start, within 4·10¹⁰ "
               "multiplications",
               1, 10, any, fitting}};
  stage.most_starts = 1;
  return stage;
}

}  // namespace

int Stage::cut() const {
  return substeps / solver.division(1).substeps;
}

Stepper Stage::begin() const {
  if (!only_needed) return steps_by(solver, cut(), sweeps);
  return needed_steps_by([choose = fitting](const World& world) { return choose(world, {}); }, cut(), sweeps);
}

Stepper Stage::begin_doubled() const {
  const Doubled doubled(solver);
  if (!only_needed) return steps_by(doubled, cut(), sweeps);
  return needed_steps_by([doubled](const World& world) { return OnlyWhatIsNeeded(world, doubled); }, cut(), sweeps);
}

const std::vector<Stage>& stages() {
  static const std::vector<Stage> all = [] {
    std::vector<Stage> list;
    for (const NamedSolver& solver : all_solvers()) list.push_back({solver});
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

Stage only_what_is_needed(Stage stage) {
  stage.only_needed = true;
  return stage;
}

const Stage& stage_named(const std::string& name) {
  return named("stage", table_stages(), name);
}

}  // namespace pushback
