/// The linear systems of smoothed Newton steps, (W + D) x = b. D has a 3 x 3 block for each contact, which is not symmetric.
///
/// If only W is known, the matrix has 3 rows per contact. If B with W = B B^T is known (factor_of), the matrix has 6 rows per
/// body instead, however many contacts a body has, and far less fill:
///
///   (I + B^T D^-1 B) v = B^T D^-1 b,   x = D^-1 (b - B v)            Sherman, Morrison, Woodbury
#pragma once

#include <memory>
#include <vector>

#include "pushback/common/collision/contact.h"
#include "pushback/engine/direct/contact_problem.h"

namespace pushback {

class World;

/// B, 3 rows per contact and 6 columns per body, in the order of problem_of(world). Each row is J M^-1/2, so W = B B^T.
SparseMatrix factor_of(World& world, const Contacts& contacts);
/// The same for all contacts of the world.
SparseMatrix factor_of(World& world);

/// A block of D and its inverse. The caller computes both, because d is nearly singular if the contact sticks, so a numerical
/// inverse of d would be inaccurate.
struct DiagonalBlock {
  Eigen::Matrix3d d, inverse;
};

class NewtonSystem {
 public:
  /// Analyzes the sparsity pattern, which stays the same. If `b` is empty, the matrix has 3 rows per contact.
  NewtonSystem(const SparseMatrix& w, const SparseMatrix& b);
  ~NewtonSystem();
  NewtonSystem(const NewtonSystem&) = delete;
  NewtonSystem& operator=(const NewtonSystem&) = delete;
  /// Returns false if the matrix is singular.
  bool factorize(const std::vector<DiagonalBlock>& blocks);
  Vector solve(const Vector& b) const;

  double entries = 0;  ///< numbers in the matrix
  double fill = 0;     ///< numbers in its factors L and U
  double work = 0;     ///< multiplications so far, as if all columns of L and all rows of U were equally long

 private:
  class Factors;
  class BetweenContacts;
  class BetweenBodies;
  struct Factored;  // one of the two matrices, and its factors
  std::unique_ptr<Factored> factored_;
};

}  // namespace pushback
