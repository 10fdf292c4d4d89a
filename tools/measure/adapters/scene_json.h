/// A world as text that other programs read. docs/benchmark.md says what its fields are.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>

#include "pushback/common/world/world.h"

namespace pushback {

/// Numbers in full: read again, they are the same bits.
using Json = nlohmann::ordered_json;

Json json_of(const Vec3& v);
/// Back, of three numbers.
Vec3 vec3_of(const Json& json);
/// w, x, y, z.
Json json_of(const Quat& q);

/// Gravity, bodies, joints, as they stand. Throws InvalidInput, which begins with not_possible, where there is something that the
/// text has no words for: a conveyor, a skin, groups, a joint that is none of JointShape's.
Json scene_json(const World& world);

/// Back. Of a body `position`, `shape` and `mass` must be there; what else is left out is as World::add has it: at rest, not turned,
/// with the friction and restitution of any body, and the inertia of a uniform one. So is gravity, and `joints` may be missing. A hull has the
/// inertia of a uniform one in any case. Throws InvalidInput, which names the body or joint, the field, what it is and what is needed.
World scene_of(const Json& json);

/// The scene in a file. Throws InvalidInput where it is none.
World scene_in(const std::filesystem::path& file);

/// Position, orientation and both velocities, and the body's index.
Json state_json(const Body& body);

}  // namespace pushback
