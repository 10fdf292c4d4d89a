/// The linear systems of smoothed Newton steps, (W + D) x = b: D has a 3 x 3 block for each contact, not symmetric.
///
/// Solved between contacts, 3 n rows, where only W is known. Where W = B B^T is known (factor_of), between bodies, where the
/// matrix has 6 rows a body however many contacts press on it, and far less fill:
///
///   (I + B^T D^-1 B) v = B^T D^-1 b,   x = D^-1 (b - B v)            Sherman, Morrison, Woodbury
#pragma once

#include <memory>
#include <vector>

#include "pushback/common/collision/contact.h"
#include "pushback/engine/direct/contact_problem.h"

namespace pushback {

class World;

/// B of these contacts of a world, 3 n x 6 bodies, in the order of problem_of(world): each row is J M^-1/2, so W = B B^T.
SparseMatrix factor_of(World& world, const Contacts& contacts);
/// The same of all its contacts.
SparseMatrix factor_of(World& world);

/// A block of D with its inverse, which loses nothing although D is nearly singular where contacts stick.
struct DiagonalBlock {
  Eigen::Matrix3d d, inverse;
};

class NewtonSystem {
 public:
  virtual ~NewtonSystem() = default;
  /// False where the matrix is singular.
  virtual bool factorize(const std::vector<DiagonalBlock>& blocks) = 0;
  virtual Vector solve(const Vector& b) const = 0;

  double entries = 0;  ///< numbers in the matrix
  double fill = 0;     ///< numbers in its factors L and U
  double work = 0;     ///< multiplications so far, as if all columns of L and all rows of U were equally long

 protected:
  void count(double matrix, double l, double u, double rows) {
    entries = matrix;
    fill = l + u;
    work += l * u / rows;
  }
};

/// The pattern is analyzed once. `b` may be empty: between contacts.
std::unique_ptr<NewtonSystem> make_newton_system(const SparseMatrix& w, const SparseMatrix& b);

}  // namespace pushback
