#include "pushback/engine/direct/newton_system.h"

#include <Eigen/Cholesky>
#include <Eigen/SparseLU>
#include <algorithm>
#include <cmath>
#include <variant>

#include "pushback/chapters/01_velocity_constraint/row.h"

namespace pushback {

namespace {

using Eigen::Index;
using Eigen::Matrix3d;
using Columns = Eigen::SparseMatrix<double>;

}  // namespace

/// L and U. The pattern is symmetric, and the diagonal nearly always has good pivots, so an order for the symmetric pattern
/// fills least.
class NewtonSystem::Factors {
 public:
  Factors() {
    lu_.isSymmetric(true);
    lu_.setPivotThreshold(1e-3);
  }
  /// Returns false if the matrix is singular.
  bool factorize(const Columns& matrix) {
    if (!analyzed_) lu_.analyzePattern(matrix);
    analyzed_ = true;
    lu_.factorize(matrix);
    return lu_.info() == Eigen::Success;
  }
  Vector solve(const Vector& b) const { return lu_.solve(b); }
  double in_l() const { return static_cast<double>(lu_.nnzL()); }
  double in_u() const { return static_cast<double>(lu_.nnzU()); }

 private:
  Eigen::SparseLU<Columns, Eigen::AMDOrdering<int>> lu_;
  bool analyzed_ = false;
};

/// W + D, with 3 rows per contact.
class NewtonSystem::BetweenContacts {
 public:
  explicit BetweenContacts(const SparseMatrix& w) : w_(w) {
    std::vector<Eigen::Triplet<double>> all_nine;  // of each diagonal block, whatever W has there
    for (int i = 0; i < static_cast<int>(w.rows()); ++i)
      for (int k = 0; k < 3; ++k) all_nine.emplace_back(i, i / 3 * 3 + k, 0.0);
    Columns diagonal(w.rows(), w.cols());
    diagonal.setFromTriplets(all_nine.begin(), all_nine.end());
    w_ = w_ + diagonal;
  }
  Columns matrix_for(const std::vector<DiagonalBlock>& blocks) const {
    Columns matrix = w_;
    for (std::size_t c = 0; c < blocks.size(); ++c)
      for (Index i = 0; i < 3; ++i)
        for (Index j = 0; j < 3; ++j)
          matrix.coeffRef(3 * static_cast<Index>(c) + i, 3 * static_cast<Index>(c) + j) += blocks[c].d(i, j);
    return matrix;
  }
  static Vector solve(const Factors& factors, const Vector& b) { return factors.solve(b); }

 private:
  Columns w_;
};

/// I + B^T D^-1 B, with 6 rows per body.
class NewtonSystem::BetweenBodies {
 public:
  explicit BetweenBodies(const SparseMatrix& b) : b_(b), parts_(static_cast<std::size_t>(b.rows() / 3)) {
    std::vector<std::vector<Index>> neighbours(static_cast<std::size_t>(b.cols() / 6));
    for (std::size_t body = 0; body < neighbours.size(); ++body) neighbours[body] = {static_cast<Index>(body)};
    for (std::size_t c = 0; c < parts_.size(); ++c) {
      for (Index k = 0; k < 3; ++k)
        for (SparseMatrix::InnerIterator it(b, 3 * static_cast<Index>(c) + k); it; ++it)
          part_of(parts_[c], it.col() / 6).rows(k, it.col() % 6) = it.value();
      for (const Part& one : parts_[c])
        for (const Part& other : parts_[c]) neighbours[static_cast<std::size_t>(other.body)].push_back(one.body);
    }
    reserve(neighbours);
  }
  const Columns& matrix_for(const std::vector<DiagonalBlock>& blocks) {
    matrix_.coeffs().setZero();
    for (Index i = 0; i < matrix_.cols(); ++i) matrix_.coeffRef(i, i) = 1;
    inverses_.clear();
    for (std::size_t c = 0; c < blocks.size(); ++c) {
      inverses_.push_back(blocks[c].inverse);
      for (const Part& one : parts_[c])
        for (const Part& other : parts_[c]) add(one, other, one.rows.transpose() * blocks[c].inverse * other.rows);
    }
    return matrix_;
  }
  Vector solve(const Factors& factors, const Vector& b) const {
    const Vector v = factors.solve(b_.transpose() * divided(b));
    return divided(b - b_ * v);
  }

