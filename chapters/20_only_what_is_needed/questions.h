/// What a scene calls for, read off what is in it.
///
/// Each question is a type, so that a program can be made of the answers. Whoever adds an effect adds its question here, or
/// in a header of its own, and one word to EveryQuestion. `only_if`: another question, before it there, without a yes to which
/// the answer is no.
#pragma once

#include <string>
#include <vector>

#include "pushback/common/world/world.h"

namespace pushback {

struct Answer {
  bool yes = false;
  std::string because;  ///< for people: who needs it, or why nobody does
};

/// Can two bodies come to touch? One of them has to be movable. Without that: no collision, no rows.
struct Touching {
  static constexpr const char* name = "contacts";
  static Answer in(const World& world);
};
/// Does a joint hold something? Throws as check_bodies_of.
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
/// Does anything but gravity pull: a spring, drag, a force that somebody has put on a body? Throws as check_bodies_of.
struct Pulling {
  static constexpr const char* name = "applied forces";
  static Answer in(const World& world);
};

/// Those to which the answer is yes.
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
