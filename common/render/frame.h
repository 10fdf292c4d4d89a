/// A picture made ready for the graphics pipeline: lists of instances, planes, and the matrices of camera and lights.
/// Numbers only; nothing in here calls OpenGL.
#pragma once

#include <array>
#include <vector>

#include "pushback/common/render/picture.h"

namespace pushback {

/// Every place in a Frame is relative to the eye, so that single precision does far from the origin, too.
struct Instance {
  Eigen::Vector3f position;
  float radius;
  std::array<float, 4> turn;  ///< quaternion: x, y, z, w
  Eigen::Vector3f half_extents;
  Eigen::Vector3f colour;
};

/// One hull, and everywhere it is.
struct HullInstances {
  const Polyhedron* solid;  ///< belongs to the picture, which has to live as long
  float bevel;              ///< m
  std::vector<Instance> instances;
};

/// A rectangle with the checker on it.
struct Plane {
  Eigen::Vector3f centre, across, along;  ///< two unit vectors; across x along points away from the viewer
  Eigen::Vector3f normal;
  Eigen::Vector2f half_size;  ///< along the two
  Eigen::Vector2f phase;      ///< where the centre is on the checker, m
  float fade;                 ///< m, at which distance it is lost in the background; 0: never
};

struct Frame {
  explicit Frame(const Picture& picture);

  std::vector<Instance> boxes, balls;         // what casts shadows
  std::vector<HullInstances> hulls;           // likewise
  std::vector<Instance> shafts, heads, dots;  // what doesn't
  std::vector<Plane> planes;

  float scale;                                 ///< m, from the eye to what it looks at
  float field_of_view;                         ///< rad
  float near, far;                             ///< m
  Eigen::Vector3f target, right, up, forward;  ///< target relative to the eye; the camera's axes

  /// `shift`: by how many pixels the picture is moved, for subpixel offsets.
  Eigen::Matrix4f clip_from_eye(int width, int height, const Eigen::Vector2f& shift) const;
  /// The direction to the key light: over the left shoulder of whoever looks.
  Eigen::Vector3f key_direction() const;

 private:
  void add(const Solid& solid, const Vec3& eye);
  void add(const Line& line, const Vec3& eye);
  void add(const Arrow& arrow, const Vec3& eye);
  void add_plane(const Vec3& normal, const Vec3& point);
  void choose_depths();
};

/// Length of an arrow's head over the radius of its base.
inline constexpr float head_slimness = 2.6f;

/// What a light that shines from one direction sees: a box around whatever casts shadows near the target.
struct ShadowView {
  Eigen::Matrix4f map_from_eye;  ///< to texture coordinates and depth, each from 0 to 1
  Eigen::Vector3f size;          ///< m, of that box: width, height, depth

  ShadowView(const Frame& frame, const Eigen::Vector3f& direction, int resolution);
};

}  // namespace pushback
