#include "pushback/engine/direct/direct_tree_joints.h"

#include <algorithm>

namespace pushback {

void DirectTreeJoints::assign_joints(const World& world) {
  std::vector<JoinedBodies> bodies;
  for (const Joint& joint : world.joints) {
    const auto moving = [&world](int body) { return world.body(body).movable() ? body : not_moving; };
    bodies.push_back(std::minmax({moving(joint.a), moving(joint.b)}));
  }
  if (bodies == bodies_) return;
  bodies_ = bodies;
  in_loops_ = in_loops(bodies_);
  in_trees_ = in_loops_;
  in_trees_.flip();
}

}  // namespace pushback
