/// Situations that several chapters look at.
#pragma once

#include "pushback/common/world/world.h"

namespace pushback {

/// A fixed slab whose top is the plane y = 0. It is a little less deep than a box of 1 m, so that one sees from the front
/// how far the box has sunk into it. Returns its index.
int slab(World& world);
/// `count` boxes of 1 m and `mass` kg, each on the one below, `gap` m between them, on the ground.
void stack(World& world, int count, Real gap = 0, Real mass = 100);
/// The same stack, and two posts behind it, to see by how much it leans.
void stack_before_posts(World& world, int count);
/// A pyramid of boxes of 1 m and 100 kg with `base` boxes in its lowest row, standing in the plane z = 0.
void pyramid(World& world, int base);
/// n x n columns of `high` boxes of 100 kg, 1 m apart and each box turned a little, which fall into a heap. The first column
/// stands at x = z = `first`.
void heap(World& world, int n, int high, Real first);
/// A plane through the origin that rises by `angle` (rad) along +x, drawn as a fixed slab 12 m long, 4 m wide.
/// Returns the slab's index.
int incline(World& world, Real angle, Real friction = Real(0.5));

}  // namespace pushback
