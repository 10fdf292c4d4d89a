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
  each_bond(*this, [&](const auto& bond) {
    const auto impulse = bond.law.at(bond.along(v) + bond.rest).impulse;
    each_body(bond, [&](int body, const auto& j) { sum.segment<6>(6 * Index{body}) += j.transpose() * impulse; });
  });
  return sum;
}

double SapProblem::cost(const Vector& v) const {
  double sum = (v - free_).dot(times_mass(v - free_)) / 2;
  each_bond(*this, [&](const auto& bond) { sum += bond.law.at(bond.along(v) + bond.rest).cost; });
  return sum;
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

void SapProblem::assemble(const Vector& v) {
  std::vector<Eigen::Triplet<double>> entries;
  const auto add = [&](int low, int high, const Mat6& block) {
    for (int column = 0; column < 6; ++column)
      for (int row = 0; row < 6; ++row) entries.emplace_back(6 * high + row, 6 * low + column, block(row, column));
  };
  for (std::size_t i = 0; i < masses_.size(); ++i) add(static_cast<int>(i), static_cast<int>(i), masses_[i]);
  each_bond(*this, [&](auto& bond) {
    bond.u = bond.along(v) + bond.rest;
    const auto g = bond.law.at(bond.u).slope;
    each_body(bond, [&](int body, const auto& j) { add(body, body, j.transpose() * (g * j).eval()); });
    if (bond.a == nothing_moves || bond.b == nothing_moves) return;
    const auto& [high, low] = bond.b > bond.a ? std::tie(bond.j_b, bond.j_a) : std::tie(bond.j_a, bond.j_b);
    add(std::min(bond.a, bond.b), std::max(bond.a, bond.b), high.transpose() * (g * low).eval());
  });
  h_.resize(free_.size(), free_.size());
  h_.setFromTriplets(entries.begin(), entries.end());
}

int SapProblem::minimise(Vector& v, double tolerance, int most_steps) {
  Vector slope;
  Eigen::SimplicialLLT<Eigen::SparseMatrix<double>> factors;
  for (int step = 0; step < most_steps; ++step) {
    if (is_there(v, slope, tolerance)) return step;
    assemble(v);
    if (step == 0) factors.analyzePattern(h_);
    factors.factorize(h_);
    const Vector change = -factors.solve(slope);
    v += best_part(v, change, slope) * change;
  }
  return most_steps;
}

double SapProblem::best_part(const Vector& v, const Vector& change, const Vector& slope) {
  each_bond(*this, [&](auto& bond) { bond.change = bond.along(change); });
  const Vector heavy = times_mass(change);
  const double start = heavy.dot(v - free_), bend = heavy.dot(change);
  double first = 0, second = 0;  // l' and l'' along the line
  const auto look = [&](double part) {
    first = start + part * bend;
    second = bend;
    each_bond(*this, [&](const auto& bond) {
      const auto answer = bond.law.at(bond.u + part * bond.change);
      first -= answer.impulse.dot(bond.change);
      second += bond.change.dot(answer.slope * bond.change);
    });
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
