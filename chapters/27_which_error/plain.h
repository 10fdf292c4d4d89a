/// The error of a step and the number of substeps of the next one, as plain functions, and a pendulum that is stepped by them.
#pragma once

#include <cmath>
#include <limits>

#include "pushback/chapters/24_half_step/plain.h"

namespace pushback::plain_27 {

/// The error of a place, m, from the same step in n substeps, `fine`, and in n / 2, `coarse`. The coarse result has 2^order times the
/// error of the fine one, so their difference is 2^order - 1 times that error.
inline Real off_by(Real coarse, Real fine, int order) {
  return std::abs(coarse - fine) / (std::exp2(static_cast<Real>(order)) - 1);
}

/// A step that was tried.
struct Tried {
  int substeps;  // of this try
  Real off;      // relative to the allowed error
  Real before;   // the same for the try before, with half as many substeps; infinite: none
  int order;
};
struct Bounds {
  int least = 2, most = 16;  // substeps
};
struct Verdict {
  bool stands;   // else the step is repeated from its start
  bool kept;     // its error is within the allowed error
  int substeps;  // of the next try, for the same step or the next one
};

/// Twice as many substeps if the error is too large, and the last doubling more than halved it. Half as many if their error, which is
/// 2^order times as large, is below half of the allowed error.
inline Verdict judge_try(const Tried& tried, const Bounds& bounds) {
  const bool kept = tried.off <= 1, falls = tried.off < tried.before / 2;
  if (!kept && falls && 2 * tried.substeps <= bounds.most) return {false, false, 2 * tried.substeps};
  const Real off_with_half = tried.off * std::exp2(static_cast<Real>(tried.order));
  const bool fewer = off_with_half < Real(0.5) && tried.substeps > bounds.least;
  return {true, kept, fewer ? tried.substeps / 2 : tried.substeps};
}

using plain_24::Bob;

/// Chapter 24's half steps, which are of order 2.
inline Bob advanced(Bob bob, const Vec3& g, Real h, int substeps) {
  for (int i = 0; i < substeps; ++i) half_step(bob, g, h / static_cast<Real>(substeps));
  return bob;
}

/// m: the error of `fine` in place, plus the distance that its error in velocity adds in half a second.
inline Real step_error(const Bob& coarse, const Bob& fine) {
  const Real half_a_second = Real(0.5);
  return off_by((coarse.x - fine.x).norm() + half_a_second * (coarse.v - fine.v).norm(), 0, 2);
}

struct Step {
  Bob bob;        // after it
  int substeps;   // of it
  Real estimate;  // of its error, m
  bool kept;      // the estimate is within the allowed error
  int next;       // substeps with which the next step begins
};

/// A step of h seconds, first tried in `substeps`, an even number. Its allowed error is `error` (m in a second) times h. The result of
/// a try is the coarse result of the next try.
inline Step controlled_step(const Bob& begin, const Vec3& g, Real h, Real error, int substeps, const Bounds& bounds) {
  Real before = std::numeric_limits<Real>::infinity();
  Bob coarse = advanced(begin, g, h, substeps / 2);
  for (;;) {
    const Bob fine = advanced(begin, g, h, substeps);
    const Real estimate = step_error(coarse, fine), off = estimate / (error * h);
    const Verdict verdict = judge_try({substeps, off, before, 2}, bounds);
    if (verdict.stands) return {fine, substeps, estimate, verdict.kept, verdict.substeps};
    before = off;
    coarse = fine;
    substeps = verdict.substeps;
  }
}

}  // namespace pushback::plain_27
