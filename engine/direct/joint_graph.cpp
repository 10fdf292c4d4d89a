#include "pushback/engine/direct/joint_graph.h"

#include <algorithm>
#include <set>

namespace pushback {

namespace {

/// Disjoint sets of connected bodies.
class Groups {
 public:
  int of(int body) {
    const int above = above_.try_emplace(body, body).first->second;
    return above == body ? body : above_[body] = of(above);
  }
  void join(int a, int b) { above_[of(a)] = of(b); }

 private:
  std::map<int, int> above_;
};

}  // namespace

std::map<int, std::vector<int>> joints_by_body(const std::vector<JoinedBodies>& joints) {
  std::map<int, std::vector<int>> all;
  for (std::size_t i = 0; i < joints.size(); ++i)
    for (const int body : {joints[i].first, joints[i].second})
      if (body != not_moving) all[body].push_back(static_cast<int>(i));
  return all;
}

std::vector<bool> in_loops(const std::vector<JoinedBodies>& joints) {
  Groups groups;
  std::set<JoinedBodies> seen;
  std::vector<int> where_loops_close;
  for (const auto& [a, b] : joints) {
    if (a == not_moving || !seen.insert({a, b}).second) continue;
    if (groups.of(a) == groups.of(b)) where_loops_close.push_back(a);
    else groups.join(a, b);
  }
  std::set<int> with_loops;
  for (const int body : where_loops_close) with_loops.insert(groups.of(body));
  std::vector<bool> in;
  for (const auto& [a, b] : joints) in.push_back(b != not_moving && with_loops.contains(groups.of(b)));
  return in;
}

std::vector<int> root_first(const std::vector<JoinedBodies>& joints) {
  const auto held = joints_by_body(joints);
  std::vector<bool> seen(joints.size());
  std::vector<int> order;
  const auto come_to = [&](int joint) {
    if (!seen[static_cast<std::size_t>(joint)]) order.push_back(joint);
    seen[static_cast<std::size_t>(joint)] = true;
  };
  std::size_t next = 0;
  for (const bool from_what_cannot_move : {true, false})
    for (std::size_t root = 0; root < joints.size(); ++root) {
      if ((joints[root].first == not_moving) != from_what_cannot_move) continue;
      for (come_to(static_cast<int>(root)); next < order.size(); ++next) {
        const JoinedBodies& bodies = joints[static_cast<std::size_t>(order[next])];
        for (const int body : {bodies.first, bodies.second})
          if (body != not_moving)
            for (const int other : held.at(body)) come_to(other);
      }
    }
  return order;
}

std::vector<std::vector<int>> joint_neighbours(const std::vector<JoinedBodies>& joints) {
  const auto held = joints_by_body(joints);
  std::vector<std::vector<int>> all(joints.size());
  for (std::size_t i = 0; i < joints.size(); ++i) {
    std::set<int> neighbours;
    for (const int body : {joints[i].first, joints[i].second})
      if (body != not_moving) neighbours.insert(held.at(body).begin(), held.at(body).end());
    neighbours.erase(static_cast<int>(i));
    all[i].assign(neighbours.begin(), neighbours.end());
  }
  return all;
}

}  // namespace pushback
