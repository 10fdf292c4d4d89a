/// Motions that are of no chapter. Their truth is in closed form, or of an equation of motion without contacts. Impacts come one after the
/// other, never two at the same time.
#pragma once

#include <Eigen/Geometry>
#include <array>

#include "pushback/chapters/19_accuracy_and_time/motion.h"

namespace pushback::further {

/// Six smooth balls in a row, heavy and light ones in turn, with gaps between them. The first comes from the left. No gravity.
/// No impact falls on the end of a substep of 1/60, 1/120, 1/240 s ...: whether balls touch there would be up to rounding.
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

/// A solid ball that spins fast flies between two plates, a floor and a ceiling. Some bounces slip, some stick, on both plates; not in the
/// plane of its flight.
///
/// Between bounces the centre flies along a parabola and the spin stays. With c the arm from the centre to the point that touches, n out of
/// the plate, and its slip u = v + w x c without the part along n, each kg gets in a bounce
///
///   (1 + e) |n . v|                           along n               (Newton)
///   min(mu (1 + e) |n . v|, 2/7 |u|)          against the slip      (Coulomb)
///
/// as 1/m + r^2 / I = 7 / (2 m): the second of the two ends the slip. A ball's slip does not turn in an impact, so it makes no difference
/// whether friction is bounded at every instant or in the sum.
struct Superball {
  static constexpr Real radius = Real(0.1), apart = 1, mu = Real(0.1), e = Real(0.9);  // m; m
  static constexpr double seconds = 1.5, height = 0.5;                                 // s; m, of the centre
  static Eigen::Vector3d velocity() { return {1.5, -6, 1}; }                           // m/s
  static Eigen::Vector3d spin() { return {-30, 4, -80}; }                              // rad/s

  void operator()(World& world) const;
  std::vector<Places> truth(int frames) const;
};

/// A box is put on a belt, across which it slides, and is carried. With the belt's velocity b and the box's v, the slip is u = v - b:
///
///   x(t) = x + b t + u/|u| (|u| t - mu g t^2 / 2)    until t = |u| / (mu g), when it rides: b t + u/|u| u^2 / (2 mu g) from there on
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

/// Tongs hold a box. Each of its two jaws is a square bar, turned so that an edge touches a side of the box, and hangs on a pin of the
/// world above the box by an arm without mass. The pins are nearer to the middle than the sides are, so a jaw's weight swings it inwards,
/// and so does the box's weight, by friction. With the contact H below the pin and w farther out, the jaw's centre of mass
/// c farther still, M a jaw's mass and m the box's, all planar:
///
///   N H = M g (w + c) + F w     moments about a pin                 F = m g / 2     forces on the box, upwards
///   F <= mu N                   Coulomb                       =>    mu >= m H / (2 M (w + c) + m w)
///
/// Nothing else balances: a box that slides down has F = mu N, and falls with  g - 2 mu N / m > 0  only where mu is less than that. For
/// mu w >= H the jaws would jam. The box hangs: its centre is below both contacts, and they are below the pins.
struct Grasp {
  Real height = Real(0.4), out = Real(0.15);      ///< m: H, w
  Real load = 4, jaw = 9;                         ///< kg: m, M
  Real mu = Real(0.5);                            ///< of all pairs; 1.43 times the friction needed
  static constexpr Real half = Real(0.2);         ///< m, of the box, across and upwards
  static constexpr Real half_side = Real(0.05);   ///< m, of a jaw's square
  static constexpr Real contact_at = Real(0.05);  ///< m, of the contacts, above the box's centre
  static constexpr Real to_floor = 1;             ///< m, below the pins: what is let go falls there
  static constexpr double seconds = 2;

  /// The least mu that holds.
  Real friction_needed() const;
  /// The floor, the left jaw, the right jaw, the box.
  void operator()(World& world) const;
  std::vector<Pin> pins() const;
  std::vector<Places> truth(int frames) const;
};

/// A square pyramid of convex hulls: layers of 14 x 14, 13 x 13 ... 1. A hull is a block with its four upright edges cut off, an octagonal
/// prism, and stands on a corner of each of the four below. Hulls of a layer do not touch. Patches of contact lie above patches of contact,
/// so normal forces balance every hull: its own weight goes down by four quarters, and a load from above goes straight down.
struct PileOfHulls {
  int base = 14;                                                                    // 1,015 hulls
  static constexpr Real half_width = Real(0.5), cut = Real(0.2), high = Real(0.5);  // m
  static constexpr Real apart = Real(1.1), mass = 100;                              // m, between centres of a layer; kg
  static constexpr double seconds = 0.5;

  void operator()(World& world) const;
  std::vector<Places> truth(int frames) const;
};

/// Chaplygin's ball: a sphere whose three moments of inertia differ, with its centre of mass in its centre, rolls on the plane y = 0
/// without slip. Friction at rest bends its path. It stands here in the place of Euler's disk, whose round rim none of our shapes has.
/// With n up, the arm from the centre to the contact is -r n, and the angular momentum about the contact is
///
///   K = J w + m r^2 n x (w x n)      J: the inertia about the centre,  w: the spin
///   dK/dt = K x w,   dn/dt = n x w   in body axes     (S. A. Chaplygin 1903, On a ball's rolling on a horizontal plane, in translation:
///                                                      Regular and Chaotic Dynamics 7 (2002) 131-148)
///
/// Gravity and the contact's force have no moment about the contact, and the contact moves as fast as the centre, so in world axes K does
/// not change:
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

  /// The ball after `seconds`, by Runge and Kutta's rule of fourth order in so many equal steps.
  RollingBall after(double seconds, int steps) const;

 private:
  /// kg m^2: J + m r^2 (1 - n n^T), of this orientation, in world axes.
  Eigen::Matrix3d inertia_about_contact(const Eigen::Quaterniond& turned) const;
};

/// A ball whose spin is about none of its principal axes. Its path winds, by a third of a radian, and ends half a metre beside a straight
/// line. Friction has to be 0.24 of the normal force at most.
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
