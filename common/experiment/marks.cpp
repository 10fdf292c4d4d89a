#include "pushback/common/experiment/marks.h"

#include <algorithm>
#include <cmath>

namespace pushback {

namespace {

/// An arc about `normal`, from the direction `towards` through the angle `to` (rad); 2 pi gives the whole ring.
std::vector<Vec3> arc(const Vec3& centre, const Vec3& normal, const Vec3& towards, Real radius, Real to) {
  constexpr int corners_of_ring = 48;
  const int count = std::max(2, static_cast<int>(std::lround(corners_of_ring * to / (2 * pi))));
  const Vec3 aside = normal.cross(towards);
  std::vector<Vec3> corners;
  for (int i = 0; i <= count; ++i) {
    const Real angle = to * static_cast<Real>(i) / static_cast<Real>(count);
    corners.emplace_back(centre + radius * (std::cos(angle) * towards + std::sin(angle) * aside));
  }
  return corners;
}

/// Lines in the axes of a body.
struct Outline {
  std::vector<std::vector<Vec3>> lines;

  void operator()(const Sphere& ball) {
    for (int axis = 0; axis < 3; ++axis)
      lines.push_back(arc(Vec3::Zero(), Vec3::Unit(axis), Vec3::Unit((axis + 1) % 3), ball.radius, 2 * pi));
  }
  void operator()(const Box& box) {
    for (int axis = 0; axis < 3; ++axis) {
      for (int corner = 0; corner < 4; ++corner) {
        Vec3 from = -box.half_extents;
        if ((corner & 1) != 0) from((axis + 1) % 3) *= -1;
        if ((corner & 2) != 0) from((axis + 2) % 3) *= -1;
        Vec3 to = from;
        to(axis) *= -1;
        lines.push_back({from, to});
      }
    }
  }
  void operator()(const Capsule& capsule) {
    const Vec3 up = Vec3::UnitY(), top = capsule.half_length * up;
    for (const Vec3& end : {top, Vec3(-top)}) lines.push_back(arc(end, up, Vec3::UnitX(), capsule.radius, 2 * pi));
    for (const Vec3& side : {Vec3(Vec3::UnitX()), Vec3(Vec3::UnitZ())}) {
      std::vector<Vec3> around = arc(top, side.cross(up), side, capsule.radius, pi);
      const std::vector<Vec3> below = arc(-top, side.cross(up), -side, capsule.radius, pi);
      around.insert(around.end(), below.begin(), below.end());
      around.push_back(around.front());
      lines.push_back(std::move(around));
    }
  }
  void operator()(const HalfSpace&) {}
  void operator()(const Hull& hull) {
    const Polyhedron& solid = *hull.solid;
    for (const Polyhedron::Edge& edge : solid.edges) {
      lines.push_back(
          {solid.corners[static_cast<std::size_t>(edge.from)], solid.corners[static_cast<std::size_t>(edge.to)]});
    }
  }
};

}  // namespace

void add_line(Picture& picture, const std::vector<Vec3>& corners, Colour colour, Real pixels) {
  const Camera& camera = picture.camera;
  for (std::size_t i = 1; i < corners.size(); ++i) {
    const Vec3 &from = corners[i - 1], &to = corners[i];
    // In pieces, each with the thickness for its own distance. The distance changes by the same factor over each piece.
    const Real ratio = camera.height_at(to) / camera.height_at(from);
    const int pieces =
        static_cast<int>(std::clamp(std::ceil(std::abs(std::log(ratio)) / Real(0.1)), Real(1), Real(64)));
    Vec3 begin = from;
    for (int k = 1; k <= pieces; ++k) {
      const Real share = static_cast<Real>(k) / static_cast<Real>(pieces);
      const Vec3 end = pieces == 1 ? to : from + (std::pow(ratio, share) - 1) / (ratio - 1) * (to - from);
      picture.lines.push_back({begin, end, pixels / 281 * camera.height_at((begin + end) / 2), colour});
      begin = end;
    }
  }
}

void add_ring(Picture& picture, const Vec3& centre, const Vec3& normal, Real radius, Colour colour, Real pixels) {
  const Vec3 axis = normal.normalized();
  add_line(picture, arc(centre, axis, tangents_of(axis).tangent1, radius, 2 * pi), colour, pixels);
}

void add_outline(Picture& picture, const Body& body, Colour colour, Real pixels) {
  Outline outline;
  std::visit(outline, body.shape);
  for (std::vector<Vec3>& corners : outline.lines) {
    for (Vec3& corner : corners) corner = body.position + body.orientation * corner;
    add_line(picture, corners, colour, pixels);
  }
}

void add_arrow(Picture& picture, const Vec3& tail, const Vec3& tip, Colour colour) {
  picture.arrows.push_back({tail, tip, arrow_thickness(picture.camera, tail), colour});
}

}  // namespace pushback
