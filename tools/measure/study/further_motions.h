/// Motions that are of no chapter, each in closed form. Their impacts come one after the other, never two at the same time.
#pragma once

#include <array>

#include "pushback/chapters/19_accuracy_and_time/motion.h"

namespace pushback::further {

/// An impulse: the velocity of a body's centre of mass changes.
struct Kick {
  double time;               ///< s, since the motion began
  std::size_t body;          ///< by its index in the motion's world
  Eigen::Vector3d velocity;  ///< m/s, world axes: by how much it changes
};

/// Where the bodies of `begin` are after 1, 2 ... frames, if nothing but gravity and these kicks changes their velocities:
///
///   x(t) = x + v t + g t^2 / 2 + sum of dv_k (t - t_k)    over the kicks with t_k < t; without g where nothing moves the body
std::vector<Places> places_of_kicked(const World& begin, const std::vector<Kick>& kicks, int frames);

/// Two neighbours in a row of balls meet.
struct Meeting {
  double time;        ///< s
  std::size_t first;  ///< the ball behind; it meets the next one
  double closing;     ///< m/s, how fast the two approach
  double impulse;     ///< kg m/s:  (1 + e) m1 m2 / (m1 + m2) closing
};

/// Balls of one radius in a row along x.
struct RowOfBalls {
  std::vector<double> masses, places, velocities;  ///< kg; m, of their centres, ascending; m/s
  double radius, e;                                ///< m; of each pair

  /// All meetings before `until` (s), in their order. Between them the balls do not accelerate, so two of them meet after
  /// (x2 - x1 - 2 r) / (v1 - v2). An impact is an impulse along x that leaves (v2 - v1)+ = e (v1 - v2)  (Newton).
  /// Throws InvalidInput beyond 1000 of them: where e is small, balls may meet infinitely often in a finite time.
  std::vector<Meeting> meetings(double until) const;
};

/// Six smooth balls in a row, heavy and light ones in turn, with gaps between them. The first comes from the left. No gravity.
/// No impact falls on the end of a substep of 1/60, 1/120, 1/240 s ...: whether balls touch there would be up to rounding.
struct Gaps {
  static constexpr Real radius = Real(0.1), e = Real(0.9), speed = 3;                                     // m; m/s
  static constexpr std::array<Real, 6> masses{1, 4, 1, 3, 1, 2};                                          // kg
  static constexpr std::array<Real, 5> gaps{Real(0.29), Real(0.21), Real(0.31), Real(0.19), Real(0.32)};  // m
  static constexpr double seconds = 1.5;

  void operator()(World& world) const;
  /// The same, in double.
  static RowOfBalls row();
  std::vector<Places> truth(int frames) const;
};

/// A ball meets a plate.
struct Bounce {
  double time;                       ///< s
  bool ceiling;                      ///< else the floor
  bool sticks;                       ///< friction takes all of the slip; else it is too weak for that
  Eigen::Vector3d velocity, spin;    ///< m/s, rad/s, as it arrives
  Eigen::Vector3d slip;              ///< m/s, of the ball's point that touches, along the plate, as it arrives
  Eigen::Vector3d kick, spin_after;  ///< m/s, by how much the velocity changes; rad/s
};

/// A solid ball between a floor, y = 0, and a ceiling that is parallel to it. Gravity is along -y.
struct BallBetweenPlates {
  double radius, apart, mu, e;     ///< m; m, from floor to ceiling
  double height;                   ///< m, of the centre
  Eigen::Vector3d velocity, spin;  ///< m/s, rad/s

  /// All bounces before `until` (s), in their order. Between them the centre flies along a parabola and the spin stays. With c the arm
  /// from the centre to the point that touches, n out of the plate, and its slip u = v + w x c without the part along n, each kg gets
  ///
  ///   (1 + e) |n . v|                           along n               (Newton)
  ///   min(mu (1 + e) |n . v|, 2/7 |u|)          against the slip      (Coulomb)
  ///
  /// as 1/m + r^2 / I = 7 / (2 m): the second of the two ends the slip. A ball's slip does not turn in an impact, so it makes no difference
  /// whether friction is bounded at every instant or in the sum. Throws InvalidInput beyond 1000 bounces.
  std::vector<Bounce> bounces(double until) const;
};

/// A ball that spins fast flies between two plates. Some bounces slip, some stick, on both plates; not in the plane of its flight.
struct Superball {
  static constexpr Real radius = Real(0.1), apart = 1, mu = Real(0.1), e = Real(0.9);  // m; m
  static constexpr double seconds = 1.5;

  void operator()(World& world) const;
  /// The same, in double.
  static BallBetweenPlates ball();
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

}  // namespace pushback::further
