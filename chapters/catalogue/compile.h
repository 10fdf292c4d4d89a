/// For solvers_*.cpp alone: what  template struct Compiled<...>;  compiles.
#pragma once

#include "pushback/chapters/catalogue/compiled.h"

namespace pushback {

template <class ContactSolver>
AnySolver Compiled<ContactSolver>::solver() {
  return ContactSolver{};
}
template <class ContactSolver>
OnlyWhatIsNeeded Compiled<ContactSolver>::fitting(const World& world, std::optional<Sleep> sleep) {
  return {world, ContactSolver{}, std::move(sleep)};
}

}  // namespace pushback
