/// Where two shapes that are apart would touch. For collide.cpp alone.
#pragma once

#include "pushback/common/collision/collide_shapes.h"

namespace pushback {

/// What is nearest now need not be what touches: a ball that rolls towards the next of two tiles that lie flush has its edge ahead, and
/// is upon its face once it gets there; a box that comes down towards a step may have the step's side nearest, and land on its top. So
/// what is apart, and moves along `way` (m, the second one's, in the first one's eyes) until contacts are looked for again, gets the normal
/// with which it touches; depths are those of now along that normal, and points go back with the second body by `part_of_second` of its way.
///
///   gap(t), with both moving straight on, is convex; on its falling side Newton's steps never go beyond its zero
///   t -> t + gap / closing,   closing = -n . way
///
/// `touch_at(t)`: the manifold when `t` of the way is gone. `grazes`: m; what would touch less deep than this passes by: it has the
/// normal where it passes most closely. No points are left where they pass each other.
template <class TouchAt>
void look_ahead(const TouchAt& touch_at, const Vec3& way, Real grazes, Real part_of_second, Manifold& found) {
  const auto near = [](const Manifold& at) { return at.overlap > Manifold{}.overlap; };  // within the margin
  const auto closing = [&](const Manifold& at) { return near(at) ? -at.normal.dot(way) : 0; };
  const auto still_ahead = [&](const Manifold& at) {
    constexpr Real at_once = Real(1e-6);  // of the way
    return closing(at) > 0 && grazes - at.overlap > at_once * closing(at);
  };
  if (!still_ahead(found) || closing(found) + found.overlap < 0) return;  // within this way it does not get there
  Manifold then = found;
  Real before = 0, t = 0;
  for (int steps = 0; steps < 16 && t < 1 && still_ahead(then); ++steps) {
    before = t;
    t = std::min(Real(1), t + (grazes - then.overlap) / closing(then));
    then = touch_at(t);
  }
  for (int halved = 0; halved < 12 && closing(then) <= 0; ++halved) {  // beyond where they pass most closely
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
  // Those that overlap along that normal by now are kept apart by another one, and do not touch on this way: nothing may push them.
  if (then.normal == found.normal || then.overlap - t * closing(then) > grazes) return;
  for (int i = 0; i < then.count; ++i) {
    then.touches[i].point -= part_of_second * t * way;
    then.touches[i].depth -= t * closing(then);
  }
  found = then;
  found.ahead = true;
}

}  // namespace pushback
