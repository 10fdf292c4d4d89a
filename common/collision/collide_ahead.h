/// Finds where two shapes that are apart would touch. Only collide.cpp needs it.
#pragma once

#include "pushback/common/collision/collide_shapes.h"

namespace pushback {

/// The closest features now are not necessarily those that will touch. If a ball rolls towards the next of two flush tiles, the tile's
/// edge is closest, but the ball will touch its face. If a box falls towards a step, the step's side may be closest, but the box may
/// land on its top. Shapes that are apart therefore get the normal with which they would touch on `way` (m, the motion of the second
/// relative to the first until the next detection). Depths are the present depths along that normal. Points move back with the second
/// body by the fraction `part_of_second` of its way until then.
///
/// If the bodies move in straight lines, gap(t) is convex. Where it falls, Newton's method never steps beyond its zero:
///
///   t -> t + gap / closing,   closing = -n . way
///
/// `touch_at(t)` returns the manifold after the fraction t of the way. Shapes that would overlap by less than `grazes` (m) get the
/// normal at their closest approach. If the shapes pass each other, no points are left.
template <class TouchAt>
void look_ahead(const TouchAt& touch_at, const Vec3& way, Real grazes, Real part_of_second, Manifold& found) {
  const auto near = [](const Manifold& at) { return at.overlap > Manifold{}.overlap; };  // within the margin
  const auto closing = [&](const Manifold& at) { return near(at) ? -at.normal.dot(way) : 0; };
  const auto still_ahead = [&](const Manifold& at) {
    constexpr Real at_once = Real(1e-6);  // fraction of the way
    return closing(at) > 0 && grazes - at.overlap > at_once * closing(at);
  };
  if (!still_ahead(found) || closing(found) + found.overlap < 0) return;  // they do not meet on this way
  Manifold then = found;
  Real before = 0, t = 0;
  for (int steps = 0; steps < 16 && t < 1 && still_ahead(then); ++steps) {
    before = t;
    t = std::min(Real(1), t + (grazes - then.overlap) / closing(then));
    then = touch_at(t);
  }
  for (int halved = 0; halved < 12 && closing(then) <= 0; ++halved) {  // beyond the closest approach
    const Real middle = (before + t) / 2;
    const Manifold between = touch_at(middle);
    if (still_ahead(between)) before = middle;
    else {
      t = middle;
      then = between;
    }
  }
  if (!near(then)) return;
  if (then.passes) {
    found.count = 0;
    found.passes = true;
    return;
  }
  // Shapes that already overlap along that normal are separated along another one. They do not touch on this way and must not be pushed.
  if (then.normal == found.normal || then.overlap - t * closing(then) > grazes) return;
  for (int i = 0; i < then.count; ++i) {
    then.touches[i].point -= part_of_second * t * way;
    then.touches[i].depth -= t * closing(then);
  }
  found = then;
  found.ahead = true;
}

}  // namespace pushback
