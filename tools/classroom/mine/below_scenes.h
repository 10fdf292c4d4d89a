/// What `./course mine body`, `touch` and `names` ask for: scenes made of random numbers, played with what a reader has written
/// from the three pages in docs/from_an_empty_file. They compare with the pages' own code, which is held to common/ and to
/// closed forms by tests.
#pragma once

#include "pushback/common/exercise/own_bodies.h"

namespace pushback {

struct CheckOfPage {
  int page;  ///< 1 to 3
  Check<OwnBodies> check;
};

/// Those of a page stand together, and after those of the pages before.
const std::vector<CheckOfPage>& checks_of_pages();

}  // namespace pushback
