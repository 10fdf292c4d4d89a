#include "pushback/engine/half_step/held_joints.h"

#include <algorithm>
#include <cmath>

#include "pushback/common/basics/input.h"

namespace pushback {

namespace {

constexpr bool fine = std::numeric_limits<Real>::digits > 24;
constexpr Real reached = fine ? Real(1e-9) : Real(1e-5);  // m or rad; a smaller distance to a limit is rounding
constexpr Real brief = Real(1) / 1024;                    // s: the step length for an evaluation outside a step

}  // namespace

void HeldJoints::begin(const World& world) {
  joint_bodies_.clear();
  joints_.clear();
  equations_.clear();
  held_.clear();
  in_matrix_.clear();
  linear_ = true;
  springs_ = false;
  for (std::size_t i = 0; i < world.joints.size(); ++i) {
    const Joint& joint = world.joints[i];
    const Body &a = world.body(joint.a), &b = world.body(joint.b);
    if (!a.movable() && !b.movable()) continue;
    const std::size_t before = equations_.size();
    joint.ask(a, b, {world.time, brief}, equations_);
    const std::size_t count = equations_.size() - before;
    joint_bodies_.push_back(
        {a.movable() ? joint.a : not_moving, b.movable() ? joint.b : not_moving, static_cast<int>(count)});
    joints_.push_back(i);
    for (std::size_t n = 0; n < count; ++n) {
      const Equation& equation = equations_[before + n];
      HeldRow& held = held_.emplace_back();
      held.lo = equation.lo;
      held.hi = equation.hi;
      held.kind = equation.softness != 0                                       ? Kind::spring
                  : !std::isfinite(equation.lo) && !std::isfinite(equation.hi) ? Kind::rigid
                  : !joint.driven && equation.lo == 0 && equation.hi > 0       ? Kind::limit
                                                                               : Kind::motor;
      if (n < joint.last_impulses.size()) held.load = world.impulse_scale(1) * joint.last_impulses[n];
      in_matrix_.push_back(held.kind == Kind::rigid);
      springs_ = springs_ || held.kind == Kind::spring;
      linear_ = linear_ && (held.kind == Kind::rigid || held.kind == Kind::spring);
    }
  }
}

/// What joints of one kind ask for in a step.
template <class Act>
void HeldJoints::each(const World& world, const TimeStep& now, Kind kind, const Act& act) {
  std::size_t row = 0;
  for (std::size_t k = 0; k < joints_.size(); ++k) {
    const auto first = held_.begin() + std::ptrdiff_t(row), end = first + joint_bodies_[k].rows;
    row += std::size_t(joint_bodies_[k].rows);
    if (std::none_of(first, end, [kind](const HeldRow& held) { return held.kind == kind; })) continue;
    const Joint& joint = world.joints[joints_[k]];
    evaluated_.clear();
    joint.ask(world.body(joint.a), world.body(joint.b), now, evaluated_);
    for (auto held = first; held != end; ++held)
      if (held->kind == kind) act(*held, evaluated_[std::size_t(held - first)], std::size_t(held - held_.begin()));
  }
}

void HeldJoints::check(const World& world, bool both_ways) {
  begin(world);
  find_springs(world);
  std::size_t row = 0;
  for (std::size_t k = 0; k < joints_.size(); ++k)
    for (int n = 0; n < joint_bodies_[k].rows; ++n, ++row) {
      const std::string& name = world.joints[joints_[k]].name;
      const HeldRow& held = held_[row];
      const bool limited = std::isfinite(held.lo) || std::isfinite(held.hi);
      if (held.kind == Kind::spring && limited)
        throw InvalidInput(fmt::format(
            "the world has {} whose force has a limit: half steps cannot solve a spring with a force limit", name));
      if (both_ways && (limited || held.damping > 0))
        throw InvalidInput(fmt::format("the world has {} {}: a composed step goes back in time, and it does not", name,
                                       limited ? "whose force has a limit" : "that damps"));
    }
}

/// k, c and C from what chapter 15 makes of them, 1 / gamma = h c + h^2 k and b = h k gamma C, for two h.
void HeldJoints::find_springs(const World& world) {
  if (!springs_) return;
  constexpr Real rounding = fine ? Real(1e-9) : Real(1e-4);
  each(world, {world.time, brief}, Kind::spring, [](HeldRow& held, const Equation& equation, std::size_t) {
    held.damping = 1 / (brief * equation.softness);        // c + h k
    held.c = equation.bias / (brief * equation.softness);  // k C
  });
  each(world, {world.time, 2 * brief}, Kind::spring, [](HeldRow& held, const Equation& equation, std::size_t) {
    const Real longer = 1 / (2 * brief * equation.softness);  // c + 2 h k
    held.stiffness = (longer - held.damping) / brief;
    held.damping = 2 * held.damping - longer;
    if (held.damping < rounding * brief * held.stiffness) held.damping = 0;
    held.c /= held.stiffness;
  });
  for (const HeldRow& held : held_) linear_ = linear_ && held.damping == 0;
}

Real HeldJoints::evaluate(const World& world, Real time) {
  equations_.clear();
  Real largest = 0;
  for (const std::size_t i : joints_) {
    const Joint& joint = world.joints[i];
    const std::size_t first = equations_.size();
    joint.ask(world.body(joint.a), world.body(joint.b), {time, brief}, equations_);
    for (std::size_t n = first; n < equations_.size(); ++n) {
      if (held_[n].kind != Kind::rigid) continue;
      const Real off = std::abs(equations_[n].error);
      if (off <= largest || std::isnan(largest)) continue;
      largest = off;
      worst_ = i;
    }
  }
  return largest;
}

void HeldJoints::build_rows(World& world, Real time, Real h) {
  rows_.clear();
  std::size_t row = 0;
  for (std::size_t k = 0; k < joints_.size(); ++k) {
    Joint& joint = world.joints[joints_[k]];
    Body &a = world.body(joint.a), &b = world.body(joint.b);
    if (joint.driven) {  // dC/dt, from half a step before to half a step after
      evaluated_.clear();
      joint.ask(a, b, {time - h / 2, h}, evaluated_);
    }
    for (int n = 0; n < joint_bodies_[k].rows; ++n, ++row) {
      rows_.emplace_back(a, b, equations_[row].jacobian, joints_[k], 0);
      held_[row].error_rate = joint.driven ? evaluated_[static_cast<std::size_t>(n)].bias : 0;
      rows_.back().bias = held_[row].error_rate;
      if (held_[row].kind == Kind::limit) held_[row].c = equations_[row].error + brief * equations_[row].bias;
    }
  }
  find_springs(world);
  factored_ = false;
}

void HeldJoints::solve(std::vector<double>& lambda) {
  if (!factored_) matrix_.factor(rows_, joint_bodies_, in_matrix_);
  factored_ = true;
  matrix_.solve(lambda);
}

void HeldJoints::apply(const std::vector<double>& lambda) {
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    if (held_[i].kind != Kind::rigid) continue;
    const Real impulse = static_cast<Real>(lambda[i]);
    rows_[i].apply(impulse);
    rows_[i].impulse += impulse;
  }
}

