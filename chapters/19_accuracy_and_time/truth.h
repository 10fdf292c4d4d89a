/// Closed forms, and equations of motion of their own, for the motions of this chapter. None of it knows contacts or rows.
#pragma once

#include <optional>

#include "pushback/chapters/19_accuracy_and_time/motion.h"

namespace pushback::truth {

/// g of every motion, m/s^2: in double, also where Real is float.
inline constexpr double g = 9.81;

/// m, of a ball that is dropped with its lowest point this high (m):   h - g t^2 / 2, then after each hit e v
double height_of_bouncing(double height, double e, double t);

/// m, along the way: v t - a t^2 / 2 until it stops, at t = v / a.
double way_of_sliding(double speed, double deceleration, double t);

/// m, of a ball that slides first: v t - mu g t^2 / 2 until t = 2 v / (7 mu g), from where it rolls with 5 v / 7.
double way_of_rolling(double speed, double mu, double t);

/// One of the bodies that hang on each other in a plane.
struct Hanging {
  double mass, inertia;       ///< kg; kg m^2, about its centre of mass
  double to_centre, to_next;  ///< m, from its upper pin: to the centre of mass, to the next pin
};

/// A smooth wall to the right, across x. The last body that hangs is a ball of this radius, and meets nothing but the wall.
struct Wall {
  double x, radius;  ///< m
  double e;
};

/// The places (m, from the uppermost pin, in the plane z = 0, y up) of what starts at rest, all at `angle` (rad) from the vertical.
///
///   sum_j M_ij cos(a_i - a_j) a_j'' + M_ij sin(a_i - a_j) a_j'^2 + g G_i sin a_i = 0       Lagrange's equations in the angles
///
/// integrated by Runge and Kutta's fourth-order rule, in steps far below a frame. Where the ball gets to the wall within one, that is
/// halved until it touches. With d the way from the ball to the wall, and d' before it,
///
///   sum_j M_ij cos(a_i - a_j) (a_j'+ - a_j') = L d d / d a_i,     d'+ = -e d'      there
std::vector<Places> places_of_hanging(const std::vector<Hanging>& bodies, double angle, int frames,
                                      const std::optional<Wall>& wall = {});

/// Equal balls without friction or gravity that collide in pairs, from one collision to the next: between them they fly straight.
std::vector<Places> places_of_colliding(Places at, Places velocities, double radius, double e, int frames);

}  // namespace pushback::truth
