/// Which joints form loops, and in which order trees of them grow: bodies that move are the places, joints lead from one to another.
#pragma once

#include <map>
#include <utility>
#include <vector>

namespace pushback {

/// Two bodies by their indices, `not_moving` first for a joint that holds one alone: what cannot move joins nothing.
using JoinedBodies = std::pair<int, int>;
inline constexpr int not_moving = -1;

/// Of each joint: whether what hangs together with it has a loop, two ways from a body to another. Two joints between the same two
/// bodies are none: a ball and socket has its limits beside it.
std::vector<bool> in_loops(const std::vector<JoinedBodies>& joints);

/// The joints of one tree after the other, each after the one that it hangs from; a tree that is held by what cannot move
/// begins there.
std::vector<int> root_first(const std::vector<JoinedBodies>& joints);

/// Of each body that moves, the joints that hold it, ascending.
std::map<int, std::vector<int>> joints_by_body(const std::vector<JoinedBodies>& joints);

/// Of each joint the others that hold one of its bodies, ascending.
std::vector<std::vector<int>> joint_neighbours(const std::vector<JoinedBodies>& joints);

}  // namespace pushback
