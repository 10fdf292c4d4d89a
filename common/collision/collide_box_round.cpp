// A box against a sphere or a capsule: the distance between the core, a segment, and the box.
#include <cmath>

#include "pushback/common/collision/collide_shapes.h"

namespace pushback {

namespace {

/// The core in the frame of the box: p(t) = middle + t half, t from -1 to 1.
struct Core {
  Vec3 middle, half;
  Vec3 extents;  // of the box

  Vec3 at(Real t) const { return middle + t * half; }
  Vec3 nearest_in_box(const Vec3& p) const { return p.cwiseMax(-extents).cwiseMin(extents); }
  /// Half the derivative of the squared distance with respect to t.
  Real slope(Real t) const { return (at(t) - nearest_in_box(at(t))).dot(half); }
};

// The squared distance between p(t) and the box is convex and consists of parabolas that join where p(t) passes the plane of a
// face. Its derivative therefore never falls and is linear between those places, so the code looks for its zero.
Real nearest_on_core(const Core& core) {
  Real places[8] = {-1, 1};  // in ascending order
  int count = 2;
  const auto put = [&](Real place) {
    int i = count++;
    for (; places[i - 1] > place; --i) places[i] = places[i - 1];
    places[i] = place;
  };
  for (int i = 0; i < 3; ++i) {
    for (const Real face : {-core.extents[i], core.extents[i]}) {
      const Real distance = face - core.middle[i];
      if (std::abs(distance) < std::abs(core.half[i])) put(distance / core.half[i]);
    }
  }
  Real before = places[0];
  Real slope_before = core.slope(before);
  if (slope_before >= 0) return before;
  for (int i = 1; i < count; ++i) {
    const Real slope = core.slope(places[i]);
    if (slope >= 0) return before + (places[i] - before) * (slope_before / (slope_before - slope));
    before = places[i];
    slope_before = slope;
  }
  return before;
}

/// How far the core must move along `normal` to leave the box, m.
Real depth_towards(const Core& core, const Vec3& normal) {
  return core.extents.dot(normal.cwiseAbs()) + std::abs(core.half.dot(normal)) - core.middle.dot(normal);
}

/// The shortest way out of the box for a core that crosses it: along one of the box's axes, or perpendicular to the core and one of
/// them. Later axes must be clearly better than earlier ones, so that rounding does not choose.
Vec3 way_out(const Core& core) {
  const Real clearly = Real(1e-3) * core.extents.minCoeff();
  Vec3 best = Vec3::UnitY();
  Real least = std::numeric_limits<Real>::max();
  const auto try_axis = [&](const Vec3& axis) {
    const Real depth =
        core.extents.dot(axis.cwiseAbs()) + std::abs(core.half.dot(axis)) - std::abs(core.middle.dot(axis));
    if (depth < least - clearly) {
      least = depth;
      best = core.middle.dot(axis) < -clearly ? Vec3(-axis) : axis;
    }
  };
  for (int i = 0; i < 3; ++i) try_axis(Vec3::Unit(i));
  const Real length = core.half.norm();
  for (int i = 0; i < 3; ++i) {
    const Vec3 across = core.half.cross(Vec3::Unit(i));
    if (across.norm() > parallel * length) try_axis(across.normalized());
  }
  return best;
}

/// The stretch of the core next to a face or an edge of the box: within the slabs of the axes along which `normal` is 0.
struct Span {
  Real begin = -1, end = 1;
};
Span beside(const Core& core, const Vec3& normal) {
  Span stretch;
  for (int i = 0; i < 3; ++i) {
    if (normal[i] != 0) continue;
    const Real reach = core.extents[i];
    if (core.half[i] == 0) {
      if (std::abs(core.middle[i]) > reach) stretch.end = stretch.begin - 1;
      continue;
    }
    Real enter = (-reach - core.middle[i]) / core.half[i];
    Real leave = (reach - core.middle[i]) / core.half[i];
    if (enter > leave) std::swap(enter, leave);
    stretch.begin = std::max(stretch.begin, enter);
    stretch.end = std::min(stretch.end, leave);
  }
  return stretch;
}

/// The point of the core, as t, that leaves the box last on the way along `normal`.
Real deepest_on_core(const Core& core, const Vec3& normal) {
  const Real climb = core.half.dot(normal);
  if (std::abs(climb) > parallel * core.half.norm()) return climb > 0 ? -1 : 1;
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    if (normal[i] == 0 && normal[j] != 0 && normal[k] != 0) {
      // The core must pass over the edge along axis i. Take the point that is nearest to the edge as seen along that axis.
      const Real to_j = std::copysign(core.extents[j], normal[j]) - core.middle[j];
      const Real to_k = std::copysign(core.extents[k], normal[k]) - core.middle[k];
      const Real squared = core.half[j] * core.half[j] + core.half[k] * core.half[k];
      if (squared > 0) return std::clamp((to_j * core.half[j] + to_k * core.half[k]) / squared, Real(-1), Real(1));
    }
  }
  const Span stretch = beside(core, normal);
  return std::clamp((stretch.begin + stretch.end) / 2, Real(-1), Real(1));
}

/// The unit normal whose components below `parallel` are set to 0: one that is nearly normal to a face, or nearly perpendicular to an
/// edge, becomes exactly so.
Vec3 without_slant(const Vec3& normal) {
  return (normal.array().abs() < parallel).select(Vec3::Zero(), normal).normalized();
}

/// Whether the core runs along the face (two zeros in `normal`) or along the edge (one zero).
bool runs_along(const Core& core, const Vec3& normal) {
  const Real length = core.half.norm();
  if (length == 0) return false;
  Real off = std::abs(core.half.dot(normal));
  int zeros = 0;
  for (int i = 0; i < 3; ++i) zeros += normal[i] == 0;
  if (zeros == 1) {
    for (int i = 0; i < 3; ++i) {
      if (normal[i] == 0) off = core.half.cross(Vec3::Unit(i)).norm();
    }
  }
  return zeros > 0 && off < parallel * length;
}

}  // namespace

