/// A single type for any solver.
#pragma once

#include <concepts>
#include <memory>
#include <typeinfo>

#include "pushback/common/world/forwarding_solver.h"

namespace pushback {

/// For programs that choose a solver at run time. A copy has the same settings, and its next step has the same bits as the
/// original's.
class AnySolver : public ForwardingSolver {
 public:
  template <std::derived_from<StepSolver> ContactSolver>
    requires(!std::same_as<ContactSolver, AnySolver>)
  AnySolver(ContactSolver solver) : held_(std::make_unique<Held<ContactSolver>>(std::move(solver))) {}
  AnySolver(const AnySolver& other) : ForwardingSolver(other), held_(other.held_->copy()) {}
  AnySolver(AnySolver&&) noexcept = default;
  AnySolver& operator=(AnySolver other) noexcept {
    held_.swap(other.held_);
    return *this;
  }
  ~AnySolver() override = default;

  void whole_step(World& world, Real dt, int sweeps) override { inner().whole_step(world, dt, sweeps); }
  /// Whether the held solver has its own order of a step, see StepSolver::whole_step.
  bool divides_worlds() const { return held_->divides_worlds(); }
  /// The held solver if it is a ContactSolver, otherwise null.
  template <std::derived_from<StepSolver> ContactSolver>
  const ContactSolver* as() const {
    return dynamic_cast<const ContactSolver*>(&inner());
  }
  /// The type of the held solver.
  const std::type_info& type() const {
    const StepSolver& held = inner();
    return typeid(held);
  }

 private:
  struct Anything {
    virtual ~Anything() = default;
    virtual std::unique_ptr<Anything> copy() const = 0;
    virtual StepSolver& solver() = 0;
    virtual bool divides_worlds() const = 0;
  };
  template <class ContactSolver>
  struct Held final : Anything {
    explicit Held(ContactSolver its_solver) : held(std::move(its_solver)) {}
    std::unique_ptr<Anything> copy() const override { return std::make_unique<Held>(*this); }
    StepSolver& solver() override { return held; }
    bool divides_worlds() const override {
      if constexpr (requires { held.divides_worlds(); }) return held.divides_worlds();
      else return has_whole_step<ContactSolver>;
    }
    ContactSolver held;
  };
  StepSolver& inner() override { return held_->solver(); }
  const StepSolver& inner() const override { return held_->solver(); }

  std::unique_ptr<Anything> held_;
};

}  // namespace pushback
