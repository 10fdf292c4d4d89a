#include "pushback/tools/measure/hard_cases/ledger.h"

#include <fmt/format.h>

#include <algorithm>

#include "pushback/common/world/measure.h"

namespace pushback {

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

void Ledger::open(const Rows& rows) {
  gather(rows);
  go_on_from(rows);
}

void Ledger::go_on_from(const Rows& rows) {
  impulses_.clear();
  for (const Row& row : rows) impulses_.push_back(row.impulse);
  now_ = energy();
}

void Ledger::normals_swept(const Rows& rows) {
  balance("normals", rows, 0, normals);
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
  if (bounds_shrunk(rows)) go_on_from(rows);
  else balance("tangents", rows, normals, rows.size());
}

void Ledger::balance(const char* what, const Rows& rows, std::size_t begin, std::size_t end) {
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
    allowed += fed - stored - (repeated && begin == 0 ? 0 : paid) + driven;
    // `wanted` is the sum, less what is too much: it knows the change only to the rounding of the sum.
    size += std::abs(fed) + std::abs(stored) + paid + std::abs(change * row.speed()) + std::abs(driven) +
            std::abs(change) * (std::abs(old) + std::abs(row.impulse)) / row.effective_mass;
    impulses_[i] = row.impulse;
  }
  if (broken.empty() && !(now_ - before <= allowed + rounding_ * size)) {
    broken =
        fmt::format("a sweep over the {} changed T by {:.6g} J where at most {:.6g} J is allowed (rounding {:.3g} J)",
                    what, now_ - before, allowed, rounding_ * size);
  }
}

}  // namespace pushback
