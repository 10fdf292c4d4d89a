/// Adds thin lines and arrows to a picture, for example to show an expected motion. Their thickness on the picture does not depend on
/// their distance.
#pragma once

#include <vector>

#include "pushback/common/bodies/body.h"
#include "pushback/common/render/palette.h"
#include "pushback/common/render/picture.h"

namespace pushback {

inline constexpr Real line_pixels = Real(2.5);  ///< in a picture 281 pixels high, like the cells of a sheet

/// Lines from corner to corner (m, world axes).
void add_line(Picture& picture, const std::vector<Vec3>& corners, Colour colour = near_black_colour(),
              Real pixels = line_pixels);
void add_ring(Picture& picture, const Vec3& centre, const Vec3& normal, Real radius,
              Colour colour = near_black_colour(), Real pixels = line_pixels);
/// The edges of a box or hull, three rings of a sphere, rings and lines of a capsule, nothing of a half-space.
void add_outline(Picture& picture, const Body& body, Colour colour = near_black_colour(), Real pixels = line_pixels);
void add_arrow(Picture& picture, const Vec3& tail, const Vec3& tip, Colour colour = near_black_colour());

/// The thickness of a shaft at this point, m: 1.2 % of the height that the picture covers there.
inline Real arrow_thickness(const Camera& camera, const Vec3& at) {
  return Real(0.012) * camera.height_at(at);
}

}  // namespace pushback
