/// The pages' own code as an answer, and the known mistakes: the same with one thing wrong.
#pragma once

#include "pushback/common/exercise/own_bodies.h"

namespace pushback {

OwnBodies bodies_of_pages();

struct MistakeOfPage {
  int page;
  Mistake<OwnBodies> mistake;
};
std::vector<MistakeOfPage> mistakes_of_pages();

}  // namespace pushback
