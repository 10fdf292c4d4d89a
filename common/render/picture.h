/// What is to be drawn, said without a word of OpenGL.
#pragma once

#include <vector>

#include "pushback/common/basics/types.h"
#include "pushback/common/collision/contact.h"

namespace pushback {

/// Linear light, each channel from 0 to 1.
struct Colour {
  float red = 0, green = 0, blue = 0;
};

struct Camera {
  Vec3 eye{6, 4, 8};               ///< m
  Vec3 target{0, 1, 0};            ///< m, what it looks at
  Real field_of_view = Real(0.6);  ///< rad, from the bottom of the picture to its top
};

/// A solid at a place. The shape is that of the body; a half-space is drawn as the checker floor (cells of 1 m), or, where
/// it is not level, as a slab with the checker on top, and not at all as seen from inside. Its colour is not used.
struct Solid {
  Shape shape;
  Vec3 position;
  Quat orientation;
  Colour colour;
};

/// A shaft with a head, from `tail` to `tip` (m, world axes); drawn without a shadow.
struct Arrow {
  Vec3 tail, tip;
  Real thickness;  ///< m, diameter of the shaft
  Colour colour;
};

/// A small ball that marks a contact point; drawn without a shadow, and visible through the bodies.
struct Dot {
  Vec3 position;
  Real radius;  ///< m
  Colour colour;
};

struct Picture {
  Camera camera;
  std::vector<Solid> solids;
  std::vector<Arrow> arrows;
  std::vector<Dot> dots;
};

}  // namespace pushback
