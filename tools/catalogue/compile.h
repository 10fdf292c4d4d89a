/// For solvers_*.cpp alone: what  template struct Compiled<...>;  compiles.
#pragma once

#include "pushback/tools/catalogue/compiled.h"

namespace pushback {

template <class ContactSolver>
AnySolver Compiled<ContactSolver>::solver() {
  return ContactSolver{};
}
template <class ContactSolver>
OnlyWhatIsNeeded Compiled<ContactSolver>::fitting(const World& world, std::optional<Sleep> sleep) {
#ifdef __EMSCRIPTEN__  // in a page nobody asks what fits: each combination would only be sent along
  return {world, solver(), std::move(sleep)};
#else
  return {world, ContactSolver{}, std::move(sleep)};
#endif
}

}  // namespace pushback
