/// All ways to solve a contact problem, by name.
#pragma once

#include "pushback/engine/direct/best.h"

namespace pushback {

/// Those that sweep; smoothed: linear systems alone; and best: what it takes, sweeps and Newton's method.
std::vector<std::string> method_names();

/// Whether a method is stopped by a number of sweeps: `smoothed` and `best` are not.
bool counts_sweeps(const std::string& method);

/// As solve_by_sweeps; `smoothed` and `best` take the tolerance only.
Solution solve(const ContactProblem& problem, const std::string& method, int sweeps, double tolerance);

/// Contacts without friction, by pivoting. Throws InvalidInput where a mu is not 0, and std::runtime_error where pivoting finds
/// no solution.
Solution solve_frictionless(const ContactProblem& problem);

}  // namespace pushback
