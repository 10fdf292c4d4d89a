/// Exercise 18: the elimination of a chain. The task is chapters/18_direct_joints/exercise/task.md.
#pragma once

#include "pushback/chapters/18_direct_joints/exercise/asked.h"

namespace student {

using namespace pushback;
using exercise_18::Blocks, exercise_18::Threes;

/// The impulses of the joints of a chain, three numbers each, from the hook (joint 0) to the free end, N s.
///
/// You read   own[i]      A_ii, 1/kg: what an impulse on joint i does to the speed of joint i
///            next[i]     A_i,i+1, 1/kg: what one on joint i + 1 does to joint i; A_i+1,i is its transpose. One less than own
///            wanted[i]   -(J V + b) of joint i, m/s
/// own and wanted are copies, and yours to change. M.inverse() and M.transpose() are those of a block M.
inline Threes solve(Blocks own, const Blocks& next, Threes wanted) {
  Threes impulses(own.size(), Eigen::Vector3d::Zero());
  // TODO A lambda = wanted: eliminate from the free end to the hook, then substitute from the hook to the free end
  (void)next, (void)wanted;  // take this line out
  // TODO ends
  return impulses;
}

inline const exercise_18::Answer answer{solve};

}  // namespace student
