/// Closed forms and separate equations of motion for the motions of this chapter. They do not use contacts or rows.
#pragma once

#include <optional>

#include "pushback/chapters/19_accuracy_and_time/motion.h"

namespace pushback::truth {

/// g of every motion, m/s^2: in double, also if Real is float.
inline constexpr double g = 9.81;

/// The height of the lowest point of a ball, dropped from `height`, m:   h - g t^2 / 2, then after each hit e v
double height_of_bouncing(double height, double e, double t);

/// The distance covered, m: v t - a t^2 / 2 until the body stops, at t = v / a.
double way_of_sliding(double speed, double deceleration, double t);

/// The distance covered by a ball that slides first, m: v t - mu g t^2 / 2 until t = 2 v / (7 mu g), then it rolls at 5 v / 7.
double way_of_rolling(double speed, double mu, double t);

/// One body of a chain that hangs in a plane.
struct Hanging {
  double mass, inertia;       ///< kg; kg m^2, about its centre of mass
  double to_centre, to_next;  ///< m, from its upper pin: to the centre of mass, to the next pin
};

/// A smooth wall to the right, across x. The last body of the chain is a ball of this radius and touches only the wall.
struct Wall {
  double x, radius;  ///< m
  double e;
};

/// The places (m, from the uppermost pin, in the plane z = 0, y up) of a chain that starts at rest, all bodies at `angle` (rad)
/// from the vertical.
///
///   sum_j M_ij cos(a_i - a_j) a_j'' + M_ij sin(a_i - a_j) a_j'^2 + g G_i sin a_i = 0       Lagrange's equations in the angles
///
/// integrated by the fourth-order Runge-Kutta method, in steps far below a frame. If the ball reaches the wall within a step,
/// bisection finds the time of contact. With the distance d from the ball to the wall, and its rate d' before the impact,
///
///   sum_j M_ij cos(a_i - a_j) (a_j'+ - a_j') = L d d / d a_i,     d'+ = -e d'      at the impact
std::vector<Places> places_of_hanging(const std::vector<Hanging>& bodies, double angle, int frames,
                                      const std::optional<Wall>& wall = {});

/// The places (m) of equal balls without friction or gravity, from one collision of a pair to the next. Between collisions they
/// move in straight lines.
std::vector<Places> places_of_colliding(Places at, Places velocities, double radius, double e, int frames);

}  // namespace pushback::truth
