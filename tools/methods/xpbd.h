/// Extended position based dynamics (XPBD) of rigid bodies: bodies move, positions are corrected, and velocities follow from that.
#pragma once

#include "pushback/chapters/01_velocity_constraint/row.h"
#include "pushback/common/world/step_solver.h"
#include "pushback/common/world/surface_points.h"

namespace pushback {

/// A step of dt is `substeps` of h. In each, bodies move freely, contacts are detected where they are now, and then
///
///   lambda = -C / K,   x += M^-1 J^T lambda,   q likewise      for each joint, and each contact with C < 0; kg m
///   V += M^-1 J^T lambda / h                                   so v = (x - x_before) / h
///   lambda_t = -s / K, unless |lambda_t| > mu lambda_n         s: what the points have moved past each other, m; or else nothing
///
/// and then, of each contact with lambda_n > 0, once, on velocities:
///
///   u_t is reduced by an impulse of mu lambda_n / h at most,   u_n becomes -e u_n^-, or 0
///
/// The compliance is 0: nothing is softer than its substeps make it. u_n^- is the speed before the step's gravity, as in chapter 05;
/// the paper takes the one after it, and has a threshold of 2 g h for that. Its bound of friction, h mu lambda_n / h^2, is an
/// impulse, and is used as one here.
/// A sweep goes over all normals before friction, as in chapter 06. With friction straight behind each normal, a box at rest creeps.
///   M. Mueller, M. Macklin, N. Chentanez, S. Jeschke, T.-Y. Kim, "Detailed Rigid Body Simulation with Extended Position Based
///   Dynamics", Computer Graphics Forum 39 (8), 2020; substeps: M. Macklin et al., "Small Steps in Physics Simulation", SCA 2019
class Xpbd : public StepSolver {
 public:
  int substeps = 1;            ///< per step; the paper has 10 to 40 in 1/60 s, of one sweep each
  Real threshold = Real(0.1);  ///< m/s; slower impacts do not bounce
  /// m: contacts are detected so far ahead, since corrections of others may close them.
  static constexpr Real margin = Real(0.01);

  Plan plan(Real /*dt*/) const override { return {.detections = substeps, .sweeps = 1, .margin = {.least = margin}}; }
  bool supports_joints() const override { return true; }
  /// Throws InvalidInput if a joint has more than C(x) = 0, such as a bias, softness, or bounds.
  void check(World& world, Real h) override;
  /// The order of the method: contacts are detected after the bodies have moved. (Whoever calls the functions below in the order of
  /// step.h, as one with Sleep does, has them detected before.)
  void whole_step(World& world, Real dt, int sweeps) override;
  void after_detection(World& world, Real h) override;
  void solve(World& world, Real h, int sweeps) override;  ///< remembers where bodies start from
  void after_move(World& world, Real h) override;         ///< corrects positions, and makes velocities of that

 private:
  struct Touch {
    Row row;                                            // along the normal, or the slip; rebuilt where it is used
    Vec3 n;                                             // the contact's normal
    SurfacePoints on;                                   // which ride on their bodies
    Real friction, bounce;                              // mu; m/s, the target separating speed
    Vec3 from_a = Vec3::Zero(), from_b = Vec3::Zero();  // m, where those points were as the step began
    Real pressed = 0;                                   // sum of lambda_n, kg m
    Real rubbed = 0;                                    // sum of |lambda_t|, kg m
    Vec3 push = Vec3::Zero();                           // sum of both, on B, kg m
  };
  struct Pose {
    Vec3 position;
    Quat orientation;

    Vec3 point_of(const Vec3& on_body) const { return position + orientation * on_body; }
  };
  using Poses = std::vector<Pose>;

  static void keep(const World& world, Poses& poses);
  void hold(World& world, const Joint& joint, Real h);
  static void press(Touch& at);
  static void rub(Touch& at, Real h);
  static void settle(Touch& at, Real h);

  int sweeps_ = 1;
  std::vector<Touch> touching_;
  Poses start_;     // of all bodies, as the step began
  Poses moved_to_;  // where they went by themselves
  Equations equations_;
};

}  // namespace pushback
