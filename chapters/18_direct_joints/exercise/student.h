/// Exercise 18: the elimination of a chain. The task is chapters/18_direct_joints/exercise/task.md.
#pragma once

#include "pushback/chapters/18_direct_joints/exercise/asked.h"

namespace student {

using namespace pushback;
using exercise_18::Blocks, exercise_18::Threes;

/// Returns the impulses of the joints of a chain, three numbers each, from the hook (joint 0) to the free end, N s.
///
/// You read   own[i]      A_ii, the change of joint i's speed per impulse on joint i, 1/kg
///            next[i]     A_i,i+1, the change of joint i's speed per impulse on joint i + 1, 1/kg. A_i+1,i is its transpose.
///                        There is one block fewer than in own
///            wanted[i]   -(J V + b) of joint i, m/s
/// own and wanted are copies that you may change. A block M has M.inverse() and M.transpose().
inline Threes solve(Blocks own, const Blocks& next, Threes wanted) {
  Threes impulses(own.size(), Eigen::Vector3d::Zero());
  // TODO A lambda = wanted: eliminate from the free end to the hook, then substitute from the hook to the free end
  (void)next, (void)wanted;  // take this line out
  // TODO ends
  return impulses;
}

inline const exercise_18::Answer answer{solve};

}  // namespace student
