#include "pushback/common/bodies/body.h"

#include <cmath>
#include <limits>

#include "pushback/common/basics/input.h"
#include "pushback/common/bodies/hull.h"

namespace pushback {

void Body::refresh_inertia() {
  const Mat3 R = orientation.toRotationMatrix();
  inverse_inertia = R * principal_inverse_inertia.asDiagonal() * R.transpose();
}

Body& Body::at(const Vec3& where) {
  position = where;
  return *this;
}

Body& Body::oriented(const Quat& to) {
  require_finite("orientation's vector part", Vec3(to.vec()));
  require_finite("orientation's scalar part", to.w());
  require_positive("length of the orientation quaternion", to.norm());
  orientation = to;
  refresh_inertia();
  return *this;
}

Body& Body::turned(Real angle, const Vec3& axis) {
  require_finite("angle of a turn", angle);
  require_finite("axis of a turn", axis);
  require_positive("length of the axis of a turn", axis.norm());
  orientation = Quat(Eigen::AngleAxis<Real>(angle, axis.normalized())) * orientation;
  orientation.normalize();
  refresh_inertia();
  return *this;
}

Body& Body::moving(const Vec3& with_velocity) {
  velocity = with_velocity;
  return *this;
}

Body& Body::spinning(const Vec3& with_angular_velocity) {
  angular_velocity = with_angular_velocity;
  return *this;
}

Body& Body::rough(Real mu) {
  friction = mu;
  return *this;
}

Body& Body::bouncy(Real e) {
  restitution = e;
  return *this;
}

Body& Body::fixed() {
  inverse_mass = 0;
  principal_inverse_inertia.setZero();
  inverse_inertia.setZero();
  return *this;
}

Body& Body::coloured(int which) {
  colour = which;
  return *this;
}

Body& Body::in_groups(std::uint32_t bits) {
  groups = bits;
  return *this;
}

Body& Body::touching(std::uint32_t bits) {
  touches = bits;
  return *this;
}

Body& Body::with_skin(Real thickness) {
  require_not_negative("skin", thickness);
  skin = thickness;
  return *this;
}

Body& Body::conveying(const Vec3& surface_velocity) {
  require_finite("surface velocity", surface_velocity);
  velocity = surface_velocity;
  conveys = true;
  return *this;
}

Body& Body::moved_to(const Vec3& where, const Quat& to, Real dt) {
  if (movable() || conveys) {
    throw InvalidInput(fmt::format("body to move by hand {}: an immovable one that does not convey is needed",
                                   movable() ? "can move by itself" : "conveys"));
  }
  require_finite("place to move to", where);
  require_finite("orientation's vector part", Vec3(to.vec()));
  require_finite("orientation's scalar part", to.w());
  require_positive("length of the orientation quaternion", to.norm());
  require_positive("dt", dt);
  const Eigen::AngleAxis<Real> turn(to.normalized() * orientation.conjugate());  // by at most pi
  velocity = (where - position) / dt;
  angular_velocity = turn.angle() / dt * turn.axis();
  return *this;
}

namespace {

/// `inertia_per_kilogram`: principal moments divided by the mass, m^2.
Body movable(const Shape& shape, Real mass, const Vec3& inertia_per_kilogram) {
  require_positive("mass", mass);
  Body body;
  body.shape = shape;
  body.inverse_mass = 1 / mass;
  body.principal_inverse_inertia = (mass * inertia_per_kilogram).cwiseInverse();
  body.refresh_inertia();
  return body;
}

}  // namespace

Body sphere(Real radius, Real mass) {
  require_positive("radius", radius);
  return movable(Sphere{radius}, mass, Vec3::Constant(Real(0.4) * radius * radius));
}

Body box(const Vec3& half_extents, Real mass) {
  for (const Real extent : half_extents) require_positive("half-extent of a box", extent);
  const Vec3 squared = half_extents.cwiseAbs2();
  return movable(Box{half_extents}, mass, (Vec3::Constant(squared.sum()) - squared) / 3);
}

Body capsule(Real radius, Real half_length, Real mass) {
  require_positive("radius", radius);
  require_positive("half-length of a capsule", half_length);
  // A cylinder and two half-balls, each with its share of the mass by volume (volumes divided by pi r^2). A half-ball's
  // centre of mass lies 3r/8 beyond its flat side; its transverse inertia about that centre is 83/320 m r^2.
  const Real r2 = radius * radius;
  const Real cylinder = 2 * half_length;
  const Real caps = Real(4) / 3 * radius;
  const Real share = cylinder / (cylinder + caps);
  const Real offset = half_length + Real(0.375) * radius;
  const Real along = share * r2 / 2 + (1 - share) * Real(0.4) * r2;
  const Real across =
      share * (r2 / 4 + half_length * half_length / 3) + (1 - share) * (Real(83) / 320 * r2 + offset * offset);
  return movable(Capsule{radius, half_length}, mass, {across, along, across});
}

Body hull(const std::vector<Vec3>& points, Real mass) {
  const PlacedSolid made = solid_of(points);
  Body body = movable(Hull{made.solid}, mass, made.inertia_per_kilogram);
  body.position = made.centre;
  body.orientation = Quat(made.axes);
  body.orientation.normalize();
  body.refresh_inertia();
  return body;
}

Body half_space(const Vec3& normal) {
  require_finite("normal of a half-space", normal);
  require_positive("length of the normal of a half-space", normal.norm());
  Body body;
  body.shape = HalfSpace{normal.normalized()};
  return body;
}

Body ground() {
  return half_space(Vec3::UnitY());
}

namespace {

struct CheckShape {
  void operator()(const Sphere& s) const { require_positive("radius", s.radius); }
  void operator()(const Box& b) const {
    for (const Real extent : b.half_extents) require_positive("half-extent of a box", extent);
  }
  void operator()(const Capsule& c) const {
    require_positive("radius", c.radius);
    require_positive("half-length of a capsule", c.half_length);
  }
  void operator()(const HalfSpace& h) const {
    require_finite("normal of a half-space", h.normal);
    require_positive("length of the normal of a half-space", h.normal.norm());
  }
  void operator()(const Hull& h) const {
    if (!h.solid) throw InvalidInput("hull has no solid: one that hull() has made of points is needed");
  }
};

}  // namespace

void check(Body& body) {
  std::visit(CheckShape{}, body.shape);
  require_finite("position", body.position);
  require_finite("velocity", body.velocity);
  require_finite("angular velocity", body.angular_velocity);
  require_finite("force", body.force);
  require_finite("torque", body.torque);
  require_finite("orientation's vector part", Vec3(body.orientation.vec()));
  require_finite("orientation's scalar part", body.orientation.w());
  require_positive("length of the orientation quaternion", body.orientation.norm());
  require_not_negative("inverse mass", body.inverse_mass);
  for (const Real entry : body.principal_inverse_inertia) require_not_negative("inverse inertia", entry);
  require_not_negative("friction", body.friction);
  require_between("restitution", body.restitution, 0, 1);
  require_not_negative("skin", body.skin);
  if (body.conveys && body.movable()) {
    throw InvalidInput(fmt::format(
        "inverse mass of a body that conveys is {}: it must be 0, only an immovable body conveys", body.inverse_mass));
  }
  if (std::holds_alternative<HalfSpace>(body.shape) && body.movable()) {
    throw InvalidInput(
        fmt::format("inverse mass of a half-space is {}: it must be 0, a half-space never moves", body.inverse_mass));
  }
  if (HalfSpace* plane = std::get_if<HalfSpace>(&body.shape)) plane->normal.normalize();
  body.orientation.normalize();
  body.refresh_inertia();
}

}  // namespace pushback
