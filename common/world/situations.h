/// Situations that several chapters use.
#pragma once

#include "pushback/common/world/world.h"

namespace pushback {

/// A fixed slab whose top is the plane y = 0, on a half-space below y = -0.5 m. The slab is a little less deep than a box of 1 m,
/// so that the front view shows how far the box has sunk into it. Returns the slab's index.
int slab(World& world);
/// A stack of `count` boxes of 1 m and `mass` kg on the ground, with `gap` m between the boxes.
void stack(World& world, int count, Real gap = 0, Real mass = 100);
/// The same stack in front of two posts, which show how far it leans.
void stack_before_posts(World& world, int count);
/// A pyramid of boxes of 1 m and 100 kg on the ground, with `base` boxes in its lowest row and all centres in the plane z = 0.
void pyramid(World& world, int base);
/// n x n columns of `high` boxes of 100 kg, 1 m apart, each box turned by 0 to 1.2 rad, which fall into a heap. The first column
/// stands at x = z = `first`, m.
void heap(World& world, int n, int high, Real first);
/// A plane through the origin that rises by `angle` (rad) along +x, drawn as a fixed slab 12 m long, 4 m wide.
/// Returns the slab's index.
int incline(World& world, Real angle, Real friction = Real(0.5));

}  // namespace pushback
