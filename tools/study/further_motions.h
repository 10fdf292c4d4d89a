/// Motions of later chapters whose every position is known, for one who plays chapter 19's.
#pragma once

#include "pushback/chapters/19_accuracy_and_time/motion.h"

namespace pushback {

/// top: chapter 24's, on a pin. pendulum-at-wall: chapter 25's, of two bodies.
std::vector<Motion> further_motions();

}  // namespace pushback
