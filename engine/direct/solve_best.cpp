#include "pushback/engine/direct/solve_best.h"

#include <numeric>
#include <random>

#include "pushback/engine/direct/conjugate_sweeper.h"
#include "pushback/engine/direct/proximal_newton.h"

namespace pushback {

namespace {

using Eigen::Index;

/// The contacts in another order: contact c is contact order[c] of the original.
using Order = std::vector<Index>;

Order order_of_round(int round, Index contacts) {
  Order order(static_cast<std::size_t>(contacts));
  std::iota(order.begin(), order.end(), Index(0));
  std::mt19937 random(static_cast<unsigned>(round));
  if (round == 1) std::reverse(order.begin(), order.end());
  else if (round > 1)  // by hand: what std::shuffle does differs from library to library
    for (std::size_t i = order.size(); i > 1; --i) std::swap(order[i - 1], order[random() % i]);
  return order;
}

ContactProblem reordered(const ContactProblem& problem, const Order& order) {
  std::vector<Index> place(order.size());
  for (std::size_t i = 0; i < order.size(); ++i) place[static_cast<std::size_t>(order[i])] = static_cast<Index>(i);
  const auto moved = [&](Index row) { return 3 * place[static_cast<std::size_t>(row / 3)] + row % 3; };
  ContactProblem other = problem;
  std::vector<Eigen::Triplet<double>> entries;
  for (Index row = 0; row < problem.w.rows(); ++row) {
    for (SparseMatrix::InnerIterator it(problem.w, row); it; ++it)
      entries.emplace_back(static_cast<int>(moved(row)), static_cast<int>(moved(it.col())), it.value());
    other.q[moved(row)] = problem.q[row];
    other.mu[moved(row) / 3] = problem.mu[row / 3];
  }
  other.w.setFromTriplets(entries.begin(), entries.end());
  return other;
}

}  // namespace

Solution solve_best(const ContactProblem& problem, const SolveLimits& limits) {
  Solution best;
  best.r = Vector::Zero(problem.q.size());
  best.residual = relative_residual(problem, best.r);
  const double unit = problem.q.norm(), of_a_sweep = static_cast<double>(problem.w.nonZeros());
  const auto spent = [&] { return best.work >= limits.work; };
  const auto enough = [&] {  // or as good as r can be told from its neighbours
    const double rounding = unit > 0 ? std::numeric_limits<double>::epsilon() * best.r.norm() / unit : 0;
    return best.residual <= std::max(limits.tolerance, rounding) || spent();
  };

  for (int round = 0; round < limits.rounds && !enough(); ++round) {
    const Order order = order_of_round(round, problem.contacts());
    const ContactProblem other = reordered(problem, order);
    const auto keep_if_better = [&](const Vector& r) {
      const double residual = relative_residual(other, r);
      if (!(residual < best.residual)) return;
      best.residual = residual;
      for (std::size_t i = 0; i < order.size(); ++i)
        best.r.segment<3>(3 * order[i]) = r.segment<3>(3 * static_cast<Index>(i));
    };
    Vector r = Vector::Zero(problem.q.size());
    ConjugateSweeper<ConeStep> sweeper(other, r);
    int done = 0;
    for (const int upto : round == 0 ? std::vector{200, 1000, 5000} : std::vector{5000, 50000}) {
      for (; done < upto && !spent(); ++done, ++best.sweeps, best.work += of_a_sweep) sweeper.sweep(r);
      if (!r.allFinite()) break;
      keep_if_better(r);
      if (enough()) break;
      Vector refined = r;
      const ProximalStats newton_work =
          solve_proximal(other, refined, {limits.tolerance, upto <= 5000 ? 30 : 400, limits.work - best.work});
      best.systems += newton_work.systems;
      best.work += newton_work.work;
      keep_if_better(refined);
      if (enough()) break;
    }
  }
  return best;
}

}  // namespace pushback
