/// The hard cases as an experiment: for who plays them step by step.
#pragma once

#include "pushback/common/experiment/experiment.h"

namespace pushback {

/// To be called inside `run`'s `define`: a scene each case, under the case's name, and a variant each stage. Each is played
/// as it begins, in steps of --dt; what a case does besides (other worlds, other starts) is left to its `run`.
void describe_hard_cases(Experiment& experiment);

}  // namespace pushback