 private:
  struct Part {  // of B: the three rows of a contact, the six columns of a body
    Index body;
    Eigen::Matrix<double, 3, 6> rows = Eigen::Matrix<double, 3, 6>::Zero();
  };
  static Part& part_of(std::vector<Part>& parts, Index body) {
    for (Part& part : parts)
      if (part.body == body) return part;
    return parts.emplace_back(Part{body});
  }
  void reserve(std::vector<std::vector<Index>>& neighbours) {
    matrix_.resize(b_.cols(), b_.cols());
    std::vector<Eigen::Triplet<double>> pattern;
    for (std::size_t body = 0; body < neighbours.size(); ++body) {
      std::vector<Index>& those = neighbours[body];
      std::sort(those.begin(), those.end());
      those.erase(std::unique(those.begin(), those.end()), those.end());
      for (const Index other : those)
        for (int i = 0; i < 6; ++i)
          for (int j = 0; j < 6; ++j)
            pattern.emplace_back(static_cast<int>(6 * other) + i, 6 * static_cast<int>(body) + j, 0.0);
    }
    matrix_.setFromTriplets(pattern.begin(), pattern.end());
  }
  /// The six rows of a body follow each other in each column.
  void add(const Part& row, const Part& column, const Eigen::Matrix<double, 6, 6>& block) {
    for (Index j = 0; j < 6; ++j) {
      const int* begin = matrix_.innerIndexPtr() + matrix_.outerIndexPtr()[6 * column.body + j];
      const int* end = matrix_.innerIndexPtr() + matrix_.outerIndexPtr()[6 * column.body + j + 1];
      const Index place = std::lower_bound(begin, end, static_cast<int>(6 * row.body)) - matrix_.innerIndexPtr();
      for (Index i = 0; i < 6; ++i) matrix_.valuePtr()[place + i] += block(i, j);
    }
  }
  /// D^-1 b.
  Vector divided(const Vector& b) const {
    Vector x(b.size());
    for (std::size_t c = 0; c < inverses_.size(); ++c)
      x.segment<3>(3 * static_cast<Index>(c)) = inverses_[c] * b.segment<3>(3 * static_cast<Index>(c));
    return x;
  }

  SparseMatrix b_;
  std::vector<std::vector<Part>> parts_;
  std::vector<Matrix3d> inverses_;
  Columns matrix_;
};

struct NewtonSystem::Factored {
  using System = std::variant<BetweenContacts, BetweenBodies>;

  Factored(const SparseMatrix& w, const SparseMatrix& b)
      : system(b.rows() > 0 ? System(BetweenBodies(b)) : System(BetweenContacts(w))) {}

  System system;
  Factors factors;
};

NewtonSystem::NewtonSystem(const SparseMatrix& w, const SparseMatrix& b)
    : factored_(std::make_unique<Factored>(w, b)) {}
NewtonSystem::~NewtonSystem() = default;

bool NewtonSystem::factorize(const std::vector<DiagonalBlock>& blocks) {
  return std::visit(
      [&](auto& system) {
        const Columns& matrix = system.matrix_for(blocks);
        Factors& factors = factored_->factors;
        if (!factors.factorize(matrix)) return false;
        entries = static_cast<double>(matrix.nonZeros());
        fill = factors.in_l() + factors.in_u();
        work += factors.in_l() * factors.in_u() / static_cast<double>(matrix.rows());
        return true;
      },
      factored_->system);
}

Vector NewtonSystem::solve(const Vector& b) const {
  return std::visit([&](const auto& system) { return system.solve(factored_->factors, b); }, factored_->system);
}

SparseMatrix factor_of(World& world, const Contacts& contacts) {
  std::vector<Matrix3d> root(world.bodies.size());  // R R^T = I^-1
  for (const Body& body : world.bodies)
    if (body.movable())
      root[static_cast<std::size_t>(body.index)] = Eigen::LLT<Matrix3d>(body.inverse_inertia.cast<double>()).matrixL();
  std::vector<Eigen::Triplet<double>> entries;
  int place = 0;
  const auto add = [&](const Body& body, const Vec3& linear, const Vec3& angular) {
    if (!body.movable()) return;
    const Eigen::Vector3d turned = root[static_cast<std::size_t>(body.index)].transpose() * angular.cast<double>();
    for (int i = 0; i < 3; ++i) {
      entries.emplace_back(place, 6 * static_cast<int>(body.index) + i,
                           std::sqrt(static_cast<double>(body.inverse_mass)) * static_cast<double>(linear[i]));
      entries.emplace_back(place, 6 * static_cast<int>(body.index) + 3 + i, turned[i]);
    }
  };
  for (std::size_t c = 0; c < contacts.size(); ++c) {
    const Tangents tangents = tangents_of(contacts[c].normal);
    for (const Vec3& direction : {contacts[c].normal, tangents.tangent1, tangents.tangent2}) {
      const Row row(world, contacts[c], direction, c);
      add(*row.a, -row.n, -row.ra_n);
      add(*row.b, row.n, row.rb_n);
      ++place;
    }
  }
  SparseMatrix b(3 * static_cast<Index>(contacts.size()), 6 * static_cast<Index>(world.bodies.size()));
  b.setFromTriplets(entries.begin(), entries.end());
  return b;
}

SparseMatrix factor_of(World& world) {
  return factor_of(world, world.contacts);
}

}  // namespace pushback
