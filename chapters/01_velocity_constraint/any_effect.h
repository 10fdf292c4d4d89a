/// A single type for any effect.
#pragma once

#include <memory>

#include "pushback/chapters/01_velocity_constraint/solver.h"

namespace pushback {

/// An effect that is compiled elsewhere. A copy has the same settings and continues as the original would.
class AnyEffect : public Effect {
 public:
  AnyEffect() : AnyEffect(Nothing{}) {}
  template <AnEffect E>
    requires(!std::same_as<E, AnyEffect>)
  AnyEffect(E effect) : held_(std::make_unique<Held<E>>(std::move(effect))) {}
  AnyEffect(const AnyEffect& other) : held_(other.held_->copy()) {}
  AnyEffect(AnyEffect&&) noexcept = default;
  AnyEffect& operator=(AnyEffect other) noexcept {
    held_.swap(other.held_);
    return *this;
  }
  ~AnyEffect() = default;

  void check(StepContext& step) { held_->check(step); }
  void adjust_separation(StepContext& step) { held_->adjust_separation(step); }
  void build(StepContext& step) { held_->build(step); }
  void start(StepContext& step) { held_->start(step); }
  void sweep(StepContext& step) { held_->sweep(step); }
  void finish(StepContext& step) { held_->finish(step); }
  void report(StepContext& step) { held_->report(step); }

 private:
  struct Anything {
    virtual ~Anything() = default;
    virtual std::unique_ptr<Anything> copy() const = 0;
    virtual void check(StepContext&) = 0;
    virtual void adjust_separation(StepContext&) = 0;
    virtual void build(StepContext&) = 0;
    virtual void start(StepContext&) = 0;
    virtual void sweep(StepContext&) = 0;
    virtual void finish(StepContext&) = 0;
    virtual void report(StepContext&) = 0;
  };
  struct Nothing : Effect {
    void check(StepContext&) {}
  };
  template <class E>
  struct Held final : Anything {
    explicit Held(E its_effect) : effect(std::move(its_effect)) {}
    std::unique_ptr<Anything> copy() const override { return std::make_unique<Held>(*this); }
    void check(StepContext& step) override { effect.check(step); }
    void adjust_separation(StepContext& step) override { effect.adjust_separation(step); }
    void build(StepContext& step) override { effect.build(step); }
    void start(StepContext& step) override { effect.start(step); }
    void sweep(StepContext& step) override { effect.sweep(step); }
    void finish(StepContext& step) override { effect.finish(step); }
    void report(StepContext& step) override { effect.report(step); }
    E effect;
  };

  std::unique_ptr<Anything> held_;
};

/// A solver that has AnyEffect among its effects, with that effect set to `effect`.
template <std::derived_from<AnyEffect> ContactSolver>
ContactSolver with_effect(const AnyEffect& effect) {
  ContactSolver solver;
  static_cast<AnyEffect&>(solver) = effect;
  return solver;
}

}  // namespace pushback