std::string HeldJoints::apply_springs_before_drift(const World& world, Real h) {
  if (!springs_) return {};
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    const HeldRow& held = held_[i];
    if (held.kind != Kind::spring) continue;
    JointRow& row = rows_[i];
    if (!(h * h * held.stiffness < 4 * row.effective_mass))
      return fmt::format("{} swings with {} rad/s, half steps of {} s follow up to {}: more substeps are needed",
                         world.joints[row.owner].name, std::sqrt(held.stiffness / row.effective_mass), h,
                         2 / std::abs(h));
    row.impulse = -h / 2 * (held.stiffness * held.c + held.damping * row.speed());
  }
  for (std::size_t i = 0; i < rows_.size(); ++i)
    if (held_[i].kind == Kind::spring) rows_[i].apply(rows_[i].impulse);
  return {};
}

void HeldJoints::apply_springs_after_drift(Real h) {
  if (!springs_) return;
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    const HeldRow& held = held_[i];
    if (held.kind != Kind::spring) continue;
    rows_[i].impulse = held.damping > 0 ? 0 : -h / 2 * held.stiffness * held.c;
    rows_[i].apply(rows_[i].impulse);
  }
}

void HeldJoints::warm_start(Real h) {
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    const HeldRow& held = held_[i];
    if (held.kind == Kind::spring) continue;
    rows_[i].impulse = 0;
    if (held.kind == Kind::rigid || held.active) rows_[i].reach(h / 2 * held.load);
  }
}

