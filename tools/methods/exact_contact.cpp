#include "pushback/tools/methods/exact_contact.h"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>

namespace pushback {

namespace {

using Vec2 = Eigen::Matrix<Real, 2, 1>;
using Mat2 = Eigen::Matrix<Real, 2, 2>;

}  // namespace

ExactContact::ExactContact(const Mat3& w, Real mu) : w_(w), inverse_(w.inverse()), mu_(mu) {
  const Vec2 w_tn = w.block<2, 1>(1, 0);
  const Mat2 rest = w.bottomRightCorner<2, 2>() - w_tn * w_tn.transpose() / w(0, 0);
  Eigen::SelfAdjointEigenSolver<Mat2> of;
  of.computeDirect(rest);
  axes_ = of.eigenvectors();
  stiff_ = of.eigenvalues();
  coupled_ = axes_.transpose() * w_tn;
}

Vec3 ExactContact::solve(const Vec3& q) const {
  if (q.x() >= 0) return Vec3::Zero();
  Vec3 sticking = -(inverse_ * q);
  if (sticking.tail<2>().norm() <= mu_ * sticking.x()) return sticking;
  const Vec2 pull = axes_.transpose() * q.tail<2>() - coupled_ * (q.x() / w_(0, 0));  // q'
  Vec2 r_t;
  Real r_n = 0, f = 0, slope = 0;
  const auto at = [&](Real s) {
    const Vec2 soft = stiff_.array() + s;
    r_t = -pull.cwiseQuotient(soft);
    const Vec2 r_t_slope = -r_t.cwiseQuotient(soft);
    r_n = -(q.x() + coupled_.dot(r_t)) / w_(0, 0);
    const Real length = r_t.norm();
    f = length - mu_ * r_n;
    slope = (length > 0 ? r_t.dot(r_t_slope) / length : 0) + mu_ * coupled_.dot(r_t_slope) / w_(0, 0);
  };
  Real low = 0, high = stiff_.maxCoeff();
  for (at(high); f > 0 && high < std::numeric_limits<Real>::max() / 4; at(high)) low = high, high *= 4;
  Real s = high;
  constexpr Real enough = 4 * std::numeric_limits<Real>::epsilon();
  for (int i = 0; i < 100 && std::abs(f) > enough * (mu_ * std::abs(r_n)) && high - low > enough * high; ++i) {
    const Real newton = s - f / slope;
    s = newton > low && newton < high ? newton : (low + high) / 2;
    at(s);
    (f > 0 ? low : high) = s;
  }
  Vec3 r;
  r << r_n, axes_ * r_t;
  return r;
}

void WholeContacts::build(StepContext& step) {
  FrictionCone::build(step);
  contacts_.clear();
  place_.assign(step.contacts.size(), none);
  for (std::size_t i = 0; i < mu_.size(); ++i) {
    const Row* tangents = &step.rows[first_ + 2 * i];
    const Row& normal = step.rows[tangents->owner];
    Mat3 w;
    w << 1 / normal.effective_mass, coupling(normal, tangents[0]), coupling(normal, tangents[1]),  //
        coupling(tangents[0], normal), 1 / tangents[0].effective_mass, coupling(tangents[0], tangents[1]),
        coupling(tangents[1], normal), coupling(tangents[1], tangents[0]), 1 / tangents[1].effective_mass;
    place_[tangents->owner] = contacts_.size();
    contacts_.emplace_back(w, mu_[i]);
  }
}

void WholeContacts::visit(StepContext& step, std::size_t i) {
  Row& normal = step.rows[i];
  if (place_[i] == none) return normal.solve();
  Row* tangents = &step.rows[first_ + 2 * place_[i]];
  const ExactContact& contact = contacts_[place_[i]];
  const Vec3 before(normal.impulse, tangents[0].impulse, tangents[1].impulse);
  const Vec3 u(normal.speed() + normal.bias, tangents[0].speed(), tangents[1].speed());
  const Vec3 r = contact.solve(u - contact.w() * before);
  normal.reach(r.x());
  tangents[0].reach(r.y());
  tangents[1].reach(r.z());
  rows_solved += 2;  // the normal is counted by the sweep
}

}  // namespace pushback
