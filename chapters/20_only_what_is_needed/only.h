/// A solver with only the effects that a scene needs. The others are not compiled into it.
#pragma once

#include "pushback/chapters/06_friction/friction.h"
#include "pushback/chapters/09_impacts/from_surface.h"
#include "pushback/chapters/09_impacts/sequential.h"
#include "pushback/chapters/11_substeps/substeps.h"
#include "pushback/chapters/12_soft_contacts/relaxing_solver.h"
#include "pushback/chapters/13_joints/joints.h"
#include "pushback/chapters/20_only_what_is_needed/questions.h"

namespace pushback {

// ---- an effect does nothing unless the answer to one of its questions is yes --------------------------------------------

/// The effect is needed if the answer to one of these questions is yes.
template <class E>
struct DependsOn {
  using questions = CalledFor<Touching>;
};
template <std::derived_from<Relaxes> E>
struct DependsOn<E> {
  using questions = CalledFor<Touching, Holding>;  // joints are relaxed as well
};
template <std::derived_from<Joints> E>
struct DependsOn<E> {
  using questions = CalledFor<Holding>;
};
template <std::derived_from<Friction> E>
struct DependsOn<E> {
  using questions = CalledFor<Rubbing>;
};
template <class E>
  requires std::derived_from<E, Restitution> || std::derived_from<E, RestitutionFromSurface> ||
           std::derived_from<E, SequentialImpacts>
struct DependsOn<E> {
  using questions = CalledFor<Bouncing>;
};

template <class Called, class... Questions>
constexpr bool has_one_of(CalledFor<Questions...>) {
  return (Called::template has<Questions> || ...);
}

// ---- Only<FullSolver, CalledFor<Touching, Bouncing>> is FullSolver without Friction ----------------------------------------

template <class Called, class Kept, class... Rest>
struct Keep {
  using type = Kept;
};
template <class Called, template <class...> class SolverOf, class... Kept, class E, class... Rest>
struct Keep<Called, SolverOf<Kept...>, E, Rest...> {
  static constexpr bool needed = has_one_of<Called>(typename DependsOn<E>::questions{});
  using with = std::conditional_t<needed, SolverOf<Kept..., E>, SolverOf<Kept...>>;
  using type = typename Keep<Called, with, Rest...>::type;
};

template <class Full, class Called>
struct OnlyOf {  // not composed of effects: there is nothing to leave out
  using type = Full;
};
template <template <class...> class SolverOf, class... Effects, class Called>
  requires(std::derived_from<SolverOf<Effects...>, Effects> && ...)
struct OnlyOf<SolverOf<Effects...>, Called> {
  using type = typename Keep<Called, SolverOf<>, Effects...>::type;
};
template <class Full, class Called>
struct OnlyOf<Substeps<Full>, Called> {
  using type = Substeps<typename OnlyOf<Full, Called>::type>;
};
template <class Full, class Called>
using Only = typename OnlyOf<Full, Called>::type;

/// `full` without the effects that are not needed, with the same settings.
template <class Called, class Full>
Only<Full, Called> only(const Full& full);
template <class Called, class Full>
Only<Substeps<Full>, Called> only(const Substeps<Full>& full) {
  const Full& divided = full;
  return Only<Substeps<Full>, Called>(only<Called>(divided), full.count, full.sweeps);
}
template <class Called, class Full>
Only<Full, Called> only(const Full& full) {
  if constexpr (std::same_as<Only<Full, Called>, Full>) {
    return full;
  } else {
    Only<Full, Called> left;
    [&]<template <class...> class SolverOf, class... Left>(SolverOf<Left...>& its) {
      ((static_cast<Left&>(its) = static_cast<const Left&>(full)), ...);
    }(left);
    return left;
  }
}

}  // namespace pushback
