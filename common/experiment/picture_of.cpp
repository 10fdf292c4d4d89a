#include "pushback/common/experiment/picture_of.h"

#include <algorithm>

#include "pushback/common/experiment/marks.h"
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

/// The mean size of the movable bodies, m; 1 if there are none.
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

/// A thin rod from corner to corner.
void add_rod(Picture& picture, const std::vector<Vec3>& corners) {
  for (std::size_t i = 1; i < corners.size(); ++i) {
    const Vec3 way = corners[i] - corners[i - 1], middle = (corners[i] + corners[i - 1]) / 2;
    if (way.isZero(0)) continue;
    const Real radius = line_pixels / 2 / 281 * picture.camera.height_at(middle);
    const Tangents across = tangents_of(way.normalized());
    Mat3 axes;
    axes << across.tangent2, way.normalized(), across.tangent1;  // a capsule lies along its y axis
    picture.solids.push_back({Capsule{radius, way.norm() / 2}, middle, Quat(axes), near_black_colour()});
  }
}

void add_body(Picture& picture, const Body& body) {
  const bool neutral = !body.movable() && body.colour < 0;
  picture.solids.push_back({body.shape, body.position, body.orientation,
                            body.asleep ? asleep_colour()
                            : neutral   ? fixed_colour()
                                        : body_colour(body.colour >= 0 ? body.colour : body.index)});
}

void add_contact(Picture& picture, const Contact& contact, Real arrow, Real size) {
  const Real dot = std::min(Real(0.018) * picture.camera.height_at(contact.point), Real(0.15) * size);
  picture.dots.push_back({contact.point, dot, contact_colour(contact.state)});
  const Real along = contact.impulse.dot(contact.normal);
  const auto add = [&](const Vec3& impulse, Colour colour) {
    const Real length = std::min(arrow * impulse.norm(), Real(1.5) * size);
    if (length < Real(1.3) * dot) return;
    const Real thickness = std::min(arrow_thickness(picture.camera, contact.point), Real(0.1) * size);
    picture.arrows.push_back({contact.point, contact.point + length * impulse.normalized(), thickness, colour});
  };
  add(along * contact.normal, normal_arrow_colour());
  add(contact.impulse - along * contact.normal, friction_arrow_colour());
}

void add_moving(Picture& picture, const World& world, std::optional<Real> arrow) {
  for (const Body& body : world.bodies) {
    if (body.movable()) add_body(picture, body);
  }
  for (const Joint& joint : world.joints) {
    if (joint.line) add_rod(picture, joint.line(body_of(world, joint.a), body_of(world, joint.b)));
  }
  if (!arrow) return;
  const Real size = typical_size(world);
  for (const Contact& contact : world.contacts)
    if (!contact.parted) add_contact(picture, contact, *arrow, size);
}

}  // namespace

Picture picture_of(const World& world, const Camera& camera, std::optional<Real> arrow) {
  Picture picture;
  picture.camera = camera;
  for (const Body& body : world.bodies) {
    if (!body.movable() && !body.removed) add_body(picture, body);
  }
  add_moving(picture, world, arrow);
  return picture;
}

void add_moving(Picture& picture, const World& world, std::optional<Real> arrow, const Vec3& shift,
                const std::function<void(Picture&, const World&)>& marks) {
  // The camera is shifted the other way, so that each dot gets the size for its final position.
  Picture added;
  added.camera = picture.camera;
  added.camera.eye -= shift;
  added.camera.target -= shift;
  add_moving(added, world, arrow);
  if (marks) marks(added, world);
  for (Solid& solid : added.solids) solid.position += shift;
  for (Dot& dot : added.dots) dot.position += shift;
  for (Line& line : added.lines) {
    line.from += shift;
    line.to += shift;
  }
  for (Arrow& one : added.arrows) {
    one.tail += shift;
    one.tip += shift;
  }
  picture.solids.insert(picture.solids.end(), added.solids.begin(), added.solids.end());
  picture.dots.insert(picture.dots.end(), added.dots.begin(), added.dots.end());
  picture.lines.insert(picture.lines.end(), added.lines.begin(), added.lines.end());
  picture.arrows.insert(picture.arrows.end(), added.arrows.begin(), added.arrows.end());
}

World magnified(const World& world, const World& start, Real times) {
  World drawn = world;
  for (std::size_t i = 0; i < std::min(world.bodies.size(), start.bodies.size()); ++i) {
    Body& body = drawn.bodies[i];
    const Body& was = start.bodies[i];
    if (!body.movable()) continue;
    body.position = was.position + times * (body.position - was.position);
    Quat turn = body.orientation * was.orientation.conjugate();
    if (turn.w() < 0) turn.coeffs() *= -1;  // the shorter way round
    const Eigen::AngleAxis<Real> turned(turn);
    body.orientation = Quat(Eigen::AngleAxis<Real>(times * turned.angle(), turned.axis())) * was.orientation;
  }
  for (Contact& contact : drawn.contacts) {
    const std::size_t on = world.bodies[contact.id.body_a].movable() ? contact.id.body_a : contact.id.body_b;
    contact.point = point_of(drawn.bodies[on], point_on(world.bodies[on], contact.point));
  }
  return drawn;
}

}  // namespace pushback
