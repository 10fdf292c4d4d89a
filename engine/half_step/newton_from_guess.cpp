#include "pushback/engine/half_step/newton_from_guess.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <tuple>

#include "pushback/engine/direct/coulomb_equation.h"
#include "pushback/engine/direct/joint_graph.h"

namespace pushback {

namespace {

// Multiplications for a contact: its law, its blocks in the matrix, its part of a right side and of what comes back.
constexpr double of_evaluation = 200, of_assembly = 700, of_change = 150;

using SixByThree = Eigen::Matrix<double, 6, 3>;
using ThreeBySix = Eigen::Matrix<double, 3, 6>;

/// J of the rows of a group, for one of its bodies. The rest is 0.
ThreeBySix jacobian_of(const std::array<Row*, 3>& rows, int count, bool of_b) {
  ThreeBySix j = ThreeBySix::Zero();
  for (int i = 0; i < count; ++i) {
    const Row& row = *rows[std::size_t(i)];
    if (of_b) j.row(i) << row.n.cast<double>().transpose(), row.rb_n.cast<double>().transpose();
    else j.row(i) << -row.n.cast<double>().transpose(), -row.ra_n.cast<double>().transpose();
  }
  return j;
}
/// M^-1 J^T of them.
SixByThree effect_of(const std::array<Row*, 3>& rows, int count, bool on_b) {
  SixByThree effect = SixByThree::Zero();
  for (int i = 0; i < count; ++i) {
    const Row& row = *rows[std::size_t(i)];
    effect.col(i) << (on_b ? row.dvb : row.dva).cast<double>(), (on_b ? row.dwb : row.dwa).cast<double>();
  }
  return effect;
}

}  // namespace

void NewtonFromGuess::add(const std::array<Row*, 3>& rows, int count, double mu, double softness) {
  Group& group = groups_.emplace_back();
  group.rows = rows;
  group.count = count;
  group.mu = mu;
  group.softness = softness;
  group.w = jacobian_of(rows, count, true) * effect_of(rows, count, true) +
            jacobian_of(rows, count, false) * effect_of(rows, count, false);
}

void NewtonFromGuess::add_contact(Row& normal, Row& tangent1, Row& tangent2, Real friction) {
  add({&normal, &tangent1, &tangent2}, 3, static_cast<double>(friction), 0);
}

void NewtonFromGuess::add_normal(Row& row) {
  row.lo = 0;
  add({&row, nullptr, nullptr}, 1, 0, 0);
}

void NewtonFromGuess::add(JointRow& row) {
  add({&row, nullptr, nullptr}, 1, 0, static_cast<double>(row.softness));
}

void NewtonFromGuess::index_bodies(const World& world) {
  body_indices_.assign(world.bodies.size(), not_moving);
  bodies_ = 0;
  pairs_.clear();
  const auto place_of = [this](const Body& body) {
    if (!body.movable()) return not_moving;
    int& place = body_indices_[static_cast<std::size_t>(body.index)];
    if (place == not_moving) place = bodies_++;
    return place;
  };
  for (Group& group : groups_) {
    group.a = place_of(*group.rows[0]->a);
    group.b = place_of(*group.rows[0]->b);
    if (group.a != not_moving && group.b != not_moving) pairs_.push_back(std::minmax(group.a, group.b));
  }
  std::sort(pairs_.begin(), pairs_.end());
  pairs_.erase(std::unique(pairs_.begin(), pairs_.end()), pairs_.end());
}

/// l and u of a group, f and what it changes by.
void NewtonFromGuess::evaluate(Group& group) const {
  group.l.setZero();
  group.u.setZero();
  for (int i = 0; i < group.count; ++i) {
    const Row& row = *group.rows[std::size_t(i)];
    group.l[i] = static_cast<double>(row.impulse);
    group.u[i] = static_cast<double>(row.speed() + row.bias);
  }
  if (group.count == 3) {
    const CoulombEquation law(ContactBlock(group.w), group.mu, group.l, group.u);
    group.f = law.f;
    group.df_du = law.df_du;
    group.df_dl = law.df_dr;
    return;
  }
  group.f.setZero();
  group.df_du.setZero();
  group.df_dl.setIdentity();
  const Row& row = *group.rows[0];
  const double k = group.w(0, 0) + group.softness, a = k > 0 ? 1 / k : 1, lo = static_cast<double>(row.lo),
               hi = static_cast<double>(row.hi);
  group.u[0] += group.softness * group.l[0];
  const double wanted = group.l[0] - a * group.u[0];
  group.f[0] = group.l[0] - std::clamp(wanted, lo, hi);
  if (wanted <= lo || wanted >= hi) return;
  group.df_du(0, 0) = a;
  group.df_dl(0, 0) = a * group.softness;
}

NewtonFromGuess::Total NewtonFromGuess::evaluate() {
  work_left -= of_evaluation * static_cast<double>(groups_.size());
  Total total{0, 0};
  for (Group& group : groups_) {
    evaluate(group);
    const double k = group.w.trace() / group.count;
    const double speed = (k > 0 ? k : 1) * group.f.norm();
    total.sum += speed * speed;
    total.largest = std::max(total.largest, speed);
  }
  total.sum = std::sqrt(total.sum);
  return total;
}

double NewtonFromGuess::largest_error() {
  return evaluate().largest;
}

/// From a system of the same bodies and rows.
bool NewtonFromGuess::has_matrix() const {
  return std::equal(groups_.begin(), groups_.end(), factored_groups_.begin(), factored_groups_.end(),
                    [](const Group& now, const FactoredGroup& then) {
                      return now.a == then.a && now.b == then.b && now.count == then.count;
                    });
}

bool NewtonFromGuess::factor(double proximal) {
  factored_groups_.clear();
  too_large = !matrix_.begin(bodies_, pairs_, most_matrix_work);
  if (too_large) return false;
  ++factorizations;
  work_left -= of_assembly * static_cast<double>(groups_.size()) + matrix_.of_factor();
  for (Group& group : groups_) {
    const double k = group.w.trace() / group.count;
    const Eigen::Matrix3d inverse = (group.df_dl + proximal * (k > 0 ? k : 1) * group.df_du).inverse();
    factored_groups_.push_back({group.a, group.b, group.count, group.df_du, inverse});
    if (!inverse.allFinite()) {
      factored_groups_.clear();
      return false;
    }
    const Eigen::Matrix3d between = inverse * group.df_du;
    for (const bool row_is_b : {false, true}) {
      const int row = row_is_b ? group.b : group.a;
      if (row == not_moving) continue;
      const SixByThree effect = effect_of(group.rows, group.count, row_is_b) * between;
      for (const bool column_is_b : {false, true}) {
        const int column = column_is_b ? group.b : group.a;
        if (column != not_moving) matrix_.add(row, column, effect * jacobian_of(group.rows, group.count, column_is_b));
      }
    }
  }
  if (matrix_.factor()) return true;
  factored_groups_.clear();
  return false;
}

bool NewtonFromGuess::find_changes() {
  work_left -= of_change * static_cast<double>(groups_.size()) + matrix_.of_solve();
  speeds_.assign(static_cast<std::size_t>(bodies_), BodyMatrix::Six::Zero());
  const auto at = [this](int place) -> BodyMatrix::Six& { return speeds_[static_cast<std::size_t>(place)]; };
  for (std::size_t i = 0; i < groups_.size(); ++i) {
    const Group& group = groups_[i];
    const Three pushed = factored_groups_[i].inverse * group.f;
    if (group.a != not_moving) at(group.a) -= effect_of(group.rows, group.count, false) * pushed;
    if (group.b != not_moving) at(group.b) -= effect_of(group.rows, group.count, true) * pushed;
  }
  matrix_.solve(speeds_);
  for (std::size_t i = 0; i < groups_.size(); ++i) {
    Group& group = groups_[i];
    Three speed = Three::Zero();
    if (group.a != not_moving) speed += jacobian_of(group.rows, group.count, false) * at(group.a);
    if (group.b != not_moving) speed += jacobian_of(group.rows, group.count, true) * at(group.b);
    group.change = -(factored_groups_[i].inverse * (group.f + factored_groups_[i].df_du * speed));
    if (!group.change.allFinite()) return false;
  }
  return true;
}

void NewtonFromGuess::apply_change(const Group& group, double part) {
  for (int i = 0; i < group.count; ++i) {
    const Real change = static_cast<Real>(part * group.change[i]);
    group.rows[std::size_t(i)]->impulse += change;
    group.rows[std::size_t(i)]->apply(change);
  }
}

void NewtonFromGuess::sweep(int times) {
  for (int i = 0; i < times && work_left > 0; ++i, work_left -= of_evaluation * static_cast<double>(groups_.size()))
    for (Group& group : groups_) {
      evaluate(group);
      group.change = -group.f;
      apply_change(group, 1);
    }
}

void NewtonFromGuess::save(const World& world, State& state) const {
  state.impulses.clear();
  state.velocities.clear();
  for (const Group& group : groups_)
    for (int i = 0; i < group.count; ++i) state.impulses.push_back(group.rows[std::size_t(i)]->impulse);
  for (const Body& body : world.bodies) state.velocities.emplace_back(body.velocity, body.angular_velocity);
}

void NewtonFromGuess::restore(World& world, const State& state) const {
  auto impulse = state.impulses.begin();
  for (const Group& group : groups_)
    for (int i = 0; i < group.count; ++i) group.rows[std::size_t(i)]->impulse = *impulse++;
  for (std::size_t i = 0; i < world.bodies.size(); ++i)
    std::tie(world.bodies[i].velocity, world.bodies[i].angular_velocity) = state.velocities[i];
}

/// A leap can go far, and what is rounded off there would stay in the velocities, though the impulses come back: momentum would
/// not be kept. So velocities are once more those of the begin and what the impulses have changed by.
void NewtonFromGuess::recompute_velocities(World& world, const State& begun) {
  for (std::size_t i = 0; i < world.bodies.size(); ++i)
    std::tie(world.bodies[i].velocity, world.bodies[i].angular_velocity) = begun.velocities[i];
  auto impulse = begun.impulses.begin();
  for (const Group& group : groups_)
    for (int i = 0; i < group.count; ++i) {
      const Row& row = *group.rows[std::size_t(i)];
      group.rows[std::size_t(i)]->apply(row.impulse - *impulse++);
    }
}

bool NewtonFromGuess::solve(World& world, double enough, double acceptable) {
  constexpr int most_steps = 60, most_leaps = 12;
  constexpr double well = 0.1;  // what |f| falls to where the matrix may be kept
  Total total = evaluate();
  if (total.largest <= enough) return true;
  index_bodies(world);
  save(world, best_);
  const State begun = best_;
  Total best = total;
  double proximal = total.largest < small_error ? 1e-5 : 1e-3;
  bool kept = has_matrix();
  int leaps = 0;
  for (int step = 0; step < most_steps && work_left > 0; ++step) {
    if (!kept) {
      if (!factor(proximal)) break;
      proximal = std::max(proximal / 10, 1e-7);
    }
    if (!find_changes()) break;
    save(world, before_);
    double fallen = 1;
    for (double part = 1; part > 1e-3 && fallen == 1; part /= 2) {  // a step halved until |f| falls
      if (part < 1) restore(world, before_);
      for (const Group& group : groups_) apply_change(group, part);
      const Total tried = evaluate();
      if (!(tried.sum < (1 - 1e-4 * part) * total.sum)) continue;
      fallen = tried.sum / total.sum;
      total = tried;
    }
    if (fallen < 1 && total.sum < best.sum) {
      best = total;
      save(world, best_);
    }
    if (best.largest <= enough / 10 || (best.largest <= enough && fallen > well)) break;
    if (fallen == 1) {  // f has kinks, and between two of them a whole step makes progress although |f| grows
      restore(world, before_);
      if (!kept) {
        if (best.largest <= acceptable) break;
        if (++leaps > most_leaps) break;
        for (const Group& group : groups_) apply_change(group, 1);
      }
      total = evaluate();
    }
    kept = fallen <= well;
  }
  restore(world, best_);
  if (leaps > 0) recompute_velocities(world, begun);
  return best.largest <= enough;
}

}  // namespace pushback
