/// The known mistakes. Each is a chapter's plain loop with a few lines replaced, as in slips/NN.txt. The build makes code of
/// them.
#pragma once

#include "pushback/common/exercise/whole_solver.h"

namespace pushback {

struct Slip {
  int chapter;       ///< whose loop it is made in
  std::string name;  ///< goes on from "you get these numbers if": "e is forgotten"
  std::string hint;  ///< a sentence or two
  WholeSolver solver;
};

/// Those of all chapters.
std::vector<Slip> slips_of_all();

}  // namespace pushback
