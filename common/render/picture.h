/// The contents of a picture, independent of OpenGL.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "pushback/common/basics/types.h"
#include "pushback/common/collision/contact.h"

namespace pushback {

/// Linear light, each channel from 0 to 1.
struct Colour {
  float red = 0, green = 0, blue = 0;
  bool operator==(const Colour&) const = default;
};

struct Camera {
  Vec3 eye{6, 4, 8};               ///< m
  Vec3 target{0, 1, 0};            ///< m, the point that it looks at
  Real field_of_view = Real(0.6);  ///< rad, from the bottom of the picture to its top

  /// The height that the picture covers at the depth of a point, m. The size of a mark is a fraction of this if it is to be the same on
  /// the picture at any depth. A point next to or behind the eye counts as a point just in front of it.
  Real height_at(const Vec3& point) const {
    const Vec3 ahead = target - eye;
    const Real depth = std::max(Real(0.01) * ahead.norm(), ahead.normalized().dot(point - eye));
    return 2 * depth * std::tan(field_of_view / 2);
  }
};

/// A shape with a position and an orientation. A half-space is drawn as the checker floor (cells of 1 m), or as a slab with the checker
/// on top if it is not level. It is not drawn from inside, and its colour is not used.
struct Solid {
  Shape shape;
  Vec3 position;
  Quat orientation;
  Colour colour;
};

/// A shaft with a head, from `tail` to `tip` (m, world axes), drawn without a shadow.
struct Arrow {
  Vec3 tail, tip;
  Real thickness;  ///< m, diameter of the shaft
  Colour colour;
};

/// A thin line (m, world axes), drawn without a shadow, and faintly through the bodies.
struct Line {
  Vec3 from, to;
  Real thickness;  ///< m
  Colour colour;
};

/// A small ball that marks a contact point, drawn without a shadow, and visible through the bodies.
struct Dot {
  Vec3 position;
  Real radius;  ///< m
  Colour colour;
};

struct Picture {
  Camera camera;
  std::vector<Solid> solids;
  std::vector<Line> lines;
  std::vector<Arrow> arrows;
  std::vector<Dot> dots;
};

}  // namespace pushback
