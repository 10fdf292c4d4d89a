#include "pushback/tools/classroom/bodies_picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "pushback/common/collision/broad_phase.h"
#include "pushback/common/experiment/marks.h"
#include "pushback/common/experiment/picture_of.h"
#include "pushback/common/render/canvas.h"
#include "pushback/common/render/painter.h"
#include "pushback/common/render/palette.h"

namespace pushback {

namespace {

constexpr int passes = 8;
constexpr Real clearly = Real(0.02);  // of the largest: what differs by less is not drawn
constexpr Ink white{255, 255, 255}, slip_ink{214, 120, 0};

/// Drawn over the bodies, so that none hides it: with a head at the end of its path, m, world axes.
struct Stroke {
  std::vector<Vec3> path;
  Ink ink;
};

/// How long arrows are: one scale for both halves.
struct Scale {
  Real of_velocity = 0, of_spin = 0, of_impulse = 0;  ///< m for 1 m/s, rad for 1 rad/s, m for 1 N s; 0: not drawn
  Real of_slip = 0;                                   ///< m for 1 m/s
  Real longest = 0, widest = 0, strongest = 0;        ///< m, rad, m: what is longer is cut
  Real least_radius = 0;                              ///< m, of a curved arrow
  bool cut = false;
};

Real typical_size(const World& world) {
  Real sum = 0, count = 0;
  for (const Body& body : world.bodies) {
    if (!body.movable()) continue;
    sum += size_of(body);
    ++count;
  }
  return count > 0 ? sum / count : 1;
}

/// The largest of something in a world.
template <class Measure>
Real largest(const World& world, Measure measure) {
  Real most = 0;
  for (const Body& body : world.bodies)
    if (body.movable()) most = std::max(most, measure(body));
  return most;
}
Real fastest(const World& world) {
  return largest(world, [](const Body& body) { return body.velocity.norm(); });
}
Real fastest_spin(const World& world) {
  return largest(world, [](const Body& body) { return body.angular_velocity.norm(); });
}
Real strongest(const World& world) {
  Real most = 0;
  for (const Contact& contact : world.contacts) most = std::max(most, contact.impulse.norm());
  return most;
}

Vec3 friction_of(const Contact& contact) {
  return contact.impulse - contact.impulse.dot(contact.normal) * contact.normal;
}
Real rubbed(const World& world) {
  Real most = 0;
  for (const Contact& contact : world.contacts) most = std::max(most, friction_of(contact).norm());
  return most;
}

/// How the surfaces move past each other where bodies touch, m/s.
Vec3 slip_of(const World& world, const Contact& contact) {
  const auto [a, b] = world.bodies_of(contact);
  const Vec3 velocity = b.velocity_at(contact.point) - a.velocity_at(contact.point);
  return velocity - velocity.dot(contact.normal) * contact.normal;
}
Real fastest_slip(const World& world) {
  Real most = 0;
  for (const Contact& contact : world.contacts) most = std::max(most, slip_of(world, contact).norm());
  return most;
}
/// Where friction acts: of the same contacts.
bool slip_differs(const World& yours, const World& right) {
  if (std::max(rubbed(yours), rubbed(right)) < Real(1e-3) || yours.contacts.size() != right.contacts.size())
    return false;
  Real most = 0;
  for (std::size_t i = 0; i < right.contacts.size(); ++i)
    most = std::max(most, (slip_of(yours, yours.contacts[i]) - slip_of(right, right.contacts[i])).norm());
  return most > std::max(clearly * std::max(fastest_slip(yours), fastest_slip(right)), Real(1e-3));
}

/// So much for each unit that the larger is drawn as `full`; yet what is right is to remain visible beside what is far off.
Real scale_of(Real yours, Real right, Real full, bool& cut) {
  constexpr Real most_times = 6;
  const bool far_off = right > Real(1e-3) && yours > most_times * right;
  cut = cut || far_off;
  return full / (far_off ? most_times * right : std::max(yours, right));
}

/// `high`: m, what the picture shows from its bottom to its top.
Scale scale_for(const World& yours, const World& right, const Apart& apart, Real high) {
  Scale scale;
  const Real size = std::max(typical_size(right), high / 6);  // an arrow needs room for its head
  scale.longest = Real(1.2) * size;
  scale.widest = Real(4.5);
  scale.strongest = Real(0.5) * size;
  scale.least_radius = high / 12;
  if (apart.speed > clearly) scale.of_velocity = scale_of(fastest(yours), fastest(right), scale.longest, scale.cut);
  if (slip_differs(yours, right))
    scale.of_slip = scale_of(fastest_slip(yours), fastest_slip(right), scale.longest, scale.cut);
  if (apart.spin > clearly) scale.of_spin = scale_of(fastest_spin(yours), fastest_spin(right), scale.widest, scale.cut);
  if (apart.impulse > clearly && std::max(strongest(yours), strongest(right)) > 0)
    scale.of_impulse = scale_of(strongest(yours), strongest(right), scale.strongest, scale.cut);
  return scale;
}

void add_straight(std::vector<Stroke>& strokes, const Vec3& from, const Vec3& value, Real scale, Real longest,
                  Ink ink) {
  const Real length = std::min(scale * value.norm(), longest);
  if (length > Real(0.02) * longest) strokes.push_back({{from, from + length * value.normalized()}, ink});
}

/// Around the body, seen from the side of the camera.
void add_turn(std::vector<Stroke>& strokes, const Body& body, const Scale& scale, const Vec3& eye) {
  const Real spin = body.angular_velocity.norm(), angle = std::min(scale.of_spin * spin, scale.widest);
  if (angle < Real(0.02) * scale.widest) return;
  const Vec3 axis = body.angular_velocity / spin, ahead = (eye - body.position).normalized();
  Vec3 towards = ahead - ahead.dot(axis) * axis;
  if (towards.norm() < Real(0.3)) towards = tangents_of(axis).tangent1;
  towards.normalize();
  const Vec3 aside = axis.cross(towards);
  const Real radius = std::max(Real(0.6) * size_of(body), scale.least_radius);
  constexpr int pieces = 40;
  Stroke stroke{{}, near_black_ink()};
  for (int i = 0; i <= pieces; ++i) {
    const Real at = angle * (static_cast<Real>(i) / pieces - Real(0.5));
    stroke.path.emplace_back(body.position + radius * (std::cos(at) * towards + std::sin(at) * aside));
  }
  strokes.push_back(std::move(stroke));
}

std::vector<Stroke> strokes_of(const World& world, const Scale& scale, const Vec3& eye) {
  std::vector<Stroke> strokes;
  for (const Contact& contact : world.contacts) {
    const Vec3 friction = friction_of(contact);
    add_straight(strokes, contact.point, contact.impulse - friction, scale.of_impulse, scale.strongest,
                 normal_arrow_ink());
    add_straight(strokes, contact.point, friction, scale.of_impulse, scale.strongest, friction_arrow_ink());
  }
  for (const Contact& contact : world.contacts)
    add_straight(strokes, contact.point, slip_of(world, contact), scale.of_slip, scale.longest, slip_ink);
  for (const Body& body : world.bodies) {
    if (!body.movable()) continue;
    add_straight(strokes, body.position, body.velocity, scale.of_velocity, scale.longest, near_black_ink());
    add_turn(strokes, body, scale, eye);
  }
  return strokes;
}

/// Where a camera's picture of so many pixels has a point.
class View {
 public:
  View(const Camera& camera, int width, int height)
      : camera_(camera),
        width_(width),
        height_(height),
        ahead_((camera.target - camera.eye).normalized()),
        right_(ahead_.cross(Vec3::UnitY()).normalized()),
        up_(right_.cross(ahead_)) {}
  Spot operator()(const Vec3& point) const {
    const Vec3 from_eye = point - camera_.eye;
    const Real pixels = static_cast<Real>(height_) / camera_.height_at(point);
    return {static_cast<double>(static_cast<Real>(width_) / 2 + pixels * right_.dot(from_eye)),
            static_cast<double>(static_cast<Real>(height_) / 2 - pixels * up_.dot(from_eye))};
  }

