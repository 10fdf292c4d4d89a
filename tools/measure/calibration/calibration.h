/// Scenes drawn at random, the true positions of their bodies after a second, and the error that a solver reports.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "pushback/common/world/world.h"

namespace pushback::calibration {

/// A second of up to six bodies, drawn from a number.
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

/// The positions of the bodies after that second, by a solver that is not measured: chapter 25's step of the whole world, cut at each
/// impact, in 128 substeps. The same in 64 substeps shows how reliable they are.
struct Truth {
  std::uint64_t number;
  Real sure = 0;             ///< m: the largest difference of the two; infinity if one of them gave up
  std::vector<Vec3> places;  ///< m: of the bodies that move, in order

  /// Whether it is exact enough to judge an error of `asked`, m.
  bool good_for(Real asked) const { return sure <= asked / 10; }
  /// m: the largest distance of a body from its true place.
  Real error(const World& world) const;
};

Truth find_truth(std::uint64_t number);

/// A line each, with the places to 0.1 nm. Throws InvalidInput where the text is no list of truths.
std::string text_of(const std::vector<Truth>& truths);
std::vector<Truth> truths_in(const std::string& text);

/// The error that a solver reports, and the true one.
struct Played {
  std::uint64_t number;
  std::string kind;
  Real asked, error, said;  ///< m: of the body that is farthest off, and the largest that is said of any
  bool flagged;             ///< `kept` was false once, of one body
  double steps, estimate;   ///< s: of the steps alone, and what the estimate took on top

  /// The failure to avoid: an error above the allowed one, without a flag.
  bool missed() const { return !flagged && error > asked; }
  /// Whether the true error is at most three times the reported one, or below 0.1 um, which Newton's method leaves.
  bool covered() const { return error <= 3 * std::max(said, Real(1e-7)); }
};

/// By `Recommended`, with the error that is asked and nothing else set; and the same steps again, without a twin.
Played play(const Scene& scene, const Truth& truth);

}  // namespace pushback::calibration
