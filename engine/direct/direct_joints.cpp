#include "pushback/engine/direct/direct_joints.h"

#include <cmath>

namespace pushback {

/// Lists the joints, and guesses which rows are active. Returns whether A may differ from the previous step.
bool DirectJoints::guess_active_rows(StepContext& step) {
  bool soft = false;
  joint_bodies_.clear();
  active_before_.swap(active_);
  active_.clear();
  const World& world = step.world;
  const Real scale = world.impulse_scale(step.dt);
  each_row(step, [&](const JointRow& row, const std::vector<Real>& impulses, std::size_t n) {
    const Joint& joint = world.joints[row.owner];
    const auto index = [](int body, const Body& its) { return its.movable() ? body : not_moving; };
    if (n == 0) joint_bodies_.push_back({index(joint.a, *row.a), index(joint.b, *row.b), 0});
    ++joint_bodies_.back().rows;
    const Real before = n < impulses.size() ? scale * impulses[n] : 0;
    active_.push_back(row.lo < before && before < row.hi);
    soft |= row.softness != 0;
  });
  return soft || active_ != active_before_;
}

/// An inactive row starts with the impulse of its limit.
void DirectJoints::start(StepContext& step) {
  const Real scale = step.world.impulse_scale(step.dt);
  std::size_t i = 0;
  each_row(step, [&](Row& row, const std::vector<Real>& impulses, std::size_t n) {
    if (!active_[i++]) row.reach(n < impulses.size() ? scale * impulses[n] : 0);
  });
}

/// Block principal pivoting: all wrong rows change between active and inactive while they become fewer. After three rounds in
/// which they do not, only the first one changes.
///   Júdice and Pires, "A block principal pivoting algorithm for large-scale strictly monotone LCPs", 1994.
void DirectJoints::sweep(StepContext&) {
  std::size_t fewest = joint_rows_.size() + 1;
  int patience = 0;
  for (int round = 0; round < most_rounds; ++round) {
    solve_at_once();
    find_wrong();
    if (wrong_.size() < fewest) fewest = wrong_.size(), patience = 3;
    else if (patience > 0) --patience;
    else wrong_.resize(1);
    for (const std::size_t i : wrong_) active_[i] = !active_[i];
    for (JointRow& row : joint_rows_)
      if (has_limits(row)) row.reach(row.impulse);
    if (wrong_.empty()) return;
    matrix_.factor(joint_rows_, joint_bodies_, active_);
  }
  for (JointRow& row : joint_rows_)
    if (has_limits(row) && std::isfinite(row.effective_mass)) row.solve();
}

/// Also where that goes beyond a limit.
void DirectJoints::solve_at_once() {
  change_.clear();
  for (const JointRow& row : joint_rows_) change_.push_back(static_cast<double>(-row.speed_error()));
  matrix_.solve(change_);
  for (std::size_t i = 0; i < joint_rows_.size(); ++i) {
    if (!matrix_.is_solved(i)) continue;
    const Real lambda = static_cast<Real>(change_[i]);
    joint_rows_[i].impulse += lambda;
    joint_rows_[i].apply(lambda);
  }
}

/// Finds active rows whose impulse is beyond a limit, and inactive rows whose impulse should leave their limit, by more than
/// rounding.
void DirectJoints::find_wrong() {
  constexpr Real rounding = 1024 * std::numeric_limits<Real>::epsilon();  // m/s
  wrong_.clear();
  for (std::size_t i = 0; i < joint_rows_.size(); ++i) {
    const JointRow& row = joint_rows_[i];
    if (!has_limits(row) || !std::isfinite(row.effective_mass)) continue;
    const Real little = rounding * row.effective_mass, total = active_[i] ? row.impulse : row.wanted();
    const bool below = total < row.lo - little;
    const bool above = total > row.hi + little;
    const bool wrong = active_[i]              ? below || above
                       : row.impulse == row.lo ? total > row.lo + little
                                               : total < row.hi - little;
    if (wrong) wrong_.push_back(i);
  }
}

}  // namespace pushback
