/// What a solver of one's own is compared by where nothing is right or wrong: the table of hard cases, and a race.
#pragma once

#include <string>
#include <vector>

#include "pushback/tools/classroom/mine/my_file.h"

namespace pushback {

struct AskedOfHardCases {
  std::vector<std::string> names;  ///< as ./course hard-cases takes them; none: all
  bool all = false;                ///< beside every stage, not only those that are a plain loop
  double at_most = 30;             ///< s, for one case
};

/// Fills hard_cases/ in the reader's folder with table.md, table.csv, times.csv and overview.png, whole or not at all, and says
/// which cases pass. False where the solver came to no end in a case. Throws InvalidInput where a name is unknown, and
/// std::runtime_error where there is no table.
bool play_hard_cases(const MyFolder& mine, const AskedOfHardCases& asked);

struct AskedOfRace {
  std::string scene;    ///< of the catalogue
  int runs = 7;         ///< of each solver
  double at_most = 30;  ///< s, for one run
};

/// Prints the time of a step and what is off in the scene: the reader's solver, the plain loop of chapter 08, and chapter 21's.
/// False where the reader's came to no end. Throws as above.
bool race(const MyFolder& mine, const AskedOfRace& asked);

struct AskedOfStudy {
  std::vector<std::string> motions;  ///< of ./course study, by their names; none: all without joints
};

/// Fills study/ in the reader's folder with the diagrams of error against time, the reader's solver among ours. Throws as above,
/// also where the solver came to no end.
void study_with_mine(const MyFolder& mine, const AskedOfStudy& asked);

}  // namespace pushback
