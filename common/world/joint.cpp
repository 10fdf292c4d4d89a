#include "pushback/common/world/joint.h"

#include <algorithm>

#include "pushback/common/basics/input.h"
#include "pushback/common/world/world.h"

namespace pushback {

const Body& body_of(const World& world, int index) {
  return world.body(index);
}

void check_joined(const World& world, const std::string& joint, int a, int b) {
  for (const int body : {a, b}) {
    if (body == the_world || (body >= 0 && std::size_t(body) < world.bodies.size())) continue;
    throw InvalidInput(fmt::format("{} holds body {}: a body from 0 to {}, or {} for the world, is needed", joint, body,
                                   static_cast<int>(world.bodies.size()) - 1, the_world));
  }
  if (a == b) throw InvalidInput(fmt::format("{} joins body {} to itself: two different ones are needed", joint, a));
  for (const int body : {a, b}) {
    if (!body_of(world, body).conveys) continue;
    throw InvalidInput(
        fmt::format("{} holds body {}, which conveys: one that goes where its velocity points is needed", joint, body));
  }
  if (!body_of(world, a).movable() && !body_of(world, b).movable()) {
    throw InvalidInput(fmt::format("{} joins bodies {} and {}, and neither can move: one has to", joint, a, b));
  }
}

Load load_of(const World& world, const Joint& joint, Real dt) {
  Equations equations;
  joint.ask(world.body(joint.a), world.body(joint.b), {world.time, dt}, equations);
  Vec3 pushed = Vec3::Zero(), turned = Vec3::Zero();  // N s, N m s
  for (std::size_t i = 0; i < std::min(equations.size(), joint.impulses.size()); ++i) {
    const Jacobian& j = equations[i].jacobian;
    if (j.n.isZero(0)) turned += joint.impulses[i] * j.rb_n;
    else pushed += joint.impulses[i] * j.n;
  }
  return {pushed.norm() / dt, turned.norm() / dt};
}

void break_joints(World& world, Real dt) {
  std::erase_if(world.joints, [&](const Joint& joint) {
    const Load& most = joint.breaks_at;
    if (std::isinf(most.force) && std::isinf(most.torque)) return false;
    const Load now = load_of(world, joint, dt);
    return now.force > most.force || now.torque > most.torque;
  });
}

void check_no_joints(const std::vector<Joint>& joints) {
  if (joints.empty()) return;
  throw InvalidInput(
      fmt::format("the world has {}, and this solver holds no joints: one with the effect Joints is needed, such as "
                  "JointedSolver or Recommended",
                  joints.front().name));
}

JoinedPairs::JoinedPairs(const std::vector<Joint>& joints) {
  for (const Joint& joint : joints) {
    if (!joint.colliding) pairs_.emplace_back(std::minmax(joint.a, joint.b));
  }
  std::sort(pairs_.begin(), pairs_.end());
}

bool JoinedPairs::contain(int a, int b) const {
  return !pairs_.empty() && std::binary_search(pairs_.begin(), pairs_.end(), std::pair<int, int>(std::minmax(a, b)));
}

}  // namespace pushback
