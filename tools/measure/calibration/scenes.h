/// Scenes that nobody has looked at: a second of up to six bodies, drawn from a number.
#pragma once

#include <cstdint>
#include <string>

#include "pushback/common/world/world.h"

namespace pushback::calibration {

struct Scene {
  World world;
  std::string kind;
  Real asked;  ///< m: the position error that is allowed after a second
};

/// The kinds: thrown, meeting, sliding, rolling and struck, four fifths of all, and jointed. The same scene for the same number,
/// with every compiler.
Scene scene(std::uint64_t number);

constexpr int frames = 60;
constexpr Real dt = Real(1) / 60;  // s

}  // namespace pushback::calibration
