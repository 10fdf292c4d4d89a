/// What is looked at: what is in it, and from where one looks.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "pushback/common/render/picture.h"
#include "pushback/common/world/world.h"

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

}  // namespace pushback
