/// The work of a solver, counted where it is done.
#pragma once

#include <cstddef>

namespace pushback {

/// How many rows this thread has solved since it began: computed an impulse from the velocities, and applied it. Who sweeps a
/// list of rows adds its length, once a sweep: an addition a row would be felt. Not in it: first guesses, which no velocity
/// decides, and linear systems, which solve no single row.
constinit inline thread_local std::size_t rows_solved = 0;

}  // namespace pushback
