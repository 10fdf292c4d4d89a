/// The graph of joints, whose nodes are moving bodies and whose edges are joints.
#pragma once

#include <map>
#include <utility>
#include <vector>

namespace pushback {

/// The indices of the two bodies of a joint. An immovable body connects no joints, so it counts as `not_moving`, which comes
/// first.
using JoinedBodies = std::pair<int, int>;
inline constexpr int not_moving = -1;

/// For each joint, whether its group of connected joints has a loop. Two joints between the same two bodies,
/// such as a ball and socket and its limits, are not a loop.
std::vector<bool> in_loops(const std::vector<JoinedBodies>& joints);

/// The joints, tree by tree, each after the joint that connects it to the root. The root of a tree is its immovable body, if it
/// has one.
std::vector<int> root_first(const std::vector<JoinedBodies>& joints);

/// The joints of each moving body, ascending.
std::map<int, std::vector<int>> joints_by_body(const std::vector<JoinedBodies>& joints);

/// For each joint, the other joints of its moving bodies, ascending.
std::vector<std::vector<int>> joint_neighbours(const std::vector<JoinedBodies>& joints);

}  // namespace pushback
