/// Islands are sets of movable bodies that contacts, joints and other calls of `join` connect, directly or through movable bodies.
/// Immovable bodies connect nothing.
#pragma once

#include <numeric>
#include <vector>

#include "pushback/common/world/world.h"

namespace pushback {

/// Disjoint sets of bodies, each identified by its lowest index.
/// Tarjan, "Efficiency of a Good But Not Linear Set Union Algorithm", J. ACM 22, 1975.
class Islands {
 public:
  /// Makes each of these bodies an island by itself. `all`: the number of bodies in the world, which does not affect the cost once
  /// the memory is allocated.
  void separate(const std::vector<int>& bodies, std::size_t all) {
    parent_.resize(all);
    for (const int body : bodies) parent_[std::size_t(body)] = body;
  }
  void join(int a, int b) {
    const int first = island_of(a), second = island_of(b);
    parent_[std::size_t(std::max(first, second))] = std::min(first, second);
  }
  /// Joins the two bodies of each contact if both are movable.
  void join(const Contacts& contacts, const World& world) {
    for (const Contact& contact : contacts) {
      const auto [a, b] = world.bodies_of(contact);
      if (a.movable() && b.movable()) join(a.index, b.index);
    }
  }
  /// Joins the two bodies of each joint if both are movable.
  void join(const std::vector<Joint>& joints, const World& world) {
    for (const Joint& joint : joints) {
      if (body_of(world, joint.a).movable() && body_of(world, joint.b).movable()) join(joint.a, joint.b);
    }
  }
  /// The lowest index in the island of this body.
  int island_of(int body) {
    int& parent = parent_[std::size_t(body)];
    while (parent != parent_[std::size_t(parent)])
      parent = parent_[std::size_t(parent)];  // a shortcut for later searches from this body
    return parent;
  }

 private:
  std::vector<int> parent_;
};

}  // namespace pushback
