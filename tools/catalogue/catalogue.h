/// Every scene that a chapter looks at, by its name. For programs and tests: no chapter's header includes this.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "pushback/common/world/world.h"

namespace pushback {

struct NamedScene {
  std::string name;                  ///< the chapter's number, a hyphen, a word or two: as typed on a command line
  std::function<void(World&)> fill;  ///< puts the bodies into an empty world
};

/// Each scene once, under the chapter that looks at it first. Parameters are those that its experiment has by default:
/// steps of 1/60 s among them.
std::vector<NamedScene> all_scenes();

}  // namespace pushback
