/// The narrow phase finds the points at which two shapes touch.
#pragma once

#include "pushback/common/collision/contact.h"
#include "pushback/common/collision/margin.h"

namespace pushback {

/// Appends to `contacts` up to four points at which the bodies overlap, or none if they do not overlap or both are immovable. The
/// normal points from `a` to `b`, whatever their shapes. Expects a.index < b.index. Bodies that are apart by no more than the
/// margin also get points, with a negative depth. If a body has a skin, the surface of the skin counts.
///
/// Ignores joints and groups. The caller checks JoinedPairs and may_touch.
void collide(const Body& a, const Body& b, Contacts& contacts, const Margin& margin = {});

}  // namespace pushback
