/// All methods that solve a contact problem, by name.
#pragma once

#include "pushback/engine/direct/solve_best.h"

namespace pushback {

/// The sweeping methods, then `smoothed`, which only solves linear systems, and `best`, which combines sweeps and Newton's method.
std::vector<std::string> method_names();

/// Whether a number of sweeps stops the method. False for `smoothed` and `best`.
bool counts_sweeps(const std::string& method);

/// As solve_by_sweeps. `smoothed` and `best` use the tolerance only.
Solution solve(const ContactProblem& problem, const std::string& method, int sweeps, double tolerance);

/// Solves contacts without friction by pivoting. Throws InvalidInput if a mu is not 0, and std::runtime_error if pivoting finds
/// no solution.
Solution solve_frictionless(const ContactProblem& problem);

}  // namespace pushback
