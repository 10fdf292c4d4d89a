/// A world as text that other programs read. docs/benchmark.md describes its fields.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>

#include "pushback/common/world/world.h"

namespace pushback {

/// Numbers have enough digits to give the same bits when they are read.
using Json = nlohmann::ordered_json;

Json json_of(const Vec3& v);
/// Converts an array of three numbers back.
Vec3 vec3_of(const Json& json);
/// w, x, y, z.
Json json_of(const Quat& q);

/// Gravity, bodies and joints in their present state. Throws InvalidInput, whose message begins with not_possible, for elements that
/// the format does not have, which are conveyors, skins, groups, and joints that are none of JointShape's kinds.
Json scene_json(const World& world);

/// Converts a scene back. A body must have `position`, `shape` and `mass`. Other missing fields get the defaults of World::add, which are
/// no velocity, no rotation, the default friction and restitution, and the inertia of a uniform body. Gravity has its default, too,
/// and `joints` may be missing. A hull always has the inertia of a uniform body. Throws InvalidInput, naming the body or joint, the
/// field, its value and the required value.
World scene_of(const Json& json);

/// The scene in a file. Throws InvalidInput if the file is not a scene.
World scene_in(const std::filesystem::path& file);

/// Position, orientation and both velocities, and the body's index.
Json state_json(const Body& body);

}  // namespace pushback
