#include "pushback/chapters/24_half_step/held_joints.h"

#include <algorithm>
#include <cmath>

#include "pushback/common/basics/input.h"

namespace pushback {

void HeldJoints::begin(const World& world) {
  held_.clear();
  joints_.clear();
  equations_.clear();
  borne_.clear();
  for (std::size_t i = 0; i < world.joints.size(); ++i) {
    const Joint& joint = world.joints[i];
    const Body &a = world.body(joint.a), &b = world.body(joint.b);
    if (!a.movable() && !b.movable()) continue;
    const std::size_t before = equations_.size();
    joint.ask(a, b, {world.time, 0}, equations_);
    const std::size_t count = equations_.size() - before;
    held_.push_back({a.movable() ? joint.a : not_moving, b.movable() ? joint.b : not_moving, static_cast<int>(count)});
    joints_.push_back(i);
    for (std::size_t n = 0; n < count; ++n)
      borne_.push_back(n < joint.impulses.size() ? world.impulse_scale(1) * joint.impulses[n] : 0);
  }
  total_.assign(equations_.size(), 0);
  in_stage_.assign(equations_.size(), 0);
  taken_.assign(equations_.size(), 1);
}

void HeldJoints::check(const World& world) {
  begin(world);
  std::size_t row = 0;
  for (std::size_t k = 0; k < held_.size(); ++k)
    for (int n = 0; n < held_[k].rows; ++n, ++row) {
      const Equation& equation = equations_[row];
      const bool limited = std::isfinite(equation.lo) || std::isfinite(equation.hi);
      if (equation.softness == 0 && !limited) continue;
      throw InvalidInput(fmt::format("the world has {} {}: half steps hold joints rigidly, and in both directions",
                                     world.joints[joints_[k]].name,
                                     limited ? "whose force has a limit" : "that gives way"));
    }
}

Real HeldJoints::ask(const World& world, Real time) {
  equations_.clear();
  Real largest = 0;
  for (const std::size_t i : joints_) {
    const Joint& joint = world.joints[i];
    const std::size_t first = equations_.size();
    joint.ask(world.body(joint.a), world.body(joint.b), {time, 0}, equations_);
    for (std::size_t n = first; n < equations_.size(); ++n) {
      const Real off = std::abs(equations_[n].error);
      if (off <= largest || std::isnan(largest)) continue;
      largest = off;
      worst_ = i;
    }
  }
  return largest;
}

void HeldJoints::place(World& world, Real time, Real h) {
  rows_.clear();
  std::size_t row = 0;
  for (std::size_t k = 0; k < held_.size(); ++k) {
    Joint& joint = world.joints[joints_[k]];
    Body &a = world.body(joint.a), &b = world.body(joint.b);
    if (joint.driven) {  // dC/dt, from half a step before to half a step after
      later_.clear();
      joint.ask(a, b, {time - h / 2, h}, later_);
    }
    for (int n = 0; n < held_[k].rows; ++n, ++row) {
      rows_.emplace_back(a, b, equations_[row].jacobian, joints_[k], 0);
      if (joint.driven) rows_.back().bias = later_[static_cast<std::size_t>(n)].bias;
    }
  }
  matrix_.factor(rows_, held_, taken_);
}

void HeldJoints::apply(const std::vector<double>& lambda) {
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    const Real impulse = static_cast<Real>(lambda[i]);
    rows_[i].apply(impulse);
    in_stage_[i] += impulse;
    total_[i] += impulse;
  }
}

void HeldJoints::start(Real h) {
  lambda_.clear();
  for (const Real force : borne_) lambda_.push_back(static_cast<double>(h / 2 * force));
  std::fill(in_stage_.begin(), in_stage_.end(), 0);
  apply(lambda_);
}

void HeldJoints::press(Real h) {
  lambda_.clear();
  for (const Equation& equation : equations_) lambda_.push_back(static_cast<double>(-equation.error / h));
  matrix_.solve(lambda_);
  apply(lambda_);
}

void HeldJoints::take_back() {
  for (std::size_t i = 0; i < rows_.size(); ++i) total_[i] -= in_stage_[i];
}

void HeldJoints::project(Real h) {
  lambda_.clear();
  for (const JointRow& row : rows_) lambda_.push_back(static_cast<double>(-row.speed_error()));
  matrix_.solve(lambda_);
  std::fill(in_stage_.begin(), in_stage_.end(), 0);
  apply(lambda_);
  for (std::size_t i = 0; i < rows_.size(); ++i) borne_[i] = 2 * in_stage_[i] / h;
}

void HeldJoints::report(World& world) const {
  std::size_t row = 0;
  for (std::size_t k = 0; k < held_.size(); ++k) {
    std::vector<Real>& impulses = world.joints[joints_[k]].impulses;
    impulses.assign(total_.begin() + static_cast<std::ptrdiff_t>(row),
                    total_.begin() + static_cast<std::ptrdiff_t>(row + std::size_t(held_[k].rows)));
    row += std::size_t(held_[k].rows);
  }
}

}  // namespace pushback
