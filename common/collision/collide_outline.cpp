#include "pushback/common/collision/collide_outline.h"

#include <cmath>

namespace pushback {

void reduce_to_four(Candidate* candidates, int count, Real clearly_deeper) {
  const auto by_name = [](const Candidate& p, const Candidate& q) { return p.feature < q.feature; };
  std::rotate(candidates, std::min_element(candidates, candidates + count, by_name), candidates + count);
  // Points that touch come before points within a margin, because a stone that loses a corner on which it stands rocks for ever.
  const auto touches = [&](const Candidate& c) { return c.depth >= -clearly_deeper; };
  const auto must_touch = std::min<std::ptrdiff_t>(4, std::count_if(candidates, candidates + count, touches));
  std::array<Candidate, 4> best{};
  const auto try_all = [&](int required) {
    Real largest = -1;
    for (int i = 0; i < count; ++i) {
      for (int j = i + 1; j < count; ++j) {
        for (int k = j + 1; k < count; ++k) {
          for (int l = k + 1; l < count; ++l) {
            if (required >= 0 && i != required && j != required && k != required && l != required) continue;
            const Candidate &p = candidates[i], &q = candidates[j], &r = candidates[k], &s = candidates[l];
            if (touches(p) + touches(q) + touches(r) + touches(s) < must_touch) continue;
            const Real area = std::abs((r.u - p.u) * (s.v - q.v) - (r.v - p.v) * (s.u - q.u)) / 2;
            if (area > largest * Real(1.001)) {
              largest = area;
              best = {p, q, r, s};
            }
          }
        }
      }
    }
  };
  try_all(-1);
  const auto by_depth = [](const Candidate& p, const Candidate& q) { return p.depth < q.depth; };
  const Real most = std::max_element(candidates, candidates + count, by_depth)->depth;
  if (most > std::max_element(best.begin(), best.end(), by_depth)->depth + clearly_deeper) {
    // The first of several that are equally deep, so that rounding does not choose.
    const auto as_deep = [&](const Candidate& c) { return c.depth >= most - clearly_deeper; };
    try_all(int(std::find_if(candidates, candidates + count, as_deep) - candidates));
  }
  std::copy(best.begin(), best.end(), candidates);
}

}  // namespace pushback
