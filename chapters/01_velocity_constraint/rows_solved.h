/// Counts the work of a solver.
#pragma once

#include <cstddef>

namespace pushback {

/// The number of rows that this thread has solved since it began. To solve a row means to compute an impulse from velocities
/// and apply it. A sweep adds the length of its list once, because an addition per row costs time. Excluded are initial guesses,
/// which do not depend on velocities, and linear systems, which solve no single row.
constinit inline thread_local std::size_t rows_solved = 0;

}  // namespace pushback
