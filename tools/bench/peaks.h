/// The most that this processor can do, in registers as wide as those of chapter 22's passes.
#pragma once

#include "pushback/chapters/22_wide/bundle.h"

namespace pushback {

/// As many products as sums, none of which waits for another: returns how many of all lanes. `sink` takes what comes out.
double multiply_and_add(int rounds, float factor, float& sink);
double multiply_and_add(int rounds, double factor, double& sink);

/// Reads each number, and writes it back.
void add_to_all(Eight<float>* numbers, long count, float part);
void add_to_all(Eight<double>* numbers, long count, double part);

}  // namespace pushback
