/// Answers with reasons which effects a scene needs, and which step each of its islands gets.
///
/// The question for an effect is a type, so that code can be selected by the answers at compile time. To add an effect, add its question
/// here or in its own header, and one word to AllQuestions. `only_if`: another question, earlier in AllQuestions. If its answer is no,
/// so is this one.
#pragma once

#include <string>
#include <type_traits>
#include <vector>

#include "pushback/engine/islands/step_classifier.h"

namespace pushback {

class IslandSolver;

struct Answer {
  bool yes = false;
  std::string because;  ///< text for users: the body, joint or force that needs the effect, or why none does
};

// ---- which effects -------------------------------------------------------------------------------------------------------

/// Can two bodies touch? One of them has to be movable. If not, detection and contact rows are not needed.
struct NeedsContacts {
  static constexpr const char* name = "contacts";
  static Answer in(const World& world);
};
/// Does the scene have joints? Throws as check_bodies_of.
struct NeedsJoints {
  static constexpr const char* name = "joints";
  static Answer in(const World& world);
};
/// Does a pair that can touch have e > 0?
struct NeedsRestitution {
  using only_if = NeedsContacts;
  static constexpr const char* name = "restitution";
  static Answer in(const World& world);
};
/// Does a pair that can touch have mu > 0?
struct NeedsFriction {
  using only_if = NeedsContacts;
  static constexpr const char* name = "friction";
  static Answer in(const World& world);
};
/// Does a body's inertia differ from axis to axis?
struct NeedsGyroscopicTerm {
  static constexpr const char* name = "gyroscopic term";
  static Answer in(const World& world);
};
/// Does a force other than gravity act: a spring, drag, or a force set on a body? Throws as check_bodies_of.
struct NeedsAppliedForces {
  static constexpr const char* name = "applied forces";
  static Answer in(const World& world);
};

/// A list of questions: all, or those whose answer is yes.
template <class... Some>
struct Questions {
  template <class Question>
  static constexpr bool has = (std::is_same_v<Question, Some> || ...);
};

using AllQuestions =
    Questions<NeedsContacts, NeedsRestitution, NeedsFriction, NeedsGyroscopicTerm, NeedsAppliedForces, NeedsJoints>;

/// A line of the first table that ./course effects prints.
struct NamedAnswer {
  std::string name;
  Answer answer;
};

template <class... Some>
std::vector<NamedAnswer> effects_of(const World& world, Questions<Some...>) {
  return {{Some::name, Some::in(world)}...};
}
inline std::vector<NamedAnswer> effects_of(const World& world) {
  return effects_of(world, AllQuestions{});
}

// ---- which step ----------------------------------------------------------------------------------------------------------

/// A line of the second table, for all islands that get the same step for the same reason.
struct StepAnswer {
  StepType step;
  std::string because;  ///< text for users, with counts for each island
  int islands;
  std::vector<int> bodies;  ///< of all these islands, ascending
};

/// "flight", "half steps" or "substeps".
const char* name_of(StepType step);

/// The step that `solver` takes next. A copy of the solver takes that step of dt (s) with a copy of the world. Throws as World::step does.
std::vector<StepAnswer> steps_of(const World& world, const IslandSolver& solver, Real dt);
/// The same for the first step of `Recommended`, of 1/60 s.
std::vector<StepAnswer> steps_of(const World& world);

}  // namespace pushback
