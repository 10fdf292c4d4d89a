/// Chaplygin's ball: a sphere whose three moments of inertia differ rolls on a plane. A motion whose path is curved by friction at rest.
///
/// It stands here in the place of Euler's disk, whose round rim none of our shapes has.
#pragma once

#include <Eigen/Geometry>

#include "pushback/chapters/19_accuracy_and_time/motion.h"

namespace pushback::further {

/// A sphere on the plane y = 0, with its centre of mass in its centre, that rolls without slip. With n up, the arm from the centre to the
/// contact is -r n, and the angular momentum about the contact is
///
///   K = J w + m r^2 n x (w x n)      J: the inertia about the centre,  w: the spin
///   dK/dt = K x w,   dn/dt = n x w   in body axes     (S. A. Chaplygin 1903, On a ball's rolling on a horizontal plane, in translation:
///                                                      Regular and Chaotic Dynamics 7 (2002) 131-148)
///
/// Gravity and the contact's force have no moment about the contact, and the contact moves as fast as the centre, so in world axes K does not change:
///
///   (J + m r^2 (1 - n n^T)) w = K,   q' = (0, w) q / 2,   x' = r w x n        J = R I R^T
struct RollingBall {
  double radius, mass;             ///< m, kg
  Eigen::Vector3d inertia;         ///< kg m^2, the principal moments, about the centre
  Eigen::Quaterniond orientation;  ///< unit; turns body axes into world axes
  Eigen::Vector3d centre, spin;    ///< m; rad/s; both in world axes

  /// m/s, r w x n.
  Eigen::Vector3d velocity() const { return radius * spin.cross(Eigen::Vector3d::UnitY()); }
  /// kg m^2/s, K, in world axes.
  Eigen::Vector3d momentum() const;
  /// J, K . w / 2: also m v^2 / 2 + w . J w / 2.
  double energy() const { return momentum().dot(spin) / 2; }

  /// The ball after `seconds`, by Runge and Kutta's rule of fourth order in so many equal steps.
  RollingBall after(double seconds, int steps) const;

 private:
  /// kg m^2: J + m r^2 (1 - n n^T), of this orientation, in world axes.
  Eigen::Matrix3d inertia_about_contact(const Eigen::Quaterniond& turned) const;
};

/// A ball whose spin is about none of its principal axes. Its path winds, by a third of a radian, and ends half a metre beside a straight line.
/// Friction has to be 0.24 of the normal force at most.
struct Chaplygin {
  static constexpr Real radius = Real(0.5), mass = 10, mu = 1;  // m, kg
  static constexpr double seconds = 2;
  static constexpr int steps_in_a_frame = 64;  ///< of the truth: twice as many change it by less than 1e-12 m

  void operator()(World& world) const;
  /// The same, in double.
  static RollingBall ball();
  std::vector<Places> truth(int frames) const;
};

}  // namespace pushback::further
