/// The requirements of each chapter on a whole solver: random scenes, played with a solver of which nothing else is
/// known.
///
/// The plain loop of a later chapter does not give the numbers of an earlier one, and who writes chapter 05 has no solver of
/// chapter 02 any more. So the scenes of a check are such that what later chapters add has nothing to do in them: no overlap,
/// no bounce, no friction, no impulse from the step before, unless the check is about it. Then a right solver of any later
/// chapter gives the same numbers, and the check stays. Where a later chapter changes the very thing (01 pulls, 02 does not;
/// 04 leaves a part of the depth that 03 took), `ends` says with which chapter the check is over.
///
/// From 08 on chapters branch: 09, 10 and 11 each begin from 08. So what a chapter keeps is not an interval, but the way back
/// to 00 over the chapter that each begins from (`predecessor`). A check is kept if it belongs to a chapter on that way and no
/// chapter later on it ends it.
///
/// Rows may be solved in another order than here. So a scene has pairs that touch in one point and know nothing of each
/// other; or two points that mirror each other, of which the same comes whichever goes first; or so many sweeps that it has
/// converged, to velocities and impulses that no order changes. The tolerances (1e-6 m/s and alike, of some m/s) are a million
/// times what another order of the arithmetic changes, and less than a thousandth of what the known mistakes do.
#pragma once

#include "pushback/common/exercise/whole_solver.h"

namespace pushback {

/// A random scene of a check, with the quantities that it measures.
struct MeasuredScene {
  using Play = std::function<Numbers(Random&, const WholeSolver&)>;
  std::vector<Quantity> quantities;
  Play play;  ///< the quantities, in their order

  MeasuredScene(std::vector<Quantity> all, Play its) : quantities(std::move(all)), play(std::move(its)) {}
  /// A type that says its quantities, and plays.
  template <class Scene>
    requires requires(const Scene& scene) { scene.quantities(); }
  MeasuredScene(const Scene& scene) : quantities(scene.quantities()), play(scene) {}
};

struct CheckOfChapter {
  int chapter;       ///< that asks for it first
  std::string says;  ///< of a right solver: "bodies that separate get no impulse"
  MeasuredScene scene;
  /// Chapters of which, and of all that begin from them, a right solver does not pass it any more.
  std::vector<int> ends = {};
};

/// The checks of a chapter are next to each other, and after those of earlier chapters.
const std::vector<CheckOfChapter>& checks_of_chapters();

/// The chapter whose solver this one begins from, or -1 for 00.
int predecessor(int chapter);

std::vector<CheckOfChapter> checks_of_later_contacts();  ///< 09 to 12
std::vector<CheckOfChapter> checks_of_joints();          ///< 13 and 14
std::vector<CheckOfChapter> checks_of_detected_once();   ///< 21

}  // namespace pushback
