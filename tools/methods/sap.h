/// Semi-analytic primal solver (SAP): a step is the minimum of one convex function of all velocities.
#pragma once

#include "pushback/common/world/step_solver.h"
#include "pushback/tools/methods/sap_problem.h"

namespace pushback {

/// All contacts and joints together, by Newton's method on velocities:
///
///   l(v) = (v - v*)^T M (v - v*) / 2 + sum of l_c(J_c v)          sap_problem.h
///
///   contact   R_t = sigma w,   R_n = beta^2 / (4 pi^2) w,   v = -phi / (h + tau)
///   joint                      R   = beta^2 / (4 pi^2) w,   v = -C / (h + tau) - b
///
/// w: how easily the contact moves, the Frobenius norm of its 3 x 3 block of J M^-1 J^T over 3, 1/kg; of an equation of a joint
/// J M^-1 J^T. phi: distance, m, below 0 for an overlap. Contacts are springs with a period of beta steps, critically damped:
/// tau = beta h / pi. So a contact that bears m g is m g h (h + tau) R_n deep. A joint's bounds are held, and its spring keeps
/// its own softness.
///
/// Lagged, friction is bounded by the impulse of the same spring and damper as the step begins: n_0 = (phi < 0) (v - tau / (h + tau)
/// u_n) / R_n, at least 0. That is the impulse of the step before, without a memory. Friction is then Coulomb's, a step late.
///
/// `sweeps` do not matter: Newton's method ends where its equations hold. There is no restitution here. Unless lagged, friction
/// that slides is relaxed: a contact that slides opens with mu |u_t|.
///   A. Castro, F. Permenter, X. Han, "An Unconstrained Convex Formulation of Compliant Contact", IEEE Transactions on Robotics, 2022
class Sap : public StepSolver {
 public:
  Real period = 1;      ///< beta, steps, above 0
  bool lagged = false;  ///< as in Drake by default, since its version 1.37; else its `sap`
  static constexpr double slow =
      1e-4;  ///< m/s, Drake's tolerance of stiction: a lagged contact that sticks creeps below it
  static constexpr double slip = 1e-3;        ///< sigma
  static constexpr Real margin = Real(0.01);  ///< m: contacts are detected so far ahead, and by the way of h + tau
  static constexpr double tolerance = 1e-8;   ///< of Newton's method, see sap_problem.h
  static constexpr int most_steps = 100;      ///< of Newton's method

  Plan plan(Real h) const override { return {.sweeps = 1, .margin = {.least = margin, .ahead = h + tau(h)}}; }
  bool supports_joints() const override { return true; }
  /// Throws InvalidInput where the period cannot be used.
  void check(World& world, Real h) override;
  void solve(World& world, Real h, int sweeps) override;

 private:
  Real tau(Real h) const { return period * h / pi; }
  double rigid() const;  // beta^2 / (4 pi^2)
  int place_of(const Body& body);
  template <class Bond, class Law>
  void tie(std::vector<Bond>& bonds, const Body& a, const Body& b, const typename Bond::Jacobian& j_a,
           const typename Bond::Jacobian& j_b, const Law& law);
  void add_contacts(const World& world, Real h);
  void add_joints(World& world, Real h);
  SapProblem::Vector start(const World& world) const;
  void write(World& world, const SapProblem::Vector& v) const;

  SapProblem problem_;
  std::vector<int> places_;  // of each body in the problem
  std::vector<int> taken_;   // of each place in the problem: the body
};

}  // namespace pushback