void touch(const Placed<Box>& a, const Round& b, Manifold& found) {
  const Core core{a.axes.transpose() * (b.centre - a.centre), a.axes.transpose() * b.half, a.shape.half_extents};
  const Real size = core.extents.maxCoeff() + b.radius;
  const Real rounding = rounding_of(size);

  Real t = nearest_on_core(core);
  const Vec3 apart = core.at(t) - core.nearest_in_box(core.at(t));
  const Real distance = apart.norm();
  if (distance > b.radius + rounding + found.margin) return;
  // Within 100 times the rounding, the direction between the two points is mostly rounding, so the core counts as crossing the box.
  const bool outside = distance > 100 * rounding;
  Vec3 normal = outside ? Vec3(apart / distance) : way_out(core);
  Real depth = b.radius - distance;
  if (!outside) {
    depth = depth_towards(core, normal) + b.radius;
    t = deepest_on_core(core, normal);
  }

  found.normal = a.axes * normal;
  found.overlap = depth;
  const auto depth_at = [&](Real at_t, const Vec3& n) {
    return core.extents.dot(n.cwiseAbs()) + b.radius - core.at(at_t).dot(n);
  };
  const auto add = [&](Real at_t, Real its_depth, std::uint32_t feature) {
    const Vec3 midway = core.at(at_t) + (its_depth / 2 - b.radius) * normal;
    found.add(a.centre + a.axes * midway, its_depth, feature);
  };

  std::uint32_t feature = b.half.isZero(0) ? somewhere : t <= -1 ? lower_end : t >= 1 ? upper_end : somewhere;
  const Vec3 straight = without_slant(normal);
  if (runs_along(core, straight)) {
    const Span stretch = beside(core, straight);
    const Real length = stretch.end - stretch.begin;
    if (length * core.half.norm() > Real(0.01) * b.radius) {
      const Real depth_begin = depth_at(stretch.begin, straight);
      const Real depth_end = depth_at(stretch.end, straight);
      if (depth_begin >= -rounding - found.margin && depth_end >= -rounding - found.margin) {
        normal = straight;
        found.normal = a.axes * normal;
        add(stretch.begin, depth_begin, lower_end);
        add(stretch.end, depth_end, upper_end);
        return;
      }
      // One end has lifted off. The other is still the same contact.
      if (t < stretch.begin + length / 4) feature = lower_end;
      if (t > stretch.end - length / 4) feature = upper_end;
    }
  }
  found.normal = a.axes * normal;
  add(t, depth, feature);
}

}  // namespace pushback
