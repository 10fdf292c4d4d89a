/// A rigid body and its step, from nothing but vectors.
#pragma once

#include <Eigen/Geometry>

namespace empty_file {

using Vec3 = Eigen::Vector3d;
using Mat3 = Eigen::Matrix3d;
using Quat = Eigen::Quaterniond;

/// A box. Position and velocities are those of its centre of mass, in world axes.
struct Body {
  Vec3 half = Vec3::Constant(0.5);       // half extents, m, along its own axes
  double inverse_mass = 0;               // 1/kg; 0: nothing moves it
  Vec3 inverse_inertia = Vec3::Zero();   // 1/(kg m^2), about its own axes
  Vec3 position = Vec3::Zero();          // x, m
  Quat orientation = Quat::Identity();   // q, turns its own axes into world axes
  Vec3 velocity = Vec3::Zero();          // v, m/s
  Vec3 angular_velocity = Vec3::Zero();  // w, rad/s
};

/// A solid box of this mass, kg.   I = m/3 (b^2 + c^2) about the axis along a, with half extents a, b, c
inline Body box(const Vec3& half, double mass) {
  Body body;
  body.half = half;
  body.inverse_mass = 1 / mass;
  const Vec3 squared = half.cwiseProduct(half);
  for (int i = 0; i < 3; ++i) body.inverse_inertia[i] = 3 / (mass * (squared.sum() - squared[i]));
  return body;
}

/// Its axes, as columns.
inline Mat3 axes_of(const Body& body) {
  return body.orientation.toRotationMatrix();
}

/// In world axes.   I^-1 = R I_body^-1 R^T
inline Mat3 world_inverse_inertia(const Body& body) {
  const Mat3 axes = axes_of(body);
  return axes * body.inverse_inertia.asDiagonal() * axes.transpose();
}

/// An impulse P, N s, at a point.   v += P / m,   w += I^-1 (r x P)
inline void push(Body& body, const Vec3& impulse, const Vec3& point) {
  body.velocity += body.inverse_mass * impulse;
  body.angular_velocity += world_inverse_inertia(body) * (point - body.position).cross(impulse);
}

/// v += h g, before the contacts are solved.
inline void accelerate(Body& body, const Vec3& gravity, double h) {
  if (body.inverse_mass > 0) body.velocity += h * gravity;
}

/// q + h/2 (0, w) q, of length 1: turned by w, rad/s, for h seconds.
inline Quat turned(const Quat& q, const Vec3& w, double h) {
  Quat turned = q;
  turned.coeffs() += h / 2 * (Quat(0, w.x(), w.y(), w.z()) * q).coeffs();
  return turned.normalized();
}

/// x += h v, and the turn, after the contacts are solved. Nothing twists the body now, so its angular momentum L = I w stays
/// as it is, and w follows. It turns with the w of the middle of the step.
inline void move(Body& body, double h) {
  if (body.inverse_mass == 0) return;
  body.position += h * body.velocity;
  const Mat3 axes = axes_of(body);
  const Vec3 momentum = axes * (axes.transpose() * body.angular_velocity).cwiseQuotient(body.inverse_inertia);
  const Quat start = body.orientation;
  body.orientation = turned(start, body.angular_velocity, h / 2);
  body.orientation = turned(start, world_inverse_inertia(body) * momentum, h);
  body.angular_velocity = world_inverse_inertia(body) * momentum;
}

}  // namespace empty_file
