/// Augmented vertex block descent (AVBD): a body after the other takes the place where its own forces balance.
#pragma once

#include <array>

#include "pushback/common/world/step_solver.h"

namespace pushback {

/// Implicit Euler as a minimum over the velocities V at the end of a step, with a penalty k and a force lambda for each row:
///
///   1/2 (V - V*)^T M (V - V*)  +  sum of 1/2 k C^2 - lambda C,      C = (1 - alpha) C_0 + h J V;   V*: as forces leave it
///   f = lambda - k C, but f_n >= 0 and |f_t| <= mu f_n              N; alpha: error_kept, or 0 of a contact ahead, C_0 > 0
///
/// A sweep goes over the bodies. Each makes its own part of the sum least while the others stay, by one linear system of 6 x 6:
///
///   (M + h^2 sum k J J^T) dV = -M (V - V*) + h sum J^T f
///
/// and then over the rows:  lambda <- f,  and k grows with |C| where f is within its bounds. The next step starts from a part of both.
/// C is as it was detected and to first order in V, of joints too; the paper computes a joint's C anew in each
/// sweep, and adds the change of J to the system. k is counted in 1 / (K h^2), so that no mass stands in the settings.
/// There is no restitution here: nothing bounces. k is remembered by the solver, lambda by the world.
///   C. Giles, E. Diaz, C. Yuksel, "Augmented Vertex Block Descent", ACM Transactions on Graphics 44 (4), SIGGRAPH 2025
class Avbd : public StepSolver {
 public:
  static constexpr Real error_kept = Real(0.95);    ///< alpha: the fraction of an old error that a step keeps
  static constexpr Real penalty_kept = Real(0.99);  ///< the part of k that the next step starts from
  static constexpr Real least_penalty = 1;          ///< in 1 / (K h^2): it halves a row's correction
  static constexpr Real most_penalty = Real(1e6);   ///< likewise
  static constexpr Real growth = 100;               ///< of k in a sweep, for each m of |C|, likewise, 1/m
  static constexpr Real margin = Real(0.01);        ///< m: contacts are detected so far ahead, and by the way of a step

  Plan plan(Real h) const override { return {.sweeps = 10, .margin = {.least = margin, .ahead = h}}; }
  bool supports_joints() const override { return true; }
  /// Throws InvalidInput if a joint has more than C(x) = 0, such as a bias, softness, or bounds.
  void check(World& world, Real h) override;
  void solve(World& world, Real h, int sweeps) override;

 private:
  /// One C, and the force that answers it.
  struct Force {
    Jacobian jacobian;
    Real c0;          // m, the part of it that this step is to undo
    Real unit;        // 1 / (K h^2), N/m
    Real k;           // N/m
    Real lambda = 0;  // N
    Real f = 0;       // N, of the latest C
    Real c = 0;       // m, that C
  };
  /// The rows of a contact, n and two tangents; or of an equation of a joint, one.
  struct Bond {
    int a, b;  // World::body
    bool contact;
    Real friction;  // mu
    int rows;
    std::array<Force, 3> forces;
    bool sticks = false;  // friction is within its bound
  };
  using Penalties = std::array<Real, 3>;
  struct Known {
    ContactId id;
    Penalties k;  // in 1 / (K h^2)
  };

  void add_contacts(World& world, Real h);
  void add_joints(World& world, Real h);
  static void answer(const World& world, Bond& bond, Real h);
  void descend(World& world, int body, const Vec3& velocity, const Vec3& angular_velocity, Real h);
  static void raise(Bond& bond);

  std::vector<Bond> bonds_;                   // contacts first
  std::vector<std::vector<std::size_t>> of_;  // of each body: its bonds
  std::vector<Known> known_;                  // of the contacts of the latest step, ascending
  std::vector<Real> known_joints_;            // of the rows of all joints likewise
};

}  // namespace pushback
