#include "pushback/engine/direct/row_matrix.h"

#include <algorithm>
#include <unordered_map>

namespace pushback {

using Eigen::Index;

namespace {

/// The contribution of one body to J_i (M^-1 J_j^T).
double part(const Row& i, const Row& j, const Body* body) {
  const Vec3& dv = j.a == body ? j.dva : j.dvb;
  const Vec3& dw = j.a == body ? j.dwa : j.dwb;
  const Real push = i.a == body ? -i.n.dot(dv) - i.ra_n.dot(dw) : i.n.dot(dv) + i.rb_n.dot(dw);
  return static_cast<double>(push);
}

}  // namespace

SparseMatrix matrix_of(const Rows& rows, const std::vector<Real>& softness) {
  std::unordered_map<const Body*, std::vector<int>> touching;  // never iterated, because its order depends on addresses
  for (std::size_t i = 0; i < rows.size(); ++i)
    for (const Body* body : {rows[i].a, rows[i].b})
      if (body->movable()) touching[body].push_back(static_cast<int>(i));
  std::vector<Eigen::Triplet<double>> entries;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const int row = static_cast<int>(i);
    entries.emplace_back(row, row, softness.empty() ? 0 : static_cast<double>(softness[i]));
    for (const Body* body : {rows[i].a, rows[i].b}) {
      if (!body->movable()) continue;
      for (const int j : touching[body])
        entries.emplace_back(row, j, part(rows[i], rows[static_cast<std::size_t>(j)], body));
    }
  }
  SparseMatrix a(static_cast<Index>(rows.size()), static_cast<Index>(rows.size()));
  a.setFromTriplets(entries.begin(), entries.end());
  return a;
}

Vector speeds_of(const Rows& rows) {
  Vector b(static_cast<Index>(rows.size()));
  for (std::size_t i = 0; i < rows.size(); ++i)
    b[static_cast<Index>(i)] = static_cast<double>(rows[i].speed() + rows[i].bias);
  return b;
}

void project_row(const SparseMatrix& a, const Vector& b, Index i, double lo, double hi, Vector& impulses) {
  double speed = b[i], own = 0;
  for (SparseMatrix::InnerIterator it(a, i); it; ++it) {
    speed += it.value() * impulses[it.col()];
    if (it.col() == i) own = it.value();
  }
  impulses[i] = std::clamp(impulses[i] - speed / own, lo, hi);
}

ContactProblem problem_of(World& world) {
  const Contacts& contacts = world.contacts;
  Rows rows;
  for (std::size_t i = 0; i < contacts.size(); ++i) rows.emplace_back(world, contacts[i], contacts[i].normal, i);
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    const Tangents tangents = tangents_of(contacts[i].normal);
    rows.emplace_back(world, contacts[i], tangents.tangent1, i);
    rows.emplace_back(world, contacts[i], tangents.tangent2, i);
  }
  return problem_of(contacts, rows);
}

ContactProblem problem_of(const Contacts& contacts, const Rows& rows) {
  std::vector<std::vector<Row>> tangents(contacts.size());
  for (std::size_t i = contacts.size(); i < rows.size(); ++i) tangents[rows[i].owner].push_back(rows[i]);
  Rows in_threes;
  ContactProblem problem;
  problem.mu = Vector::Zero(static_cast<Index>(contacts.size()));
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    in_threes.push_back(rows[i]);
    if (tangents[i].empty()) {
      const Tangents two = tangents_of(contacts[i].normal);
      Body &a = *rows[i].a, &b = *rows[i].b;
      for (const Vec3& tangent : {two.tangent1, two.tangent2})
        in_threes.emplace_back(a, b, Jacobian::along(tangent, a, b, contacts[i].point), i);
    } else {
      problem.mu[static_cast<Index>(i)] = static_cast<double>(contacts[i].friction);
      in_threes.insert(in_threes.end(), tangents[i].begin(), tangents[i].end());
    }
  }
  problem.w = matrix_of(in_threes);
  problem.q = speeds_of(in_threes);
  return problem;
}

std::vector<Index> places_in_problem(const Contacts& contacts, const Rows& rows) {
  std::vector<Index> next, places;  // next: the place of the contact's next row
  for (std::size_t i = 0; i < contacts.size(); ++i) next.push_back(3 * static_cast<Index>(i));
  for (const Row& row : rows) places.push_back(next[row.owner]++);
  return places;
}

}  // namespace pushback
