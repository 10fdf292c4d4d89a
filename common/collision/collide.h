/// Narrow phase: where two shapes touch.
#pragma once

#include "pushback/common/collision/contact.h"
#include "pushback/common/collision/margin.h"

namespace pushback {

/// Appends up to four points at which the bodies overlap to `contacts`; none where they do not, or where both are
/// immovable. The normal points from `a` to `b`, whichever shapes they have; a.index < b.index. What is apart by no more
/// than the margin counts as well: with a negative depth.
void collide(const Body& a, const Body& b, Contacts& contacts, const Margin& margin = {});

}  // namespace pushback
