/// Any effect, as one type.
#pragma once

#include <memory>

#include "pushback/chapters/01_velocity_constraint/solver.h"

namespace pushback {

/// For who takes an effect that is compiled elsewhere. A copy has the same settings and goes on as the original would.
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

  void check(Step& step) { held_->check(step); }
  void touch(Step& step) { held_->touch(step); }
  void build(Step& step) { held_->build(step); }
  void start(Step& step) { held_->start(step); }
  void sweep(Step& step) { held_->sweep(step); }
  void finish(Step& step) { held_->finish(step); }
  void report(Step& step) { held_->report(step); }

 private:
  struct Anything {
    virtual ~Anything() = default;
    virtual std::unique_ptr<Anything> copy() const = 0;
    virtual void check(Step&) = 0;
    virtual void touch(Step&) = 0;
    virtual void build(Step&) = 0;
    virtual void start(Step&) = 0;
    virtual void sweep(Step&) = 0;
    virtual void finish(Step&) = 0;
    virtual void report(Step&) = 0;
  };
  struct Nothing : Effect {
    void check(Step&) {}
  };
  template <class E>
  struct Held final : Anything {
    explicit Held(E its_effect) : effect(std::move(its_effect)) {}
    std::unique_ptr<Anything> copy() const override { return std::make_unique<Held>(*this); }
    void check(Step& step) override { effect.check(step); }
    void touch(Step& step) override { effect.touch(step); }
    void build(Step& step) override { effect.build(step); }
    void start(Step& step) override { effect.start(step); }
    void sweep(Step& step) override { effect.sweep(step); }
    void finish(Step& step) override { effect.finish(step); }
    void report(Step& step) override { effect.report(step); }
    E effect;
  };

  std::unique_ptr<Anything> held_;
};

/// A solver that names AnyEffect among its effects, with this one in that place.
template <std::derived_from<AnyEffect> ContactSolver>
ContactSolver with_effect(const AnyEffect& effect) {
  ContactSolver solver;
  static_cast<AnyEffect&>(solver) = effect;
  return solver;
}

}  // namespace pushback
