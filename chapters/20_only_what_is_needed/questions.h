/// The effects that a scene needs, determined from its contents.
///
/// Each question is a type, so that code can be selected by the answers at compile time. To add an effect, add its question here
/// or in its own header, and one word to EveryQuestion. `only_if`: another question, earlier in EveryQuestion; unless its answer is
/// yes, the answer is no.
#pragma once

#include <string>
#include <vector>

#include "pushback/common/world/world.h"

namespace pushback {

struct Answer {
  bool yes = false;
  std::string because;  ///< text for users: the body or joint that needs the effect, or why none does
};

/// Can two bodies touch? One of them has to be movable. If not, detection and contact rows are not needed.
struct Touching {
  static constexpr const char* name = "contacts";
  static Answer in(const World& world);
};
/// Does the scene have joints? Throws as check_bodies_of.
struct Holding {
  static constexpr const char* name = "joints";
  static Answer in(const World& world);
};
/// Does a pair that can touch have e > 0?
struct Bouncing {
  using only_if = Touching;
  static constexpr const char* name = "restitution";
  static Answer in(const World& world);
};
/// Does a pair that can touch have mu > 0?
struct Rubbing {
  using only_if = Touching;
  static constexpr const char* name = "friction";
  static Answer in(const World& world);
};
/// Does a body's inertia differ from axis to axis?
struct Tumbling {
  static constexpr const char* name = "gyroscopic term";
  static Answer in(const World& world);
};
/// Does a force other than gravity act: a spring, drag, or a force set on a body? Throws as check_bodies_of.
struct Pulling {
  static constexpr const char* name = "applied forces";
  static Answer in(const World& world);
};

/// The questions whose answer is yes.
template <class... Questions>
struct CalledFor {
  template <class Question>
  static constexpr bool has = (std::is_same_v<Question, Questions> || ...);
};

using EveryQuestion = CalledFor<Touching, Bouncing, Rubbing, Tumbling, Pulling, Holding>;

/// A line of the table that ./course effects prints.
struct NamedAnswer {
  std::string name;
  Answer answer;
};

template <class... Questions>
std::vector<NamedAnswer> effects_of(const World& world, CalledFor<Questions...>) {
  return {{Questions::name, Questions::in(world)}...};
}
inline std::vector<NamedAnswer> effects_of(const World& world) {
  return effects_of(world, EveryQuestion{});
}

}  // namespace pushback