 private:
  Camera camera_;
  int width_, height_;
  Vec3 ahead_, right_, up_;
};

/// With a rim, since bodies have all colours.
void draw(Image& image, const Stroke& stroke, const View& view) {
  const float wide = static_cast<float>(image.height) / 75;
  std::vector<Spot> path;
  for (const Vec3& point : stroke.path) path.push_back(view(point));
  // The head takes the last pieces of the path.
  std::size_t neck = path.size() - 2;
  const auto from_tip = [&](std::size_t i) { return std::hypot(path.back().x - path[i].x, path.back().y - path[i].y); };
  while (neck > 0 && from_tip(neck) < 5.0 * static_cast<double>(wide)) --neck;
  const auto draw_at = [&](double x, double y, Ink ink) {
    const auto moved = [&](const Spot& spot) { return Spot{spot.x + x, spot.y + y}; };
    for (std::size_t i = 0; i < neck; ++i) draw_line(image, moved(path[i]), moved(path[i + 1]), wide, ink);
    draw_arrow(image, moved(path[neck]), moved(path.back()), wide, ink);
  };
  constexpr int around = 12;
  constexpr double rim = 2;  // pixels
  for (int i = 0; i < around; ++i)
    draw_at(rim * std::cos(2 * pi * i / around), rim * std::sin(2 * pi * i / around), white);
  draw_at(0, 0, stroke.ink);
}

Bounds together(const Bounds& a, const Bounds& b) {
  return {a.low.cwiseMin(b.low), a.high.cwiseMax(b.high)};
}

void add_corners(std::vector<Vec3>& points, const Bounds& bounds) {
  for (int corner = 0; corner < 8; ++corner)
    points.emplace_back((corner & 1) != 0 ? bounds.high.x() : bounds.low.x(),
                        (corner & 2) != 0 ? bounds.high.y() : bounds.low.y(),
                        (corner & 4) != 0 ? bounds.high.z() : bounds.low.z());
}

/// What is to be in the picture: all that moves, but for bodies that have gone far from where they should be.
std::vector<Vec3> corners_of(const World& yours, const World& right) {
  std::vector<Vec3> points;
  std::optional<Bounds> all;
  for (const Body& body : right.bodies)
    if (body.movable()) all = all ? together(*all, bounds_of(body)) : bounds_of(body);
  if (!all) return {Vec3::Zero()};
  for (const Joint& joint : right.joints) {
    if (!joint.line) continue;
    for (const Vec3& corner : joint.line(body_of(right, joint.a), body_of(right, joint.b))) {
      all = together(*all, {corner, corner});
      points.push_back(corner);
    }
  }
  const Real extent = (all->high - all->low).maxCoeff();
  for (std::size_t i = 0; i < right.bodies.size(); ++i) {
    const Bounds should_be = bounds_of(right.bodies[i]);
    const bool floor = !should_be.low.allFinite() || !should_be.high.allFinite();
    if (floor || (!right.bodies[i].movable() && (should_be.high - should_be.low).maxCoeff() > 3 * extent)) continue;
    add_corners(points, should_be);
    if ((yours.bodies[i].position - right.bodies[i].position).norm() < 3 * extent)
      add_corners(points, bounds_of(yours.bodies[i]));
  }
  return points;
}

/// How well it is seen from there, 1 at best: bodies beside each other, a velocity that differs from its side, slopes from
/// above.
Real seen_from(const Vec3& back, const World& yours, const World& right) {
  const auto across = [&](const Vec3& v) { return (v - v.dot(back) * back).norm(); };
  Real seen = 1, most = 0;
  Vec3 differs = Vec3::Zero();
  for (std::size_t i = 0; i < right.bodies.size(); ++i) {
    const Body& one = right.bodies[i];
    if (const auto* slope = std::get_if<HalfSpace>(&one.shape))
      seen = std::min(seen, 4 * back.dot(one.orientation * slope->normal));
    if (!one.movable()) continue;
    for (std::size_t k = 0; k < i; ++k) {
      const Vec3 between = one.position - right.bodies[k].position;
      if (!right.bodies[k].movable() || between.isZero(0)) continue;
      const Real apart = std::min(between.norm(), (size_of(one) + size_of(right.bodies[k])) / 2);
      seen = std::min(seen, across(between) / apart);
    }
    const Vec3 difference = yours.bodies[i].velocity - one.velocity;
    if (difference.norm() <= most) continue;
    most = difference.norm();
    differs = difference;
  }
  if (apart(yours, right).speed > clearly) seen = std::min(seen, across(differs) / most);
  return seen;
}

/// From before, a little from the right and from above; from elsewhere where little is seen from there.
Vec3 side_of_camera(const World& yours, const World& right) {
  constexpr Real enough = Real(0.8);
  const Vec3 usual = Vec3(Real(0.4), Real(0.32), 1).normalized();
  Vec3 best = usual;
  for (const Real degrees : {0, -45, 45, -90, 90, -135, 135, 180}) {
    const Vec3 back = Quat(Eigen::AngleAxis<Real>(degrees * pi / 180, Vec3::UnitY())) * usual;
    if (seen_from(best, yours, right) > enough) break;
    if (seen_from(back, yours, right) > seen_from(best, yours, right)) best = back;
  }
  return best;
}

/// As near as all points are in the picture with some room.
Camera camera_for(const std::vector<Vec3>& points, Real aspect, const Vec3& back) {
  constexpr Real room = Real(0.86);
  Camera camera;
  camera.field_of_view = Real(0.5);
  const Vec3 right = Vec3::UnitY().cross(back).normalized(), up = back.cross(right);
  const Real tall = room * std::tan(camera.field_of_view / 2), wide = tall * aspect;
  camera.target = points.front();
  for (int round = 0; round < 8; ++round) {
    Real distance = Real(0.1);
    for (const Vec3& point : points) {
      const Vec3 at = point - camera.target;
      distance =
          std::max(distance, back.dot(at) + std::max(std::abs(right.dot(at)) / wide, std::abs(up.dot(at)) / tall));
    }
    // What is to the left and to the right of the target, and below and above it, gets as much room.
    Real left = 0, most_right = 0, bottom = 0, top = 0;
    for (const Vec3& point : points) {
      const Vec3 at = point - camera.target;
      const Real nearer = distance / std::max(Real(0.1) * distance, distance - back.dot(at));
      left = std::min(left, nearer * right.dot(at));
      most_right = std::max(most_right, nearer * right.dot(at));
      bottom = std::min(bottom, nearer * up.dot(at));
      top = std::max(top, nearer * up.dot(at));
    }
    camera.target += (left + most_right) / 2 * right + (bottom + top) / 2 * up;
    camera.eye = camera.target + distance * back;
  }
  return camera;
}

/// How many times a deviation is drawn so as to be at most so large.
Real times_drawn(Real deviation, Real most) {
  Real times = 1;
  if (deviation < Real(1e-5)) return times;
  for (const Real more : {2, 5, 10, 20, 50, 100, 200, 500, 1000, 2000, 5000, 10000})
    if (more * deviation <= most) times = more;
  return times;
}

/// The same of where bodies are, if an eye would miss it, and it is what tells, or nothing else does.
Real times_drawn(const Apart& apart, bool of_place) {
  const Real deviation = std::max(apart.place, apart.turn);
  const bool moving = std::max(apart.speed, apart.spin) > Real(0.1);
  if (deviation > Real(0.06) || (moving && !of_place)) return 1;
  return times_drawn(deviation, Real(0.25));
}

/// Bodies that move as those of `world` do, but so many times as far off the right ones.
World faster_off(World world, const World& right, Real times) {
  for (std::size_t i = 0; i < world.bodies.size(); ++i) {
    Body& body = world.bodies[i];
    const Body& right_one = right.bodies[i];
    body.velocity = right_one.velocity + times * (body.velocity - right_one.velocity);
    body.angular_velocity = right_one.angular_velocity + times * (body.angular_velocity - right_one.angular_velocity);
  }
  return world;
}

/// So far that it is seen.
bool is_off(const Body& body, const Body& right) {
  return (body.position - right.position).norm() > Real(0.02) * size_of(right) ||
         body.orientation.angularDistance(right.orientation) > Real(0.02);
}

/// The floor or slope is before it.
bool hidden(const Body& body, const World& world) {
  return std::any_of(world.bodies.begin(), world.bodies.end(), [&](const Body& other) {
    const auto* floor = std::get_if<HalfSpace>(&other.shape);
    return floor && body.movable() && (body.position - other.position).dot(floor->normal) < 0;
  });
}

}  // namespace

BodiesPicture picture_of_bodies(const World& yours, const World& right, int width, int height, bool of_place) {
  BodiesPicture made;
  Apart differing = apart(yours, right);
  const Real times = times_drawn(differing, of_place);
  std::array<World, 2> worlds{times > 1 ? magnified(yours, right, times) : yours, right};
  const Apart drawn = apart(worlds[0], right);
  const bool outlined = std::max(drawn.place, drawn.turn) > Real(0.02);
  Real times_faster = 1;
  if (times > 1 && of_place) differing.speed = differing.spin = 0;
  else if (!outlined && std::max({differing.speed, differing.spin, differing.impulse}) <= clearly)
    times_faster = times_drawn(std::max(differing.speed, differing.spin), Real(0.5));
  if (times_faster > 1) {
    worlds[0] = faster_off(worlds[0], right, times_faster);
    differing = apart(worlds[0], right);
  }

  const Real aspect = static_cast<Real>(width) / static_cast<Real>(height);
  std::vector<Vec3> points = corners_of(worlds[0], right);
  const Vec3 side = side_of_camera(yours, right);
  Camera camera = camera_for(points, aspect, side);
  const Scale scale = scale_for(worlds[0], right, differing, camera.height_at(camera.target));
  for (const World& world : worlds)
    for (const Stroke& stroke : strokes_of(world, scale, camera.eye))
      points.insert(points.end(), stroke.path.begin(), stroke.path.end());
  camera = camera_for(points, aspect, side);

  Painter painter(width, height);
  Legend legend;
  std::array<Image, 2> images;
  for (std::size_t half = 0; half < 2; ++half) {
    Picture picture = picture_of(worlds[half], camera, Real(0));
    legend.see(picture);
    for (std::size_t i = 0; i < right.bodies.size(); ++i) {
      const Body &one = worlds[half].bodies[i], &right_one = right.bodies[i];
      if (outlined && one.movable() && is_off(one, right_one)) add_outline(picture, right_one);
      if (hidden(one, worlds[half])) add_outline(picture, one);
    }
    images[half] = painter.draw_still(picture, passes);
    for (const Stroke& stroke : strokes_of(worlds[half], scale, camera.eye))
      draw(images[half], stroke, View(camera, width, height));
  }
  made.yours = std::move(images[0]);
  made.right = std::move(images[1]);

  made.legend = legend.entries();
  using Kind = LegendEntry::Kind;
  const auto arrow = [&](bool there, Ink ink, const std::string& words, Real most, const std::string& unit) {
    const std::string longest = times_faster > 1 ? "" : fmt::format(" (the longest: {:.3g} {})", most, unit);
    if (there) made.legend.push_back({Kind::arrow, ink, words + longest});
  };
  arrow(scale.of_velocity > 0, near_black_ink(), "velocity", std::max(fastest(yours), fastest(right)), "m/s");
  arrow(scale.of_spin > 0, near_black_ink(), "spin, curved", std::max(fastest_spin(yours), fastest_spin(right)),
        "rad/s");
  arrow(scale.of_impulse > 0, normal_arrow_ink(), "impulse", std::max(strongest(yours), strongest(right)), "N s");
  arrow(scale.of_impulse > 0 && std::max(rubbed(yours), rubbed(right)) > Real(1e-3), friction_arrow_ink(), "friction",
        std::max(rubbed(yours), rubbed(right)), "N s");
  arrow(scale.of_slip > 0, slip_ink, "slip", std::max(fastest_slip(yours), fastest_slip(right)), "m/s");
  if (times > 1) made.note = fmt::format("Yours deviates so little that it is drawn {:.0f} times as far off. ", times);
  if (times_faster > 1)
    made.note =
        fmt::format("Yours moves so little otherwise that the difference is drawn {:.0f} times. ", times_faster);
  if (outlined) made.note += "Thin lines: where the right ones are. ";
  if (scale.cut) made.note += "Arrows that are more than six times as long as the longest right one are cut. ";
  return made;
}

}  // namespace pushback
