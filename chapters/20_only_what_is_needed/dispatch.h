/// Chooses once, at run time, the solver that fits a scene.
#pragma once

#include <memory>

#include "pushback/chapters/20_only_what_is_needed/only.h"
#include "pushback/common/world/forwarding_solver.h"
#include "pushback/common/world/step.h"
#include "pushback/engine/islands/sleep.h"

namespace pushback {

/// Whether the answer to `Question` can be yes, if exactly the questions of `Yes` have been answered yes so far.
template <class Question, class Yes>
constexpr bool possible = true;
template <class Question, class Yes>
  requires requires { typename Question::only_if; }
constexpr bool possible<Question, Yes> = Yes::template has<typename Question::only_if>;

/// Calls `use(Questions<...>{})` with the questions whose answer is yes for the scene. Every possible combination is compiled.
template <class Use, class... Yes>
void with_answers(const World&, const Use& use, Questions<>, Questions<Yes...> yes) {
  use(yes);
}
template <class Use, class Question, class... Rest, class... Yes>
void with_answers(const World& world, const Use& use, Questions<Question, Rest...>, Questions<Yes...>) {
  if constexpr (possible<Question, Questions<Yes...>>) {
    if (Question::in(world).yes) return with_answers(world, use, Questions<Rest...>{}, Questions<Yes..., Question>{});
  }
  with_answers(world, use, Questions<Rest...>{}, Questions<Yes...>{});
}

/// A solver reduced to the effects that a scene needs. Each call is one indirect call. The sweeps are compiled as in any solver.
class FittingSolver : public ForwardingSolver {
 public:
  template <class Full>
  FittingSolver(const World& world, const Full& full) : holder_(holder_for(world, full)) {}
  FittingSolver(const FittingSolver& other) : ForwardingSolver(other), holder_(other.holder_->copy()) {}
  FittingSolver(FittingSolver&&) noexcept = default;
  FittingSolver& operator=(FittingSolver other) noexcept {
    holder_.swap(other.holder_);
    return *this;
  }
  ~FittingSolver() override = default;

  /// Chooses again, for another scene, and keeps the settings. Throws InvalidInput, without any change, if the scene has joints
  /// and the solver does not support joints.
  void fit(const World& world) { holder_ = holder_->fitting(world); }
  void whole_step(World& world, Real dt, int sweeps) override { inner().whole_step(world, dt, sweeps); }
  /// Whether its step has its own order: see StepSolver::whole_step.
  bool divides_worlds() const { return holder_->divides_worlds(); }
  /// The rows of the latest substep, or none if the solver shows none.
  const Rows& rows() const { return holder_->rows(); }
  const JointRows& joint_rows() const { return holder_->joint_rows(); }

 private:
  struct AnyHolder {
    virtual ~AnyHolder() = default;
    virtual std::unique_ptr<AnyHolder> copy() const = 0;
    virtual std::unique_ptr<AnyHolder> fitting(const World& world) const = 0;
    virtual StepSolver& solver() = 0;
    virtual bool divides_worlds() const = 0;
    virtual const Rows& rows() const = 0;
    virtual const JointRows& joint_rows() const = 0;
  };
  template <class Full, class Fitting>
  struct Holder final : AnyHolder {
    Holder(const Full& its_full, Fitting its_fitting) : full(its_full), held(std::move(its_fitting)) {}
    std::unique_ptr<AnyHolder> copy() const override { return std::make_unique<Holder>(*this); }
    std::unique_ptr<AnyHolder> fitting(const World& world) const override { return holder_for(world, full); }
    StepSolver& solver() override { return held; }
    bool divides_worlds() const override {
      if constexpr (requires { held.divides_worlds(); }) return held.divides_worlds();
      else return has_whole_step<Fitting>;
    }
    const Rows& rows() const override {
      if constexpr (requires { held.rows(); }) return held.rows();
      else return none<Rows>();
    }
    const JointRows& joint_rows() const override {
      if constexpr (requires { held.joint_rows(); }) return held.joint_rows();
      else return none<JointRows>();
    }
    template <class List>
    static const List& none() {
      static const List nothing;
      return nothing;
    }
    Full full;  // for the settings of the omitted effects
    Fitting held;
  };
  StepSolver& inner() override { return holder_->solver(); }
  const StepSolver& inner() const override { return holder_->solver(); }

  template <class Full>
  static std::unique_ptr<AnyHolder> holder_for(const World& world, const Full& full) {
    check_solvable(world, full);
    std::unique_ptr<AnyHolder> chosen;
    const auto choose = [&](auto yes) {
      using Fitting = Only<Full, decltype(yes)>;
      chosen = std::make_unique<Holder<Full, Fitting>>(full, only<decltype(yes)>(full));
    };
    with_answers(world, choose, Questions<NeedsContacts, NeedsRestitution, NeedsFriction, NeedsJoints>{},
                 Questions<>{});
    return chosen;
  }

  std::unique_ptr<AnyHolder> holder_;
};

/// All bodies take part. Contacts are detected only if the scene has bodies that can touch.
struct DetectedIfTouching : AllBodies {
  bool touching = true;
  void find_contacts(World& world, const Margin& margin = {}) const {
    if (touching) AllBodies::find_contacts(world, margin);
    else world.contacts.clear();
  }
};

/// World::step with the effects that the scene needs, and with a Sleep only for bodies that are awake. It examines the scene again
/// if the number of bodies, forces or joints has changed. If you make an existing body movable, rough or bouncy, call `fit`.
class OnlyWhatIsNeeded {
 public:
  std::optional<Sleep> sleep;

  template <class Full>
  OnlyWhatIsNeeded(const World& world, const Full& full, std::optional<Sleep> with_sleep = {})
      : sleep(std::move(with_sleep)), solver_(world, full) {
    look(world);
  }
  void fit(const World& world);
  /// `dt`: s. `sweeps`: in each substep, by default the number in the solver's plan.
  void step(World& world, Real dt, std::optional<int> sweeps = {});
  SolveStats stats() const { return solver_.stats(); }
  const Rows& rows() const { return solver_.rows(); }
  const JointRows& joint_rows() const { return solver_.joint_rows(); }

 private:
  void look(const World& world);

  FittingSolver solver_;
  DetectedIfTouching all_bodies_;
  std::size_t bodies_ = 0, forces_ = 0, joints_ = 0;
};

}  // namespace pushback
