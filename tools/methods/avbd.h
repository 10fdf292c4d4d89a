/// Augmented vertex block descent (AVBD): a body after the other takes the place where its own forces balance.
#pragma once

#include <array>
#include <span>

#include "pushback/common/world/step_solver.h"

namespace pushback {

/// Implicit Euler as a minimum over the velocities V at the end of a step, with a penalty k and a force lambda for each row:
///
///   1/2 (V - V*)^T M (V - V*)  +  sum of 1/2 k C^2 - lambda C       V*: as forces leave it
///   C = (1 - alpha) C_0 + h J V                                     contact; alpha: error_kept, or 0 of a contact ahead, C_0 > 0
///   C = C(x) - alpha C_0,  x: where V leads in h                    joint: its C and J are computed again for each body in each sweep
///   f = lambda - k C, but f_n >= 0 and |f_t| <= mu f_n              N
///
/// A sweep goes over the bodies. Each makes its own part of the sum least while the others stay, by one linear system of 6 x 6:
///
///   (M + h^2 sum (s J J^T + |f| G)) dV = -M (V - V*) + h sum J^T f
///
/// s is k, but |f - lambda| / |C| of a row that is at a bound. G is diagonal: how much J changes with each of the body's 6 ways to
/// move, as the step begins. Then the rows:  lambda <- f,  and k grows with |C| where f is within its bounds. The next step starts
/// from a part of both, and V from where a body goes if it gains of V* what it gained before.
/// k is counted in 1 / (K h^2), so that no mass stands in the settings.
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
  using Vec6 = Eigen::Matrix<Real, 6, 1>;
  /// One C, and the force that answers it.
  struct Force {
    Jacobian jacobian;
    Real c0;             // m: of a contact the part that this step is to undo, of a joint the part that it is to leave
    Real unit;           // 1 / (K h^2), N/m
    Real k;              // N/m
    Real lambda = 0;     // N
    Real f = 0;          // N, of the latest C
    Real c = 0;          // m, that C
    Real stiffness = 0;  // N/m, s
  };
  /// The rows of a contact, n and two tangents; or of a joint, its equations.
  struct Bond {
    int a, b;  // World::body
    std::size_t first;
    std::size_t rows;
    const Joint* joint = nullptr;
    Real friction = 0;    // mu
    bool sticks = false;  // friction is within its bound
  };
  using Penalties = std::array<Real, 3>;
  struct Known {
    ContactId id;
    Penalties k;  // in 1 / (K h^2)
  };
  /// A body as the step begins.
  struct Start {
    Vec3 velocity, angular_velocity;  // V*
    Mat3 inertia;
    Vec3 position;
    Quat orientation;
    bool joined = false;  // it takes the place where V leads, for C(x)
  };

  std::span<Force> rows_of(const Bond& bond) { return std::span(forces_).subspan(bond.first, bond.rows); }
  void add_contacts(World& world, Real h);
  void add_joints(World& world, Real h);
  void bend(World& world, const Bond& bond, Real h);
  void begin(World& world, Real h);
  void answer(const World& world, Bond& bond, Real h);
  void descend(World& world, std::size_t body, Real h);
  void raise(Bond& bond);
  void store(World& world, Real h);

  std::vector<Bond> bonds_;  // contacts first
  std::vector<Force> forces_;
  std::size_t contact_rows_ = 0;              // of forces_
  std::vector<std::array<Vec6, 2>> bends_;    // of each row of a joint: the diagonals of G for its two bodies, 1/m
  std::vector<std::vector<std::size_t>> of_;  // of each body: its bonds
  std::vector<Start> starts_;                 // of each body
  std::vector<Vec3> velocities_before_;       // of each body, as the step before this one began
  std::vector<Known> known_;                  // of the contacts of the latest step, ascending
  std::vector<Real> known_joints_;            // of the rows of all joints likewise
  Equations equations_;
};

}  // namespace pushback
