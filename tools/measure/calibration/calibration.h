/// Scenes drawn at random, the true positions of their bodies after a second, and the error that a solver reports.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "pushback/common/world/world.h"

namespace pushback::calibration {

/// A scene of up to six bodies and one second, generated from a number.
struct Scene {
  World world;
  std::string kind;
  Real asked;  ///< m, the allowed position error after a second
};

/// The kinds are thrown, meeting, sliding, rolling and struck, which make up four fifths of all, and jointed. The same number gives the
/// same scene with every compiler.
Scene scene(std::uint64_t number);

constexpr int frames = 60;
constexpr Real dt = Real(1) / 60;  // s

/// The positions of the bodies after that second, computed by a solver that is not measured, chapter 25's step of the whole world, cut at
/// each impact, in 128 substeps. The same step in 64 substeps shows how reliable they are.
struct Truth {
  std::uint64_t number;
  Real sure = 0;             ///< m, the largest difference of the two; infinite if one of them failed
  std::vector<Vec3> places;  ///< m, of the movable bodies, in order

  /// Whether it is exact enough to judge an error of `asked`, m.
  bool good_for(Real asked) const { return sure <= asked / 10; }
  /// The largest distance of a body from its true position, m.
  Real error(const World& world) const;
};

Truth find_truth(std::uint64_t number);

/// Converts truths to a text of one line each, with positions to 0.1 nm, and back. Throws InvalidInput if a text is not of this form.
std::string text_of(const std::vector<Truth>& truths);
std::vector<Truth> truths_in(const std::string& text);

/// The error that a solver reports, and the true one.
struct Played {
  std::uint64_t number;
  std::string kind;
  Real asked, error, said;  ///< m: the allowed error, the largest true error of a body, the largest reported error
  bool flagged;             ///< whether `kept` was false for a body after any step
  double steps, estimate;   ///< s, the time of the steps without the estimate, and the time of the estimate

  /// The failure to avoid: an error above the allowed one, without a flag.
  bool missed() const { return !flagged && error > asked; }
  /// Whether the true error is at most three times the reported one, or below 0.1 um, which Newton's method leaves.
  bool covered() const { return error <= 3 * std::max(said, Real(1e-7)); }
};

/// Plays the scene by `Recommended` with the scene's allowed error and defaults otherwise, and then the same steps without a twin.
Played play(const Scene& scene, const Truth& truth);

}  // namespace pushback::calibration
