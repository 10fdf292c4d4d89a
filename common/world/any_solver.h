/// Any solver, as one type.
#pragma once

#include <algorithm>
#include <memory>
#include <typeinfo>

#include "pushback/common/world/step.h"

namespace pushback {

/// For who chooses among solvers while the program runs. To call it is an indirect call; sweeps are compiled as ever, and
/// once, where it is made. A copy has the same settings and goes on as the original would.
class AnySolver : public StepSolver {
 public:
  template <std::derived_from<StepSolver> ContactSolver>
  AnySolver(ContactSolver solver) : held_(std::make_unique<Held<ContactSolver>>(std::move(solver))) {}
  AnySolver(const AnySolver& other) : held_(other.held_->copy()) {}
  AnySolver(AnySolver&&) noexcept = default;
  AnySolver& operator=(AnySolver other) noexcept {
    held_.swap(other.held_);
    return *this;
  }
  ~AnySolver() = default;

  Workers& workers() const { return held_->workers(); }
  void check(World& world, Real dt) { held_->check(world, dt); }
  Division division(Real dt) const { return held_->division(dt); }
  void detected(World& world, Real dt) { held_->detected(world, dt); }
  void solve(World& world, Real dt, int sweeps) { held_->solve(world, dt, sweeps); }
  void displace(World& world, Real dt) { held_->displace(world, dt); }
  void after_move(World& world, Real dt) { held_->after_move(world, dt); }
  void done(World& world) { held_->done(world); }

  /// What it says of its latest step: how many rows of contacts and joints it solved, 0 where it has none to show; and how
  /// far the worst of them was from being solved, m/s.
  struct Solved {
    int rows = 0;
    Real residual = 0;
  };
  Solved solved() const { return held_->solved(); }
  const std::type_info& type() const { return held_->type(); }

 private:
  struct Anything {
    virtual ~Anything() = default;
    virtual std::unique_ptr<Anything> copy() const = 0;
    virtual Workers& workers() const = 0;
    virtual void check(World& world, Real dt) = 0;
    virtual Division division(Real dt) const = 0;
    virtual void detected(World& world, Real dt) = 0;
    virtual void solve(World& world, Real dt, int sweeps) = 0;
    virtual void displace(World& world, Real dt) = 0;
    virtual void after_move(World& world, Real dt) = 0;
    virtual void done(World& world) = 0;
    virtual Solved solved() const = 0;
    virtual const std::type_info& type() const = 0;
  };
  template <class ContactSolver>
  struct Held final : Anything {
    explicit Held(ContactSolver its_solver) : solver(std::move(its_solver)) {}
    std::unique_ptr<Anything> copy() const override { return std::make_unique<Held>(*this); }
    Workers& workers() const override { return solver.workers(); }
    void check(World& world, Real dt) override { solver.check(world, dt); }
    Division division(Real dt) const override { return solver.division(dt); }
    void detected(World& world, Real dt) override { solver.detected(world, dt); }
    void solve(World& world, Real dt, int sweeps) override { solver.solve(world, dt, sweeps); }
    void displace(World& world, Real dt) override { solver.displace(world, dt); }
    void after_move(World& world, Real dt) override { solver.after_move(world, dt); }
    void done(World& world) override { solver.done(world); }
    Solved solved() const override {
      Solved sum;
      [[maybe_unused]] const auto add = [&sum](const auto& rows) {
        sum.rows += static_cast<int>(rows.size());
        for (const auto& row : rows) sum.residual = std::max(sum.residual, row.error());
      };
      if constexpr (requires { solver.rows(); }) add(solver.rows());
      if constexpr (requires { solver.joint_rows(); }) add(solver.joint_rows());
      return sum;
    }
    const std::type_info& type() const override { return typeid(ContactSolver); }
    ContactSolver solver;
  };

  std::unique_ptr<Anything> held_;
};

extern template void World::step(AnySolver& solver, Real dt, int sweeps);

}  // namespace pushback
