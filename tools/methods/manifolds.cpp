#include "pushback/tools/methods/manifolds.h"

#include <Eigen/Cholesky>
#include <array>

namespace pushback {

void Manifolds::build(StepContext& step) {
  blocks_.clear();
  const Contacts& contacts = step.contacts;
  for (std::size_t i = 0; i < contacts.size();) {
    const auto same_bodies = [&](const Contact& other) {
      return other.id.body_a == contacts[i].id.body_a && other.id.body_b == contacts[i].id.body_b;
    };
    int size = 1;
    while (size < most && i + static_cast<std::size_t>(size) < contacts.size() &&
           same_bodies(contacts[i + static_cast<std::size_t>(size)]))
      ++size;
    Small<Eigen::Dynamic> w(size, size);
    for (int row = 0; row < size; ++row)
      for (int column = 0; column < size; ++column)
        w(row, column) =
            coupling(step.rows[i + static_cast<std::size_t>(row)], step.rows[i + static_cast<std::size_t>(column)]);
    const Real pull = Real(1e-6) * w.diagonal().maxCoeff();
    w.diagonal().array() += pull;
    blocks_.push_back({size, w, pull});
    for (int other = 1; other < size; ++other) blocks_.push_back({0, {}, 0});
    i += static_cast<std::size_t>(size);
  }
}

Manifolds::Small<1> Manifolds::solve(const Small<Eigen::Dynamic>& w, const Small<1>& q, const Small<1>& before) {
  const int size = static_cast<int>(q.size());
  std::array<bool, most> presses{};
  for (int i = 0; i < size; ++i) presses[static_cast<std::size_t>(i)] = before[i] > 0;
  Small<1> r = Small<1>::Zero(size);
  for (int round = 0; round < 1 << most; ++round) {
    std::array<int, most> which{};
    int count = 0;
    for (int i = 0; i < size; ++i)
      if (presses[static_cast<std::size_t>(i)]) which[static_cast<std::size_t>(count++)] = i;
    Small<Eigen::Dynamic> part(count, count);
    Small<1> wanted(count);
    for (int i = 0; i < count; ++i) {
      const int row = which[static_cast<std::size_t>(i)];
      wanted[i] = -q[row];
      for (int j = 0; j < count; ++j) part(i, j) = w(row, which[static_cast<std::size_t>(j)]);
    }
    const Small<1> solved = part.llt().solve(wanted);
    r.setZero();
    for (int i = 0; i < count; ++i) r[which[static_cast<std::size_t>(i)]] = solved[i];
    const Small<1> u = w * r + q;
    int wrong = 0;
    while (wrong < size && (presses[static_cast<std::size_t>(wrong)] ? r[wrong] >= 0 : u[wrong] >= 0)) ++wrong;
    if (wrong == size) break;
    presses[static_cast<std::size_t>(wrong)] = !presses[static_cast<std::size_t>(wrong)];
  }
  return r;
}

void Manifolds::visit(StepContext& step, std::size_t i) {
  const Block& block = blocks_[i];
  if (block.size == 0) return;
  Row* rows = &step.rows[i];
  if (block.size == 1) return rows->solve();
  Small<1> before(block.size), u(block.size);
  for (int k = 0; k < block.size; ++k) {
    before[k] = rows[k].impulse;
    u[k] = rows[k].speed() + rows[k].bias;
  }
  // u = W r + q with W = w - e: q - e r_before = u - W r_before - e r_before = u - w r_before
  const Small<1> r = solve(block.w, u - block.w * before, before);
  for (int k = 0; k < block.size; ++k) rows[k].reach(r[k]);
}

}  // namespace pushback
