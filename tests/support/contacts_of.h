/// What collision says of two bodies, for the tests.
#pragma once

#include "pushback/common/collision/collide.h"

namespace pushback {

/// What collision finds between the two. Their indices become 3 and 8.
inline Contacts contacts_of(Body& a, Body& b) {
  a.index = 3;
  b.index = 8;
  Contacts contacts;
  collide(a, b, contacts);
  return contacts;
}

/// m; -1 where there are none.
inline Real deepest(const Contacts& contacts) {
  Real depth = -1;
  for (const Contact& c : contacts) depth = std::max(depth, c.depth);
  return depth;
}

}  // namespace pushback
