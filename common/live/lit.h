/// A quantity of the contacts that a picture shows in front of everything else.
#pragma once

#include "pushback/common/render/picture.h"
#include "pushback/common/world/world.h"

namespace pushback {

enum class Lit { nothing, normals, depths, impulses };

/// Adds it to the picture of a world whose bodies are displaced by `shift` (m). A normal becomes an arrow, and a depth the gap
/// between two, as in a technical drawing. Each impulse is an arrow already. All of these grow alike until the longest is easily
/// seen, at most threefold.
void light(Picture& picture, const World& world, const Vec3& shift, Lit lit);

}  // namespace pushback
