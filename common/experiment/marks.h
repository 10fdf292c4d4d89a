/// Thin lines and arrows in a picture: what should be, beside what is. They are as thick on the picture wherever they are.
#pragma once

#include <vector>

#include "pushback/common/bodies/body.h"
#include "pushback/common/render/palette.h"
#include "pushback/common/render/picture.h"

namespace pushback {

inline constexpr Real line_pixels = Real(2.5);  ///< of a picture 281 pixels high, as the cells of a sheet are

/// From corner to corner, m, world axes.
void add_line(Picture& picture, const std::vector<Vec3>& corners, Colour colour = near_black_colour(),
              Real pixels = line_pixels);
void add_ring(Picture& picture, const Vec3& centre, const Vec3& normal, Real radius,
              Colour colour = near_black_colour(), Real pixels = line_pixels);
/// The edges of a box or hull, three rings of a ball, rings and lines of a capsule; of a half-space nothing.
void add_outline(Picture& picture, const Body& body, Colour colour = near_black_colour(), Real pixels = line_pixels);
void add_arrow(Picture& picture, const Vec3& tail, const Vec3& tip, Colour colour = near_black_colour());

/// m, of a shaft at that point: 1.2 % of the picture's height there.
inline Real arrow_thickness(const Camera& camera, const Vec3& at) {
  return Real(0.012) * camera.height_at(at);
}

}  // namespace pushback
