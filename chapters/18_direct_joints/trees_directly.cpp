#include "pushback/chapters/18_direct_joints/trees_directly.h"

#include <map>
#include <numeric>
#include <set>

namespace pushback {

namespace {

/// Bodies that hang together, each under one of them.
class Groups {
 public:
  int of(int body) {
    const auto [found, added] = above_.try_emplace(body, body);
    if (found->second == body) return body;
    return found->second = of(found->second);
  }
  void join(int a, int b) { above_[of(a)] = of(b); }

 private:
  std::map<int, int> above_;
};

}  // namespace

/// Two joints between the same two bodies are no loop: a ball and socket has its limits beside it.
void TreesDirectly::share_out(const World& world) {
  constexpr int none = JointMatrix::none;
  std::vector<std::pair<int, int>> pairs;
  for (const Joint& joint : world.joints) {
    const auto moving = [&world](int body) { return world.body(body).movable() ? body : none; };
    pairs.push_back(std::minmax({moving(joint.a), moving(joint.b)}));
  }
  if (pairs == pairs_ && in_trees_.size() == pairs.size()) return;
  pairs_ = pairs;
  Groups groups;
  std::set<std::pair<int, int>> seen;
  std::set<int> with_loops;
  for (const auto& pair : pairs_) {
    if (pair.first == none || !seen.insert(pair).second) continue;
    if (groups.of(pair.first) == groups.of(pair.second)) with_loops.insert(pair.first);
    else groups.join(pair.first, pair.second);
  }
  std::set<int> groups_with_loops;
  for (const int body : with_loops) groups_with_loops.insert(groups.of(body));
  in_loops_.assign(pairs_.size(), false);
  in_trees_.assign(pairs_.size(), true);
  for (std::size_t i = 0; i < pairs_.size(); ++i) {
    if (pairs_[i].second == none || !groups_with_loops.contains(groups.of(pairs_[i].second))) continue;
    in_loops_[i] = true;
    in_trees_[i] = false;
  }
}

}  // namespace pushback
