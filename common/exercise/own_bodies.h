/// An answer that is what stands under a solver, written from an empty file: a body and its step, where bodies touch, and what
/// contacts are called. docs/from_an_empty_file says which types and functions it has.
#pragma once

#include "pushback/common/exercise/exercise.h"

namespace pushback {

/// The state of a box, as scenes know it. In world axes but for `half` and `inverse_inertia`, which are along its own.
struct OwnBody {
  Vec3 half, inverse_inertia;  // m, 1/(kg m^2)
  Real inverse_mass;           // 1/kg
  Vec3 position;               // m
  Quat orientation;
  Vec3 velocity, angular_velocity;  // m/s, rad/s
};

struct OwnTouch {
  Vec3 point, normal;  // m; from A to B
  Real depth;          // m
  int name;
};
using OwnTouches = std::vector<OwnTouch>;

struct OwnBodies {
  std::function<OwnBody(const Vec3& half, Real mass)> box;
  std::function<void(OwnBody&, const Vec3& impulse, const Vec3& point)> push;
  std::function<void(OwnBody&, const Vec3& gravity, Real h)> accelerate;
  std::function<void(OwnBody&, Real h)> move;
  // From the second page on. A plane is all p with p . normal = offset.
  std::function<OwnTouches(const Vec3& normal, Real offset, const Vec3& centre, Real radius)> plane_and_ball;
  std::function<OwnTouches(const Vec3& a, Real radius_a, const Vec3& b, Real radius_b)> balls;
  std::function<OwnTouches(const Vec3& normal, Real offset, const OwnBody&)> plane_and_box;
  /// The direction in which two boxes overlap least, as a normal and a depth; none: they are apart.
  std::function<OwnTouches(const OwnBody& a, const OwnBody& b)> least_overlap;
  /// The point of two boxes whose edges touch.
  std::function<OwnTouches(const OwnBody& a, const OwnBody& b)> edges;
  // From the third page on.
  std::function<OwnTouches(const OwnBody& a, const OwnBody& b)> boxes;
};

/// What is measured in a scene of a check, counted from 0 through all pages.
Numbers play(std::size_t check, Random& random, const OwnBodies& answer);

template <class Body>
Body as_theirs(const OwnBody& own) {
  Body body;
  body.half = own.half.cast<double>();
  body.inverse_mass = static_cast<double>(own.inverse_mass);
  body.inverse_inertia = own.inverse_inertia.cast<double>();
  body.position = own.position.cast<double>();
  body.orientation = own.orientation.cast<double>();
  body.velocity = own.velocity.cast<double>();
  body.angular_velocity = own.angular_velocity.cast<double>();
  return body;
}

template <class Body>
OwnBody as_ours(const Body& body) {
  return {.half = body.half.template cast<Real>(),
          .inverse_inertia = body.inverse_inertia.template cast<Real>(),
          .inverse_mass = static_cast<Real>(body.inverse_mass),
          .position = body.position.template cast<Real>(),
          .orientation = body.orientation.template cast<Real>(),
          .velocity = body.velocity.template cast<Real>(),
          .angular_velocity = body.angular_velocity.template cast<Real>()};
}

/// The first page's. `box`: makes one, of half extents and a mass.
template <class Body, class Box>
OwnBodies own_bodies(Box box) {
  using Theirs = Eigen::Vector3d;
  OwnBodies made;
  made.box = [box](const Vec3& half, Real mass) {
    return as_ours<Body>(box(Theirs(half.cast<double>()), static_cast<double>(mass)));
  };
  made.push = [](OwnBody& own, const Vec3& impulse, const Vec3& point) {
    Body body = as_theirs<Body>(own);
    push(body, Theirs(impulse.cast<double>()), Theirs(point.cast<double>()));
    own = as_ours(body);
  };
  made.accelerate = [](OwnBody& own, const Vec3& gravity, Real h) {
    Body body = as_theirs<Body>(own);
    accelerate(body, Theirs(gravity.cast<double>()), static_cast<double>(h));
    own = as_ours(body);
  };
  made.move = [](OwnBody& own, Real h) {
    Body body = as_theirs<Body>(own);
    move(body, static_cast<double>(h));
    own = as_ours(body);
  };
  return made;
}

template <class Touches>
OwnTouches as_ours_of(const Touches& theirs) {
  OwnTouches touches;
  for (const auto& one : theirs)
    touches.push_back(
        {one.point.template cast<Real>(), one.normal.template cast<Real>(), static_cast<Real>(one.depth), one.name});
  return touches;
}

/// The second page's, beside what `bodies` has.
template <class Body, class Plane, class Ball, class Axis>
OwnBodies own_touches(OwnBodies bodies) {
  const auto plane_of = [](const Vec3& normal, Real offset) {
    return Plane{normal.cast<double>(), static_cast<double>(offset)};
  };
  const auto ball_of = [](const Vec3& centre, Real radius) {
    return Ball{centre.cast<double>(), static_cast<double>(radius)};
  };
  bodies.plane_and_ball = [=](const Vec3& normal, Real offset, const Vec3& centre, Real radius) {
    return as_ours_of(touch(plane_of(normal, offset), ball_of(centre, radius)));
  };
  bodies.balls = [=](const Vec3& a, Real radius_a, const Vec3& b, Real radius_b) {
    return as_ours_of(touch(ball_of(a, radius_a), ball_of(b, radius_b)));
  };
  bodies.plane_and_box = [=](const Vec3& normal, Real offset, const OwnBody& own) {
    return as_ours_of(touch(plane_of(normal, offset), as_theirs<Body>(own)));
  };
  bodies.least_overlap = [](const OwnBody& a, const OwnBody& b) -> OwnTouches {
    Axis axis;
    if (!least_overlap(as_theirs<Body>(a), as_theirs<Body>(b), axis)) return {};
    return {{Vec3::Zero(), axis.normal.template cast<Real>(), static_cast<Real>(axis.depth), 0}};
  };
  bodies.edges = [](const OwnBody& own_a, const OwnBody& own_b) -> OwnTouches {
    const Body a = as_theirs<Body>(own_a), b = as_theirs<Body>(own_b);
    Axis axis;
    if (!least_overlap(a, b, axis) || axis.axis_a < 0 || axis.axis_b < 0) return {};
    return as_ours_of(std::vector{touch_of_edges(a, b, axis)});
  };
  return bodies;
}

/// The third page's.
template <class Body>
OwnBodies own_names(OwnBodies bodies) {
  bodies.boxes = [](const OwnBody& a, const OwnBody& b) {
    return as_ours_of(touch(as_theirs<Body>(a), as_theirs<Body>(b)));
  };
  return bodies;
}

}  // namespace pushback
