/// A situation to look at: what is in it, and from where one looks.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "common/render/picture.h"
#include "common/world.h"

namespace pushback {

struct Scene {
  std::string name;                  ///< a few words
  std::function<void(World&)> fill;  ///< puts the bodies into an empty world
  Camera camera = {};
  Real seconds = 2;  ///< how long it is watched
  std::vector<Real> instants =
      {};                ///< s, the columns of the sheet; empty: four, evenly spread from the start to the end
  bool pictures = true;  ///< false: only numbers and curves, for what an eye could not tell apart
  Real arrow = 0;        ///< m to draw for an impulse of 1 N s; 0: as long as a body for what holds it against gravity
};

// ---- situations that several chapters look at ------------------------------------------------------------------------

/// A fixed slab whose top is the plane y = 0. It is a little less deep than a box of 1 m, so that one sees from the front
/// how far the box has sunk into it. Returns its index.
int slab(World& world);
/// `count` boxes of 1 m and `mass` kg, each on the one below, `gap` m between them, on the ground.
void stack(World& world, int count, Real gap = 0, Real mass = 100);
/// A pyramid of boxes of 1 m and 100 kg with `base` boxes in its lowest row, standing in the plane z = 0.
void pyramid(World& world, int base);
/// A plane through the origin that rises by `angle` (rad) along +x, drawn as a fixed slab 12 m long, 4 m wide.
/// Returns the slab's index.
int incline(World& world, Real angle, Real friction = Real(0.5));

}  // namespace pushback
