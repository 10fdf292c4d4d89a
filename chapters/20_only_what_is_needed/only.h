/// A solver with only the effects that a scene needs. The others are not compiled into it.
#pragma once

#include "pushback/chapters/06_friction/friction.h"
#include "pushback/chapters/09_impacts/from_surface.h"
#include "pushback/chapters/09_impacts/sequential.h"
#include "pushback/chapters/11_substeps/substeps.h"
#include "pushback/chapters/12_soft_contacts/relaxing_solver.h"
#include "pushback/chapters/13_joints/joints.h"
#include "pushback/common/world/solver_from.h"
#include "pushback/engine/islands/scene_questions.h"

namespace pushback {

// ---- an effect does nothing unless the answer to one of its questions is yes --------------------------------------------

/// The effect is needed if the answer to one of these questions is yes.
template <class E>
struct DependsOn {
  using questions = Questions<NeedsContacts>;
};
template <std::derived_from<Relaxes> E>
struct DependsOn<E> {
  using questions = Questions<NeedsContacts, NeedsJoints>;  // joints are relaxed as well
};
template <std::derived_from<Joints> E>
struct DependsOn<E> {
  using questions = Questions<NeedsJoints>;
};
template <std::derived_from<Friction> E>
struct DependsOn<E> {
  using questions = Questions<NeedsFriction>;
};
template <class E>
  requires std::derived_from<E, Restitution> || std::derived_from<E, RestitutionFromSurface> ||
           std::derived_from<E, SequentialImpacts>
struct DependsOn<E> {
  using questions = Questions<NeedsRestitution>;
};

template <class Yes, class... Some>
constexpr bool has_one_of(Questions<Some...>) {
  return (Yes::template has<Some> || ...);
}

// ---- Only<FullSolver, Questions<NeedsContacts, NeedsRestitution>> is FullSolver without Friction -------------------------

template <class Yes, class Kept, class... Rest>
struct Keep {
  using type = Kept;
};
template <class Yes, template <class...> class SolverOf, class... Kept, class E, class... Rest>
struct Keep<Yes, SolverOf<Kept...>, E, Rest...> {
  static constexpr bool needed = has_one_of<Yes>(typename DependsOn<E>::questions{});
  using with = std::conditional_t<needed, SolverOf<Kept..., E>, SolverOf<Kept...>>;
  using type = typename Keep<Yes, with, Rest...>::type;
};

template <class Full, class Yes>
struct OnlyOf {  // not composed of effects, so there is nothing to leave out
  using type = Full;
};
template <template <class...> class SolverOf, class... Effects, class Yes>
  requires(std::derived_from<SolverOf<Effects...>, Effects> && ...)
struct OnlyOf<SolverOf<Effects...>, Yes> {
  using type = typename Keep<Yes, SolverOf<>, Effects...>::type;
};
template <class Full, class Yes>
struct OnlyOf<Substeps<Full>, Yes> {
  using type = Substeps<typename OnlyOf<Full, Yes>::type>;
};
template <class Functions, class Yes>
struct OnlyOf<SolverFrom<Functions>, Yes> {
  using type = SolverFrom<Functions>;
};
template <class Full, class Yes>
using Only = typename OnlyOf<Full, Yes>::type;

/// `full` without the effects that are not needed, with the same settings.
template <class Yes, class Full>
Only<Full, Yes> only(const Full& full);
template <class Yes, class Full>
Only<Substeps<Full>, Yes> only(const Substeps<Full>& full) {
  const Full& divided = full;
  return Only<Substeps<Full>, Yes>(only<Yes>(divided), full.count, full.sweeps);
}
template <class Yes, class Full>
Only<Full, Yes> only(const Full& full) {
  if constexpr (std::same_as<Only<Full, Yes>, Full>) {
    return full;
  } else {
    Only<Full, Yes> left;
    [&]<template <class...> class SolverOf, class... Left>(SolverOf<Left...>& its) {
      ((static_cast<Left&>(its) = static_cast<const Left&>(full)), ...);
    }(left);
    return left;
  }
}

}  // namespace pushback
