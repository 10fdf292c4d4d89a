/// Newton's method for a handful of contacts: the same equation f = 0 as that of proximal_newton.h, in matrices whose size has a
/// bound, so that nothing is allocated.
#pragma once

#include "pushback/chapters/01_velocity_constraint/row.h"
#include "pushback/engine/direct/contact_problem.h"

namespace pushback {

struct SmallContactProblem {
  static constexpr int most_contacts = 8;  ///< contacts: two boxes on each other on the ground
  template <int Columns, int MostColumns>
  using Dense = Eigen::Matrix<double, Eigen::Dynamic, Columns, Eigen::ColMajor, 3 * most_contacts, MostColumns>;
  using Matrix = Dense<Eigen::Dynamic, 3 * most_contacts>;
  using Impulses = Dense<1, 1>;

  Matrix w;     ///< 1/kg
  Impulses q;   ///< m/s
  Impulses mu;  ///< one a contact
};

/// W of rows as problem_of has it, for at most SmallContactProblem::most_contacts contacts: `places` says where each row stands there.
SmallContactProblem::Matrix small_matrix_of(const Rows& rows, const std::vector<Eigen::Index>& places);

/// Whether r, which is where it starts, has become a solution to `tolerance` of relative_residual. If not, r is as it was.
///
/// Each step solves (df_dr + df_du (W + p)) dr = -f with a p that falls to almost nothing: the proximal term of one round a step.
bool solve_small(const SmallContactProblem& problem, SmallContactProblem::Impulses& r, double tolerance);

}  // namespace pushback
