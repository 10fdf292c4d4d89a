/// The law of one contact with all three of its numbers, solved exactly: 3 x 3.
#pragma once

#include "pushback/chapters/08_friction_cone/friction_cone.h"
#include "pushback/tools/methods/visiting_solver.h"

namespace pushback {

/// Signorini's condition and Coulomb's law of one contact, as if it were alone. r = (r_n, r_t), u = W r + q likewise:
///
///   parts    r = 0                 where q_n >= 0
///   sticks   W r + q = 0           where |r_t| <= mu r_n
///   slides   u_n = 0,  |r_t| = mu r_n,  u_t = -s r_t,  s > 0
///
/// With u_n = 0 solved for r_n, what slides has   (W' + s) r_t = -q',   W' = W_tt - W_tn W_nt / W_nn,   q' = q_t - W_tn q_n / W_nn.
/// In the axes of W', which are found once, |r_t| - mu r_n is a function of s alone; it is above 0 at s = 0, and below 0 as s grows.
/// It is a quartic in s (O. Bonnefon, G. Daviet, "Quartic formulation of Coulomb 3D frictional contact", INRIA 2011); here a
/// bracketed Newton iteration finds its root. Where q_n < 0 there is one; several with strong coupling, of which one is taken.
class ExactContact {
 public:
  /// `w`: 1/kg, symmetric, positive definite. `mu`: 0 or more.
  ExactContact(const Mat3& w, Real mu);
  /// r, N s; `q`: u without it, m/s.
  Vec3 solve(const Vec3& q) const;
  const Mat3& w() const { return w_; }

 private:
  Mat3 w_, inverse_;
  Real mu_;
  Eigen::Matrix<Real, 2, 2> axes_;             // columns: of W'
  Eigen::Matrix<Real, 2, 1> stiff_, coupled_;  // W' along its axes; W_nt along them
};

/// Instead of FrictionCone, in a VisitingSolver. A visit gives a contact new impulses along its normal and both tangents at once, so
/// that its law holds where it stands: a sweep of non-linear block Gauss-Seidel.
///   F. Jourdan, P. Alart, M. Jean, "A Gauss-Seidel like algorithm to solve frictional contact problems", 1998
struct WholeContacts : FrictionCone {
  void build(StepContext& step);
  void visit(StepContext& step, std::size_t i);
  void sweep(StepContext&) {}  // the visits have solved the tangents

 private:
  static constexpr std::size_t none = std::numeric_limits<std::size_t>::max();

  std::vector<ExactContact> contacts_;  // of those that can rub
  std::vector<std::size_t> place_;      // of each contact in contacts_, or none
};

}  // namespace pushback
