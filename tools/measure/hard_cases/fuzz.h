/// Plays a random scene with one solver and checks the invariants that must hold in any scene.
#pragma once

#include <string>
#include <vector>

#include "pushback/tools/measure/hard_cases/random_scene.h"

namespace pushback {

struct FuzzResult {
  std::string broken;      ///< the invariant that broke first, or empty
  int step = 0;            ///< the step in which it broke, from 1
  std::uint64_t hash = 0;  ///< of the world at the end
};

/// The names of all solvers of the catalogue. Their reported impulses are compared with the motion of the bodies, and for some solvers
/// each sweep is checked as well.
std::vector<std::string> fuzzed_stages();

/// Plays 60 steps of a scene. Throws InvalidInput if the stage is not one of fuzzed_stages(). `log`: whether to print the scene and
/// every step.
FuzzResult fuzz(const RandomScene& scene, const std::string& stage, bool log = false);

}  // namespace pushback
