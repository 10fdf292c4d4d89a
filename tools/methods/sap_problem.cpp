#include "pushback/tools/methods/sap_problem.h"

#include <tuple>

namespace pushback {

using Eigen::Index;

void SapProblem::clear() {
  contacts.clear();
  rows.clear();
  masses_.clear();
  free_.resize(0);
}

int SapProblem::add(const Mat6& mass, const Vec6& free) {
  masses_.push_back(mass);
  free_.conservativeResize(6 * static_cast<Index>(masses_.size()));
  free_.tail<6>() = free;
  return static_cast<int>(masses_.size()) - 1;
}

SapProblem::Vector SapProblem::times_mass(const Vector& v) const {
  Vector p(v.size());
  for (std::size_t i = 0; i < masses_.size(); ++i) {
    const Index at = 6 * static_cast<Index>(i);
    p.segment<6>(at) = masses_[i] * v.segment<6>(at);
  }
  return p;
}

SapProblem::Vector SapProblem::pushes(const Vector& v) const {
  Vector sum = Vector::Zero(v.size());
  const auto of = [&](const auto& bonds) {
    for (const auto& bond : bonds) {
      const auto impulse = bond.law.at(bond.along(v) + bond.rest).impulse;
      each_body(bond, [&](int body, const auto& j) { sum.segment<6>(6 * Index{body}) += j.transpose() * impulse; });
    }
  };
  of(contacts);
  of(rows);
  return sum;
}

double SapProblem::cost(const Vector& v) const {
  double sum = (v - free_).dot(times_mass(v - free_)) / 2;
  const auto of = [&](const auto& bonds) {
    for (const auto& bond : bonds) sum += bond.law.at(bond.along(v) + bond.rest).cost;
  };
  of(contacts);
  of(rows);
  return sum;
}

SapProblem::Vector SapProblem::gradient(const Vector& v) const {
  return times_mass(v - free_) - pushes(v);
}

bool SapProblem::is_there(const Vector& v, Vector& slope, double tolerance) const {
  const Vector pushed = pushes(v);
  slope = times_mass(v - free_) - pushed;
  Vector scale(v.size());
  for (std::size_t i = 0; i < masses_.size(); ++i)
    scale.segment<6>(6 * static_cast<Index>(i)) = masses_[i].diagonal().cwiseSqrt().cwiseInverse();
  const double largest = std::max(scale.cwiseProduct(times_mass(v)).norm(), scale.cwiseProduct(pushed).norm());
  return scale.cwiseProduct(slope).norm() <= tolerance * largest;
}

void SapProblem::lay_out() {
  std::vector<std::vector<int>> below(masses_.size());  // of each body, those of a larger place that it is tied to
  for (std::size_t i = 0; i < below.size(); ++i) below[i] = {static_cast<int>(i)};
  const auto each_pair = [](auto& bonds, const auto& visit) {
    for (auto& bond : bonds)
      if (bond.a != nothing_moves && bond.b != nothing_moves)
        visit(bond, static_cast<std::size_t>(std::min(bond.a, bond.b)), std::max(bond.a, bond.b));
  };
  const auto tie = [&](auto&, std::size_t low, int high) { below[low].push_back(high); };
  each_pair(contacts, tie);
  each_pair(rows, tie);
  diagonal_.clear();
  stride_.clear();
  Index count = 0;
  for (std::vector<int>& bodies : below) {
    std::sort(bodies.begin(), bodies.end());
    bodies.erase(std::unique(bodies.begin(), bodies.end()), bodies.end());
    diagonal_.push_back(count);
    stride_.push_back(6 * std::ssize(bodies));
    count += 6 * stride_.back();
  }
  h_.resize(free_.size(), free_.size());
  h_.resizeNonZeros(count);
  for (std::size_t i = 0; i < below.size(); ++i) {
    for (Index column = 0; column < 6; ++column) {
      Index at = diagonal_[i] + column * stride_[i];
      h_.outerIndexPtr()[6 * static_cast<Index>(i) + column] = static_cast<int>(at);
      for (const int body : below[i])
        for (int row = 0; row < 6; ++row) h_.innerIndexPtr()[at++] = 6 * body + row;
    }
  }
  h_.outerIndexPtr()[free_.size()] = static_cast<int>(count);
  const auto find = [&](auto& bond, std::size_t low, int high) {
    const auto place = std::lower_bound(below[low].begin(), below[low].end(), high) - below[low].begin();
    bond.block = diagonal_[low] + 6 * place;
    bond.stride = stride_[low];
  };
  each_pair(contacts, find);
  each_pair(rows, find);
}

void SapProblem::assemble(const Vector& v) {
  const auto block = [&](Index at, Index stride) {
    return Eigen::Map<Mat6, 0, Eigen::OuterStride<>>(h_.valuePtr() + at, Eigen::OuterStride<>(stride));
  };
  h_.coeffs().setZero();
  for (std::size_t i = 0; i < masses_.size(); ++i) block(diagonal_[i], stride_[i]) = masses_[i];
  const auto of = [&](auto& bonds) {
    for (auto& bond : bonds) {
      bond.u = bond.along(v) + bond.rest;
      const auto g = bond.law.at(bond.u).slope;
      each_body(bond, [&](int body, const auto& j) {
        const auto i = static_cast<std::size_t>(body);
        block(diagonal_[i], stride_[i]) += j.transpose() * (g * j).eval();
      });
      if (bond.a == nothing_moves || bond.b == nothing_moves) continue;
      const auto& [high, low] = bond.b > bond.a ? std::tie(bond.j_b, bond.j_a) : std::tie(bond.j_a, bond.j_b);
      block(bond.block, bond.stride) += high.transpose() * (g * low).eval();
    }
  };
  of(contacts);
  of(rows);
}

Eigen::MatrixXd SapProblem::hessian(const Vector& v) {
  lay_out();
  assemble(v);
  return h_.selfadjointView<Eigen::Lower>() * Eigen::MatrixXd::Identity(v.size(), v.size());
}

double SapProblem::best_part(const Vector& v, const Vector& change, const Vector& slope) {
  const auto prepare = [&](auto& bonds) {
    for (auto& bond : bonds) bond.change = bond.along(change);
  };
  prepare(contacts);
  prepare(rows);
  const Vector heavy = times_mass(change);
  const double start = heavy.dot(v - free_), bend = heavy.dot(change);
  double first = 0, second = 0;  // l' and l'' along the line
  const auto look = [&](double part) {
    first = start + part * bend;
    second = bend;
    const auto of = [&](const auto& bonds) {
      for (const auto& bond : bonds) {
        const auto answer = bond.law.at(bond.u + part * bond.change);
        first -= answer.impulse.dot(bond.change);
        second += bond.change.dot(answer.slope * bond.change);
      }
    };
    of(contacts);
    of(rows);
  };
  const double enough = 1e-4 * std::abs(slope.dot(change));
  double low = 0, high = 1;
  look(high);
  while (first < -enough) {  // l is convex, so l' only grows
    low = high;
    high *= 2;
    look(high);
  }
  double part = high;
  for (int round = 0; round < 100 && std::abs(first) > enough; ++round) {
    (first < 0 ? low : high) = part;
    const double next = part - first / second;
    part = next > low && next < high ? next : (low + high) / 2;
    look(part);
  }
  return part;
}

}  // namespace pushback