void HeldJoints::solve_positions(Real h) {
  lambda_.clear();
  for (const Equation& equation : equations_) lambda_.push_back(static_cast<double>(-equation.error / h));
  solve(lambda_);
  apply(lambda_);
}

void HeldJoints::solve_velocities(Real h) {
  lambda_.clear();
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    if (held_[i].kind == Kind::rigid) rows_[i].impulse = 0;
    lambda_.push_back(held_[i].kind == Kind::rigid ? static_cast<double>(-rows_[i].speed_error()) : 0);
  }
  solve(lambda_);
  apply(lambda_);
  end_velocities(h);
}

void HeldJoints::end_positions() {
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    held_[i].position_impulse = rows_[i].impulse;
    held_[i].total += rows_[i].impulse;
  }
}

void HeldJoints::end_velocities(Real h) {
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    held_[i].load = 2 * rows_[i].impulse / h;
    held_[i].total += rows_[i].impulse;
  }
}

void HeldJoints::prepare_positions(const World& world, Real time, Real h) {
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    HeldRow& held = held_[i];
    if (held.kind != Kind::limit) continue;
    rows_[i].lo = 0;
    rows_[i].bias = held.c / h;
    held.active = true;
    held.was_violated = held.c < -reached;
  }
  each(world, {time, h}, Kind::motor, [this, h](HeldRow& held, const Equation& equation, std::size_t i) {
    rows_[i].lo = h / 2 * held.lo;
    rows_[i].hi = h / 2 * held.hi;
    rows_[i].bias = equation.bias + equation.error / h;
  });
}

void HeldJoints::prepare_rigid(Real h) {
  for (std::size_t i = 0; i < rows_.size(); ++i)
    if (held_[i].kind == Kind::rigid) rows_[i].bias = equations_[i].error / h - rows_[i].speed();
}

/// A row that was beyond its limit must not keep that speed, so its second impulse may be negative, but not the sum.
void HeldJoints::prepare_velocities(Real h) {
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    HeldRow& held = held_[i];
    JointRow& row = rows_[i];
    switch (held.kind) {
      case Kind::rigid:
        break;
      case Kind::limit:
        held.active = held.position_impulse > 0 || held.c < reached;
        row.lo = held.was_violated ? -held.position_impulse : 0;
        break;
      case Kind::motor:
        row.lo = h / 2 * held.lo;
        row.hi = h / 2 * held.hi;
        break;
      case Kind::spring:
        if (held.damping == 0) break;
        row.softness = 2 / (h * held.damping);
        row.bias = held.stiffness * held.c / held.damping;
    }
  }
}

void HeldJoints::add_to(NewtonFromGuess& newton, bool second) {
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    const HeldRow& held = held_[i];
    if (held.kind == Kind::limit ? held.active : held.kind != Kind::spring || (second && held.damping > 0))
      newton.add(rows_[i]);
  }
}

void HeldJoints::add_impact_to(NewtonFromGuess& newton) {
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    const HeldRow& held = held_[i];
    JointRow& row = rows_[i];
    row.impulse = 0;
    const bool stops = held.kind == Kind::limit && held.c < reached;
    if (held.kind != Kind::rigid && !stops) continue;
    if (stops) row.lo = 0;
    row.bias = held.error_rate;
    newton.add(row);
  }
}

void HeldJoints::end_impact() {
  for (std::size_t i = 0; i < rows_.size(); ++i) held_[i].total += rows_[i].impulse;
}

void HeldJoints::report(World& world) const {
  auto held = held_.begin();
  for (std::size_t k = 0; k < joints_.size(); ++k) {
    Joint& joint = world.joints[joints_[k]];
    joint.impulses.resize(static_cast<std::size_t>(joint_bodies_[k].rows));
    joint.last_impulses.clear();
    for (Real& impulse : joint.impulses) {
      joint.last_impulses.push_back((held++)->total);
      impulse += joint.last_impulses.back();
    }
  }
}

}  // namespace pushback
