#include "pushback/engine/islands/still_bodies.h"

#include <algorithm>
#include <cassert>

namespace pushback {

namespace {

/// The world axis along which the positions reach farthest.
int longest_axis(const std::vector<Body>& bodies, std::span<const int> which) {
  Vec3 low = bodies[std::size_t(which.front())].position, high = low;
  for (const int index : which) {
    low = low.cwiseMin(bodies[std::size_t(index)].position);
    high = high.cwiseMax(bodies[std::size_t(index)].position);
  }
  int axis = 0;
  (high - low).maxCoeff(&axis);
  return axis;
}

}  // namespace

StillBodies::StillBodies(const std::vector<Body>& bodies, std::span<const int> which) {
  if (which.empty()) return;
  nodes_.resize(2 * which.size() - 1);  // as many leaves as bodies, and one fork less
  std::vector<int> order(which.begin(), which.end());
  arrange(bodies, order, 0);
}

/// Writes the tree of these from the node `here` on. The half that is lower along the longest axis is the lower branch.
void StillBodies::arrange(const std::vector<Body>& bodies, std::span<int> which, std::size_t here) {
  Node& node = nodes_[here];
  node.after = int(here + 2 * which.size() - 1);
  if (which.size() == 1) {
    const Body& body = bodies[std::size_t(which.front())];
    assert(!std::holds_alternative<HalfSpace>(body.shape));
    node.bounds = bounds_of(body);
    node.body = which.front();
    return;
  }
  const int axis = longest_axis(bodies, which);
  const std::size_t half = which.size() / 2, lower = here + 1, upper = here + 2 * half;
  // By index if positions are equal, so that the halves do not depend on the order within them.
  std::nth_element(which.begin(), which.begin() + std::ptrdiff_t(half), which.end(), [&bodies, axis](int i, int j) {
    const Real p = bodies[std::size_t(i)].position[axis], q = bodies[std::size_t(j)].position[axis];
    return p != q ? p < q : i < j;
  });
  arrange(bodies, which.first(half), lower);
  arrange(bodies, which.subspan(half), upper);
  const Bounds &p = nodes_[lower].bounds, &q = nodes_[upper].bounds;
  node.bounds = {p.low.cwiseMin(q.low), p.high.cwiseMax(q.high)};
}

void StillBodies::near(const Bounds& bounds, std::vector<int>& found) const {
  const std::ptrdiff_t before = std::ssize(found);
  for (std::size_t at = 0; at < nodes_.size();) {
    const Node& node = nodes_[at];
    if (!node.bounds.overlaps(bounds)) {
      at = std::size_t(node.after);
    } else {
      if (node.body >= 0) found.push_back(node.body);
      ++at;
    }
  }
  std::sort(found.begin() + before, found.end());
}

}  // namespace pushback
