/// Which bodies tell what is wrong: a student's and the right ones, at the instant where they differ the most.
#pragma once

#include <optional>

#include "pushback/common/world/world.h"
#include "pushback/tools/classroom/judge.h"

namespace pushback {

/// How far the movable bodies of two worlds are apart, each in the worst body.
struct Apart {
  Real place = 0;  ///< in sizes of the body
  Real turn = 0;   ///< rad
  Real speed = 0;  ///< of the largest in either world, as are the next two
  Real spin = 0;
  Real impulse = 0;         ///< of a contact; 1 where one world has another number of contacts
  Real sleep = 0;           ///< 1: a body sleeps in one world only
  Real to_be_seen() const;  ///< 0: nothing
};

/// Of worlds with the same bodies.
Apart apart(const World& yours, const World& right);
/// m, the largest extent of a body along an axis.
Real size_of(const Body& body);

struct TellingInstant {
  std::size_t check, scene, quantity;  ///< those of the verdict's sentence
  World yours, right;
  bool of_place = false;  ///< the number is a length or an angle: velocities do not tell it
};

/// Nothing where no check fails by its numbers, or where what was shown differs nowhere, or makes no sense.
std::optional<TellingInstant> telling_instant(const Exercise& exercise, std::uint64_t seed, const Attempt& outcome,
                                              const Verdict& verdict);

}  // namespace pushback
