/// All ways to solve a contact problem, by name.
#pragma once

#include "pushback/chapters/17_direct_contacts/best.h"

namespace pushback {

/// Those that sweep; and best: what it takes, sweeps and Newton's method.
std::vector<std::string> method_names();

/// As solve_by_sweeps; `best` counts its own sweeps and takes the tolerance only.
Solution solve(const ContactProblem& problem, const std::string& method, int sweeps, double tolerance);

}  // namespace pushback
