/// Narrow phase: where two shapes touch.
#pragma once

#include "pushback/common/collision/contact.h"

namespace pushback {

/// Appends up to four points at which the bodies overlap to `contacts`; none where they do not, or where both are
/// immovable. The normal points from `a` to `b`, whichever shapes they have; a.index < b.index.
void collide(const Body& a, const Body& b, Contacts& contacts);

}  // namespace pushback
