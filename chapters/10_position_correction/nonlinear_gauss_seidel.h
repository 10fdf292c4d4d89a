/// Non-linear Gauss-Seidel moves the bodies of one contact after the other apart, by a fraction of their present overlap.
#pragma once

#include "pushback/chapters/03_baumgarte/baumgarte.h"
#include "pushback/chapters/10_position_correction/correcting_solver.h"
#include "pushback/chapters/10_position_correction/displace.h"
#include "pushback/common/world/surface_points.h"

namespace pushback {

/// Replaces Baumgarte, with Slop or without. Once the bodies have moved, `rounds` passes over the contacts apply
///
///   C = (P_B - P_A) . n + allowed         P_A, P_B: the contact's points on the two surfaces, each fixed to its body
///   lambda = -beta C / K  if C < 0        K: for the present positions
///   x += M^-1 J^T lambda,  q likewise     v and w do not change
///
/// Each contact uses the positions that the contact before it has left. No sums are accumulated, so only a contact on the other
/// side of the body can undo a correction that was too large.
/// Catto, Box2D 2.4, b2ContactSolver::SolvePositionConstraints, where the method is called non-linear Gauss-Seidel.
struct NonlinearGaussSeidel : Effect, Corrects {
  Real beta = Real(0.2);   ///< 0 ... 1: the fraction of the overlap that one round removes
  Real most = Real(0.05);  ///< m; no contact corrects more in one step
  int rounds = 3;

  void check(StepContext&) {
    require_between("beta", beta, 0, 1);
    require_not_negative("most", most);
    if (rounds < 0) throw InvalidInput(fmt::format("rounds is {}: a whole number, 0 or more, is needed", rounds));
  }
  void build(CorrectingContext& step) {
    touching_.clear();
    allowed_ = 0;
    overlap_ = false;
    for (std::size_t i = 0; i < step.contacts.size(); ++i) {
      const Contact& at = step.contacts[i];
      const Row& normal = step.rows[i];
      touching_.emplace_back(*normal.a, *normal.b, at);
      allowed_ = std::max(allowed_, at.depth + normal.separation);
      overlap_ = overlap_ || normal.separation < 0;
    }
  }
  void correct(CorrectingContext& step) {
    if (!overlap_) return;
    for (int round = 0; round < rounds; ++round) {
      for (std::size_t i = 0; i < touching_.size(); ++i) push_apart(step.rows[i], touching_[i]);
      rows_solved += touching_.size();
    }
  }

 private:
  void push_apart(Row& row, const SurfacePoints& at) const {
    Body &a = *row.a, &b = *row.b;
    const Vec3 on_a = point_of(a, at.on_a), on_b = point_of(b, at.on_b);
    const Real separation = (on_b - on_a).dot(row.n) + allowed_;
    if (separation >= 0) return;
    row.place(Jacobian::along(row.n, a, b, (on_a + on_b) / 2));
    const Real lambda = std::min(-beta * separation, most / static_cast<Real>(rounds)) * row.effective_mass;  // kg m
    displace(a, lambda * row.dva, lambda * row.dwa);
    displace(b, lambda * row.dvb, lambda * row.dwb);
  }

  std::vector<SurfacePoints> touching_;
  Real allowed_ = 0;      // m, the largest depth that does not count as an overlap: the slop, if a contact is deeper
  bool overlap_ = false;  // whether a contact is deeper than the slop
};

}  // namespace pushback
