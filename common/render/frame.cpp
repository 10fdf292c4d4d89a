#include "pushback/common/render/frame.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "pushback/common/basics/input.h"
#include "pushback/common/render/mesh.h"

namespace pushback {
namespace {

using Eigen::Matrix3f;
using Eigen::Matrix4f;
using Eigen::Vector2f;
using Eigen::Vector3f;

constexpr float checker_period = 20;  // m, after which the pattern of 0.1 m, 1 m and 10 m cells repeats

Vector3f rgb(const Colour& colour) {
  return {colour.red, colour.green, colour.blue};
}

std::array<float, 4> turn_of(const Quat& q) {
  return {static_cast<float>(q.x()), static_cast<float>(q.y()), static_cast<float>(q.z()), static_cast<float>(q.w())};
}

Matrix3f rotation_of(const Instance& instance) {
  const auto& [x, y, z, w] = instance.turn;
  return Eigen::Quaternionf(w, x, y, z).toRotationMatrix();
}

float reach_of(const Instance& instance) {
  return instance.half_extents.norm() + instance.radius;
}

/// The position of a coordinate (m) on the checker pattern.
float phase_of(Real metres) {
  return static_cast<float>(std::remainder(static_cast<double>(metres), static_cast<double>(checker_period)));
}

/// The rotation of y onto a unit vector, by the half-way quaternion (1 + y . d, y x d).
std::array<float, 4> turn_onto(const Vector3f& direction) {
  Eigen::Quaternionf turn(1 + direction.y(), direction.z(), 0, -direction.x());
  turn = direction.y() < -0.9999f ? Eigen::Quaternionf(0, 1, 0, 0) : turn.normalized();
  return {turn.x(), turn.y(), turn.z(), turn.w()};
}

bool drawable(const Solid& solid) {
  // A simulation that blew up is still drawn, without the bodies that went to infinity.
  constexpr Real limit = Real(1e9);
  return solid.position.cwiseAbs().maxCoeff() < limit && solid.orientation.coeffs().allFinite() &&
         solid.position.allFinite();
}

}  // namespace

Frame::Frame(const Picture& picture) {
  const Camera& camera = picture.camera;
  require_finite("the camera's eye", camera.eye);
  require_finite("the camera's target", camera.target);
  require_between("the camera's field of view", camera.field_of_view, Real(0.001), Real(3));
  const Vec3 ahead = camera.target - camera.eye;
  require_positive("the distance from the camera's eye to its target", ahead.norm());
  scale = static_cast<float>(ahead.norm());
  field_of_view = static_cast<float>(camera.field_of_view);
  target = ahead.cast<float>();
  forward = ahead.normalized().cast<float>();
  const bool steep = std::abs(forward.y()) > 0.999f;
  right =
      forward.cross(steep ? Vector3f(0, 0, forward.y() > 0 ? 1.0f : -1.0f) : Vector3f(Vector3f::UnitY())).normalized();
  up = right.cross(forward);

  for (const Solid& solid : picture.solids) {
    if (drawable(solid)) add(solid, camera.eye);
  }
  for (const Line& line : picture.lines) add(line, camera.eye);
  for (const Arrow& arrow : picture.arrows) add(arrow, camera.eye);
  for (const Dot& dot : picture.dots) {
    if (!dot.position.allFinite()) continue;
    dots.push_back({(dot.position - camera.eye).cast<float>(),
                    static_cast<float>(dot.radius),
                    {0, 0, 0, 1},
                    Vector3f::Zero(),
                    rgb(dot.colour)});
  }
  // Only the first of the hidden marks at a pixel is blended in, so the nearest has to come first.
  const auto nearer = [](const Instance& a, const Instance& b) {
    return a.position.squaredNorm() < b.position.squaredNorm();
  };
  for (auto* marks : {&shafts, &heads, &dots}) std::stable_sort(marks->begin(), marks->end(), nearer);
  choose_depths();
}

void Frame::add(const Solid& solid, const Vec3& eye) {
  Instance instance{(solid.position - eye).cast<float>(), 0, turn_of(solid.orientation), Vector3f::Zero(),
                    rgb(solid.colour)};
  if (const auto* ball = std::get_if<Sphere>(&solid.shape)) {
    instance.radius = static_cast<float>(ball->radius);
    balls.push_back(instance);
  } else if (const auto* capsule = std::get_if<Capsule>(&solid.shape)) {
    instance.radius = static_cast<float>(capsule->radius);
    instance.half_extents.y() = static_cast<float>(capsule->half_length);
    balls.push_back(instance);
  } else if (const auto* box = std::get_if<Box>(&solid.shape)) {
    const Vector3f full = box->half_extents.cast<float>();
    instance.radius = std::min(0.15f * full.minCoeff(), 0.01f * scale);  // the bevel
    instance.half_extents = full.array() - instance.radius;
    boxes.push_back(instance);
  } else if (const auto* space = std::get_if<HalfSpace>(&solid.shape)) {
    add_plane((solid.orientation * space->normal).normalized(), solid.position - eye);
  } else if (const auto* hull = std::get_if<Hull>(&solid.shape)) {
    const Polyhedron* which = hull->solid.get();
    const auto known =
        std::find_if(hulls.begin(), hulls.end(), [which](const HullInstances& one) { return one.solid == which; });
    Real thinnest = which->half_width;
    for (const Polyhedron::Face& face : which->faces) thinnest = std::min(thinnest, face.half_width);
    instance.radius = std::min(0.15f * static_cast<float>(thinnest), 0.01f * scale);  // the bevel
    instance.half_extents = half_extents_of(*which);
    if (known != hulls.end()) known->instances.push_back(instance);
    else hulls.push_back({which, instance.radius, {instance}});
  }
}

void Frame::add(const Line& line, const Vec3& eye) {
  const Vector3f middle = ((line.from + line.to) / 2 - eye).cast<float>(), way = (line.to - line.from).cast<float>();
  const float length = way.norm(), radius = static_cast<float>(line.thickness) / 2;
  if (!(length > 0) || !std::isfinite(length) || !middle.allFinite() || !(radius > 0)) return;
  // A little longer at both ends, so that two lines that meet close their corner.
  shafts.push_back({middle, 0, turn_onto(way / length), {radius, length / 2 + radius / 2, radius}, rgb(line.colour)});
}

void Frame::add(const Arrow& arrow, const Vec3& eye) {
  const Vector3f tail = (arrow.tail - eye).cast<float>(), shaft = (arrow.tip - arrow.tail).cast<float>();
  const float length = shaft.norm();
  if (!(length > 0) || !std::isfinite(length) || !tail.allFinite() || !(arrow.thickness > 0)) return;
  const Vector3f direction = shaft / length;
  // Short arrows become smaller, not stubbier, so that a shaft is always visible.
  constexpr float base = 1.25f;  // radius of the head's base divided by the shaft's diameter
  const float thickness = std::min(static_cast<float>(arrow.thickness), length / (1.5f * base * head_slimness));
  const float head = base * head_slimness * thickness;
  const std::array<float, 4> turned = turn_onto(direction);
  const float rest = (length - head) / 2;
  shafts.push_back({tail + rest * direction, 0, turned, {thickness / 2, rest, thickness / 2}, rgb(arrow.colour)});
  heads.push_back({tail + (length - head / 2) * direction,
                   0,
                   turned,
                   {base * thickness, head / 2, base * thickness},
                   rgb(arrow.colour)});
}

void Frame::add_plane(const Vec3& normal, const Vec3& point) {
  const Real height = -normal.dot(point);  // height of the eye above the plane
  if (!(height > 0)) return;               // a half-space is invisible from inside
  const bool level = normal.y() > Real(0.9999);
  const Vec3 across = level ? Vec3(Vec3::UnitX()) : Vec3(Vec3::UnitY().cross(normal).normalized());
  const Vec3 along = level ? Vec3(Vec3::UnitZ()) : Vec3(normal.cross(across));  // uphill or downhill
  const Vec3 ahead = target.cast<Real>();
  const Vec3 centre = level ? Vec3(-height * normal) : Vec3(ahead - normal.dot(ahead - point) * normal);
  Plane plane{centre.cast<float>(),
              across.cast<float>(),
              along.cast<float>(),
              normal.cast<float>(),
              {},
              {phase_of(across.dot(centre - point)), phase_of(along.dot(centre - point))},
              0};
  if (level) {
    plane.fade = 6 * std::max(scale, static_cast<float>(height));
    plane.half_size = {2 * plane.fade, 2 * plane.fade};
    planes.push_back(plane);
    return;
  }
  // A slanted plane is drawn as a slab, long enough for bodies that slide on it, with edges that show its slope.
  plane.half_size = {0.3f * scale, 1.1f * scale};
  const float thickness = 0.02f * scale, lowered = 0.0005f * scale;
  Matrix3f axes;
  axes << plane.across, plane.normal, plane.across.cross(plane.normal);
  const Eigen::Quaternionf turn(axes);
  const float bevel = 0.1f * thickness;
  const Vector3f middle = plane.centre - (thickness + lowered) * plane.normal;
  boxes.push_back({middle,
                   bevel,
                   {turn.x(), turn.y(), turn.z(), turn.w()},
                   {plane.half_size.x() - bevel, thickness - bevel, plane.half_size.y() - bevel},
                   {0.5f, 0.52f, 0.55f}});
  plane.half_size.array() -= bevel;
  planes.push_back(plane);
}

void Frame::choose_depths() {
  float nearest = scale, farthest = scale;
  const auto include = [&](const std::vector<Instance>& solids) {
    for (const Instance& instance : solids) {
      const float depth = forward.dot(instance.position), reach = reach_of(instance);
      if (depth + reach < 0) continue;  // behind the eye
      nearest = std::min(nearest, depth - reach);
      farthest = std::max(farthest, depth + reach);
    }
  };
  for (const auto* solids : {&boxes, &balls, &shafts, &heads, &dots}) include(*solids);
  for (const HullInstances& hull : hulls) include(hull.instances);
  for (const Plane& plane : planes) farthest = std::max(farthest, 3 * plane.fade);
  near = std::clamp(0.9f * nearest, 0.01f * scale, 0.5f * scale);
  far = std::min(1.1f * farthest, 1e5f * near);
}

Matrix4f Frame::clip_from_eye(int width, int height, const Vector2f& shift) const {
  const float zoom = 1 / std::tan(field_of_view / 2);
  Matrix4f view = Matrix4f::Identity();
  view.block<1, 3>(0, 0) = right.transpose();
  view.block<1, 3>(1, 0) = up.transpose();
  view.block<1, 3>(2, 0) = -forward.transpose();
  Matrix4f lens = Matrix4f::Zero();
  lens(0, 0) = zoom * static_cast<float>(height) / static_cast<float>(width);
  lens(1, 1) = zoom;
  lens(0, 2) = 2 * shift.x() / static_cast<float>(width);
  lens(1, 2) = 2 * shift.y() / static_cast<float>(height);
  lens(2, 2) = (far + near) / (near - far);
  lens(2, 3) = 2 * far * near / (near - far);
  lens(3, 2) = -1;
  return lens * view;
}

Vector3f Frame::key_direction() const {
  const Vector3f level = right.cross(Vector3f::UnitY());  // backwards and horizontal
  return (-0.62f * right + 0.62f * level + 1.05f * Vector3f::UnitY()).normalized();
}

ShadowView::ShadowView(const Frame& frame, const Vector3f& direction, int resolution) {
  Matrix3f axes;  // rows: right and up on the map, and the direction in which the light travels
  const Vector3f aside =
      direction.cross(std::abs(direction.y()) < 0.99f ? Vector3f::UnitY() : Vector3f::UnitX()).normalized();
  axes << aside.transpose(), direction.cross(aside).transpose(), -direction.transpose();
  const Vector3f centre = axes * frame.target;
  const float reach = 1.6f * frame.scale;

  Vector3f low = Vector3f::Constant(std::numeric_limits<float>::max()), high = -low;
  const auto include = [&](const Instance& instance) {
    const Vector3f middle = axes * instance.position;
    const Matrix3f turned = axes * rotation_of(instance);
    const Vector3f extent = turned.cwiseAbs() * (instance.half_extents.array() + instance.radius).matrix();
    if (((middle - centre).cwiseAbs() - extent).head<2>().maxCoeff() > reach) return;  // too far away to matter
    low = low.cwiseMin(middle - extent);
    high = high.cwiseMax(middle + extent);
  };
  for (const auto* solids : {&frame.boxes, &frame.balls}) {
    for (const Instance& instance : *solids) include(instance);
  }
  for (const HullInstances& hull : frame.hulls) {
    for (const Instance& instance : hull.instances) include(instance);
  }
  if (low.x() > high.x()) {
    low = centre.array() - 0.1f * frame.scale;
    high = centre.array() + 0.1f * frame.scale;
  }
  for (int axis = 0; axis < 2; ++axis) {
    low[axis] = std::max(low[axis], centre[axis] - reach);
    high[axis] = std::min(high[axis], centre[axis] + reach);
    // In steps, so that shadows do not flicker from one frame to the next while the bodies move.
    const float wide = std::exp2(std::ceil(4 * std::log2(1.05f * (high[axis] - low[axis]))) / 4);
    const float texel = wide / static_cast<float>(resolution);
    low[axis] = std::floor((low[axis] + high[axis] - wide) / 2 / texel) * texel;
    high[axis] = low[axis] + wide;
  }
  const float slack = 0.01f * (high.z() - low.z());
  low.z() -= slack;
  high.z() += slack;
  size = high - low;
  map_from_eye.setIdentity();
  map_from_eye.topLeftCorner<3, 3>() = size.cwiseInverse().asDiagonal() * axes;
  map_from_eye.topRightCorner<3, 1>() = -low.cwiseQuotient(size);
}

}  // namespace pushback
