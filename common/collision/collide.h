/// Narrow phase: where two shapes touch.
#pragma once

#include "pushback/common/collision/contact.h"
#include "pushback/common/collision/margin.h"

namespace pushback {

/// Appends up to four points at which the bodies overlap to `contacts`; none where they do not, or where both are
/// immovable. The normal points from `a` to `b`, whichever shapes they have; a.index < b.index. What is apart by no more
/// than the margin counts as well: with a negative depth. The surfaces are those of the skins, where bodies have some.
///
/// Joints and groups are not asked: whoever calls this has asked may_touch and JoinedPairs.
void collide(const Body& a, const Body& b, Contacts& contacts, const Margin& margin = {});

}  // namespace pushback
