/// Motions that belong to no chapter. Their true positions have a closed form, or follow from an equation of motion without contacts.
/// No two impacts occur at the same time.
#pragma once

#include <Eigen/Geometry>
#include <array>

#include "pushback/chapters/19_accuracy_and_time/motion.h"

namespace pushback::further {

/// Six smooth balls in a row, alternately light and heavy, with gaps between them. The first comes from the left. No gravity. No impact
/// is at the end of a substep of 1/60, 1/120, 1/240 s ..., because rounding would decide whether balls touch there.
///
/// Between impacts the balls do not accelerate, so two neighbours meet after (x2 - x1 - 2 r) / (v1 - v2). An impact is an impulse along x
/// that leaves (v2 - v1)+ = e (v1 - v2)   (Newton):   (1 + e) m1 m2 / (m1 + m2) (v1 - v2)
struct Gaps {
  static constexpr Real radius = Real(0.1), e = Real(0.9), speed = 3;                                     // m; m/s
  static constexpr std::array<Real, 6> masses{1, 4, 1, 3, 1, 2};                                          // kg
  static constexpr std::array<Real, 5> gaps{Real(0.29), Real(0.21), Real(0.31), Real(0.19), Real(0.32)};  // m
  static constexpr double seconds = 1.5;

  void operator()(World& world) const;
  std::vector<Places> truth(int frames) const;
};

/// A solid ball that spins fast flies between two plates, a floor and a ceiling. On both plates some bounces slip and some stick. The
/// slip is not in the plane of the flight.
///
/// Between bounces the centre moves along a parabola and the spin is constant. c is the arm from the centre to the contact point, n the
/// normal of the plate, and u the slip, which is v + w x c without its component along n. The impulse of a bounce per kg is
///
///   (1 + e) |n . v|                           along n               (Newton)
///   min(mu (1 + e) |n . v|, 2/7 |u|)          against the slip      (Coulomb)
///
/// because 1/m + r^2 / I = 7 / (2 m). The second term of the minimum ends the slip. The slip of a ball keeps its direction in an impact,
/// so friction may be bounded at every instant or in the sum, with the same result.
struct Superball {
  static constexpr Real radius = Real(0.1), apart = 1, mu = Real(0.1), e = Real(0.9);  // m; m
  static constexpr double seconds = 1.5, height = 0.5;                                 // s; m, of the centre
  static Eigen::Vector3d velocity() { return {1.5, -6, 1}; }                           // m/s
  static Eigen::Vector3d spin() { return {-30, 4, -80}; }                              // rad/s

  void operator()(World& world) const;
  std::vector<Places> truth(int frames) const;
};

/// A box is put on a belt, slides across it, and then moves with it. With the velocities b of the belt and v of the box, the slip is
/// u = v - b:
///
///   x(t) = x + b t + u/|u| (|u| t - mu g t^2 / 2)    until t = |u| / (mu g),  then  x(t) = x + b t + u/|u| u^2 / (2 mu g)
///
/// Friction acts along the slip at each of its points, and the load moves along the slip only, so the box does not turn.
struct Conveyor {
  static constexpr Real mu = Real(0.4);
  static constexpr double seconds = 2;
  static Vec3 belt() { return {Real(2.6), 0, Real(1.5)}; }       // m/s
  static Vec3 velocity() { return {Real(-0.6), 0, Real(0.9)}; }  // m/s, of the box as it is put down

  void operator()(World& world) const;
  std::vector<Places> truth(int frames) const;
};

/// Tongs hold a box. Each of the two jaws is a square bar, rotated so that an edge touches a side of the box. It hangs by a massless arm on
/// a pin that is fixed to the world above the box. The pins are nearer to the middle than the sides are, so a jaw's weight swings it
/// inwards, and so does the box's weight, by friction. Let the contact be H below the pin and w farther out, the jaw's centre of mass c
/// farther out than the contact, M the mass of a jaw and m the mass of the box. In the plane,
///
///   N H = M g (w + c) + F w     moments about a pin                 F = m g / 2     forces on the box, upwards
///   F <= mu N                   Coulomb                       =>    mu >= m H / (2 M (w + c) + m w)
///
/// A box that slides down has F = mu N and an acceleration of  g - 2 mu N / m, which is positive only if mu is less than this, so there is
/// no other solution. For mu w >= H the jaws would jam. The box hangs stably, because its centre is below both contacts, and these are
/// below the pins.
struct Grasp {
  Real height = Real(0.4), out = Real(0.15);      ///< m: H, w
  Real load = 4, jaw = 9;                         ///< kg: m, M
  Real mu = Real(0.5);                            ///< of all pairs; 1.43 times the friction needed
  static constexpr Real half = Real(0.2);         ///< m, of the box, across and upwards
  static constexpr Real half_side = Real(0.05);   ///< m, of a jaw's square
  static constexpr Real contact_at = Real(0.05);  ///< m, of the contacts, above the box's centre
  static constexpr Real to_floor = 1;             ///< m, from the pins down to the floor, on which a dropped box lands
  static constexpr double seconds = 2;

