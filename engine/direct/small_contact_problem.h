/// Newton's method for a few contacts, with the equation f = 0 of proximal_newton.h. The matrices have a maximum size, so
/// they need no memory from the heap.
#pragma once

#include "pushback/chapters/01_velocity_constraint/row.h"
#include "pushback/engine/direct/contact_problem.h"

namespace pushback {

struct SmallContactProblem {
  static constexpr int most_contacts = 8;  ///< enough for two boxes on top of each other on the ground
  template <int Columns, int MostColumns>
  using Dense = Eigen::Matrix<double, Eigen::Dynamic, Columns, Eigen::ColMajor, 3 * most_contacts, MostColumns>;
  using Matrix = Dense<Eigen::Dynamic, 3 * most_contacts>;
  using Impulses = Dense<1, 1>;

  Matrix w;     ///< 1/kg
  Impulses q;   ///< m/s
  Impulses mu;  ///< of each contact
};

/// W in the order of problem_of, for at most `most_contacts` contacts. `places`: the index of each row in the problem.
SmallContactProblem::Matrix small_matrix_of(const Rows& rows, const std::vector<Eigen::Index>& places);

/// Starts from r, and returns whether r has become a solution within `tolerance` of relative_residual. If not, r is unchanged.
///
/// Each step solves (df_dr + df_du (W + p)) dr = -f. The proximal term p of proximal_newton.h decreases in each step to almost
/// 0.
bool solve_small(const SmallContactProblem& problem, SmallContactProblem::Impulses& r, double tolerance);

}  // namespace pushback
