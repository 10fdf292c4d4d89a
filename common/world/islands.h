/// Who can feel whom: bodies that touch or are joined, and those that these touch, and so on; but not through what nothing
/// moves.
#pragma once

#include <numeric>
#include <vector>

#include "pushback/common/world/world.h"

namespace pushback {

/// Sets of bodies, each known by one of its members.
/// Tarjan, "Efficiency of a Good But Not Linear Set Union Algorithm", J. ACM 22, 1975.
class Islands {
 public:
  /// From now on each of these is an island by itself. Work is done for them only, however many bodies there are.
  void separate(const std::vector<int>& bodies, std::size_t all) {
    parent_.resize(all);
    for (const int body : bodies) parent_[std::size_t(body)] = body;
  }
  void join(int a, int b) {
    const int first = island_of(a), second = island_of(b);
    parent_[std::size_t(std::max(first, second))] = std::min(first, second);
  }
  /// What touches, and is movable, is one.
  void join(const Contacts& contacts, const World& world) {
    for (const Contact& contact : contacts) {
      const auto [a, b] = world.bodies_of(contact);
      if (a.movable() && b.movable()) join(a.index, b.index);
    }
  }
  /// And so is what is joined.
  void join(const std::vector<Joint>& joints, const World& world) {
    for (const Joint& joint : joints) {
      if (body_of(world, joint.a).movable() && body_of(world, joint.b).movable()) join(joint.a, joint.b);
    }
  }
  /// The lowest index in the island of this body.
  int island_of(int body) {
    int& parent = parent_[std::size_t(body)];
    while (parent != parent_[std::size_t(parent)])
      parent = parent_[std::size_t(parent)];  // halves the way for the next
    return parent;
  }

 private:
  std::vector<int> parent_;
};

}  // namespace pushback