  /// The least mu that holds.
  Real friction_needed() const;
  /// The floor, the left jaw, the right jaw, the box.
  void operator()(World& world) const;
  std::vector<Pin> pins() const;
  std::vector<Places> truth(int frames) const;
};

/// A square pyramid of convex hulls, in layers of 14 x 14, 13 x 13 ... 1. A hull is a block with its four upright edges cut off, which is
/// an octagonal prism. It stands on a corner of each of the four hulls below. Hulls of one layer do not touch. The contact patches of a
/// hull lie above each other, so normal forces balance every hull. A quarter of its own weight goes down at each patch, and a load from
/// above goes straight down.
struct PileOfHulls {
  int base = 14;                                                                    // 1,015 hulls
  static constexpr Real half_width = Real(0.5), cut = Real(0.2), high = Real(0.5);  // m
  static constexpr Real apart = Real(1.1), mass = 100;                              // m, between centres of a layer; kg
  static constexpr double seconds = 0.5;

  void operator()(World& world) const;
  std::vector<Places> truth(int frames) const;
};

/// Chaplygin's ball is a sphere with three different moments of inertia and its centre of mass at its centre. It rolls on the plane y = 0
/// without slip, and static friction bends its path. It replaces Euler's disk, because none of our shapes has a round rim. With n up, the
/// arm from the centre to the contact is -r n, and the angular momentum about the contact is
///
///   K = J w + m r^2 n x (w x n)      J: the inertia about the centre,  w: the spin
///   dK/dt = K x w,   dn/dt = n x w   in body axes     (S. A. Chaplygin 1903, On a ball's rolling on a horizontal plane, in translation:
///                                                      Regular and Chaotic Dynamics 7 (2002) 131-148)
///
/// Gravity and the contact force have no moment about the contact, and the contact moves at the velocity of the centre, so in world axes
/// K is constant:
///
///   (J + m r^2 (1 - n n^T)) w = K,   q' = (0, w) q / 2,   x' = r w x n        J = R I R^T
struct RollingBall {
  double radius, mass;             ///< m, kg
  Eigen::Vector3d inertia;         ///< kg m^2, the principal moments, about the centre
  Eigen::Quaterniond orientation;  ///< unit; turns body axes into world axes
  Eigen::Vector3d centre, spin;    ///< m; rad/s; both in world axes

  /// The velocity of the centre, r w x n, m/s.
  Eigen::Vector3d velocity() const { return radius * spin.cross(Eigen::Vector3d::UnitY()); }
  /// K, in world axes, kg m^2/s.
  Eigen::Vector3d momentum() const;

  /// The ball after `seconds`, by the fourth-order Runge-Kutta method in this number of equal steps.
  RollingBall after(double seconds, int steps) const;

 private:
  /// J + m r^2 (1 - n n^T) for this orientation, in world axes, kg m^2.
  Eigen::Matrix3d inertia_about_contact(const Eigen::Quaterniond& turned) const;
};

/// A ball whose spin is not about a principal axis. Its path winds by a third of a radian and ends half a metre from a straight line.
/// Friction is at most 0.24 of the normal force.
struct Chaplygin {
  static constexpr Real radius = Real(0.5), mass = 10, mu = 1;  // m, kg
  static constexpr double seconds = 2;
  static constexpr int steps_in_a_frame = 64;  ///< of the truth; twice as many change it by less than 1e-12 m

  void operator()(World& world) const;
  /// The same ball in double precision.
  static RollingBall ball();
  std::vector<Places> truth(int frames) const;
};

}  // namespace pushback::further
