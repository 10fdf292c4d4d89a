/// Hulls for the tests: boxes in disguise, wedges, prisms, the stones of an arch, and any of them.
#pragma once

#include <cmath>
#include <vector>

#include "pushback/common/bodies/random.h"

namespace pushback {

using Points = std::vector<Vec3>;

inline Points corners_of_box(const Vec3& extents) {
  Points points;
  for (int corner = 0; corner < 8; ++corner) {
    const Vec3 side((corner & 1) ? 1 : -1, (corner & 2) ? 1 : -1, (corner & 4) ? 1 : -1);
    points.push_back(side.cwiseProduct(extents));
  }
  return points;
}

/// A ramp of this size, its blade along z at the lower left, its steep side to the right.
inline Points wedge(Real length, Real height, Real depth) {
  const Real x = length / 2, z = depth / 2;
  return {{-x, 0, -z}, {-x, 0, z}, {x, 0, -z}, {x, 0, z}, {x, height, -z}, {x, height, z}};
}

/// Stones of a round arch, each with two faces towards its neighbours.
inline Points stone(int which, int count, Real inner, Real outer, Real half_depth) {
  Points points;
  for (const int side : {which, which + 1}) {
    const Real angle = pi * Real(side) / Real(count);
    for (const Real r : {inner, outer}) {
      for (const Real z : {-half_depth, half_depth}) points.push_back({r * std::cos(angle), r * std::sin(angle), z});
    }
  }
  return points;
}

inline Points prism(int sides, Real radius, Real half_height) {
  Points points;
  for (int i = 0; i < sides; ++i) {
    const Real angle = 2 * pi * Real(i) / Real(sides);
    for (const Real y : {-half_height, half_height}) {
      points.push_back({radius * std::cos(angle), y, radius * std::sin(angle)});
    }
  }
  return points;
}

inline const Polyhedron& solid_of(const Body& body) {
  return *std::get<Hull>(body.shape).solid;
}

inline Points corners_of(const Body& body) {
  if (const Box* box = std::get_if<Box>(&body.shape)) {
    Points points = corners_of_box(box->half_extents);
    for (Vec3& p : points) p = (body.position + body.orientation * p).eval();
    return points;
  }
  Points points;
  for (const Vec3& p : solid_of(body).corners) points.push_back(body.position + body.orientation * p);
  return points;
}

/// Of the hull of some random points within a ball, or a wedge, a prism, a stone: about 1 m across, however turned.
inline Body random_hull(Random& random) {
  const auto length = [&] { return random.between(Real(0.2), 1); };
  Points points;
  const std::size_t kind = random.below(4);
  if (kind == 0) {
    const std::size_t count = 4 + random.below(12);
    while (points.size() < count) {
      const Real distance = random.between(Real(0.3), Real(0.8));
      points.push_back(distance * random.direction());
    }
  } else if (kind == 1) {
    const Real x = length(), y = length(), z = length();
    points = wedge(2 * x, y, 2 * z);
  } else if (kind == 2) {
    const int sides = 3 + int(random.below(6));
    const Real radius = length(), height = length();
    points = prism(sides, radius, height);
  } else {
    points = stone(int(random.below(5)), 5, 1, 1 + length(), length());
  }
  const Real angle = random.between(-pi, pi);
  return hull(points, 1).turned(angle, random.direction());
}

}  // namespace pushback
