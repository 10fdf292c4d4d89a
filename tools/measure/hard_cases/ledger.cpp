#include "pushback/tools/measure/hard_cases/ledger.h"

#include <fmt/format.h>

#include <algorithm>

#include "pushback/common/world/measure.h"

namespace pushback {

void Account::add(const Account& other) {
  if (broken.empty()) broken = other.broken;
  solves += other.solves;
  started_above += other.started_above;
  returned += other.returned;
  ended_above += other.ended_above;
  most_started = std::max(most_started, other.most_started);
  most_returned = std::max(most_returned, other.most_returned);
  most_above = std::max(most_above, other.most_above);
}

void Ledger::gather(const Rows& rows) {
  bodies_.clear();
  for (const Row& row : rows) {
    for (const Body* body : {row.a, row.b}) {
      if (body->movable()) bodies_.push_back(body);
    }
  }
  std::sort(bodies_.begin(), bodies_.end(), [](const Body* p, const Body* q) { return p->index < q->index; });
  bodies_.erase(std::unique(bodies_.begin(), bodies_.end()), bodies_.end());
  // R I^-1 R^T is one matrix: its large entries' rounding hides the small ones.
  Real worst = 1;
  for (const Body* body : bodies_) {
    const Vec3& inverse = body->principal_inverse_inertia;
    if (inverse.minCoeff() > 0) worst = std::max(worst, inverse.maxCoeff() / inverse.minCoeff());
  }
  rounding_ = std::numeric_limits<Real>::epsilon() * (1e4 + 100 * worst);
}

Real Ledger::energy() const {
  Real sum = 0;
  for (const Body* body : bodies_) {
    sum += (body->velocity.squaredNorm() / body->inverse_mass + body->angular_velocity.dot(spin_momentum(*body))) / 2;
  }
  return sum;
}

namespace {

/// The part of JV that no impulse changes: a fixed body that has a velocity is a conveyor or a crank, and does work.
Real speed_of_immovable(const Row& row) {
  Real speed = 0;
  if (!row.a->movable()) speed -= row.n.dot(row.a->velocity) + row.ra_n.dot(row.a->angular_velocity);
  if (!row.b->movable()) speed += row.n.dot(row.b->velocity) + row.rb_n.dot(row.b->angular_velocity);
  return speed;
}

Real larger_eigenvalue(const Rows& rows, std::size_t tangent) {
  return TangentBlock(rows[tangent], rows[tangent + 1]).larger_eigenvalue();
}

}  // namespace

void Ledger::remember(const Rows& rows) {
  impulses_.resize(rows.size());
  for (std::size_t i = 0; i < rows.size(); ++i) impulses_[i] = rows[i].impulse;
}

void Ledger::open(const Rows& rows) {
  gather(rows);
  opening_ = now_ = energy();
  returned_ = 0;
  if (!rows.empty()) ++account.solves;
}

void Ledger::started(const Rows& rows) {
  remember(rows);
  const Real before = now_;
  now_ = energy();
  const Real gained = now_ - before, size = std::max(now_, before);
  if (gained <= rounding_ * size) return;
  ++account.started_above;
  account.most_started = std::max(account.most_started, gained / size);
}

void Ledger::guess_scaled(const Rows& rows) {
  const Real before = now_, after = energy();
  Real f = after - before, size = std::max(before, after);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const Row& row = rows[i];
    const Real fed = -row.bias * row.impulse, stored = softness_of(i) * row.impulse * row.impulse / 2;
    const Real driven = -row.impulse * speed_of_immovable(row);
    f += stored - fed - driven;
    // The whole guess acted before it was scaled: every sum knows it to its rounding.
    size +=
        std::abs(guess[i]) * (std::abs(row.bias) + std::abs(row.speed()) + std::abs(guess[i]) / row.effective_mass) +
        std::abs(driven);
  }
  if (account.broken.empty() && !(f <= rounding_ * size)) {
    account.broken = fmt::format("the scaled guess raised f to {:.6g} J (rounding {:.3g} J)", f, rounding_ * size);
  }
}

void Ledger::reopened(const Rows& rows) {
  remember(rows);
  now_ = energy();
}

void Ledger::normals_swept(const Rows& rows) {
  balance("normals", rows, 0, normals);
}

void Ledger::impacts_swept(const Rows& rows) {
  balance("normals, repeated,", rows, 0, normals, true);
}

bool Ledger::bounds_shrunk(const Rows& rows) const {
  for (std::size_t i = 0; i < friction.size(); ++i) {
    const std::size_t tangent = normals + 2 * i;
    const Real bound = friction[i] * rows[rows[tangent].owner].impulse;
    const Real one = std::abs(impulses_[tangent]), two = std::abs(impulses_[tangent + 1]);
    if ((cone ? std::hypot(one, two) : std::max(one, two)) > bound) return true;
  }
  return false;
}

void Ledger::tangents_swept(const Rows& rows) {
  if (!bounds_shrunk(rows)) return balance("tangents", rows, normals, rows.size());
  const Real before = now_;
  now_ = energy();
  returned_ += std::max(Real(0), now_ - before);
  remember(rows);
}

void Ledger::balance(const char* what, const Rows& rows, std::size_t begin, std::size_t end, bool repeated) {
  const Real before = now_;
  now_ = energy();
  Real allowed = 0, size = std::max(before, now_);
  for (std::size_t i = begin; i < end; ++i) {
    const Row& row = rows[i];
    const Real old = impulses_[i], change = row.impulse - old;
    const Real fed = -row.bias * change;
    const Real stored = softness_of(i) * (row.impulse + old) * change / 2;
    const Real k = cone && begin > 0 ? larger_eigenvalue(rows, begin + (i - begin) / 2 * 2) : 1 / row.effective_mass;
    const Real paid = change * change * k / 2;
    const Real driven = -change * speed_of_immovable(row);
    allowed += fed - stored - (repeated ? 0 : paid) + driven;
    // `wanted` is the sum, less what is too much: it knows the change only to the rounding of the sum.
    size += std::abs(fed) + std::abs(stored) + paid + std::abs(change * row.speed()) + std::abs(driven) +
            std::abs(change) * (std::abs(old) + std::abs(row.impulse)) / row.effective_mass;
    impulses_[i] = row.impulse;
  }
  if (account.broken.empty() && !(now_ - before <= allowed + rounding_ * size)) {
    account.broken =
        fmt::format("a sweep over the {} changed T by {:.6g} J where at most {:.6g} J is allowed (rounding {:.3g} J)",
                    what, now_ - before, allowed, rounding_ * size);
  }
}

void Ledger::finished(const Rows& rows) {
  Real fed = 0;
  for (std::size_t i = 0; i < normals; ++i) {
    fed += -rows[i].bias * rows[i].impulse - softness_of(i) * rows[i].impulse * rows[i].impulse / 2;
  }
  for (const Row& row : rows) fed -= row.impulse * speed_of_immovable(row);
  const Real size = std::max(opening_, now_), above = now_ - opening_ - fed;
  if (returned_ > rounding_ * size) {
    ++account.returned;
    account.most_returned = std::max(account.most_returned, returned_ / size);
  }
  if (above > rounding_ * (size + std::abs(fed))) {
    ++account.ended_above;
    account.most_above = std::max(account.most_above, above / size);
  }
}

}  // namespace pushback
