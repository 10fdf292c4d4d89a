/// Where the bodies of a scene truly are after a second, as far as that can be found.
#pragma once

#include <vector>

#include "pushback/tools/measure/calibration/scenes.h"

namespace pushback::calibration {

/// By a solver that is none of those measured: chapter 25's step of the whole world, cut at each impact, in 128 substeps. The same
/// in 64 says how sure that is.
struct Truth {
  std::uint64_t number;
  Real sure = 0;             ///< m: how far apart both have the same body; infinity if one of them gave up
  std::vector<Vec3> places;  ///< m: of the bodies that move, in order

  /// Whether it can tell what is kept of the error that is asked of this scene.
  bool good_for(Real asked) const { return sure <= asked / 10; }
  /// m: the largest distance of a body from its true place.
  Real error(const World& world) const;
};

Truth find_truth(std::uint64_t number);

/// A line each, with the places to 0.1 nm. Throws InvalidInput where the text is no list of truths.
std::string text_of(const std::vector<Truth>& truths);
std::vector<Truth> truths_in(const std::string& text);

}  // namespace pushback::calibration
