#include "pushback/common/collision/collide.h"

#include <cmath>

#include "pushback/common/collision/collide_ahead.h"
#include "pushback/common/collision/collide_shapes.h"

namespace pushback {

// ---- against a half-space

void touch(const Placed<HalfSpace>& a, const Round& b, Manifold& found) {
  found.normal = a.axes * a.shape.normal;
  const auto try_point = [&](const Vec3& core, std::uint32_t feature) {
    const Real depth = b.radius - found.normal.dot(core - a.centre);
    if (depth >= -rounding_of(b.radius) - found.margin)
      found.add(core + (depth / 2 - b.radius) * found.normal, depth, feature);
  };
  if (b.half.isZero(0)) {
    try_point(b.centre, somewhere);
  } else {
    try_point(b.centre - b.half, lower_end);
    try_point(b.centre + b.half, upper_end);
  }
}

// The feature is the number of the corner, whose bit i is set if the corner lies on the positive side of axis i.
void touch(const Placed<HalfSpace>& a, const Placed<Box>& b, Manifold& found) {
  found.normal = a.axes * a.shape.normal;
  const Vec3& extents = b.shape.half_extents;
  const Vec3 slope = b.axes.transpose() * found.normal;  // sine of the slope of each box axis against the plane
  // At most four points: the corners of the face that points most steeply into the solid. The deepest corner is one of them. If two
  // faces are about equally steep, the first one counts until another is clearly steeper.
  int down = 0;
  for (int i = 1; i < 3; ++i) {
    if (std::abs(slope[i]) > std::abs(slope[down]) + Real(1e-3)) down = i;
  }
  const Real rounding = rounding_of(extents.maxCoeff());
  for (std::uint32_t corner = 0; corner < 8; ++corner) {
    const Vec3 side((corner & 1) ? 1 : -1, (corner & 2) ? 1 : -1, (corner & 4) ? 1 : -1);
    if (side[down] * slope[down] > 0) continue;
    const Vec3 point = b.centre + b.axes * side.cwiseProduct(extents);
    const Real depth = -found.normal.dot(point - a.centre);
    if (depth >= -rounding - found.margin) found.add(point + depth / 2 * found.normal, depth, corner);
  }
}

// ---- which function for which shapes ------------------------------------------------------------------------------

namespace {

Round as_touched(const Placed<Sphere>& s) {
  return round_of(s);
}
Round as_touched(const Placed<Capsule>& c) {
  return round_of(c);
}
const Placed<Box>& as_touched(const Placed<Box>& b) {
  return b;
}
const Placed<HalfSpace>& as_touched(const Placed<HalfSpace>& h) {
  return h;
}
const Placed<Hull>& as_touched(const Placed<Hull>& h) {
  return h;
}

/// Whether pairs with this first shape look ahead. The normal of a half-space is always the same.
template <class P>
constexpr bool turns_normal = std::is_same_v<P, const Placed<Box>> || std::is_same_v<P, const Placed<Hull>>;

/// Finds where two shapes, whose present manifold is `found`, would touch within `ahead`, s. If they pass each other, adds a point that
/// is as far apart as the margin, which records that the two come near each other.
template <class First, class Second>
void find_ahead(const Placed<First>& first, const Body& a, const Placed<Second>& second, const Body& b, Real ahead,
                Manifold& found) {
  const Vec3 way = ahead * (b.velocity - a.velocity);
  const auto touch_at = [&](Real t) {
    Manifold then;
    then.margin = found.margin;
    Placed<Second> moved = second;
    moved.centre += t * way;
    touch(as_touched(first), as_touched(moved), then);
    return then;
  };
  Real grazes = 0, part_of_second = !a.movable() ? 1 : b.movable() ? Real(0.5) : 0;
  if constexpr (requires { second.shape.radius; }) {
    grazes = Real(1e-3) * second.shape.radius;  // a resting ball sinks in by less
    part_of_second = 1;
  }
  look_ahead(touch_at, way, grazes, part_of_second, found);
  if (found.passes) found.add(second.centre / 2, -found.margin, passing);
}

/// Moves the points from the shapes to their skins: deeper by both skins, and midway between them.
void add_skins(Manifold& found, Real first, Real second) {
  for (int i = 0; i < found.count; ++i) {
    found.touches[i].depth += first + second;
    found.touches[i].point += (first - second) / 2 * found.normal;
  }
}

void append(const Body& a, const Body& b, const Manifold& found, bool swapped, Contacts& contacts) {
  const Vec3& origin = swapped ? b.position : a.position;
  for (int i = 0; i < found.count; ++i) {
    Contact& contact = contacts.emplace_back();
    contact.point = origin + found.touches[i].point;
    contact.normal = swapped ? Vec3(-found.normal) : found.normal;
    contact.depth = found.touches[i].depth;
    contact.ahead = found.ahead;
    contact.friction = std::sqrt(a.friction * b.friction);
    contact.restitution = std::max(a.restitution, b.restitution);
    contact.id = {static_cast<std::uint32_t>(a.index), static_cast<std::uint32_t>(b.index), found.touches[i].feature};
  }
}

}  // namespace

void collide(const Body& a, const Body& b, Contacts& contacts, const Margin& margin) {
  if (!a.movable() && !b.movable()) return;
  const auto meet = [&]<class A, class B>(const A& shape_a, const B& shape_b) {
    Manifold found;
    found.margin = margin.of(a, b);
    const bool skinned = a.skin > 0 || b.skin > 0;
    if (skinned) found.margin += a.skin + b.skin;
    bool swapped = false;
    const auto try_order = [&found, &margin](const auto& first, const Body& p, const auto& second, const Body& q) {
      const Placed<std::decay_t<decltype(first)>> one{first, Vec3::Zero(), p.orientation.toRotationMatrix()};
      const Placed<std::decay_t<decltype(second)>> two{second, q.position - p.position,
                                                       q.orientation.toRotationMatrix()};
      if constexpr (requires { touch(as_touched(one), as_touched(two), found); }) {
        touch(as_touched(one), as_touched(two), found);
        if constexpr (turns_normal<decltype(one)>)
          if (margin.ahead > 0 && !margin.where_nearest) find_ahead(one, p, two, q, margin.ahead, found);
        return true;
      }
      return false;
    };
    // There is a function for (box, sphere) but none for (sphere, box), so the order may have to be swapped.
    if (!try_order(shape_a, a, shape_b, b)) swapped = try_order(shape_b, b, shape_a, a);
    if (skinned) swapped ? add_skins(found, b.skin, a.skin) : add_skins(found, a.skin, b.skin);
    append(a, b, found, swapped, contacts);
  };
  std::visit(meet, a.shape, b.shape);
}

}  // namespace pushback
