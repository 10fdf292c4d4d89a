#include "pushback/common/experiment/picture_of.h"

#include <algorithm>

#include "pushback/common/render/palette.h"

namespace pushback {

namespace {

struct Size {
  Real operator()(const Sphere& s) const { return 2 * s.radius; }
  Real operator()(const Box& b) const { return 2 * std::cbrt(b.half_extents.prod()); }
  Real operator()(const Capsule& c) const { return 2 * c.radius + c.half_length; }
  Real operator()(const HalfSpace&) const { return 0; }
  Real operator()(const Hull& h) const { return std::cbrt(h.solid->volume); }
};

/// A typical diameter of the bodies that move, m.
Real typical_size(const World& world) {
  Real sum = 0;
  int count = 0;
  for (const Body& body : world.bodies) {
    if (!body.movable()) continue;
    sum += std::visit(Size{}, body.shape);
    ++count;
  }
  return count == 0 ? 1 : sum / static_cast<Real>(count);
}

}  // namespace

Real fitting_arrow(const World& world, Real dt) {
  Real mass = 0;
  int count = 0;
  for (const Body& body : world.bodies) {
    if (!body.movable()) continue;
    mass += 1 / body.inverse_mass;
    ++count;
  }
  if (count == 0) return 1;
  const Real speed = world.gravity.norm() > 0 ? world.gravity.norm() * dt : 1;
  return typical_size(world) / (mass / static_cast<Real>(count) * speed);
}

namespace {

/// A thin rod from corner to corner, about three pixels thick wherever the camera stands.
void add_line(Picture& picture, const std::vector<Vec3>& corners) {
  const Real radius = Real(0.0022) * (picture.camera.eye - picture.camera.target).norm();
  for (std::size_t i = 1; i < corners.size(); ++i) {
    const Vec3 way = corners[i] - corners[i - 1];
    if (way.isZero(0)) continue;
    const Tangents across = tangents_of(way.normalized());
    Mat3 axes;
    axes << across.tangent2, way.normalized(), across.tangent1;  // a capsule lies along its y axis
    picture.solids.push_back(
        {Capsule{radius, way.norm() / 2}, (corners[i] + corners[i - 1]) / 2, Quat(axes), near_black_colour()});
  }
}

}  // namespace

Picture picture_of(const World& world, const Camera& camera, Real arrow) {
  Picture picture;
  picture.camera = camera;
  for (const Body& body : world.bodies) {
    const bool neutral = !body.movable() && body.colour < 0;
    picture.solids.push_back({body.shape, body.position, body.orientation,
                              body.asleep ? asleep_colour()
                              : neutral   ? fixed_colour()
                                          : body_colour(body.colour >= 0 ? body.colour : body.index)});
  }
  for (const Joint& joint : world.joints) {
    if (joint.line) add_line(picture, joint.line(body_of(world, joint.a), body_of(world, joint.b)));
  }
  const Real size = typical_size(world);
  for (const Contact& contact : world.contacts) {
    picture.dots.push_back({contact.point, Real(0.06) * size, contact_colour(contact.state)});
    const Real along = contact.impulse.dot(contact.normal);
    const Vec3 across = contact.impulse - along * contact.normal;
    const auto add = [&](const Vec3& impulse, Colour colour) {
      const Real length = std::min(arrow * impulse.norm(), Real(1.5) * size);
      if (length < Real(0.05) * size) return;
      picture.arrows.push_back(
          {contact.point, contact.point + length * impulse.normalized(), Real(0.045) * size, colour});
    };
    add(along * contact.normal, normal_arrow_colour());
    add(across, friction_arrow_colour());
  }
  return picture;
}

}  // namespace pushback
