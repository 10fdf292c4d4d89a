#include "pushback/engine/direct/small_contact_problem.h"

#include <Eigen/LU>

#include "pushback/engine/direct/coulomb_equation.h"

namespace pushback {

namespace {

using Eigen::Index;
using Impulses = SmallContactProblem::Impulses;
using Matrix = SmallContactProblem::Matrix;

/// The contribution of `body` to the change of the speed of row i by 1 N s on row j.
double through(const Body* body, const Row& i, const Row& j) {
  if (!body->movable() || (j.a != body && j.b != body)) return 0;
  const Vec3 &dv = j.a == body ? j.dva : j.dvb, &dw = j.a == body ? j.dwa : j.dwb;
  return static_cast<double>(i.a == body ? -i.n.dot(dv) - i.ra_n.dot(dw) : i.n.dot(dv) + i.rb_n.dot(dw));
}

/// f of all contacts; also f' with the proximal term p, if `derivative` is not null.
Impulses f_of(const SmallContactProblem& problem, const Impulses& r, const Impulses& u, double pull = 0,
              Matrix* derivative = nullptr) {
  Impulses f(r.size());
  for (Index c = 0; c < problem.mu.size(); ++c) {
    const CoulombEquation law(ContactBlock(problem.w.block<3, 3>(3 * c, 3 * c)), problem.mu[c], r.segment<3>(3 * c),
                              u.segment<3>(3 * c));
    f.segment<3>(3 * c) = law.f;
    if (derivative == nullptr) continue;
    derivative->middleRows<3>(3 * c).noalias() = law.df_du * problem.w.middleRows<3>(3 * c);
    derivative->block<3, 3>(3 * c, 3 * c) += law.df_dr + pull * law.df_du;
  }
  return f;
}

}  // namespace

Matrix small_matrix_of(const Rows& rows, const std::vector<Index>& places) {
  const Index size = static_cast<Index>(rows.size());
  Matrix w(size, size);
  for (std::size_t i = 0; i < rows.size(); ++i)
    for (std::size_t j = 0; j <= i; ++j)
      w(places[i], places[j]) = w(places[j], places[i]) =
          through(rows[i].a, rows[i], rows[j]) + through(rows[i].b, rows[i], rows[j]);
  return w;
}

bool solve_small(const SmallContactProblem& problem, Impulses& r, double tolerance) {
  double pull = 1e-3 * problem.w.diagonal().maxCoeff();
  Impulses at = r, u = problem.w * at + problem.q;
  Matrix derivative(r.size(), r.size());
  for (int step = 0; step < 30; ++step, pull /= 5) {
    const Impulses f = f_of(problem, at, u, pull, &derivative);
    const Impulses change = derivative.partialPivLu().solve(-f);
    bool shorter = false;
    for (double part = 1; part > 1e-3 && !shorter; part /= 2) {  // a step halved until |f| falls
      const Impulses tried = at + part * change, speeds = problem.w * tried + problem.q;
      shorter = f_of(problem, tried, speeds).norm() < (1 - 1e-4 * part) * f.norm();
      if (shorter) at = tried, u = speeds;
    }
    if (!shorter) return false;
    if (relative_residual(at, u, problem.q, problem.mu) > tolerance) continue;
    r = at;
    return true;
  }
  return false;
}

}  // namespace pushback
