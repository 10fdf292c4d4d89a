/// The answer to exercise 07, and its checks.
#pragma once

#include "pushback/chapters/01_velocity_constraint/row.h"
#include "pushback/common/exercise/exercise.h"

namespace pushback::exercise_07 {

/// The stored data of a contact point.
struct Remembered {
  ContactId id;
  Vec3 impulse = Vec3::Zero();  ///< N s, world axes: the impulse that the solver last applied there
  Real dt = 0;                  ///< s, the length of the step in which it did
  Real age = 0;                 ///< s, since that step
};
using Memory = std::vector<Remembered>;

/// The time for which a point is remembered after it last touched, s.
inline constexpr Real lasts = Real(0.1);

struct Answer {
  Vec3 (*guess)(const Memory& memory, const ContactId& id, Real dt);
  void (*keep)(Memory& memory, const Contacts& contacts, Real dt);
  void (*put_elsewhere)(Memory& memory, std::uint32_t body);
};

std::vector<Check<Answer>> checks_of(const Answer& /*any*/);

}  // namespace pushback::exercise_07
