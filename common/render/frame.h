/// A picture prepared for the graphics pipeline: lists of instances, planes, and the matrices of camera and lights. Nothing in this
/// file calls OpenGL.
#pragma once

#include <array>
#include <vector>

#include "pushback/common/render/picture.h"

namespace pushback {

/// All positions in a Frame are relative to the eye (m), so that single precision suffices far from the origin, too.
struct Instance {
  Eigen::Vector3f position;
  float radius;
  std::array<float, 4> turn;  ///< quaternion: x, y, z, w
  Eigen::Vector3f half_extents;
  Eigen::Vector3f colour;
};

/// One hull and its instances.
struct HullInstances {
  const Polyhedron* solid;  ///< owned by the picture, which must live as long
  float bevel;              ///< m
  std::vector<Instance> instances;
};

/// A rectangle with the checker pattern.
struct Plane {
  Eigen::Vector3f centre, across, along;  ///< across, along: perpendicular unit vectors in the plane
  Eigen::Vector3f normal;
  Eigen::Vector2f half_size;  ///< m, along `across` and `along`
  Eigen::Vector2f phase;      ///< m, position of the centre on the checker pattern
  float fade;                 ///< m, distance at which it fades into the background; 0: never
};

struct Frame {
  explicit Frame(const Picture& picture);

  std::vector<Instance> boxes, balls;         // cast shadows
  std::vector<HullInstances> hulls;           // also cast shadows
  std::vector<Instance> shafts, heads, dots;  // cast no shadows
  std::vector<Plane> planes;

  float scale;                                 ///< m, from the eye to the target
  float field_of_view;                         ///< rad
  float near, far;                             ///< m
  Eigen::Vector3f target, right, up, forward;  ///< target relative to the eye; the camera's axes

  /// `shift`: displacement of the picture in pixels, for subpixel offsets.
  Eigen::Matrix4f clip_from_eye(int width, int height, const Eigen::Vector2f& shift) const;
  /// The direction to the key light, over the viewer's left shoulder.
  Eigen::Vector3f key_direction() const;

 private:
  void add(const Solid& solid, const Vec3& eye);
  void add(const Line& line, const Vec3& eye);
  void add(const Arrow& arrow, const Vec3& eye);
  void add_plane(const Vec3& normal, const Vec3& point);
  void choose_depths();
};

/// Length of an arrow's head divided by the radius of its base.
inline constexpr float head_slimness = 2.6f;

/// The view of a directional light: a box around the bodies that cast shadows near the target.
struct ShadowView {
  Eigen::Matrix4f map_from_eye;  ///< to texture coordinates and depth, each from 0 to 1
  Eigen::Vector3f size;          ///< m, of that box: width, height, depth

  ShadowView(const Frame& frame, const Eigen::Vector3f& direction, int resolution);
};

}  // namespace pushback
