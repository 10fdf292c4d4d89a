/// A random scene under one stage, with everything watched that must hold in any scene.
#pragma once

#include <string>
#include <vector>

#include "pushback/tools/measure/hard_cases/random_scene.h"

namespace pushback {

struct FuzzResult {
  std::string broken;      ///< what broke first; empty: nothing
  int step = 0;            ///< in which step, from 1
  std::uint64_t hash = 0;  ///< of the world at the end
};

/// All solvers of the catalogue. What they say they did is held against what they did, and some are watched from inside as well.
std::vector<std::string> fuzzed_stages();

/// 60 steps of a scene. Throws InvalidInput for a stage that is not one of fuzzed_stages(). `log`: the scene and
/// every step are printed.
FuzzResult fuzz(const RandomScene& scene, const std::string& stage, bool log = false);

}  // namespace pushback
